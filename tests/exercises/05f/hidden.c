/* The hidden tests of exercise 05f, "What is still true in a heap". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 1000, BODIES = 60 };

struct job {
    size_t n;
    struct event heap[MOST];
    unsigned counts[BODIES];
};

static void check(const struct job *j, size_t got, size_t expected,
                  const char *quantity)
{
    CHECK_NEAR((double)got, .quantity = quantity,
               .input =
                   check_text("%zu events between %d bodies, from %g s on",
                              j->n, BODIES, j->n ? j->heap[0].time : 0.0),
               .expected = (double)expected,
               .because = "a number of events is exact");
}

/* An event that agrees with the counters of its two bodies, or is behind.
 */
static struct event draw_event(const struct job *j, double time,
                               unsigned behind_i, unsigned behind_j)
{
    const size_t a = (size_t)check_draw_whole(0, BODIES - 1);
    const size_t b = (a + (size_t)check_draw_whole(1, BODIES - 1)) % BODIES;
    return (struct event){time, a, b, j->counts[a] - behind_i,
                          j->counts[b] - behind_j};
}

/* All events stand in the order of time, which is a heap as well, but for
   the second half of each generation, which comes before the first half.
   The first `stale` of them are stale. Returns the place of the next. */
static size_t fill(struct job *j, size_t n, size_t stale)
{
    size_t next = n, k = 0;
    double time = 0.0;
    j->n = n;
    for (size_t b = 0; b < BODIES; ++b)
        j->counts[b] = (unsigned)check_draw_whole(0, 3);
    for (size_t first = 0; first < n; first = 2 * first + 1) {
        const size_t size = first + 1 < n - first ? first + 1 : n - first;
        for (size_t i = 0; i < size; ++i, ++k) {
            const size_t place = first + (i + size / 2) % size;
            const unsigned behind =
                (unsigned)(k < stale) +
                (unsigned)(k > stale && check_draw_whole(0, 1));
            time += check_draw(0.01, 1.0);
            j->heap[place] = i % 2 ? draw_event(j, time, behind, 0)
                                   : draw_event(j, time, 0, behind);
            if (k == stale)
                next = place;
        }
    }
    return next;
}

CHECK_TIMES(20, test_hundreds, i)
{
    static struct job j;
    const size_t n = (size_t)check_draw_whole(0, MOST);
    const size_t stale =
        i % 5 == 4 ? n : (size_t)check_draw_whole(0, (int)n);
    const size_t next = fill(&j, n, stale);
    size_t told = n + 1;
    const size_t got = next_valid(n, j.heap, j.counts, &told);
    check(&j, got, next, "number of the next event");
    check(&j, told, stale, "*stale");
}

/* Only equal counters count, and only which time is earlier: all bodies may
   have had more collisions before, and the clock may go at another rate. */
CHECK_TIMES(20, test_other_clock, i)
{
    static struct job j;
    const int n = check_draw_whole(1, 300);
    const size_t stale = (size_t)check_draw_whole(0, n);
    const size_t next = fill(&j, (size_t)n, stale);
    const int second = check_draw_whole(-60, 60);
    unsigned more[BODIES];
    for (size_t b = 0; b < BODIES; ++b) {
        more[b] = 0u - (unsigned)check_draw_whole(0, 6);
        j.counts[b] += more[b];
    }
    for (size_t k = 0; k < j.n; ++k) {
        struct event *e = &j.heap[k];
        e->time = ldexp(e->time, second);
        e->count_i += more[e->i];
        e->count_j += more[e->j];
    }
    size_t told = j.n + 1;
    const size_t got = next_valid(j.n, j.heap, j.counts, &told);
    check(&j, got, next, "number of the next event");
    check(&j, told, stale, "*stale");
}

const struct check_test check_hidden[] = {
    {"hundreds of events between sixty bodies", test_hundreds, 2, 0},
    {"other counters and another clock", test_other_clock, 1, 0},
    {0}};
