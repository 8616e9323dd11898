/* The suite of exercise 05f, "What is still true in a heap". */

#include "examiner/check.h"
#include "toolbox/random.h"
#include <limits.h>
#include <stdio.h>
#include "call.h"

enum { BODIES = 4, MOST = 300 };

struct job {
    size_t n;
    struct event heap[MOST];
    unsigned counts[BODIES];
};

/* What the student's function answers; an untouched place reads as NaN. */
struct answer {
    double next, stale;
};

static struct answer answer(const struct job *j)
{
    const size_t untouched = (size_t)-1;
    size_t stale = untouched;
    struct answer a;
    a.next = (double)next_valid(j->n, j->heap, j->counts, &stale);
    a.stale = stale == untouched ? CHECK_EMPTY : (double)stale;
    return a;
}

static const char *input(const struct job *j)
{
    char list[400] = "";
    size_t used = 0, k = 0;
    for (; k < j->n && used < 340; ++k) {
        const struct event e = j->heap[k];
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "; %zu: %g s, %zu and %zu (%u, %u)", k,
                                 e.time, e.i, e.j, e.count_i, e.count_j);
    }
    return check_text("%zu events, counters {%u, %u, %u, %u}%s%s", j->n,
                      j->counts[0], j->counts[1], j->counts[2],
                      j->counts[3], list, k < j->n ? "; ..." : "");
}

/* Whether an event is good, and what the slips take for it. */

static bool good(const struct job *j, const struct event *e)
{
    return e->count_i == j->counts[e->i] && e->count_j == j->counts[e->j];
}

static bool first_counter(const struct job *j, const struct event *e)
{
    return e->count_i == j->counts[e->i];
}

static bool second_counter(const struct job *j, const struct event *e)
{
    return e->count_j == j->counts[e->j];
}

static bool crossed(const struct job *j, const struct event *e)
{
    return e->count_i == j->counts[e->j] && e->count_j == j->counts[e->i];
}

static bool not_older(const struct job *j, const struct event *e)
{
    return e->count_i >= j->counts[e->i] && e->count_j >= j->counts[e->j];
}

/* The earliest event of those taken for good, by looking at them all. */
static size_t earliest(const struct job *j,
                       bool (*holds)(const struct job *,
                                     const struct event *))
{
    size_t next = j->n;
    for (size_t k = 0; k < j->n; ++k)
        if (holds(j, &j->heap[k]) &&
            (next == j->n || j->heap[k].time < j->heap[next].time))
            next = k;
    return next;
}

static size_t first_in_array(const struct job *j)
{
    size_t k = 0;
    while (k < j->n && !good(j, &j->heap[k]))
        ++k;
    return k;
}

/* Down from the top, always to the earlier child. */
static size_t one_path_down(const struct job *j)
{
    size_t k = 0;
    while (k < j->n && !good(j, &j->heap[k])) {
        const size_t left = 2 * k + 1, right = left + 1;
        k = right < j->n && j->heap[right].time < j->heap[left].time ? right
                                                                     : left;
    }
    return k < j->n ? k : j->n;
}

static size_t earlier_than(const struct job *j, size_t next)
{
    size_t count = 0;
    for (size_t k = 0; k < j->n; ++k)
        if (next == j->n || j->heap[k].time < j->heap[next].time)
            ++count;
    return count;
}

static size_t all_stale(const struct job *j)
{
    size_t count = 0;
    for (size_t k = 0; k < j->n; ++k)
        if (!good(j, &j->heap[k]))
            ++count;
    return count;
}

/* The stale events below which one has to look. */
static size_t passed(const struct job *j, size_t k)
{
    return k < j->n && !good(j, &j->heap[k])
               ? 1 + passed(j, 2 * k + 1) + passed(j, 2 * k + 2)
               : 0;
}

static void check_next(const struct job *j, double got, size_t next)
{
    const size_t crosswise = earliest(j, crossed);
    CHECK_NEAR(
        got, .quantity = "number of the next event", .input = input(j),
        .expected = (double)next, .because = "a place in an array is exact",
        .mistakes = {
            {"top-unchecked", 0.0,
             "This is the top of the heap, and it is stale. Which two "
             "numbers tell so, and with what must they be compared?"},
            {"one-counter", (double)earliest(j, first_counter),
             "One of the two bodies has collided since this event was "
             "foretold, and its path is another one now. Whose counter did "
             "you compare?"},
            {"one-counter", (double)earliest(j, second_counter),
             "One of the two bodies has collided since this event was "
             "foretold, and its path is another one now. Whose counter did "
             "you compare?"},
            {"one-path-down", (double)one_path_down(j),
             "A stale event was left by way of its earlier child, and only "
             "that. What if this child is stale as well: who says that the "
             "best is below it, and not on the other side?"},
            {"counters-crossed", crosswise < j->n ? (double)crosswise : NAN,
             "The counters of the event and those of the bodies were "
             "compared crosswise. Whose counter is count_i, and whose "
             "count_j?"},
            {"first-in-the-array", (double)first_in_array(j),
             "This is the first good event of the array, but a heap is not "
             "sorted. What does its order promise about an event and its "
             "children, and what about two brothers?"},
            {"older-not-different", (double)earliest(j, not_older),
             "A counter that is full goes on from 0, and is smaller then "
             "than it was. What does it mean when it is not the one that "
             "the event has noted, larger or smaller?"}});
}

static void check_stale(const struct job *j, double got, size_t next,
                        size_t stale)
{
    CHECK_NEAR(
        got, .quantity = "*stale, the stale events before the next one",
        .input = input(j), .expected = (double)stale,
        .because = "a number of events is exact",
        .mistakes = {
            {"passed-on-the-way", (double)passed(j, 0),
             "These are the stale events that you looked at on the way. "
             "Some of them are later than the one that you found. Must a "
             "program throw them away to come to it?"},
            {"place-in-the-array", (double)next,
             "This is how many stand before it in the array. A heap is not "
             "sorted: does whoever stands before it come earlier as well?"},
            {"all-the-stale", (double)all_stale(j),
             "So many are stale in the whole heap, and some of them come "
             "after the next event. Which ones stand before it in time?"},
            {"counts-the-good-one",
             (double)stale + (next < j->n ? 1.0 : 0.0),
             "The event that you return is not stale. Is it among those "
             "that you have counted?"}});
}

static void check_known(const struct job *j, size_t next, size_t stale)
{
    const struct answer a = answer(j);
    check_next(j, a.next, next);
    check_stale(j, a.stale, next, stale);
}

static void check_both(const struct job *j)
{
    const size_t next = earliest(j, good);
    check_known(j, next, earlier_than(j, next));
}

static void test_good_top(void)
{
    static const struct job all_good = {4,
                                        {{1.0, 0, 1, 3, 5},
                                         {2.0, 2, 3, 5, 7},
                                         {1.5, 1, 2, 5, 5},
                                         {3.0, 0, 1, 3, 5}},
                                        {3, 5, 5, 7}};
    static const struct job alone = {1, {{4.5, 2, 0, 8, 1}}, {1, 0, 8, 0}};
    check_ask("All counters agree, so nothing is stale here. Where does a "
              "heap keep its earliest event?");
    check_both(&all_good);
    check_both(&alone);
}

static void test_stale_top(void)
{
    static const struct job j = {7,
                                 {{1.0, 0, 1, 2, 4},
                                  {1.5, 0, 1, 2, 5},
                                  {2.0, 1, 2, 5, 1},
                                  {5.0, 0, 1, 3, 5},
                                  {3.5, 2, 3, 2, 7},
                                  {3.0, 2, 3, 2, 7},
                                  {3.25, 0, 2, 3, 2}},
                                 {3, 5, 2, 7}};
    check_ask("Cross out the stale events in a drawing of this heap. Which "
              "of those left is the earliest?");
    check_both(&j);
}

static void test_other_side(void)
{
    static const struct job j = {5,
                                 {{1.0, 0, 1, 2, 4},
                                  {2.0, 1, 2, 4, 2},
                                  {3.0, 2, 3, 2, 7},
                                  {4.0, 0, 1, 3, 5},
                                  {5.0, 1, 3, 5, 7}},
                                 {3, 5, 2, 7}};
    check_ask("The earlier child of the top is stale, too. Where may the "
              "best event stand now?");
    check_both(&j);
}

static void test_count(void)
{
    static const struct job j = {11,
                                 {{1.0, 0, 1, 2, 4},
                                  {4.0, 1, 2, 4, 2},
                                  {2.0, 2, 3, 1, 7},
                                  {5.0, 0, 3, 2, 6},
                                  {4.5, 0, 1, 3, 5},
                                  {3.5, 0, 2, 2, 2},
                                  {3.0, 1, 3, 5, 7},
                                  {6.0, 2, 3, 2, 7},
                                  {7.0, 1, 2, 5, 2},
                                  {8.0, 0, 1, 1, 1},
                                  {9.0, 2, 3, 0, 3}},
                                 {3, 5, 2, 7}};
    check_ask("A program throws the top away as long as it is stale. How "
              "often, before the next event is at the top?");
    check_both(&j);
}

static void test_none(void)
{
    static const struct job stale = {4,
                                     {{1.0, 0, 1, 2, 5},
                                      {1.5, 1, 2, 4, 2},
                                      {1.25, 0, 3, 2, 7},
                                      {1.75, 2, 3, 2, 6}},
                                     {3, 5, 2, 7}};
    static const struct job empty = {0, {{0}}, {3, 5, 2, 7}};
    check_ask("Every event is stale. What was to be returned then, and how "
              "many has a program to throw away?");
    check_both(&stale);
    check_ask("There is no event in this heap, not even a top. Which of "
              "your lines looks at it all the same?");
    check_both(&empty);
}

/* A heap of n events: each comes a little after its parent, and one out of
   `rarity` or so is good. */
static struct job large(size_t n, unsigned rarity, unsigned seed)
{
    struct job j = {.n = n, .counts = {40, 12, 33, 71}};
    struct random r;
    random_seed(&r, seed);
    for (size_t k = 0; k < n; ++k) {
        struct event *e = &j.heap[k];
        e->time = (k > 0 ? j.heap[(k - 1) / 2].time : 0.0) +
                  random_between(&r, 0.01, 1.0);
        e->i = random_below(&r, BODIES - 1);
        e->j = e->i + 1;
        const bool fresh = random_below(&r, rarity) == 0;
        e->count_i = j.counts[e->i] - (fresh ? 0 : 1);
        e->count_j =
            j.counts[e->j] - (unsigned)random_below(&r, fresh ? 1 : 3);
    }
    return j;
}

static void test_large(void)
{
    check_ask("In this larger heap your answer is not that of somebody who "
              "looked at every event. Which part of the heap have you left "
              "out, and why?");
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const struct job j = large(seed * 5, 3 + seed, seed);
        check_both(&j);
    }
}

static void test_run_over(void)
{
    static const struct job j = {3,
                                 {{1.0, 1, 2, 4, 1},
                                  {2.0, 0, 3, UINT_MAX, UINT_MAX},
                                  {3.0, 1, 2, 5, 2}},
                                 {0, 5, 2, 0}};
    check_ask(
        "The counters of bodies 0 and 3 were full and have gone on from 0. "
        "When does a counter agree with what an event has noted?");
    check_both(&j);
}

/* Fills a heap in the order of time: the top first, and then any place
   whose parent has been filled. order[k] is the place of the k-th event. */
static void draw_order(size_t n, size_t order[])
{
    size_t open[MOST], opened = 1;
    open[0] = 0;
    for (size_t k = 0; k < n; ++k) {
        const size_t one = (size_t)check_draw_whole(0, (int)opened - 1);
        const size_t place = open[one];
        order[k] = place;
        open[one] = open[--opened];
        for (size_t child = 2 * place + 1;
             child < n && child <= 2 * place + 2; ++child)
            open[opened++] = child;
    }
}

/* An event between two bodies, which agrees with both counters or is one to
   three collisions behind one of them, or both. */
static struct event draw_event(const struct job *j, double time,
                               bool is_good)
{
    const size_t a = (size_t)check_draw_whole(0, BODIES - 1);
    const size_t b = (a + (size_t)check_draw_whole(1, 3)) % BODIES;
    struct event e = {time, a, b, j->counts[a], j->counts[b]};
    const int behind = is_good ? 0 : check_draw_whole(1, 3);
    if (behind != 2)
        e.count_i -= is_good ? 0 : (unsigned)check_draw_whole(1, 3);
    if (behind >= 2)
        e.count_j -= (unsigned)check_draw_whole(1, 3);
    return e;
}

/* Made from the answer: in the order of time so many events are stale, the
   one after them is good, and of the others half are. Some counters have
   run over. */
CHECK_TIMES(60, test_drawn, i)
{
    struct job j = {.n = (size_t)check_draw_whole(1, 40)};
    size_t order[MOST];
    const size_t stale =
        i % 10 == 9 ? j.n : (size_t)check_draw_whole(0, (int)j.n - 1);
    for (size_t b = 0; b < BODIES; ++b)
        j.counts[b] = (unsigned)check_draw_whole(0, 9);
    draw_order(j.n, order);
    double time = 0.0;
    for (size_t k = 0; k < j.n; ++k) {
        time += check_draw(0.01, 1.0);
        j.heap[order[k]] = draw_event(
            &j, time, k == stale || (k > stale && check_draw_whole(0, 1)));
    }
    check_ask(check_text("This heap was filled with %zu stale events "
                         "first. Which of them has led you astray?",
                         stale));
    check_known(&j, stale < j.n ? order[stale] : j.n, stale);
}

const struct check_suite check_suite = {
    .file = "05f-stale.c",
    .title = "What is still true in a heap",
    .minutes = 25,
    .equation = "eq:heap",
    .tests = {{"a top that is good is the next event", test_good_top, 1, 0},
              {"stale events are passed over", test_stale_top, 1, 0},
              {"the next event may stand on the other side",
               test_other_side, 2, 0},
              {"only what is earlier is counted", test_count, 2, 0},
              {"where nothing is good nothing is found", test_none, 1, 0},
              {"large heaps give what a look at every event gives",
               test_large, 2, 0},
              {"a counter may run over", test_run_over, 1, 0},
              {"sixty heaps are filled in the order of time", test_drawn, 1,
               3},
              {0}},
    .idle = {test_good_top},
};
