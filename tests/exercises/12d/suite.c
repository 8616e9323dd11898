/* The suite of exercise 12d: an axis, any line, one that moves, bodies at
   rest, few of them, a plane that looks like a line, weight, a hair's
   breadth, and drawn lines, whole and spoilt. */

#include "examiner/check.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct body {
    int x[3];
    int v[3];
};

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3]);

enum { MOST = 12, LARGE = 1000000000 };

struct scene {
    size_t n;
    struct body body[MOST + 1];
    int weight[3];
};

struct answer {
    bool line;
    int along[3];
};

static const int untouched[3] = {-99, 7, 13};

/* What the student's function says. Behind the last body stands one that is
   on no line with them and does not belong to them. */
static struct answer answer(const struct scene *s)
{
    struct scene all = *s;
    struct answer a = {false, {untouched[0], untouched[1], untouched[2]}};
    all.body[s->n] = (struct body){{12345, -777, 999}, {-31, 41, 59}};
    a.line = one_line(s->n, all.body, all.weight, a.along);
    return a;
}

static const char *vector(const int v[3])
{
    return check_text("(%d, %d, %d)", v[0], v[1], v[2]);
}

static const char *input(const struct scene *s)
{
    char list[420] = "";
    size_t used = 0;
    for (size_t i = 0; i < s->n && used < 330; ++i)
        used += (size_t)snprintf(
            list + used, sizeof list - used, "; at %s nm, %s nm/s",
            vector(s->body[i].x), vector(s->body[i].v));
    return check_text("%zu %s, weight %s nm/s^2%s%s", s->n,
                      s->n == 1 ? "body" : "bodies", vector(s->weight),
                      list, used < 330 ? "" : "; ...");
}

/* ---- checks ---- */

static bool none(const int v[3])
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

static bool parallel(const int p[3], const int q[3])
{
    const int k = p[0] ? 0 : p[1] ? 1 : 2;
    for (int j = 0; j < 3; ++j)
        if ((long long)p[k] * q[j] != (long long)q[k] * p[j])
            return false;
    return true;
}

static bool check_line(const struct scene *s, bool got, bool expected,
                       const char *name, const char *hint,
                       const char *question)
{
    return CHECK_NEAR(
        got, .quantity = "is the scene on one line? (1 yes, 0 no)",
        .input = input(s), .expected = expected, .tolerance = 0.0,
        .because = "whole numbers leave no doubt",
        .equation = "eq:one-line", .question = question,
        .mistakes = {{name, !expected, hint}});
}

/* Why a vector is none along the line. */
static struct check_mistake no_direction(const struct scene *s,
                                         const int got[3])
{
    if (none(got) || parallel(got, untouched))
        return (struct check_mistake){
            "direction-forgotten", 0.0,
            "There is a line, and one vector along it you have used "
            "already. Where did you leave it?"};
    if (s->n > 0 && parallel(got, s->body[0].x))
        return (struct check_mistake){
            "place-for-direction", 0.0,
            "This points from the origin to a body. Does the line go "
            "through the origin?"};
    return (struct check_mistake){NULL, 0.0, NULL};
}

static bool check_along(const struct scene *s, const int got[3],
                        const int along[3], const char *question)
{
    if (none(along))
        return CHECK_NEAR(
            none(got), .quantity = "is along (0, 0, 0)? (1 yes, 0 no)",
            .input = input(s), .expected = 1.0, .tolerance = 0.0,
            .because = "every line through the bodies will do",
            .equation = "eq:one-line", .question = question,
            .mistakes = {{"direction-of-nothing", 0.0,
                          "All is at one place and at rest. What was to "
                          "stand in along then?"}});
    return CHECK_NEAR(
        !none(got) && parallel(got, along),
        .quantity = check_text("is along, here %s, a vector along the "
                               "line, as %s is? (1 yes, 0 no)",
                               vector(got), vector(along)),
        .input = input(s), .expected = 1.0, .tolerance = 0.0,
        .because = "whole numbers leave no doubt",
        .equation = "eq:one-line", .question = question,
        .mistakes = {no_direction(s, got)});
}

/* A scene, and where its line goes; the slip is one that finds none. */
struct on_line {
    struct scene s;
    int along[3];
    const char *name, *hint;
};

static bool check_on(const struct on_line *c, const char *question)
{
    const struct answer a = answer(&c->s);
    return check_line(&c->s, a.line, true, c->name, c->hint, question) &&
           check_along(&c->s, a.along, c->along, question);
}

/* A scene that is on none; the slip finds one. */
struct off_line {
    struct scene s;
    const char *name, *hint;
};

static bool check_off(const struct off_line *c, const char *question)
{
    return check_line(&c->s, answer(&c->s).line, false, c->name, c->hint,
                      question);
}

/* ---- the tests ---- */

static const char origin[] =
    "These bodies are on one line, which does not go through the origin. "
    "From where to where are the ways that must be parallel?";

static const char axis_question[] =
    "Which differences of places, and which velocities, point along the "
    "axis, and which do not?";

static void test_axis(void)
{
    static const struct on_line x = {
        {3, {{{50}, {7}}, {{100}, {0}}, {{250}, {-3}}}, {0}}, {1}, 0, 0};
    static const struct on_line z = {
        {2, {{{4, 5, 6}, {0, 0, 2}}, {{4, 5, 9}, {0}}}, {0}},
        {0, 0, 1},
        "through-the-origin",
        origin};
    static const struct off_line place = {
        {3, {{{0}, {7}}, {{100}, {0}}, {{250, 50}, {-3}}}, {0}},
        "places-forgotten",
        "All velocities point along one axis here. And the places?"};
    static const struct off_line velocity = {
        {3, {{{0}, {7}}, {{100}, {0, 40}}, {{250}, {-3}}}, {0}},
        "velocities-forgotten",
        "All bodies are on one line now. Will they still be there in a "
        "second?"};
    (void)(check_on(&x, axis_question) && check_on(&z, axis_question) &&
           check_off(&place, axis_question) &&
           check_off(&velocity, axis_question));
}

static void test_oblique(void)
{
    static const char question[] =
        "The line need not be an axis. Which vectors would have to be "
        "parallel?";
    static const char axes[] =
        "These bodies are on one line, only not on an axis. What do the "
        "ways from one to the others have in common?";
    static const struct on_line through = {
        {3,
         {{{10, 20, 30}, {1, 2, 3}},
          {{-20, -40, -60}, {-3, -6, -9}},
          {{40, 80, 120}, {0}}},
         {0}},
        {1, 2, 3},
        "only-axes",
        axes};
    static const struct on_line beside = {{3,
                                           {{{15, 7, 30}, {4, -2, 6}},
                                            {{17, 6, 33}, {0}},
                                            {{5, 12, 15}, {-6, 3, -9}}},
                                           {0}},
                                          {2, -1, 3},
                                          "through-the-origin",
                                          origin};
    static const struct off_line bent = {{3,
                                          {{{10, 20, 30}, {1, 2, 3}},
                                           {{20, 40, 60}, {2, 4, 6}},
                                           {{40, 70, 120}, {1, 2, 3}}},
                                          {0}},
                                         0,
                                         0};
    static const struct off_line across = {
        {2, {{{10, 20, 30}, {1, 2, 3}}, {{20, 40, 60}, {2, 1, 3}}}, {0}},
        0,
        0};
    static const struct off_line among = {
        {3,
         {{{0}, {2, 4, 6}}, {{5, 5, 0}, {-1, -2, -3}}, {{9, 9, 0}, {0}}},
         {0}},
        "each-kind-for-itself",
        "The places are on one line and the velocities are parallel. To "
        "what must they be parallel?"};
    (void)(check_on(&through, question) && check_on(&beside, question) &&
           check_off(&bent, question) && check_off(&across, question) &&
           check_off(&among, question));
}

/* Two bodies in a train. */
static void test_moving(void)
{
    static const char hint[] =
        "Somebody who travels along sees a line. And which line did the "
        "exercise ask for?";
    static const struct off_line c = {
        {2, {{{0}, {0, 6, 0}}, {{9, 0, 0}, {0, 6, 0}}}, {0}},
        "line-that-moves",
        hint};
    static const struct off_line d = {
        {2, {{{0}, {2, 6, 0}}, {{9, 0, 0}, {-3, 6, 0}}}, {0}},
        "line-that-moves",
        hint};
    static const char question[] =
        "All have the same velocity across the line. Do they stay on it?";
    (void)(check_off(&c, question) && check_off(&d, question));
}

/* Bodies at the same place, and bodies at rest, say nothing. */
static void test_nothing_between(void)
{
    static const char question[] =
        "A vector that is zero is parallel to everything. Against which "
        "one do you hold the others?";
    static const char chain[] =
        "The two vectors that are not parallel were never held against "
        "each other: one that is zero came between them. Which one will "
        "do for all?";
    static const char first[] =
        "Everything is parallel to a vector that is zero. Which of the "
        "vectors tells where the line goes?";
    static const struct off_line cases[] = {
        {{3, {{{0}, {0}}, {{0}, {0}}, {{7, 0, 0}, {0, 5, 0}}}, {0}},
         "parallel-to-nothing",
         first},
        {{3, {{{0}, {0, 5, 0}}, {{0}, {0}}, {{7, 0, 0}, {0}}}, {0}},
         "chain-broken",
         chain},
        {{4,
          {{{0}, {0}}, {{7, 0, 0}, {0}}, {{0}, {0}}, {{0}, {0, 5, 0}}},
          {0}},
         "chain-broken",
         chain},
        {{3, {{{0}, {5, 0, 0}}, {{0}, {0}}, {{0}, {0, 5, 0}}}, {0}},
         "chain-broken",
         chain}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        if (!check_off(&cases[i], question))
            return;
}

static void test_few(void)
{
    static const char question[] =
        "How many vectors are there that are not zero, and what must "
        "along be?";
    static const char refused[] =
        "There is a line through these. Which body would leave it?";
    static const struct on_line cases[] = {
        {{1, {{{5, 6, 7}, {0}}}, {0}}, {0}, "point-refused", refused},
        {{2, {{{5, 6, 7}, {0}}, {{5, 6, 7}, {0}}}, {0}},
         {0},
         "point-refused",
         refused},
        {{0, {{{0}, {0}}}, {0}}, {0}, "point-refused", refused},
        {{1, {{{5, 6, 7}, {1, 0, -2}}}, {0}},
         {1, 0, -2},
         "point-refused",
         refused},
        {{2, {{{5, 6, 7}, {0}}, {{5, 8, 3}, {0}}}, {0}},
         {0, 1, -2},
         "point-refused",
         refused},
        {{2, {{{5, 6, 7}, {0}}, {{5, 6, 7}, {3, 3, 0}}}, {0}},
         {1, 1, 0},
         "point-refused",
         refused}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        if (!check_on(&cases[i], question))
            return;
}

/* Each coordinate in turn is the one that is off. */
static void test_plane(void)
{
    static const char question[] =
        "Seen along one of the axes this is a line. And seen along the "
        "others?";
    for (int k = 0; k < 3; ++k) {
        struct off_line c = {
            {3,
             {{{1, 2, 3}, {0}}, {{3, 6, 9}, {0}}, {{5, 10, 15}, {0}}},
             {0}},
            "two-axes-compared",
            "Only some of the components of these ways were compared. How "
            "many pairs of three are there?"};
        c.s.body[1].v[k] = 4;
        if (!check_off(&c, question))
            return;
        c.s.body[1].v[k] = 0;
        c.s.body[2].x[k] += 1;
        if (!check_off(&c, question))
            return;
        c.s = (struct scene){.n = 2};
        for (int j = 0; j < 3; ++j)
            c.s.body[1].x[j] = j != k;
        c.s.body[0].v[(k + 1) % 3] = 1;
        if (!check_off(&c, question))
            return;
    }
}

static void test_weight(void)
{
    static const char question[] =
        "All bodies fall. Along the line, or off it?";
    static const char slip[] =
        "All is on one line, and then it falls. In which direction?";
    static const struct off_line across = {
        {2, {{{0}, {1, 0, 0}}, {{9, 0, 0}, {0}}}, {0, 0, -9}},
        "weight-forgotten",
        slip};
    static const struct off_line thrown = {
        {1, {{{3, 4, 5}, {1, 0, 0}}}, {0, 0, -9}},
        "weight-forgotten",
        slip};
    static const struct on_line shaft = {
        {2, {{{1, 1, 0}, {0, 0, 4}}, {{1, 1, 9}, {0}}}, {0, 0, -9}},
        {0, 0, 1},
        0,
        0};
    static const struct on_line let_go = {
        {1, {{{3, 4, 5}, {0}}}, {1, -1, 2}}, {1, -1, 2}, 0, 0};
    (void)(check_off(&across, question) && check_off(&thrown, question) &&
           check_on(&shaft, question) && check_on(&let_go, question));
}

static void test_hair(void)
{
    static const char question[] =
        "Nearly on a line is not on it. How do you compare?";
    static const char hint[] =
        "One of these is off by one nanometre, or by one in a second. For "
        "how long will that be too little to be seen?";
    static const struct off_line slow = {{3,
                                          {{{0}, {LARGE, 0, 0}},
                                           {{LARGE, 0, 0}, {0, 0, 1}},
                                           {{-LARGE, 0, 0}, {0}}},
                                          {0}},
                                         "nearly",
                                         hint};
    static const struct off_line place = {
        {3, {{{0}, {0}}, {{LARGE, 0, 0}, {0}}, {{-LARGE, 1, 0}, {0}}}, {0}},
        "nearly",
        hint};
    static const struct off_line weight = {
        {2, {{{0}, {0}}, {{LARGE, 0, 0}, {0}}}, {-LARGE, 1, 0}},
        "nearly",
        hint};
    (void)(check_off(&slow, question) && check_off(&place, question) &&
           check_off(&weight, question));
}

/* Ways whose slopes are equal but for 1e-18, and others that are equal. */
static void test_digits(void)
{
    static const char question[] =
        "How many digits has the product of two of these numbers, and how "
        "many does your variable hold?";
    static const char hint[] =
        "Two of these directions differ by 1e-18 of themselves. What does "
        "a double make of that quotient, or of that product?";
    enum { L = LARGE };
    static const struct off_line slope = {
        {3,
         {{{0}, {0}}, {{L, L - 1, 0}, {0}}, {{L - 1, L - 2, 0}, {0}}},
         {0}},
        "rounded",
        hint};
    static const struct off_line far = {
        {2,
         {{{1 - L, 5, -L}, {L - 2, 0, L - 1}}, {{L - 1, 5, L}, {0}}},
         {0}},
        "rounded",
        hint};
    static const struct on_line corner = {{3,
                                           {{{-L, L, -L}, {L, -L, L}},
                                            {{L, -L, L}, {1, -1, 1}},
                                            {{7, -7, 7}, {0}}},
                                           {-L, L, -L}},
                                          {1, -1, 1},
                                          0,
                                          0};
    static const struct on_line even = {
        {3,
         {{{0}, {0}}, {{L, L - 2, 4}, {0}}, {{L / 2, L / 2 - 1, 2}, {0}}},
         {0}},
        {L / 2, L / 2 - 1, 2},
        0,
        0};
    (void)(check_on(&corner, question) && check_on(&even, question) &&
           check_off(&slope, question) && check_off(&far, question));
}

/* ---- drawn lines ---- */

/* At least two components are not zero, so that whoever goes one unit along
   an axis leaves the line. */
static void draw_direction(int most, int along[3])
{
    int used;
    do {
        used = 0;
        for (int k = 0; k < 3; ++k) {
            along[k] =
                check_draw_whole(0, 3) ? check_draw_whole(-most, most) : 0;
            used += along[k] != 0;
        }
    } while (used < 2);
}

/* A scene on this line: so many steps along it each, no more than `most`,
   and the first three bodies at different places. */
static struct scene draw_scene(const int along[3], const int base[3],
                               int most)
{
    struct scene s = {.n = (size_t)check_draw_whole(3, MOST)};
    const int weight = check_draw_whole(-most, most);
    for (size_t i = 0; i < s.n; ++i) {
        const int steps =
            i < 3 ? (int)i - 1 : check_draw_whole(-most, most);
        const int fast = check_draw_whole(-most, most);
        for (int k = 0; k < 3; ++k) {
            s.body[i].x[k] = base[k] + steps * along[k];
            s.body[i].v[k] = fast * along[k];
        }
    }
    for (int k = 0; k < 3; ++k)
        s.weight[k] = weight * along[k];
    return s;
}

/* One number of it is made larger or smaller by one. */
static void spoil(struct scene *s)
{
    const size_t which = (size_t)check_draw_whole(0, 2 * (int)s->n);
    struct body *b = &s->body[which / 2];
    int *one = which == 2 * s->n ? s->weight : which % 2 ? b->x : b->v;
    one += check_draw_whole(0, 2);
    *one += *one > 0 ? -1 : 1;
}

static void check_drawn(int most, int steps, int away, int times)
{
    for (int i = 0; i < times; ++i) {
        struct on_line c = {.name = NULL};
        int base[3];
        draw_direction(most, c.along);
        for (int k = 0; k < 3; ++k)
            base[k] = check_draw_whole(-away, away);
        c.s = draw_scene(c.along, base, steps);
        if (!check_on(&c, "All of these are on one line. Which of them do "
                          "you not believe?"))
            return;
        spoil(&c.s);
        if (!check_line(&c.s, answer(&c.s).line, false, NULL, NULL,
                        "One number is off by one. Which of the vectors "
                        "is not parallel to the others?"))
            return;
    }
}

static void test_drawn_near(void)
{
    check_drawn(20, 5, 100, 30);
}

static void test_drawn_far(void)
{
    check_drawn(900, 1000, LARGE / 100, 30);
    check_drawn(LARGE, 1, 0, 30);
}

const struct check_suite check_suite = {
    .file = "12d-line.c",
    .title = "Is this scene one-dimensional?",
    .minutes = 25,
    .tests = {{"bodies on an axis", test_axis, 2, 0},
              {"bodies on any other line", test_oblique, 2, 0},
              {"a line that moves", test_moving, 1, 0},
              {"bodies at rest and at the same place", test_nothing_between,
               1, 0},
              {"one body, none, or all at one place", test_few, 1, 0},
              {"a line when seen from one side", test_plane, 1, 0},
              {"a weight", test_weight, 1, 0},
              {"off by a nanometre", test_hair, 1, 0},
              {"slopes that differ by 1e-18", test_digits, 2, 0},
              {"drawn lines, and one number off by one", test_drawn_near, 1,
               2},
              {"drawn lines of many digits", test_drawn_far, 1, 2},
              {0}},
    .idle = {test_moving, test_nothing_between, test_plane, test_hair},
};
