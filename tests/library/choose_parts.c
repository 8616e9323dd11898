/* What the chooser is made of, each part by itself against what is found by
   hand: rungs, bills, when a run is kept, which rung comes next, and what
   is said. */
#include "unit.h"

#include "choosing/record.h"

/* Runs are played from a script. */
#define record_run played_run
#define record_both played_both
static void played_run(struct record *r, struct record_view *v,
                       const struct record_setup *o);
static void played_both(struct record *a, struct record *b,
                        struct record_view *v,
                        const struct record_setup *oa,
                        const struct record_setup *ob, double apart);
/* All of src that is private to the chooser. */
#include <choosing/task.c>
#include <choosing/rung.c>
#include <choosing/twins.c>
#include <choosing/reference_run.c>
#include <choosing/climb.c>
#include <choosing/choose.c>

#include "library/plans.h"

/* What the next runs do: they end so after so many of four rows, in all of
   which the only number is the same. */
struct played {
    enum models_end end;
    size_t reached;
    double value, cost, least, clock;
    const char *why;
};
enum { MOST_PLAYED = 20 };
static struct played script[MOST_PLAYED];
static struct record_setup ordered[MOST_PLAYED]; /* what was asked for */
static size_t played, written;

static void played_run(struct record *r, struct record_view *v,
                       const struct record_setup *o)
{
    (void)v;
    UNIT_TRUE(played < written);
    const struct played *p = &script[played];
    ordered[played] = *o;
    played += played + 1 < MOST_PLAYED;
    *r = (struct record){.plan = o->plan,
                         .end = p->end,
                         .reached = p->reached,
                         .value = calloc(5, sizeof(double)),
                         .cost = p->cost,
                         .least = p->least,
                         .clock = p->clock,
                         .twin = o->twin,
                         .why = p->why};
    for (size_t row = 0; row < 5; ++row)
        r->value[row] = p->value;
}

static void played_both(struct record *a, struct record *b,
                        struct record_view *v,
                        const struct record_setup *oa,
                        const struct record_setup *ob, double apart)
{
    UNIT_TRUE(apart > 0);
    played_run(a, v, oa);
    played_run(b, v, ob);
}

static void write_run(struct played p)
{
    script[written++] = p;
}

static void write_whole(double value)
{
    write_run((struct played){MODELS_DONE, 4, value, 1e-3, 1, 0, NULL});
}

static void write_end(enum models_end end, size_t reached)
{
    write_run((struct played){end, reached, 0, 1e-3, 1, 0, NULL});
}

/* Several in a row: whole ones of these values; or their ends. */
#define WHOLE(...)                                                         \
    for (size_t i = 0;                                                     \
         i < sizeof((double[]){__VA_ARGS__}) / sizeof(double); ++i)        \
    write_whole((double[]){__VA_ARGS__}[i])
#define ENDS(...)                                                          \
    for (size_t i = 0;                                                     \
         i < sizeof((int[][2]){__VA_ARGS__}) / sizeof(int[2]); ++i)        \
    write_end((enum models_end)(int[][2]){__VA_ARGS__}[i][0],              \
              (size_t)(int[][2]){__VA_ARGS__}[i][1])

static struct choose_choice choice;
static struct choose_request request;
static struct record_view view;
static struct reference reference;
static const struct task task = {&request, &view, &reference, &choice};

/* Nothing is known yet; errors are shares of 2 m, four rows of 0.5 s. */
static void begin(double tolerance)
{
    choice = (struct choose_choice){.horizon = INFINITY, .rows = 4};
    request = (struct choose_request){
        .program = "choose", .every = 0.5, .tolerance = tolerance};
    request.budget = 100;
    static double weight[1] = {1}, turn[1], last[1];
    view = (struct record_view){.columns = 1,
                                .length = 2,
                                .weight = weight,
                                .period = turn,
                                .rounding = last};
    reference = (struct reference){.seen = 0};
    played = written = 0;
}

static struct scene still; /* none of its bodies is ever asked for */

static void begin_still(double tolerance)
{
    begin(tolerance);
    request.scene = &still;
}

static struct models_plan steps_of(const char *name, uint64_t steps)
{
    return (struct models_plan){.model = models_find(name), .steps = steps};
}

static struct models_plan own_steps_of(double tolerance)
{
    return (struct models_plan){.model = models_find("radau15"),
                                .steps = 1,
                                .tolerance = tolerance};
}

/* Eight numbers of steps to an octave, three tolerances to a decade. */
TEST(test_rungs, "rungs, from the foot on")
{
    static const double known[] = {
        1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16,
        18, 20, 22, 24, 26, 28, 30, 32, 36, 40, 44, 48, 52, 56, 60, 64};
    static const double own[] = {1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005};
    const struct models_plan p = steps_of("leapfrog", 1);
    for (int n = 1; n <= 32; ++n)
        UNIT_EQUAL(nth_rung(p, n).steps, known[n - 1]);
    for (int n = 1; n <= 8; ++n)
        UNIT_EQUAL(nth_rung(own_steps_of(1), n).tolerance, own[n - 1]);
    UNIT_EQUAL(nth_rung(own_steps_of(1), 46).tolerance, 1e-15);
    UNIT_EQUAL(nth_rung(own_steps_of(1), 45).tolerance, 2e-15);
    UNIT_EQUAL(rung_at(p, log2(17)).steps, 18);
    UNIT_EQUAL(rung_at(p, log2(18)).steps, 18);
    UNIT_EQUAL(rung_at(p, log2(18.01)).steps, 20);
    UNIT_EQUAL(rung_at(p, -3).steps, 1);
    UNIT_EQUAL(rung_at(p, 1e9).steps, 0x1p52);
    UNIT_EQUAL(rung_at(own_steps_of(1), -log2(0.0011)).tolerance, 1e-3);
    UNIT_EQUAL(rung_at(own_steps_of(1), -log2(1e-3)).tolerance, 1e-3);
    UNIT_EQUAL(rung_at(own_steps_of(1), -log2(0.99e-3)).tolerance, 5e-4);
    UNIT_EQUAL(rung_at(own_steps_of(1), 1e9).tolerance, 1e-15);
    UNIT_NEAR(finer(own_steps_of(2e-5)).tolerance, 2e-7, 1e-21);
    UNIT_EQUAL(finer(own_steps_of(1e-14)).tolerance, 1e-15);
    struct models_plan q = steps_of("leapfrog", 48);
    UNIT_EQUAL(rung_fineness(&q), log2(48));
    q = own_steps_of(0.125);
    UNIT_EQUAL(rung_fineness(&q), 3);
}

/* What an order is made of: a fifth of a twentieth of what is asked for, if
   the steps are asked for a fifth of the first tolerance; and so on. */
TEST(test_order, "what an order is made of")
{
    begin(1e-6);
    UNIT_NEAR(task_first_tolerance(&task), 1e-4, 1e-18);
    request.tolerance = 1e-3;
    UNIT_EQUAL(task_first_tolerance(&task), 1e-3);
    request.tolerance = 1e-15;
    UNIT_EQUAL(task_first_tolerance(&task), 1e-8);
    request.tolerance = 1e-6;
    choice.spent = 30;
    struct record_setup o = task_setup(&task, own_steps_of(2e-5), 50);
    UNIT_NEAR(o.plan.negligible, 0.2 * 0.05 * 1e-6 * 2, 1e-20);
    UNIT_EQUAL(o.plan.time_left, 2);
    UNIT_EQUAL(o.plan.start_limit, 35);
    UNIT_EQUAL(o.plan.contact_margin, 2e-6);
    UNIT_EQUAL(o.limit, 50);
    UNIT_EQUAL(o.rows, 4);
    UNIT_EQUAL(o.every, 0.5);
    o = task_setup(&task, own_steps_of(1e-2),
                   90); /* coarser than the first */
    UNIT_NEAR(o.plan.negligible, 0.05 * 1e-6 * 2, 1e-20);
    UNIT_EQUAL(o.limit, 70);
    o = task_setup(&task, steps_of("leapfrog", 5), INFINITY);
    UNIT_EQUAL(o.plan.contact_margin, 0);
    UNIT_EQUAL(o.plan.steps, 5);
    choice.spent = 200;
    UNIT_EQUAL(task_budget(&task), 0);
    o = task_setup(&task, steps_of("leapfrog", 5), 1);
    UNIT_EQUAL(o.plan.start_limit, 1e-9);
    UNIT_EQUAL(o.limit, 0);
}

static struct choose_candidate *candidate(const char *name, unsigned cuts)
{
    struct models_plan p = steps_of(name, 1);
    p.cuts = cuts;
    return task_candidate(&task, p);
}

TEST(test_candidates, "a candidate for each way")
{
    begin(1e-6);
    struct choose_candidate *a = candidate("leapfrog", 0);
    UNIT_TRUE(a == choice.candidate && choice.candidates == 1);
    UNIT_TRUE(isinf(a->error) && isinf(a->cost) && isinf(a->foreseen));
    UNIT_TRUE(!a->holds && a->text[0] == '\0');
    UNIT_TRUE(candidate("leapfrog", MODELS_RODS) == a + 1);
    UNIT_TRUE(candidate("pefrl", 0) == a + 2);
    UNIT_TRUE(candidate("leapfrog", 0) == a);
    UNIT_TRUE(candidate("leapfrog", MODELS_RODS) == a + 1);
    UNIT_TRUE(candidate("pefrl", MODELS_RODS) == a + 3);
    UNIT_EQUAL(choice.candidates, 4);
}

TEST(test_endings, "how a run ended")
{
    static const struct {
        enum models_end end;
        const char *text;
    } known[] = {{MODELS_DONE, ""},
                 {MODELS_BROKEN, "breaks down"},
                 {MODELS_STANDSTILL, "collisions without end"},
                 {MODELS_COSTLY, "more expensive than the best"},
                 {MODELS_MEMORY, "no memory"}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        struct record r = {.end = known[k].end};
        UNIT_SAYS(task_ending(&r), known[k].text);
        r.why = "so";
        UNIT_SAYS(task_ending(&r), "so");
    }
}

/* Offers a run of so many steps; returns whether it was taken. */
static bool offered(struct choose_candidate *k, uint64_t steps, double cost,
                    double error)
{
    FREED(record)
    r = {.plan = steps_of(k->plan.model->name, steps),
         .cost = cost,
         .value = calloc(1, sizeof(double))};
    task_consider(&task, k, &r, error);
    const bool taken = !r.value;
    UNIT_TRUE(!taken || choice.run.plan.steps == steps);
    return taken;
}

/* Taken is what holds and costs less than the best; what a candidate did is
   noted until it holds, and then if it holds for less. */
TEST(test_offers, "what is offered is kept if it is better")
{
    begin(1e-3);
    struct choose_candidate *a = candidate("leapfrog", 0);
    struct choose_candidate *b = candidate("pefrl", 0);
    UNIT_TRUE(isinf(task_best_cost(&task)));
    UNIT_TRUE(!offered(a, 3, 1, 1.001e-3));
    UNIT_TRUE(!a->holds && a->error == 1.001e-3 && a->cost == 1);
    UNIT_TRUE(offered(a, 9, 5, 1e-3));
    UNIT_TRUE(a->holds && a->cost == 5 && choice.taken == 0);
    UNIT_EQUAL(task_best_cost(&task), 5);
    UNIT_TRUE(!offered(a, 10, 5, 1e-5) && a->plan.steps == 9);
    UNIT_TRUE(!offered(a, 4, 2, 2e-3) && a->plan.steps == 9);
    UNIT_TRUE(!offered(b, 7, 5, 1e-4) && b->holds && b->cost == 5);
    UNIT_TRUE(choice.taken == 0);
    UNIT_TRUE(offered(b, 6, 4, 1e-4) && b->cost == 4);
    UNIT_TRUE(choice.taken == 1);
    UNIT_TRUE(!offered(a, 8, 4.5, 9e-4) && a->cost == 4.5);
    UNIT_TRUE(!offered(a, 1, 1, INFINITY) && a->cost == 4.5);
    UNIT_EQUAL(choice.points, 7); /* all but the last */
    UNIT_EQUAL(choice.point[0].error, 1.001e-3);
    UNIT_EQUAL(choice.point[6].cost, 4.5);
    UNIT_EQUAL(choice.point[6].plan.steps, 8);
    choice.points = CHOOSE_POINTS - 1;
    offered(a, 1, 1, 1);
    offered(a, 1, 1, 1);
    UNIT_EQUAL(choice.points, CHOOSE_POINTS);
    choose_free(&choice);
}

/* As many twins as these margins are for mislead with one chance. */
TEST(test_margins, "margins have one chance")
{
    const double pi = 3.14159265358979323846;
    for (unsigned k = 1; k <= TWINS; ++k) {
        const double half = (k + 1) / 2.0;
        UNIT_NEAR(pow(2 / twins_margin[k - 1], k) * tgamma(half) *
                      pow(2 * pi * half, -half),
                  6.6e-5, 2.5e-6);
    }
    UNIT_EQUAL(TWINS, 6);
    UNIT_EQUAL(last_margin, twins_margin[TWINS - 1]);
}

TEST(test_horizon, "the horizon is the first that was seen")
{
    struct scene s = {.time = 3};
    begin(1e-3);
    request.scene = &s;
    task_note_horizon(&task, 8, 0.5);
    UNIT_EQUAL(choice.horizon, 7);
    task_note_horizon(&task, 9, 0.5);
    UNIT_EQUAL(choice.horizon, 7);
    task_note_horizon(&task, 0, 0.5);
    UNIT_EQUAL(choice.horizon, 3);
}

/* Two runs agree on the closest contact if both say the same of it but for
   half of the smaller one. */
TEST(test_decided, "two agree on the closest contact")
{
    static const double known[][3] = {
        {1, 1.49, 1},   {1, 1.51, 0},  {1.49, 1, 1}, {1.51, 1, 0},
        {-1, -1.49, 1}, {-1, -1.6, 0}, {1, -1, 0},   {-0.1, 0.1, 0},
        {1, 1.5, 0},    {0, 0, 0},     {3, 4.4, 1},  {2, 2, 1}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        const struct reference f = {.coarser.least = known[k][0],
                                    .run.least = known[k][1]};
        UNIT_TRUE(is_decided(&f) == (known[k][2] > 0));
    }
}

/* A ladder of a method that has been run once. */
static struct ladder ladder(const char *name, uint64_t steps, double error,
                            double cost)
{
    const struct models_plan p = steps_of(name, steps);
    return (struct ladder){.candidate = candidate(name, 0),
                           .foot = steps_of(name, 1),
                           .best = {p, error, cost},
                           .least = log2((double)steps),
                           .most = INFINITY,
                           .rise = 1};
}

TEST(test_rise, "finer steps cost more, or a little more")
{
    struct ladder two[2];
    size_t n = 0;
    begin(1e-6);
    request.scene = &still;
    for (int k = 0; k < 2; ++k) {
        WHOLE(0.5, 0.5, 0.5);
        add_ladder(&task, two, &n, models_find(k ? "dopri5" : "leapfrog"),
                   0);
    }
    UNIT_EQUAL(n, 2);
    UNIT_EQUAL(two[0].rise, 1);
    UNIT_EQUAL(two[1].rise, 1 / 7.0);
}

TEST(test_lost, "errors that say nothing")
{
    begin(1e-6);
    struct ladder l = ladder("leapfrog", 16, 1e-3, 1);
    UNIT_TRUE(!is_lost(0.1) && is_lost(0.1001));
    UNIT_TRUE(!is_blind(&l));
    l.best.error = 0.2;
    UNIT_TRUE(is_blind(&l));
    l.foot.cuts = MODELS_RODS; /* may be what is left out */
    UNIT_TRUE(!is_blind(&l));
    l.best.error = INFINITY;
    UNIT_TRUE(is_blind(&l));
    UNIT_TRUE(is_vain(&l, INFINITY));
    UNIT_TRUE(!is_vain(&l, 1e-3));
    l.best.error = 1e-3;
    UNIT_TRUE(!is_vain(&l, INFINITY));
    UNIT_TRUE(is_vain(&l, 1.0099e-3) && !is_vain(&l, 1.0103e-3));
    UNIT_TRUE(is_vain(&l, 0.9902e-3) && !is_vain(&l, 0.9899e-3));
    l.best.error = 0.2;
    UNIT_TRUE(!is_vain(&l, 0.2));
    l.foot.cuts = 0;
    l.best.error = 1e-3;
    UNIT_TRUE(!is_vain(&l, 1e-3));
}

static void noted(struct ladder *l, uint64_t steps, double error,
                  double cost)
{
    climb_note(
        &task, l,
        (struct choose_point){steps_of("leapfrog", steps), error, cost});
}

/* Between which rungs the next one lies, and which run stands for all: the
   coarsest that holds, or the last that does not. */
TEST(test_notes, "what a run says of the next rung")
{
    begin(1e-6);
    struct ladder l = ladder("leapfrog", 16, 1e-3, 1);
    noted(&l, 32, 1e-4, 2);
    UNIT_TRUE(l.least == 5 && isinf(l.most) && l.best.plan.steps == 32);
    noted(&l, 512, 1e-7, 32);
    UNIT_TRUE(l.least == 5 && l.most == 9 && l.best.plan.steps == 512);
    noted(&l, 128, 1e-6, 8); /* holds, just */
    UNIT_TRUE(l.least == 5 && l.most == 7 && l.best.plan.steps == 128);
    noted(&l, 64, 1e-5, 4);
    UNIT_TRUE(l.least == 6 && l.most == 7 && l.best.plan.steps == 128);
    noted(&l, 32, 1e-5, 4);
    UNIT_TRUE(l.least == 6 && l.most == 7);
    noted(&l, 256, 1e-7, 16);
    UNIT_TRUE(l.most == 7 && l.best.plan.steps == 256);
    l = ladder("leapfrog", 16, 1e-3, 1);
    noted(&l, 64, INFINITY, INFINITY); /* too dear */
    UNIT_TRUE(l.least == 4 && l.most == 6 && l.best.plan.steps == 16);
    noted(&l, 32, INFINITY, 3); /* breaks down */
    UNIT_TRUE(l.least == 5 && l.most == 6 && l.best.plan.steps == 32);
    noted(&l, 36, INFINITY, 3); /* once more */
    UNIT_TRUE(l.most == -INFINITY);
    l = ladder("leapfrog", 16, 1e-3, 1);
    l.foot.cuts = MODELS_RODS;
    noted(&l, 32, 1.001e-3, 1); /* finer steps are no help */
    UNIT_TRUE(l.most == -INFINITY);
    l = ladder("leapfrog", 16, 1e-7, 1);
    l.foot.cuts = MODELS_RODS;
    noted(&l, 8, 1e-7, 0.5); /* but it holds */
    UNIT_TRUE(l.most == 3 && l.best.plan.steps == 8);
}

TEST(test_prices, "what finer steps would cost")
{
    begin(1e-6);
    struct ladder l = ladder("leapfrog", 16, 1e-4, 3);
    UNIT_NEAR(excess(&task, &l), log2(100), 1e-12);
    UNIT_EQUAL(order_of_method(&l), 2);
    UNIT_NEAR(octaves_up(&task, &l), log2(10), 1e-12);
    UNIT_EQUAL(price_of(&l, 2), 12);
    l.rise = 0.5;
    UNIT_EQUAL(price_of(&l, 2), 6);
    l.best.error = 0.1;
    UNIT_EQUAL(octaves_up(&task, &l), 4); /* and no more at once */
    l.best.error = 0.2; /* it says nothing of the order: twice the cost */
    UNIT_EQUAL(octaves_up(&task, &l), 2);
    l.rise = 0.2;
    UNIT_EQUAL(octaves_up(&task, &l), 4);
    l.best.error = 1e-8; /* it holds: coarser ones may */
    UNIT_NEAR(octaves_up(&task, &l), -log2(10), 1e-12);
    l.foot = own_steps_of(1e-6);
    UNIT_EQUAL(order_of_method(&l), 1);
    l.price = 2;
    struct ladder other = {.price = 3};
    UNIT_TRUE(by_price(&l, &other) < 0 && by_price(&other, &l) > 0 &&
              by_price(&l, &l) == 0);
}

static double next_steps(const struct ladder *l)
{
    const struct models_plan p = next_rung(&task, l);
    return p.model ? (double)p.steps : 0;
}

/* The same while the best way costs so much. */
static double next_below(const struct ladder *l, double cost)
{
    double value = 0;
    choice.run.value = &value;
    choice.run.cost = cost;
    const double steps = next_steps(l);
    choice.run.value = NULL;
    return steps;
}

/* A method of second order with 16 steps to a row is off by a hundred times
   what is asked for and costs 1 ms: it needs 160 steps, by its order. If
   there is a better way, an eighth of an octave below its price; and no run
   at all if not even an order of 2.4 could make it cheap enough. */
TEST(test_next, "the next rung")
{
    begin(1e-6);
    struct ladder l = ladder("leapfrog", 16, 1e-4, 1e-3);
    UNIT_EQUAL(next_steps(&l), 160);
    /* 0.98 of that, times 2^(-1/8), is the price of 143.8 steps */
    UNIT_EQUAL(next_below(&l, 0.0100), 144);
    UNIT_EQUAL(next_below(&l, 0.0090), 0);   /* 129.4: 144 are too dear */
    UNIT_EQUAL(next_below(&l, 0.0080), 120); /* 115.04 */
    /* 100.7; 2^(log2(100)/2.4) ms are 6.81 */
    UNIT_EQUAL(next_below(&l, 0.00700), 104);
    UNIT_EQUAL(next_below(&l, 0.00690), 0);
    choice.spent = request.budget - 0.0100 * 0.98; /* or what is left */
    UNIT_EQUAL(next_below(&l, 1e9), 144);
    UNIT_EQUAL(next_steps(&l), 144);
    choice.spent = 0;
    l.best.error = 2e-6; /* one octave: 2^(1/2.4) ms are 1.335 */
    /* an eighth less: 20.3 steps */
    UNIT_EQUAL(next_below(&l, 0.00138 / 0.98), 22);
    /* An error beyond the scale bounds nothing: at twice the cost, if that
       can be paid, whatever the order promises. */
    l.best.error = 1.5;
    UNIT_EQUAL(next_steps(&l), 32);
    UNIT_EQUAL(next_below(&l, 0.00203), 30);
    /* 1.888 ms by an eighth less: 30.2 steps */
    UNIT_EQUAL(next_below(&l, 0.0021), 32);
    /* Within the scale, but lost: twice the cost, if the order from a tenth
       of the scale on could make it: 2^(log2(1e5)/2.4) is 121. */
    l.best.error = 0.5;
    UNIT_EQUAL(next_below(&l, 0.125), 32);
    UNIT_EQUAL(next_below(&l, 0.121), 0);
    /* A method that follows orbits may be of the eighth order. */
    l = ladder("wisdom-holman", 16, 1e-4, 1e-3);
    UNIT_EQUAL(next_below(&l, 0.00189), 28); /* 2^(6.644/8) = 1.778 */
    UNIT_EQUAL(next_below(&l, 0.00181), 0);
    /* It holds with 160, and 96 did not: halfway, in octaves, or where the
       order says, if that is between them. */
    l = ladder("leapfrog", 160, 1e-8, 0.01);
    l.least = log2(96);
    l.most = log2(160);
    UNIT_EQUAL(next_steps(&l), 128);
    l.best.error = 0.5e-6; /* sqrt(1/2) of 160: 113.1 */
    UNIT_EQUAL(next_steps(&l), 120);
    l.least = log2(144);
    UNIT_EQUAL(next_steps(&l), 0); /* no rung between them */
    l.least = log2(128);
    UNIT_EQUAL(next_steps(&l), 144);
    l.best.plan.model = NULL; /* no run at all */
    UNIT_EQUAL(next_steps(&l), 0);
    /* No rung is tried twice. */
    l = ladder("leapfrog", 16, 1.0001e-6, 1e-3);
    UNIT_EQUAL(next_steps(&l), 18);
}

/* What a ladder says on which nothing holds. */
TEST(test_foreseen, "what a ladder promises")
{
    begin(1e-6);
    struct ladder l = ladder("leapfrog", 16, 1e-4, 1e-3);
    struct choose_candidate *k = l.candidate;
    foresee(&task, &l);
    UNIT_NEAR(k->foreseen, 1e-2, 1e-12);
    UNIT_SAYS(k->text, "by its order too expensive");
    foresee(&task, &l);
    task_explain(k, "so");
    foresee(&task, &l);
    UNIT_SAYS(k->text, "so");
    k->foreseen = INFINITY;
    task_explain(k, "");
    l.best.error = 0.5;
    foresee(&task, &l);
    UNIT_SAYS(k->text, "too far off to go on");
    UNIT_TRUE(isinf(k->foreseen));
    task_explain(k, "");
    l.best.error = 1e-4;
    l.most = -INFINITY;
    foresee(&task, &l);
    UNIT_SAYS(k->text, "finer steps are no help");
    UNIT_TRUE(isinf(k->foreseen));
    l.most = 7;
    l.best.plan.model = NULL;
    foresee(&task, &l);
    UNIT_TRUE(isinf(k->foreseen));
}

static void refuses(const char *text)
{
    choice.refusal[0] = '\0';
    refuse(&task);
    UNIT_SAYS(choice.refusal, text);
}

TEST(test_refusals, "refusals")
{
    struct scene s = {.time = 1};
    const struct models_plan p = steps_of("pefrl", 24);
    const struct record r = {.reached = 3};
    begin(1e-6);
    request.scene = &s;
    choice.spent = 1.234;
    task_refuse_plan(&task, &p, "no luck", " or so");
    UNIT_SAYS(choice.refusal, "pefrl:24: no luck");
    task_refuse_plan(&task, &p, NULL, ", so far,");
    UNIT_SAYS(choice.refusal,
              "beyond reason: pefrl:24, so far, would bring the bill "
              "above 100 s by the price list; spent: 1.2 s");
    refuse_standstill(&task, &r);
    UNIT_SAYS(choice.refusal,
              "collisions without end: after t = 2.5 bodies come to "
              "rest on each other, and no model here carries them "
              "on from there; spent: 1.2 s");
    choice.candidates = 5;
    refuse(&task);
    UNIT_TRUE(strstr(choice.refusal, "collisions") == choice.refusal);
    UNIT_EQUAL(choice.taken, 5);
    refuses("no model holds 1e-06; spent: 1.2 s by the price list");
    choice.spent = 90.1;
    refuses("beyond reason: no run and its proof cost less than "
            "100 s by the price list; spent: 90 s");
    choice.refusal[0] = '\0';
    choice.spent = 89.9;
    refuse(&task);
    UNIT_TRUE(strstr(choice.refusal, "no model") == choice.refusal);
    choice.horizon = 2.25;
    refuses("horizon: after t = 2.25 rounding decides by more than "
            "1e-06 what happens; spent: 90 s");
    choice.acts.contact = true;
    refuses("horizon: after t = 2.25 rounding or the order of "
            "collisions at one moment decides by more than 1e-06 "
            "what happens; spent: 90 s");
}

static void says(struct models_plan taken, double price, bool holds,
                 const char *known)
{
    char text[CHOOSE_SENTENCE];
    begin(1e-6);
    struct choose_candidate *k = candidate("leapfrog", MODELS_RODS);
    k->holds = holds;
    k->cost = holds ? price : 7; /* what a run cost that did not hold */
    k->foreseen = holds ? 5 : price;
    k->plan.steps = 99;
    choice.run.plan = taken;
    choice.run.cost = 2;
    choice.taken = 1;
    candidate("pefrl", 0)->cost = 2;
    choice.candidate[1].holds = true;
    choose_sentence(&choice, 1e-6, text);
    UNIT_SAYS(text, known);
}

/* What was taken, with why it is enough, and what the next best costs. */
TEST(test_sentences, "sentences")
{
    says(steps_of("pefrl", 8), INFINITY, false,
         "pefrl:8: its fourth order meets 1e-06 at 8 steps a row");
    says(steps_of("leapfrog", 1), 3, true,
         "leapfrog:1: its second order meets 1e-06 at 1 step a row; "
         "leapfrog,rods would cost 1.5 times as much");
    says(steps_of("kahan-li8", 2), 198.2, true,
         "kahan-li8:2: its eighth order meets 1e-06 at 2 steps a row; "
         "leapfrog,rods would cost 99 times as much");
    says(own_steps_of(1e-5), 246.8, false,
         "radau15:1e-05: steps of its own length meet 1e-06; by its order "
         "leapfrog,rods would cost 123 times as much");
    says(
        steps_of("symplectic-euler", 4), 2001, false,
        "symplectic-euler:4: its first order meets 1e-06 at 4 steps a row; "
        "by its order leapfrog,rods would cost over a thousand times as "
        "much");
    says(steps_of("pefrl", 8), 1999, true,
         "pefrl:8: its fourth order meets 1e-06 at 8 steps a row; "
         "leapfrog,rods would cost 1000 times as much");
    says(steps_of("pefrl", 8), 2.09, true,
         "pefrl:8: its fourth order meets 1e-06 at 8 steps a row; "
         "leapfrog,rods would cost as much");
    says(steps_of("pefrl", 8), 2.11, true,
         "pefrl:8: its fourth order meets 1e-06 at 8 steps a row; "
         "leapfrog,rods would cost 1.1 times as much");
    says((struct models_plan){.model = models_find("free")}, INFINITY,
         false, "free: every body flies alone, in closed form");
}

/* The cheapest of the others, but not one that costs less than what was
   taken: that was dropped for another reason. */
TEST(test_next_best, "the next best")
{
    double price;
    begin(1e-6);
    choice.run.cost = 2;
    choice.taken = 1;
    UNIT_TRUE(!next_best(&choice, &price) && isinf(price));
    for (size_t k = 0; k < 4; ++k) {
        static const double cost[] = {9, 2, 1, 4};
        struct choose_candidate *c = candidate("leapfrog", (unsigned)k);
        c->holds = true;
        c->cost = cost[k];
        c->foreseen = 3;
    }
    UNIT_TRUE(next_best(&choice, &price) == &choice.candidate[3]);
    UNIT_EQUAL(price, 4);
    choice.candidate[0].holds = false; /* by its order, 3 */
    UNIT_TRUE(next_best(&choice, &price) == &choice.candidate[0]);
    UNIT_EQUAL(price, 3);
    choice.candidate[0].foreseen = 2; /* as much: it is no other price */
    UNIT_TRUE(next_best(&choice, &price) == &choice.candidate[3]);
    choice.candidate[0].foreseen = 4; /* the first of equals */
    UNIT_TRUE(next_best(&choice, &price) == &choice.candidate[0]);
}

/* Looks for a reference as the script says; it has to be played out. */
static bool found(void)
{
    still.contact = true;
    request.scene = &still;
    const bool is = reference_find(&task, &reference);
    UNIT_EQUAL(played, written);
    record_free(&reference.run);
    record_free(&reference.coarser);
    return is;
}

/* Bodies come to rest if two runs in turn say so after the same row. */
TEST(test_standstill, "two say that bodies come to rest")
{
    begin(1e-3);
    ENDS({MODELS_STANDSTILL, 2}, {MODELS_DONE, 2}, {MODELS_STANDSTILL, 2},
         {MODELS_STANDSTILL, 2});
    UNIT_TRUE(!found());
    UNIT_TRUE(strstr(choice.refusal, "collisions without end: after t = 1 "
                                     "bodies") == choice.refusal);
    UNIT_TRUE(isinf(choice.horizon));
    begin(1e-3); /* after another row; and then the same breaks down */
    ENDS({MODELS_STANDSTILL, 2}, {MODELS_DONE, 2}, {MODELS_STANDSTILL, 1},
         {MODELS_DONE, 1}, {MODELS_BROKEN, 1}, {MODELS_DONE, 1},
         {MODELS_STANDSTILL, 1}, {MODELS_DONE, 1});
    WHOLE(7, 7);
    UNIT_TRUE(found());
    UNIT_TRUE(choice.refusal[0] == '\0');
    begin(1e-3); /* the finer one alone, in the first row */
    write_whole(7);
    write_end(MODELS_STANDSTILL, 0);
    write_whole(7);
    write_end(MODELS_STANDSTILL, 0);
    UNIT_TRUE(!found());
    UNIT_TRUE(strstr(choice.refusal, "after t = 0 bodies") != NULL);
}

/* Other ends: dear, broken twice at one place, or not begun at all. */
TEST(test_no_reference, "no reference")
{
    begin(1e-3);
    write_whole(7);
    write_end(MODELS_COSTLY, 3);
    UNIT_TRUE(!found());
    UNIT_TRUE(strstr(choice.refusal,
                     "beyond reason: radau15:1e-05, to compare others "
                     "with, would bring") == choice.refusal);
    begin(1e-3);
    write_end(MODELS_COSTLY, 3);
    write_whole(7);
    UNIT_TRUE(!found());
    UNIT_TRUE(strstr(choice.refusal, "beyond reason: radau15:0.001, to") ==
              choice.refusal);
    begin(1e-3);
    write_end(MODELS_MEMORY, 3);
    write_whole(7);
    UNIT_TRUE(!found());
    UNIT_SAYS(choice.refusal, "radau15:0.001: no memory");
    begin(1e-3);
    ENDS({MODELS_BROKEN, 3}, {MODELS_BROKEN, 2}, {MODELS_DONE, 3},
         {MODELS_BROKEN, 3}, {MODELS_BROKEN, 2}, {MODELS_BROKEN, 2});
    UNIT_TRUE(!found());
    UNIT_SAYS(choice.refusal, "radau15:1e-07: breaks down");
    begin(1e-3);
    write_run((struct played){.end = MODELS_BROKEN, .why = "so"});
    write_end(MODELS_DONE, 0);
    UNIT_TRUE(!found());
    UNIT_SAYS(choice.refusal, "radau15:0.001: so");
}

/* Two agree to a twentieth of what is asked for. The second is a hundred
   times finer, in other units, and keeps from the bounds of its steps; the
   next pair begins where it stood. */
TEST(test_reference, "a reference")
{
    begin(1e-3);
    WHOLE(7, 7 + 0.051e-3, 7, 7 + 0.049e-3);
    UNIT_TRUE(found());
    UNIT_NEAR(reference.doubt, 0.049e-3, 1e-15);
    UNIT_EQUAL(reference.seen, reference.doubt);
    UNIT_NEAR(choice.spent, 4e-3, 1e-18);
    static const double tolerances[] = {1e-3, 1e-5, 1e-5, 1e-7};
    for (size_t k = 0; k < 4; ++k) {
        UNIT_NEAR(ordered[k].plan.tolerance, tolerances[k], 1e-18);
        UNIT_EQUAL(ordered[k].twin, k % 2);
        UNIT_EQUAL(ordered[k].plan.slack, k % 2 ? 0.2 : 0);
    }
    /* Close contacts have to be the same in both. */
    begin(1e-3);
    write_run((struct played){MODELS_DONE, 4, 7, 1, 1e-9, 0, NULL});
    write_run((struct played){MODELS_DONE, 4, 7, 1, 2e-9, 0, NULL});
    WHOLE(7, 7);
    UNIT_TRUE(found());
    UNIT_TRUE(!(choice.horizon < INFINITY));
}

/* No two agree, down to the last digits: they part where the last two do,
   by more than a quarter of the tolerance. */
TEST(test_parting, "references that part")
{
    begin(1e-9); /* from 1e-6 in steps of a hundred: five pairs */
    for (int pair = 0; pair < 5; ++pair) {
        WHOLE(7, 7 + 0.6e-9);
    }
    UNIT_TRUE(!found());
    UNIT_EQUAL(choice.horizon, 0);
    begin(1e-9); /* hardly: four twins bound it by less than a fifth */
    for (int pair = 0; pair < 5; ++pair) {
        WHOLE(7, 7 + 0.06e-9);
    }
    for (int twin = 0; twin < 4; ++twin)
        write_whole(7);
    UNIT_TRUE(found());
    UNIT_EQUAL(reference.twins, 5);
    UNIT_NEAR(reference.doubt, 2.7 * 0.06e-9, 1e-14);
    UNIT_EQUAL(ordered[10].twin, 2);
    UNIT_EQUAL(ordered[13].twin, 5);
}

/* Sets a reference that is off by so much of the coarser one. */
static void set_reference(double seen, double least_coarser,
                          double least_run)
{
    write_run(
        (struct played){MODELS_DONE, 4, 0, 1, least_coarser, 0, NULL});
    write_run((struct played){MODELS_DONE, 4, 0, 1, least_run, 0, NULL});
    run_pair(&task, &reference, own_steps_of(1e-6));
    reference.seen = reference.doubt = seen;
    played = written = 0;
}

static void drop_reference(void)
{
    record_free(&reference.run);
    record_free(&reference.coarser);
}

/* By hand, with the margins 4800, 43, 9.2, 4.3, 2.7 and 2 for one to six:
   0.01 of the tolerance needs four for a fifth, 0.09 needs six and is then
   0.18, 0.11 is then too much for that, but not for half; with 0.26 no twin
   is asked. A twin that is farther off counts. */
TEST(test_twins, "twins of a reference")
{
    static const struct {
        double seen, twin, want;
        unsigned twins;
        double doubt;
        bool sure;
    } known[] = {{0.01, 0, 0.2, 3, 0.092, true},
                 {0.04, 0, 0.2, 4, 0.172, true},
                 {0.09, 0, 0.2, 6, 0.18, true},
                 {0.11, 0, 0.2, 6, 0.22, true},
                 {0.25, 0, 0.2, 6, 0.5, true},
                 {0.26, 0, 0.2, 1, 0.52, false},
                 {0.01, 0.26, 0.2, 2, 0.52, false},
                 {0.01, 0.05, 0.2, 5, 0.135, true},
                 {4e-5, 0, 0.2, 1, 0.192, true},
                 {5e-5, 0, 0.2, 2, 2.15e-3, true},
                 {0.01, 0, 0.09, 4, 0.043, true}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        begin_still(1e-3);
        set_reference(known[k].seen * 1e-3, 1, 1);
        for (unsigned twin = 1; twin < known[k].twins; ++twin)
            write_whole(-known[k].twin * 1e-3);
        UNIT_TRUE(
            reference_ask_twins(&task, &reference, known[k].want * 1e-3) ==
            known[k].sure);
        UNIT_EQUAL(played, written);
        UNIT_EQUAL(reference.twins, known[k].twins);
        UNIT_NEAR(reference.doubt, known[k].doubt * 1e-3, 1e-9);
        for (size_t j = 0; j < played; ++j)
            UNIT_EQUAL(ordered[j].twin, 2 + (double)j);
        UNIT_TRUE((choice.horizon == 0) == (known[k].twin > 0.25));
        drop_reference();
    }
}

/* Near the floor of rounding the twins of the reference are asked after a
   run was taken, and its error has what they bound: 0.2 of the tolerance
   from the reference, which three bound by 9.2 times 0.01. */
TEST(test_surely, "they count in the error of what was taken")
{
    const struct models_plan only = steps_of("leapfrog", 5);
    begin_still(1e-3);
    request.only = &only;
    set_reference(0.01e-3, 1, 1);
    write_whole(-0.2e-3);
    write_whole(-0.25e-3); /* its twin: rounding counts */
    WHOLE(0, 0);
    compare_surely(&task);
    UNIT_EQUAL(played, 4);
    UNIT_TRUE(choice.run.value != NULL);
    UNIT_NEAR(choice.doubt, 0.092e-3, 1e-9);
    UNIT_NEAR(choice.candidate[choice.taken].error, 0.292e-3, 1e-9);
    record_free(&choice.run);
    drop_reference();
}

/* An exact run and its twin, which are so far apart, in shares of the
   tolerance; runs that cost next to nothing have all six. */
TEST(test_exact_twins, "twins of an exact run")
{
    static const struct {
        double far, twin, cost;
        unsigned twins;
        double error;
        bool horizon;
    } known[] = {{2e-4, 0, 1, 1, 0.96, false},
                 {2e-4, 0, 1e-4, 6, 4e-4, false},
                 {2e-4, 0, 1.6e-4, 6, 4e-4, false},
                 {2e-4, 0, 1.7e-4, 1, 0.96, false},
                 {2.2e-4, 0, 1, 2, 43 * 2.2e-4, false},
                 {0.1, 0, 1, 3, 0.92, false},
                 {0.3, 0, 1, 5, 0.81, false},
                 {0.5, 0, 1, 6, 1, false},
                 {0.51, 0, 1, 1, 1.02, false},
                 {0.1, 0.6, 1, 2, 1.2, true},
                 {0.1, -0.2, 1, 4, 0.86, false}};
    const struct models_plan p = {.model = models_find("line")};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        begin_still(1e-3);
        const struct record_setup o = task_setup(&task, p, INFINITY);
        struct record_setup other = o;
        other.twin = 2;
        write_run(
            (struct played){MODELS_DONE, 4, 7, known[k].cost, 1, 0, NULL});
        write_whole(7 + known[k].far * 1e-3);
        for (unsigned twin = 1; twin < known[k].twins; ++twin)
            write_whole(7 + known[k].twin * 1e-3);
        MADE(record, a, played_run(&a, &view, &o));
        MADE(record, b, played_run(&b, &view, &other));
        UNIT_NEAR(twins_bound(&task, &a, &b), known[k].error * 1e-3, 1e-9);
        UNIT_EQUAL(played, written);
        for (size_t j = 1; j < played; ++j)
            UNIT_EQUAL(ordered[j].twin, 1 + (double)j);
        UNIT_TRUE((choice.horizon == 0) == known[k].horizon);
    }
}

/* What a twin costs that the first limit has stopped after two of four
   rows, is twice as much; if it has seen none, a sixteenth of a row is
   looked at, and so on; unless twins part there. */
TEST(test_price_of_twin, "what a twin would cost")
{
    const struct models_plan p = {.model = models_find("disks")};
    struct record r = {.plan = p, .reached = 2, .cost = 3};
    begin_still(1e-3);
    UNIT_EQUAL(price_of_twin(&task, &r), 6);
    r.reached = 0;
    ENDS({MODELS_COSTLY, 0}, {MODELS_COSTLY, 0});
    write_whole(7);
    write_run((struct played){MODELS_DONE, 2, 7, 0.25, 1, 0, NULL});
    UNIT_EQUAL(price_of_twin(&task, &r), 0.25 * 256 * 4 / 2);
    UNIT_EQUAL(played, 4);
    for (size_t k = 0; k < 4; ++k) {
        UNIT_EQUAL(ordered[k].every, 0.5 / (k < 2 ? 16 : 256));
        UNIT_EQUAL(ordered[k].rows, 16);
        UNIT_EQUAL(ordered[k].limit, 2 * first_limit);
        UNIT_EQUAL(ordered[k].twin, k % 2 ? 2 : 0);
    }
    UNIT_NEAR(choice.spent, 3e-3 + 0.25, 1e-15);
    begin_still(1e-3);
    WHOLE(7, 7.1);
    UNIT_TRUE(isinf(price_of_twin(&task, &r)));
    UNIT_EQUAL(choice.horizon, 0);
}

/* A clock that is late by a share of the time moves places by so much more
   than a run does whose rows are 2^-40 later. */
TEST(test_slip, "clocks that are late")
{
    begin_still(1e-3);
    const struct record_setup o = task_setup(
        &task, (struct models_plan){.model = models_find("line")},
        INFINITY);
    write_run((struct played){MODELS_DONE, 4, 7, 1, 1, 0x1p-44, NULL});
    write_whole(7 + 0x1p-30);
    MADE(record, a, played_run(&a, &view, &o));
    UNIT_EQUAL(error_of_clock(&task, &a), 0x1p-34);
    UNIT_EQUAL(ordered[1].every, 0.5 * (1 + 0x1p-40));
    a.clock = 0;
    UNIT_EQUAL(error_of_clock(&task, &a), 0);
    UNIT_EQUAL(played, 2);
}

/* An undecided contact is asked of balls that are smaller and larger by
   twice as much as the finer run just met or missed, or by a hair. */
TEST(test_balls, "balls a little larger")
{
    begin_still(1e-3);
    set_reference(1e-5, 1, 1.1);
    ask_balls(&task, &reference);
    UNIT_EQUAL(played, 0);
    drop_reference();
    for (int close = 0; close < 2; ++close) {
        const double swell = close ? 0x1p-39 : 2e-3;
        begin_still(1e-3);
        set_reference(1e-5, 1, close ? 1e-20 : -1e-3);
        WHOLE(2e-4, -1e-4);
        ask_balls(&task, &reference);
        UNIT_EQUAL(played, 2);
        UNIT_EQUAL(ordered[0].grow, -swell);
        UNIT_EQUAL(ordered[1].grow, swell);
        UNIT_NEAR(reference.doubt, 2e-4, 1e-18);
        UNIT_TRUE(isinf(choice.horizon));
        drop_reference();
    }
    begin_still(1e-3);
    set_reference(1e-5, 1, -1);
    write_whole(0);
    write_whole(2.6e-4); /* it decides by more than a quarter */
    ask_balls(&task, &reference);
    UNIT_EQUAL(choice.horizon, 0);
    drop_reference();
}

/* Whether rounding moves a run by a 300th of the tolerance is asked of the
   first twin. */
TEST(test_near_floor, "what rounding moves")
{
    for (int near = 0; near < 2; ++near) {
        begin_still(3e-3);
        WHOLE(7, 7 + (near ? 1.001e-5 : 0.999e-5));
        task_run(&task, &choice.run,
                 &(struct record_setup){.plan = own_steps_of(1e-9)});
        UNIT_TRUE(is_near_floor(&task) == near);
        UNIT_EQUAL(ordered[1].twin, 1);
        UNIT_EQUAL(ordered[1].plan.tolerance, 1e-9);
        choose_free(&choice);
    }
}

/* Runs with p, 2 p + 1, ... steps, four at most, and no more if two of them
   differ by 16 times too much: by the order of the method two more would
   not help. */
TEST(test_even, "references of equal steps")
{
    static const struct {
        double value[4]; /* in fifths of the tolerance */
        size_t runs;
        double doubt; /* the same; 0: none */
    } known[] = {{{100, 99.01}, 2, 0.99},         {{10, 0, 0.9}, 3, 0.9},
                 {{15.9, 0, 15.9, 15.8}, 4, 0.1}, {{16.1, 0}, 2, 0},
                 {{15.9, 0, 16.1}, 3, 0},         {{10, 0, 10, 0}, 4, 0}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        begin(1e-3);
        CREATED(scene, s, 1);
        request.scene = &s;
        for (size_t j = 0; j < known[k].runs; ++j)
            write_whole(known[k].value[j] * 0.2e-3);
        UNIT_TRUE(find_even(&task, &reference, "leapfrog") ==
                  (known[k].doubt > 0));
        UNIT_EQUAL(played, written);
        for (size_t j = 0; j < played; ++j)
            UNIT_EQUAL(ordered[j].plan.steps,
                       j == 0 ? 1
                              : 2 * (double)ordered[j - 1].plan.steps + 1);
        if (known[k].doubt > 0)
            UNIT_NEAR(reference.doubt, known[k].doubt * 0.2e-3, 1e-12);
        UNIT_TRUE((reference.run.value != NULL) == (known[k].doubt > 0));
        drop_reference();
    }
}

/* A run of 40 steps that holds is taken if one of 44 holds, too; if not,
   one of 36 is, that does; and else it is said to be as bad as the finer
   one. Rungs that are known are not run again. */
TEST(test_neighbours, "neighbours on a ladder")
{
    static const struct {
        double finer, coarser; /* 0: it is not asked */
        uint64_t steps;
        double error;
    } known[] = {{0.9, 0, 40, 0.5},
                 {1.1, 0.95, 36, 0.95},
                 {1.1, 1.2, 40, 1.1},
                 {1.1, 1, 36, 1}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k) {
        begin_still(1e-3);
        set_reference(0, 1, 1);
        struct ladder l = ladder("leapfrog", 16, 1, 1e-3);
        struct record r;
        struct choose_point seen = {steps_of("leapfrog", 40), 0.5e-3, 40};
        WHOLE(0.5e-3, known[k].finer * 1e-3);
        if (known[k].coarser > 0)
            write_whole(known[k].coarser * 1e-3);
        task_run(&task, &r,
                 &(struct record_setup){.plan = steps_of("leapfrog", 40)});
        ask_neighbours(&task, &l, &r, &seen);
        UNIT_EQUAL(played, written);
        UNIT_EQUAL(ordered[1].plan.steps, 44);
        UNIT_TRUE(written < 3 || ordered[2].plan.steps == 36);
        UNIT_EQUAL(r.plan.steps, known[k].steps);
        UNIT_EQUAL(seen.plan.steps, known[k].steps);
        UNIT_NEAR(seen.error, known[k].error * 1e-3, 1e-15);
        UNIT_EQUAL(seen.cost, known[k].steps == 40 ? 40 : 1e-3);
        record_free(&r);
        drop_reference();
    }
    /* What is next to a run that is known: 44 was the last, and 36 fails.
     */
    begin_still(1e-3);
    set_reference(0, 1, 1);
    struct ladder l = ladder("leapfrog", 44, 7, 1);
    struct record r = {.value = NULL};
    struct models_plan p = steps_of("leapfrog", 40);
    UNIT_EQUAL(error_of_finer(&task, &l, &p), 7);
    l.least = log2(36);
    UNIT_TRUE(isinf(error_of_coarser(&task, &l, &p, &r)));
    l.least = 0;
    p.steps = 7; /* few steps have no near rung below */
    UNIT_TRUE(isinf(error_of_coarser(&task, &l, &p, &r)));
    p.steps = 9;
    write_whole(3);
    UNIT_EQUAL(error_of_coarser(&task, &l, &p, &r), 3);
    UNIT_EQUAL(ordered[0].plan.steps, 8);
    record_free(&r);
    drop_reference();
}
