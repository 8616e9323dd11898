/* The calendar against a plain array that is searched from end to end. */
#include "unit.h"

#include "box/calendar.h"
#include "toolbox/random.h"

enum { MOST = 3000 };

/* What the calendar should hold. */
struct plain {
    size_t size;
    double time[MOST];
    uint32_t partner[MOST];
};

/* How far the times of a run lie apart, s: a day should be about this. */
struct spread {
    double near, far, early; /* of most events, of some, and overdue */
    int levels;              /* so many different times; 0: no ties */
};

static bool before(const struct plain *p, size_t a, size_t b)
{
    const size_t x = p->partner[a], y = p->partner[b];
    const size_t low_a = a < x ? a : x, low_b = b < y ? b : y;
    if (p->time[a] != p->time[b])
        return p->time[a] < p->time[b];
    return low_a != low_b ? low_a < low_b
                          : (a < x ? x : a) < (b < y ? y : b);
}

/* The earliest event; CALENDAR_NONE when there is none. */
static size_t plain_first(const struct plain *p)
{
    size_t first = CALENDAR_NONE;
    for (size_t i = 0; i < p->size; ++i)
        if (p->time[i] < INFINITY &&
            (first == CALENDAR_NONE || before(p, i, first)))
            first = i;
    return first;
}

/* Two events may be a pair, and then either of them is the first. */
static bool same_pair(const struct plain *p, size_t a, size_t b)
{
    return a == b || (a != CALENDAR_NONE && b != CALENDAR_NONE &&
                      !before(p, a, b) && !before(p, b, a));
}

/* Says whether each event that has a time is in one list, and no other. */
static bool is_whole(const struct calendar *c, const struct plain *p)
{
    size_t seen = 0;
    for (size_t day = 0; day <= c->days; ++day)
        for (uint32_t e = c->day[day]; e < c->size; e = c->event[e].next) {
            if (!(p->time[e] < INFINITY) || ++seen > c->size)
                return false;
        }
    return seen == c->count;
}

static void put(struct calendar *c, struct plain *p, size_t event,
                double time, size_t partner)
{
    p->time[event] = time;
    p->partner[event] = (uint32_t)partner;
    c->event[event].partner = (uint32_t)partner;
    calendar_put(c, (uint32_t)event, time);
}

static void begin(struct calendar *c, struct plain *p, size_t size,
                  double start, double width)
{
    p->size = size;
    UNIT_MUST(calendar_create(c, size, start, width));
    for (size_t i = 0; i < size; ++i) {
        p->time[i] = INFINITY;
        p->partner[i] = 0;
    }
}

/* A time that comes after now, mostly; sometimes never. */
static double choose(struct random *r, double now, const struct spread *s)
{
    const uint64_t kind = random_below(r, 20);
    const double u = random_uniform(r);
    const double later = kind == 0   ? INFINITY
                         : kind == 1 ? 0
                         : kind == 2 ? -s->early * u
                         : kind < 5  ? s->far * u
                                     : s->near * u;
    if (s->levels > 0 && later < INFINITY)
        return now + floor(later / s->near * s->levels) / s->levels;
    return now + later;
}

/* Plays with the calendar: the first event gets a new time, and so do
   others, as after a collision. Counts where it is wrong. */
static int play(struct calendar *c, struct plain *p, int turns,
                double start, const struct spread *s, struct random *r)
{
    double now = start;
    int bad = 0;
    for (int k = 0; k < turns; ++k) {
        const size_t first = plain_first(p), got = calendar_first(c);
        bad += !same_pair(p, first, got);
        if (first != CALENDAR_NONE)
            now = fmax(now, p->time[first]);
        if (got != CALENDAR_NONE)
            put(c, p, got, choose(r, now, s), random_below(r, p->size));
        for (uint64_t i = random_below(r, 3); i > 0; --i)
            put(c, p, random_below(r, p->size), choose(r, now, s),
                random_below(r, p->size));
        if (k % 200 == 0)
            bad += !is_whole(c, p);
    }
    return bad;
}

/* Takes out one event after another: the times never fall. */
static int drain(struct calendar *c, struct plain *p)
{
    int bad = 0;
    for (size_t left = c->count; left > 0; --left) {
        const size_t first = plain_first(p), got = calendar_first(c);
        bad += !same_pair(p, first, got) || c->count != left;
        put(c, p, got, INFINITY, 0);
    }
    return bad + (calendar_first(c) != CALENDAR_NONE) + (c->count != 0);
}

static int mix(size_t size, double width, double start,
               const struct spread *s, uint64_t seed, int turns)
{
    static struct plain p;
    SEEDED(r, seed);
    MADE(calendar, c, begin(&c, &p, size, start, width));
    for (size_t i = 0; i < size; ++i)
        put(&c, &p, i, choose(&r, start, s), random_below(&r, size));
    const int bad = play(&c, &p, turns, start, s, &r) + drain(&c, &p);
    return bad;
}

static const struct spread spreads[] = {
    {1, 1, 0, 0}, {1, 1e7, 1, 0}, {1, 50, 3, 3}, {1, 1e3, 0, 100}};

TEST(test_against_plain, "events come out as from a plain array")
{
    static const size_t sizes[] = {1, 2, 3, 10, 100, 400};
    uint64_t seed = 0;
    for (size_t n = 0; n < 6; ++n)
        for (int s = 0; s < 4; ++s)
            for (int k = 0; k < 3; ++k) {
                const double start = k == 0 ? 0 : k == 1 ? -7.3 : 1e6;
                const double width = 1 / (double)sizes[n];
                UNIT_EQUAL(
                    mix(sizes[n], width, start, &spreads[s], ++seed, 2000),
                    0);
            }
}

TEST(test_wrong_widths, "wrong widths make nothing wrong")
{
    static const double widths[] = {1e-300, 1e-15, 1e-9, 1e-4,
                                    1e4,    1e9,   1e300};
    for (int w = 0; w < 7; ++w)
        for (int s = 0; s < 4; ++s)
            UNIT_EQUAL(mix(100, widths[w], w % 2 ? 0 : 1e6, &spreads[s],
                           (uint64_t)(10 * w + s), 2000),
                       0);
}

TEST(test_ties, "equal times come in the order of pairs")
{
    for (uint64_t seed = 1; seed <= 5; ++seed) {
        static struct plain p;
        SEEDED(r, seed);
        MADE(calendar, c, begin(&c, &p, 300, 0, seed == 5 ? 100 : 0.01));
        for (int k = 0; k < 900; ++k)
            put(&c, &p, random_below(&r, 300), k % 2 ? 2.0 : 1.0,
                random_below(&r, 300));
        UNIT_EQUAL(drain(&c, &p), 0);
    }
}

TEST(test_partners, "walls and the event itself are partners")
{
    static struct plain p;
    MADE(calendar, c, begin(&c, &p, 4, 0, 1));
    put(&c, &p, 3, 1, 3);
    put(&c, &p, 1, 1, 5); /* a wall */
    put(&c, &p, 2, 1, 1);
    put(&c, &p, 0, 2, 1);
    UNIT_EQUAL(calendar_first(&c), 2); /* 1, 2 before 1, wall */
    put(&c, &p, 2, 3, 1);
    UNIT_EQUAL(calendar_first(&c), 1);
    put(&c, &p, 1, INFINITY, 5);
    UNIT_EQUAL(calendar_first(&c), 3);
    put(&c, &p, 3, INFINITY, 5);
    UNIT_EQUAL(calendar_first(&c), 0);
}

TEST(test_bursts, "bursts at one time come out in order")
{
    static struct plain p;
    SEEDED(r, 9);
    int bad = 0;
    MADE(calendar, c, begin(&c, &p, 500, 0, 0.01));
    for (int burst = 1; burst <= 8; ++burst) {
        const double time = burst * burst * 1e3;
        for (size_t i = 0; i < 500; ++i)
            put(&c, &p, i, i % 7 ? time : time + 1e-9 * (double)i,
                random_below(&r, 500));
        for (int k = 0; k < 400; ++k) {
            const size_t got = calendar_first(&c);
            bad += !same_pair(&p, plain_first(&p), got);
            put(&c, &p, got, k % 3 ? time : time + 1e-6, got);
        }
    }
    UNIT_EQUAL(bad + drain(&c, &p), 0);
}

TEST(test_overdue, "what is overdue comes first")
{
    static struct plain p;
    MADE(calendar, c, begin(&c, &p, 5, 10, 0.5));
    put(&c, &p, 0, 1000, 1);
    UNIT_EQUAL(calendar_first(&c), 0);
    put(&c, &p, 1, 20, 0);
    UNIT_EQUAL(calendar_first(&c), 1);
    put(&c, &p, 2, -1e300, 0);
    UNIT_EQUAL(calendar_first(&c), 2);
    put(&c, &p, 3, -INFINITY, 0);
    UNIT_EQUAL(calendar_first(&c), 3);
    put(&c, &p, 3, 1e300, 0);
    UNIT_EQUAL(calendar_first(&c), 2);
    UNIT_EQUAL(drain(&c, &p), 0);
}

TEST(test_edges, "taken out, put again, freed twice")
{
    static struct plain p;
    struct calendar c;
    begin(&c, &p, 3, 0, 1);
    UNIT_TRUE(calendar_first(&c) == CALENDAR_NONE);
    put(&c, &p, 2, INFINITY, 0);
    UNIT_EQUAL(c.count, 0);
    put(&c, &p, 2, 5, 0);
    put(&c, &p, 2, 4, 0);
    UNIT_EQUAL(c.count, 1);
    put(&c, &p, 2, INFINITY, 0);
    put(&c, &p, 2, INFINITY, 0);
    UNIT_EQUAL(c.count, 0);
    UNIT_TRUE(calendar_first(&c) == CALENDAR_NONE);
    put(&c, &p, 1, 1e9, 0);
    UNIT_EQUAL(calendar_first(&c), 1);
    calendar_free(&c);
    calendar_free(&c);
    UNIT_TRUE(c.event == NULL && c.day == NULL);
}

/* Plays without a plain array to compare with, a large calendar: each
   event comes again after 1 s on the average. Returns events in a day. */
static double events_in_a_day(size_t size, double width, uint64_t turns)
{
    struct calendar c;
    SEEDED(r, 3);
    if (!calendar_create(&c, size, 0, width))
        return NAN;
    for (uint32_t i = 0; i < size; ++i)
        calendar_put(&c, i, 2 * random_uniform(&r));
    for (uint64_t k = 0; k < turns; ++k) {
        const uint32_t first = calendar_first(&c);
        calendar_put(&c, first,
                     c.event[first].time + 2 * random_uniform(&r));
    }
    const double events = c.width * (double)size;
    calendar_free(&c);
    return events;
}

/* Whatever it was told, a calendar soon has a few events in each day. */
TEST(test_width_is_mended, "the calendar mends its width")
{
    enum { SIZE = 20000 };
    UNIT_NEAR(events_in_a_day(SIZE, 1e-4, 20 * SIZE), 2, 1.5);
    UNIT_NEAR(events_in_a_day(SIZE, 1e-7, 20 * SIZE), 2, 1.5);
    UNIT_NEAR(events_in_a_day(SIZE, 1e-2, 20 * SIZE), 2, 1.5);
}

/* A year ends where no event is left in it, and the next begins with the
   next event; its days are as long as would have held two events each, but
   no more than four times longer or shorter. An event put on the last bit
   of the year is of the next. */
TEST(test_years, "a year begins with its first event")
{
    static const struct {
        int asked;
        double factor;
    } years[] = {{0, 4},     {30, 4},     {32, 130 / 33.0}, {129, 1},
                 {259, 0.5}, {519, 0.25}, {520, 0.25},      {2000, 0.25}};
    for (size_t k = 0; k < sizeof years / sizeof years[0]; ++k) {
        static struct plain p;
        MADE(calendar, c, begin(&c, &p, 1, 100, 2));
        UNIT_EQUAL(c.days, 65);
        put(&c, &p, 0, 100.5, 0);
        for (int i = 0; i < years[k].asked; ++i)
            UNIT_EQUAL(calendar_first(&c), 0);
        UNIT_EQUAL(c.asked, years[k].asked);
        put(&c, &p, 0, nextafter(230, 0), 0);
        UNIT_EQUAL(c.day[64], 0);
        put(&c, &p, 0, 230, 0);
        UNIT_EQUAL(c.day[64], 1);
        UNIT_EQUAL(c.day[65], 0);
        put(&c, &p, 0, 230 + 1000 * (double)k, 0);
        UNIT_EQUAL(calendar_first(&c), 0);
        UNIT_EQUAL(c.begin, 230 + 1000 * (double)k);
        UNIT_NEAR(c.width, 2 * years[k].factor, 1e-15);
        UNIT_EQUAL(c.today, 0);
        UNIT_EQUAL(c.asked, 1);
    }
}

/* Days in which more than eight others have to be looked at for each event,
   and for each day of the year, become a quarter as long, from today on,
   unless the clock has no shorter ones; the events keep their times. */
TEST(test_shorter_days, "a crowded day becomes shorter")
{
    enum { CROWD = 101 };
    for (int last = 0; last < 2; ++last) {
        static struct plain p;
        const double width = last ? 0x1p-52 : 8, start = last ? 1 : 16;
        MADE(calendar, c, begin(&c, &p, CROWD, start, width));
        const uint64_t days = c.days;
        UNIT_EQUAL(days, CROWD + 64);
        for (size_t i = 0; i < CROWD; ++i)
            put(&c, &p, i,
                start + width * (3 + (last ? 0 : (double)i / 128)), 0);
        uint64_t asked = 0;
        for (; 100 * asked <= 8 * (asked + days); ++asked) {
            UNIT_EQUAL(calendar_first(&c), 0);
            UNIT_EQUAL(c.looked, 100 * ((double)asked + 1));
            UNIT_EQUAL(c.today, 3);
        }
        UNIT_EQUAL(c.width, width);
        UNIT_EQUAL(calendar_first(&c), 0);
        UNIT_EQUAL(c.asked, 1);
        UNIT_EQUAL(c.width, last ? width : width / 4);
        UNIT_EQUAL(c.begin, last ? start : start + 3 * width);
        UNIT_TRUE(is_whole(&c, &p));
        UNIT_EQUAL(drain(&c, &p), 0);
    }
}
