/* The schedule against a plain array, and the scan against both. */
#include "unit.h"

#include "line/schedule.h"
#include "toolbox/random.h"

enum { MOST = 300 };

/* What the schedule should hold. */
struct plain {
    size_t size, count;
    bool in[MOST];
    double time[MOST];
};

/* The earliest event of those that are in, the first of equal ones; size
   when there is none. */
static size_t plain_first(const struct plain *p)
{
    size_t first = p->size;
    for (size_t i = 0; i < p->size; ++i)
        if (p->in[i] && (first == p->size || p->time[i] < p->time[first]))
            first = i;
    return first;
}

/* Says whether the heap is one: places and entries name each other, and
   no entry is before its parent. */
static bool is_heap(const struct schedule *s)
{
    bool good = true;
    for (size_t k = 0; k < s->count; ++k) {
        const struct schedule_entry e = s->heap[k];
        const struct schedule_entry up = s->heap[k > 0 ? (k - 1) / 2 : 0];
        good = good && s->place[e.event] == k &&
               (up.time < e.time ||
                (up.time == e.time && up.event <= e.event));
    }
    return good;
}

static void put(struct schedule *s, struct plain *p, size_t event,
                double time)
{
    schedule_put(s, event, time);
    p->count += !p->in[event];
    p->in[event] = true;
    p->time[event] = time;
}

static void drop(struct schedule *s, struct plain *p, size_t event)
{
    schedule_drop(s, event);
    p->count -= p->in[event];
    p->in[event] = false;
}

static void take(struct schedule *s, struct plain *p)
{
    const size_t first = plain_first(p);
    UNIT_EQUAL(schedule_take(s), first);
    p->in[first] = false;
    --p->count;
}

/* `levels` different times only, so that most are equal; the last level is
   INFINITY. Fewer levels mean more ties. */
static void mix(size_t size, int levels, uint64_t seed)
{
    struct plain p = {.size = size};
    SEEDED(r, seed);
    int bad = 0;
    CREATED(schedule, s, size, size);
    for (int k = 0; k < 3000; ++k) {
        const size_t event = (size_t)random_below(&r, size);
        const uint64_t level = random_below(&r, (uint64_t)levels);
        const uint64_t deed = random_below(&r, 10);
        const double time = level + 1 == (uint64_t)levels
                                ? INFINITY
                                : (double)level / 3 - 2;
        if (deed < 6)
            put(&s, &p, event, time);
        else if (deed < 8)
            drop(&s, &p, event);
        else if (p.count > 0)
            take(&s, &p);
        if (k % 997 == 996) {
            schedule_clear(&s);
            memset(p.in, 0, sizeof p.in);
            p.count = 0;
        }
        bad += s.count != p.count || !is_heap(&s) ||
               (s.count > 0 && s.heap[0].event != plain_first(&p));
    }
    UNIT_EQUAL(bad, 0);
    while (p.count > 0)
        take(&s, &p);
    UNIT_EQUAL(s.count, 0);
}

TEST(test_against_plain, "events come out as from a plain array")
{
    static const size_t sizes[] = {1, 2, 3, 4, 7, 8, 31, 100, MOST};
    static const int levels[] = {2, 4, 30, 100000};
    for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k)
        for (int i = 0; i < 4; ++i)
            mix(sizes[k], levels[i], 10 * k + (uint64_t)i);
}

TEST(test_ties, "equal times come in the order of numbers")
{
    MADE(schedule, s, schedule_create(&s, MOST, MOST));
    for (size_t i = 0; i < MOST; ++i)
        schedule_put(&s, (i * 77) % MOST, i % 2 ? 0.0 : -0.0);
    for (size_t i = 0; i < MOST; ++i)
        UNIT_EQUAL(schedule_take(&s), i);
}

TEST(test_edges, "dropped twice, put again, cleared")
{
    struct schedule s;
    schedule_create(&s, 3, 3);
    schedule_drop(&s, 2);
    UNIT_EQUAL(s.count, 0);
    schedule_clear(&s);
    schedule_put(&s, 2, 1);
    schedule_drop(&s, 2);
    schedule_drop(&s, 2);
    UNIT_EQUAL(s.count, 0);
    schedule_put(&s, 2, 5);
    schedule_put(&s, 0, 7);
    schedule_put(&s, 2, 9);
    UNIT_EQUAL(s.count, 2);
    UNIT_EQUAL(s.heap[0].time, 7);
    UNIT_EQUAL(schedule_take(&s), 0);
    UNIT_EQUAL(schedule_take(&s), 2);
    schedule_clear(&s);
    schedule_put(&s, 1, INFINITY);
    UNIT_EQUAL(schedule_take(&s), 1);
    schedule_free(&s);
    schedule_free(&s); /* twice is harmless */
    UNIT_TRUE(s.heap == NULL && s.place == NULL);
}

TEST(test_scan, "the scan finds the first of the smallest")
{
    SEEDED(r, 3);
    for (size_t n = 1; n < MOST; n += 1 + n / 4)
        for (uint64_t levels = 1; levels < 1000; levels *= 5) {
            double time[MOST];
            struct plain p = {.size = n};
            for (size_t i = 0; i < n; ++i) {
                const uint64_t level = random_below(&r, levels);
                p.in[i] = true;
                p.time[i] = time[i] = level == 7 ? INFINITY : (double)level;
            }
            UNIT_EQUAL(schedule_scan(time, n), plain_first(&p));
        }
    UNIT_EQUAL(schedule_scan((double[]){INFINITY, INFINITY}, 2), 0);
    UNIT_EQUAL(schedule_scan((double[]){1, 0, 0}, 3), 1);
}
