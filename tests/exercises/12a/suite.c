/* The suite of exercise 12a, "The Pareto front". */

#include "examiner/check.h"
#include <stdio.h>
#include <string.h>
#include "call.h"

enum { MOST = 40 };

struct choices {
    size_t n;
    struct choice choice[MOST + 1];
};

struct list {
    size_t count, index[MOST + 1];
};

enum { UNTOUCHED = 777, BEHIND = 999 };

/* What the student's function answers. Behind the last choice stands one
   that would beat all others, and does not belong to them. */
static struct list answer(const struct choices *c)
{
    struct choices all = *c;
    struct list l = {.count = 0};
    for (size_t i = 0; i < c->n; ++i)
        l.index[i] = UNTOUCHED;
    l.index[c->n] = BEHIND;
    all.choice[c->n] = (struct choice){0.0, 0.0};
    l.count = pareto_front(c->n, all.choice, l.index);
    return l;
}

static const char *input(const struct choices *c)
{
    char list[420] = "";
    size_t used = 0;
    for (size_t i = 0; i < c->n && used < 360; ++i)
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "%s%zu: %.15g and %.15g", i ? "; " : "", i,
                                 c->choice[i].cost, c->choice[i].error);
    return check_text("%zu choice%s%s%s%s", c->n, c->n == 1 ? "" : "s",
                      c->n ? ", cost and error of " : "", list,
                      used < 360 ? "" : "; ...");
}

/* ---- the slips: the same question with a word wrong in it ---- */

enum slip {
    BOTH_OUT,
    ONE_OF_EQUALS,
    TIES_STAY,
    UPSIDE_DOWN,
    BLOWN_UP,
    AS_GIVEN,
    BY_ERROR,
    NEIGHBOURS,
    UNSORTED,
    SLIPS
};

/* Whether a puts b out, as the slip has it. */
static bool puts_out(enum slip slip, const struct choice *a,
                     const struct choice *b)
{
    const double less = b->cost - a->cost, better = b->error - a->error;
    if (slip == UPSIDE_DOWN)
        return less <= 0.0 && better <= 0.0 && less + better < 0.0;
    if (slip == TIES_STAY)
        return less > 0.0 && better > 0.0;
    if (slip == UNSORTED)
        return a < b && better >= 0.0;
    return less >= 0.0 && better >= 0.0 &&
           (less + better > 0.0 || slip == BOTH_OUT ||
            (slip == ONE_OF_EQUALS && a < b));
}

/* Before b in the list of the slip? */
static bool earlier(enum slip slip, const struct choice *a,
                    const struct choice *b)
{
    const double by =
        slip == BY_ERROR ? a->error - b->error : a->cost - b->cost;
    if (slip == AS_GIVEN || slip == UNSORTED || !(fabs(by) > 0.0))
        return a < b;
    return by < 0.0;
}

/* Those that keep[] has, in the order of the slip. */
static struct list ordered(enum slip slip, const struct choices *c,
                           const bool keep[])
{
    struct list l = {.count = 0};
    bool used[MOST] = {false};
    for (;;) {
        size_t next = c->n;
        for (size_t i = 0; i < c->n; ++i)
            if (keep[i] && !used[i] &&
                (next == c->n ||
                 earlier(slip, &c->choice[i], &c->choice[next])))
                next = i;
        if (next == c->n)
            return l;
        used[next] = true;
        l.index[l.count++] = next;
    }
}

/* All in the order of costs, each held against the one before it. */
static struct list against_neighbours(const struct choices *c)
{
    bool keep[MOST];
    struct list all, kept = {.count = 0};
    for (size_t i = 0; i < c->n; ++i)
        keep[i] = isfinite(c->choice[i].error);
    all = ordered(NEIGHBOURS, c, keep);
    for (size_t k = 0; k < all.count; ++k)
        if (k == 0 || c->choice[all.index[k]].error <=
                          c->choice[all.index[k - 1]].error)
            kept.index[kept.count++] = all.index[k];
    return kept;
}

static struct list slipped(enum slip slip, const struct choices *c)
{
    bool keep[MOST];
    if (slip == NEIGHBOURS)
        return against_neighbours(c);
    for (size_t i = 0; i < c->n; ++i) {
        keep[i] = slip == BLOWN_UP || isfinite(c->choice[i].error);
        for (size_t j = 0; j < c->n; ++j)
            if (j != i && isfinite(c->choice[j].error) &&
                puts_out(slip, &c->choice[j], &c->choice[i]))
                keep[i] = false;
    }
    return ordered(slip, c, keep);
}

static bool same(const struct list *a, const struct list *b)
{
    return a->count == b->count &&
           memcmp(a->index, b->index, a->count * sizeof a->index[0]) == 0;
}

/* The slips that explain the whole answer, with the number that they are
   to explain here. */
static void explain(const struct choices *c, const struct list *got,
                    double value, struct check_mistake mistakes[8])
{
    static const struct {
        const char *name, *hint;
    } slip[SLIPS] = {
        {"both-equals-out",
         "Two that are equal in cost and error have put each other out "
         "here. Is one of them better than the other in anything?"},
        {"one-of-equals", "Of two that are equal in cost and error only "
                          "one is left. Which of them beats the other?"},
        {"ties-stay",
         "Some of these cost the same as another one and err more, or the "
         "other way round. Must one be better in both to beat another?"},
        {"upside-down", "These are the worst: nobody is dearer and errs "
                        "more. Which way do the comparisons go?"},
        {"blown-up-counted", "Here stands a run that blew up. Is it of use "
                             "to anybody, however cheap it was?"},
        {"order-as-given",
         "The right ones are there, in the order in which they were given. "
         "Which order was wanted?"},
        {"order-of-errors", "The right ones are there, the best error "
                            "first. Which order was wanted?"},
        {"only-the-neighbour",
         "This holds each one against the next cheaper one only. Might one "
         "that is cheaper still be better?"},
        {"not-sorted", "This keeps whoever errs less than those before it "
                       "in the list. Are they the cheaper ones?"}};
    int used = 0;
    for (int i = 0; i < SLIPS && used < 8; ++i) {
        const struct list l = slipped((enum slip)i, c);
        if (same(&l, got))
            mistakes[used++] =
                (struct check_mistake){slip[i].name, value, slip[i].hint};
    }
}

static void check_number(const struct choices *c, const struct list *got,
                         const char *quantity, double number,
                         double expected)
{
    struct check check = {.quantity = quantity,
                          .input = input(c),
                          .expected = expected,
                          .because = "a number of things is exact"};
    if (got->count <= c->n)
        explain(c, got, number, check.mistakes);
    check_near(number, check);
}

static void check_front(const struct choices *c,
                        const struct list *expected)
{
    const struct list got = answer(c);
    check_number(c, &got, "how many are on the front", (double)got.count,
                 (double)expected->count);
    for (size_t k = 0; k < expected->count; ++k)
        check_number(c, &got, check_text("front[%zu]", k),
                     (double)got.index[k], (double)expected->index[k]);
    check_number(c, &got, "what stands behind the room for n",
                 (double)got.index[c->n], BEHIND);
}

/* ---- the tests ---- */

static void test_three(void)
{
    check_ask("Take each of them in turn: is there another one that costs "
              "no more and errs no more?");
    const struct choices beaten = {3, {{1, 0.1}, {2, 0.5}, {4, 0.01}}};
    const struct choices all = {3, {{1, 0.1}, {2, 0.05}, {4, 0.01}}};
    const struct choices best = {3, {{1, 0.01}, {2, 0.5}, {4, 0.1}}};
    check_front(&all, &(struct list){3, {0, 1, 2}});
    check_front(&beaten, &(struct list){2, {0, 2}});
    check_front(&best, &(struct list){1, {0}});
}

static void test_few(void)
{
    check_ask(
        "Who is there to beat it? And what if there is nobody at all?");
    const struct choices one = {1, {{3, 0.25}}}, none = {0, {{0, 0}}};
    const struct choices exact = {3, {{3, 0.0}, {0, 0.5}, {1, 0.25}}};
    check_front(&one, &(struct list){1, {0}});
    check_front(&none, &(struct list){0, {0}});
    check_front(&exact, &(struct list){3, {1, 2, 0}});
}

static void test_order(void)
{
    check_ask("The list begins with the cheapest. How do you find the "
              "place of one that comes later?");
    const struct choices falling = {4, {{8, 1}, {6, 2}, {4, 3}, {2, 4}}};
    const struct choices mixed = {
        6, {{5, 2}, {1, 9}, {9, 1}, {4, 6}, {3, 4}, {7, 3}}};
    check_front(&falling, &(struct list){4, {3, 2, 1, 0}});
    check_front(&mixed, &(struct list){4, {1, 4, 0, 2}});
}

/* The third one beats the last, and so does the first one. */
static void test_further(void)
{
    const struct choices c = {5, {{1, 2}, {2, 7}, {3, 1}, {4, 8}, {5, 3}}};
    const struct choices d = {
        6, {{1, 5}, {2, 9}, {3, 6}, {4, 4}, {5, 8}, {6, 7}}};
    check_ask("Is it enough to look at the next cheaper one?");
    check_front(&c, &(struct list){2, {0, 2}});
    check_front(&d, &(struct list){2, {0, 3}});
}

static void test_ties(void)
{
    check_ask("Two cost the same, or err the same. Is one of them better?");
    const struct choices cost = {3, {{2, 5}, {2, 3}, {2, 4}}};
    const struct choices error = {3, {{5, 2}, {3, 2}, {4, 2}}};
    const struct choices corner = {
        5, {{1, 4}, {1, 6}, {3, 2}, {4, 2}, {3, 4}}};
    check_front(&cost, &(struct list){1, {1}});
    check_front(&error, &(struct list){1, {1}});
    check_front(&corner, &(struct list){2, {0, 2}});
}

static void test_equals(void)
{
    check_ask("Some are equal in cost and error. Does one of them beat "
              "another, and which of them comes first?");
    const struct choices two = {3, {{2, 3}, {2, 3}, {1, 4}}};
    const struct choices more = {
        7, {{5, 1}, {2, 3}, {5, 1}, {2, 3}, {4, 3}, {4, 3}, {2, 3}}};
    const struct choices beaten = {3, {{2, 3}, {2, 3}, {2, 2}}};
    check_front(&two, &(struct list){3, {2, 0, 1}});
    check_front(&more, &(struct list){5, {1, 3, 6, 0, 2}});
    check_front(&beaten, &(struct list){1, {2}});
}

static void test_blown_up(void)
{
    check_ask("Some of these runs blew up. Who would choose one of them?");
    const struct choices no_number = {3,
                                      {{1, 0.1}, {0.25, NAN}, {2, 0.01}}};
    const struct choices infinite = {
        3, {{0.5, INFINITY}, {1, 0.1}, {2, 0.01}}};
    const struct choices dear = {
        4, {{5, NAN}, {1, 0.1}, {5, INFINITY}, {1, NAN}}};
    const struct choices all = {3,
                                {{1, NAN}, {2, INFINITY}, {1, INFINITY}}};
    check_front(&no_number, &(struct list){2, {0, 2}});
    check_front(&infinite, &(struct list){2, {1, 2}});
    check_front(&dear, &(struct list){1, {1}});
    check_front(&all, &(struct list){0, {0}});
}

/* Neighbours among the doubles. */
static void test_hair(void)
{
    check_ask(
        "One of these is better by the last binary digit. Is that better?");
    const double more = nextafter(1.0, 2.0);
    const struct choices error = {2, {{1.0, more}, {1.0, 1.0}}};
    const struct choices cost = {2, {{1.0, 1.0}, {more, 1.0}}};
    const struct choices both = {2, {{more, 1.0}, {1.0, more}}};
    const struct choices tiny = {2, {{1.0, 3e-17}, {2.0, 2e-17}}};
    check_front(&error, &(struct list){1, {1}});
    check_front(&cost, &(struct list){1, {0}});
    check_front(&both, &(struct list){2, {1, 0}});
    check_front(&tiny, &(struct list){2, {0, 1}});
}

/* ---- drawn choices ---- */

/* A staircase from the cheapest down to the best, and behind its steps
   some that one of them beats; then all change places. */
static struct choices draw_staircase(struct list *front)
{
    struct choices c = {.n = (size_t)check_draw_whole(1, 12)};
    size_t place[MOST];
    double cost = check_draw(0.0, 2.0), error = 100.0;
    front->count = c.n;
    for (size_t i = 0; i < front->count; ++i) {
        c.choice[i] = (struct choice){cost, error};
        cost += check_draw(0.1, 2.0);
        error *= check_draw(0.2, 0.95);
    }
    for (int more = check_draw_whole(0, 20); more > 0; --more) {
        const struct choice step =
            c.choice[check_draw_whole(0, (int)front->count - 1)];
        const double worse = check_draw(0.1, 4.0);
        c.choice[c.n++] = (struct choice){
            step.cost + (more % 3 == 0 ? 0.0 : worse),
            more % 3 == 1 ? step.error
                          : step.error * (1.0 + check_draw(0.1, 4.0))};
    }
    for (size_t i = 0; i < c.n; ++i)
        place[i] = i;
    for (size_t i = 1; i < c.n; ++i) {
        const size_t j = (size_t)check_draw_whole(0, (int)i);
        const struct choice other = c.choice[i];
        const size_t where = place[i];
        c.choice[i] = c.choice[j];
        c.choice[j] = other;
        place[i] = place[j];
        place[j] = where;
    }
    for (size_t i = 0; i < c.n; ++i)
        if (place[i] < front->count)
            front->index[place[i]] = i;
    return c;
}

CHECK_TIMES(40, test_drawn_staircase, i)
{
    check_ask(
        "Draw the points: who has nobody to the left of and below itself?");
    struct list front;
    const struct choices c = draw_staircase(&front);
    check_front(&c, &front);
}

/* Small whole numbers have many ties and equals. On the front is who has
   the best error of its cost, if that is better than at all lower costs. */
static struct choices draw_crowd(struct list *front)
{
    enum { SIZE = 7 };
    struct choices c = {.n = (size_t)check_draw_whole(0, MOST)};
    int best[SIZE], record = SIZE;
    for (int k = 0; k < SIZE; ++k)
        best[k] = SIZE;
    for (size_t i = 0; i < c.n; ++i) {
        const int cost = check_draw_whole(0, SIZE - 1);
        const int error = check_draw_whole(0, SIZE - 1);
        c.choice[i] = (struct choice){cost, error};
        if (check_draw_whole(0, 5) == 0)
            c.choice[i].error = error % 2 ? NAN : INFINITY;
        else if (error < best[cost])
            best[cost] = error;
    }
    front->count = 0;
    for (int k = 0; k < SIZE; ++k) {
        for (size_t i = 0; i < c.n && best[k] < record; ++i)
            if (!(fabs(c.choice[i].cost - k) > 0.0) &&
                fabs(c.choice[i].error - best[k]) < 0.5)
                front->index[front->count++] = i;
        record = best[k] < record ? best[k] : record;
    }
    return c;
}

CHECK_TIMES(60, test_drawn_crowd, i)
{
    check_ask("Many of these are equal in something. Who is beaten, and by "
              "whom?");
    struct list front;
    const struct choices c = draw_crowd(&front);
    check_front(&c, &front);
}

const struct check_suite check_suite = {
    .file = "12a-front.c",
    .title = "The Pareto front",
    .minutes = 20,
    .equation = "eq:front",
    .tests = {{"three choices, of which one may be beaten", test_three, 2,
               0},
              {"one choice, or none", test_few, 1, 0},
              {"the cheapest first, in whatever order they come",
               test_order, 1, 0},
              {"beaten by one that is much cheaper", test_further, 1, 0},
              {"the same cost, or the same error", test_ties, 1, 0},
              {"the same cost and the same error", test_equals, 1, 0},
              {"a run that blew up", test_blown_up, 1, 0},
              {"better by a hair", test_hair, 1, 0},
              {"drawn staircases with others behind", test_drawn_staircase,
               1, 2},
              {"drawn crowds with many equals", test_drawn_crowd, 1, 2},
              {0}},
};
