/* Scenes: files as the paper prints them, files that are refused, and
 * scenes that come back with the same bits. */
#include "unit.h"

#include "scenes/gallery.h"
#include "library/scene_same.h"
#include "library/toolbox_child.h"
#include "scenes/scene.h"
#include "toolbox/random.h"
#include "toolbox/table.h"

static struct scene_error error; /* of the last parse */

static bool parse(struct scene *s, const char *text)
{
    memset(&error, 0, sizeof error);
    return scene_parse(s, text, strlen(text), &error);
}

TEST(test_paper, "the paper's listing reads as it is")
{
    struct scene s;
    UNIT_TRUE(parse(&s, "# Sun and Earth // two bodies\n"
                        "#--- ID x y z m c r rgb\n"
                        "pos 0  0.0 0.0 0.0   1.0  0.0 0.1   1.0 1.0 0.0\n"
                        "  pos 1\t1.0 0.0 0.0  3e-6 0.0 0.03  .3 .3 1.\n"
                        "\n"
                        "vel 0 0.0 0.0 0.0 # at rest\r\n"
                        "vel 1 0.0 0.0172 0.0\n"
                        "vfix 0 1 1 0\n"
                        "vfix 1 1 1 0\n"
                        "k2 2.9584e-4\n"
                        "  dt 0.03"));
    UNIT_EQUAL(s.bodies, 2);
    UNIT_LIST(s.mass, 0, 1, 3e-6);
    UNIT_EQUAL(s.radius[1], 0.03);
    UNIT_EQUAL(s.position[1], 1);
    UNIT_EQUAL(s.velocity[1 * 2 + 1], 0.0172);
    UNIT_EQUAL(s.freedom[0] + s.freedom[2] + s.freedom[4], 2);
    UNIT_EQUAL(s.colour[0 * 2 + 1], 0.3);
    UNIT_EQUAL(s.colour[2 * 2 + 1], 1);
    UNIT_EQUAL(s.k2, 2.9584e-4);
    UNIT_EQUAL(s.dt, 0.03);
    UNIT_EQUAL(s.restitution, 1);
    UNIT_TRUE(!s.contact && !s.axial && s.carry == NULL && s.kept == NULL);
    UNIT_EQUAL(s.softening, 0);
    scene_free(&s);
    UNIT_TRUE(s.mass == NULL);
}

TEST(test_springs, "springs in any order, rest lengths, displacements")
{
    FREED(scene) s;
    UNIT_TRUE(parse(&s, "dis 1 0 0 5\n"
                        "sl 1 0 0\n"
                        "sl 0 2 1 0.5\n"
                        "pos 2 0 0 2 1 0 .1\n"
                        "s 1 7 0\n"
                        "s 0 50.0 0.003 0.4 0.4 1.0\n"
                        "pos 1 3 4 0 1 0 .1\n"
                        "pos 0 0 0 0 1 0 .1\n"
                        "grav 0.0 0.0 -9.81\n"
                        "damp 0.25\n"));
    UNIT_EQUAL(s.springs, 2);
    UNIT_EQUAL(s.spring[0].a, 1);
    UNIT_EQUAL(s.spring[0].b, 0);
    UNIT_EQUAL(s.spring[0].rest, 5); /* before it is displaced */
    UNIT_EQUAL(s.position[2 * 3 + 1], 5);
    UNIT_EQUAL(s.spring[1].rest, 0.5);
    UNIT_EQUAL(s.spring[1].kind, 1);
    UNIT_EQUAL(s.kind[0].stiffness, 50);
    UNIT_EQUAL(s.kind[0].damping, 0.003);
    UNIT_EQUAL(s.kind[0].colour[2], 1);
    UNIT_EQUAL(s.kind[1].stiffness, 7);
    UNIT_EQUAL(s.gravity[2], -9.81);
    UNIT_EQUAL(s.damping, 0.25);
}

TEST(test_ours, "our own lines")
{
    FREED(scene) s;
    UNIT_TRUE(parse(&s, "pos 0 1 2 3 0 -1 .5\nspecies 0 4294967295\n"
                        "carry 0 1 2 3 4 5 6e-20\nsoft 1e-3\ntime -5\n"
                        "kept 0 7 -0 8e-20\n"
                        "contact\nrestitution .9\ndashpot axial\n"
                        "walls hard periodic open\nbox 0 4 -1 1 3 3\n"));
    UNIT_EQUAL(s.species[0], 4294967295);
    UNIT_EQUAL(s.carry[5], 6e-20);
    UNIT_EQUAL(s.kept[0], 7);
    UNIT_TRUE(s.kept[1] == 0 && signbit(s.kept[1]));
    UNIT_EQUAL(s.kept[2], 8e-20);
    UNIT_EQUAL(s.charge[0], -1);
    UNIT_EQUAL(s.softening, 1e-3);
    UNIT_EQUAL(s.time, -5);
    UNIT_EQUAL(s.restitution, 0.9);
    UNIT_TRUE(s.contact && s.axial);
    UNIT_TRUE(s.wall[0] == SCENE_HARD && s.wall[1] == SCENE_PERIODIC &&
              s.wall[2] == SCENE_OPEN);
    UNIT_EQUAL(s.low[1], -1);
    UNIT_EQUAL(s.high[0], 4);
}

/* A text is read in passes: first what belongs to the bodies and the scene,
   then springs and walls, displacements last. Of two bad lines that of the
   earlier pass is named, of one pass the first. */
TEST(test_passes, "passes over a text")
{
    static const struct {
        const char *word;
        int pass;
    } known[] = {{"pos", 1},     {"vel", 1},         {"vfix", 1},
                 {"dis", 3},     {"species", 1},     {"carry", 1},
                 {"kept", 1},    {"s", 1},           {"sl", 2},
                 {"dashpot", 1}, {"grav", 1},        {"damp", 1},
                 {"k2", 1},      {"soft", 1},        {"dt", 1},
                 {"time", 1},    {"restitution", 1}, {"linear", 1},
                 {"hertz", 1},   {"box", 1},         {"walls", 2}};
    enum { WORDS = sizeof known / sizeof *known };
    for (size_t i = 0; i < WORDS; ++i)
        for (size_t j = 0; j < WORDS; ++j) {
            struct scene s;
            char text[128];
            snprintf(text, sizeof text, "%s?\n%s ?\n%s ?\n",
                     "pos 0 0 0 0 1 0 1\n#", known[i].word, known[j].word);
            UNIT_TRUE(!parse(&s, text));
            UNIT_EQUAL(error.line, known[i].pass <= known[j].pass ? 3 : 4);
        }
}

/* A text that is refused: on which line, and what is said. */
struct refusal {
    const char *text;
    size_t line;
    const char *part;
};

#define P0 "pos 0 0 0 0 1 0 1\n"
#define P1 "pos 1 2 0 0 1 0 1\n"
#define P2 "pos 2 4 0 0 1 0 1\n"
#define TWO P0 P1 "s 0 1 0\n"

static const struct refusal refusals[] = {
    {"", 1, "no line pos"},
    {"# nothing\nk2 1\n", 3, "no line pos"},
    {P0 "poss 1 2 3\n", 2, "found 'poss', expected pos, vel, vfix"},
    {P0 "po 1\n", 2, "found 'po'"},
    {P0 "Pos 1\n", 2, "or walls"},
    /* bodies that are missing, doubled, out of range */
    {P0 "pos 2 0 0 0 1 0 1\n", 2,
     "found '2', expected body: 0 to 1 (lines pos: 2)"},
    {P0 P1 P0, 3, "found '0', expected one without a line pos so far"},
    {P0 "vel 1 0 0 0\n", 2, "body: 0 to 0 (lines pos: 1)"},
    {"vel 0 0 0 0\n", 2, "no line pos"},
    {P0 "vel 0 0 0 0\nvel 0 1 0 0\n", 3, "without a line vel"},
    {P0 "pos -1 0 0 0 1 0 1\n", 2, "found '-1'"},
    {P0 "pos 1.0 0 0 0 1 0 1\n", 2, "found '1.0'"},
    {P0 "pos 4294967297 0 0 0 1 0 1\n", 2, "found '4294967297'"},
    {P0 "pos 00000000001 0 0 0 1 0 1\n", 2, "found '00000000001'"},
    {P0 "pos x 0 0 0 1 0 1\n", 2, "found 'x'"},
    {P0 "dis 1 0 0 0\n", 2, "body: 0 to 0 (lines pos: 1)"},
    {P0 "carry 3 0 0 0 0 0 0\n", 2, "body: 0 to 0 (lines pos: 1)"},
    /* an acceleration for each, or for none */
    {P0 "kept 1 0 0 0\n", 2, "found '1', expected body: 0 to 0 (lines pos"},
    {P0 P1 P2 "\nkept 1 0 0 0\nkept 0 0 0 0\n", 5,
     "found 'kept', expected one for each of the 3 bodies, or none (lines "
     "kept: 2)"},
    {"kept 1 0 0 0\n" P0 P1, 1, "of the 2 bodies, or none (lines kept: 1)"},
    {P0 P1 "kept 1 0 0 0\nkept 1 0 0 0\n", 4,
     "found '1', expected one without a line kept so far"},
    {P0 P1 "kept 1 0 0 0\nkept 0 0 0 0\nkept 0 0 0 0\n", 5,
     "found '0', expected one without a line kept so far"},
    {P0 "kept 0 0 nan 0\n", 2, "found 'nan', expected ay: a number"},
    {P0 "kept 0 0 0 -inf\n", 2, "found '-inf', expected az: a number"},
    {P0 "kept 0 0 0\n", 2, "found the end of the line, expected az"},
    {P0 "kept 0 0 0 0 0\n", 2, "found '0', expected the end of the line"},
    {P0 "kept\n", 2, "found the end of the line, expected body"},
    /* numbers */
    {"pos 0 nan 0 0 1 0 1\n", 1, "found 'nan', expected x: a number"},
    {"pos 0 0 inf 0 1 0 1\n", 1, "found 'inf', expected y: a number"},
    {"pos 0 0 0 -Infinity 1 0 1\n", 1, "expected z: a number"},
    {"pos 0 0 0 0x10 1 0 1\n", 1, "found '0x10'"},
    {"pos 0 0 0 1e999 1 0 1\n", 1, "found '1e999'"},
    {"pos 0 0 0 1e99999999999999 1 0 1\n", 1, "found '1e9999"},
    {"pos 0 0 0 1e 1 0 1\n", 1, "found '1e'"},
    {"pos 0 0 0 1e+ 1 0 1\n", 1, "found '1e+'"},
    {"pos 0 0 0 . 1 0 1\n", 1, "found '.'"},
    {"pos 0 0 0 1.2.3 1 0 1\n", 1, "found '1.2.3'"},
    {"pos 0 0 0 1,5 1 0 1\n", 1, "found '1,5'"},
    {"pos 0 0 0 +-1 1 0 1\n", 1, "found '+-1'"},
    {"pos 0 0 0 1d5 1 0 1\n", 1, "found '1d5'"},
    {P0 "species 0 1a\n", 2, "found '1a', expected species: a whole"},
    {P0 "species 0 1:\n", 2, "found '1:', expected species: a whole"},
    {P0 "species 0 1/\n", 2, "found '1/', expected species: a whole"},
    {P0 "species 0 00000000001\n", 2, "found '00000000001', expected spec"},
    {P0 "restitution -0.01\n", 2, "restitution: a number from 0 to 1"},
    {P0 "restitution 1.01\n", 2, "restitution: a number from 0 to 1"},
    {"pos 0 0 0 0 -1 0 1\n", 1,
     "found '-1', expected mass: a number not below 0"},
    {"pos 0 0 0 0 1 0 -1\n", 1, "expected radius: a number not below"},
    {"pos 0 0 0 0 1 0 1 1 1 2\n", 1, "expected blue: a number from 0 to 1"},
    {"pos 0 0 0 0 1 0 1 1 1\n", 1, "expected blue"},
    {"pos 0 0 0 0 1 0\n", 1, "found the end of the line, expected rad"},
    {"pos\n", 1, "found the end of the line, expected body"},
    {"pos 0 0 0 0 1 0 1 1 1 1 7\n", 1,
     "found '7', expected the end of the"},
    {P0 "vel 0 1 2\n", 2, "expected vz"},
    {P0 "vel 0 1 2 3 rubbish\n", 2, "found 'rubbish', expected the end"},
    {P0 "vfix 0 1 1 2\n", 2, "found '2', expected z: 0 (fixed) or 1"},
    {P0 "dis 0 1e308 0 0\n" P1 "dis 1 0 0 0 #\nvel 0 0 0\n", 5, "vz"},
    {"pos 0 1.7e308 0 0 1 0 1\ndis 0 1.7e308 0 0\n", 2, "beyond"},
    {P0 "species 0 -1\n", 2, "a whole number"},
    {P0 "species 0 4294967296\n", 2, "a whole number"},
    /* springs */
    {P0 "s 0 1\n", 2, "expected c: a number"},
    {P0 "s 0 -1 0\n", 2, "found '-1', expected D"},
    {P0 "s 0 1 -1\n", 2, "found '-1', expected c"},
    {P0 "s 0 1 0 1\n", 2, "expected green"},
    {P0 "s 0 1 0 1 1\n", 2, "expected blue"},
    {P0 "s 1 1 0\n", 2, "kind: 0 to 0 (lines s: 1)"},
    {P0 "s 0 1 0\ns 0 1 0\n", 3, "without a line s so far"},
    {P0 P1 "sl 0 1 0\n", 3, "kind, but there is no line s"},
    {TWO "sl 0 2 0\n", 4, "found '2', expected body"},
    {TWO "sl 0 1 1\n", 4, "found '1', expected kind"},
    {TWO "sl 1 1 0\n", 4, "found '1', expected another body"},
    {TWO "sl 0 1 0 -1\n", 4, "found '-1', expected rest"},
    {TWO "sl 0 1 0 1 1\n", 4, "expected the end"},
    {"pos 0 1e200 0 0 1 0 1\n" P1 "s 0 1 0\nsl 0 1 0\n", 4, "not so far"},
    {P0 "dashpot full\n", 2, "found 'full', expected way: ax"},
    /* what acts on all */
    {P0 "k2 1\nk2 1\n", 3, "found 'k2', expected it once only"},
    {P0 "k2 -1\n", 2, "expected k2: a number not below 0"},
    {P0 "dt 0\n", 2, "found '0', expected step: a number above 0"},
    {P0 "dt 1\n\n# dt 2\ndt 3\n", 5, "it once only"},
    {P0 "soft -1\n", 2, "softening: "},
    {P0 "damp -1\n", 2, "damping: "},
    {P0 "grav 0 0\n", 2, "expected gz"},
    {P0 "time nan\n", 2, "found 'nan', expected time"},
    {P0 "contact 1\n", 2, "found '1', expected the end"},
    {P0 "contact\ncontact\n", 3, "once only"},
    {P0 "restitution 1.1\n", 2, "from 0 to 1"},
    {P0 "linear 0\n", 2, "stiffness"},
    {P0 "linear 1 -1\n", 2, "dashpot"},
    {P0 "hertz 1 1\n", 2, "end of the line"},
    {P0 "box 0 1 0 1 0\n", 2, "expected zhigh"},
    {P0 "box 0 1 0 -1 0 1\n", 2, "found '-1', expected the high end"},
    {P0 "walls hard hard soft\n", 2,
     "'soft', expected z: open, hard or periodic"},
    {P0 "walls hard open open\n", 2, "found 'hard', expected open, as no"},
    {P0 "box 0 1 0 1 0 0\nwalls open open hard\n", 3, "found 'hard'"},
    {P0 "walls open open\n", 2, "the end of the line"}};

TEST(test_refusals, "what is refused, where and why")
{
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; ++i) {
        struct scene s;
        const struct refusal *r = &refusals[i];
        const bool good = parse(&s, r->text);
        if (good || error.line != r->line || !strstr(error.text, r->part))
            printf("not ok scene: refusal %zu - line %zu: %s (wanted "
                   "%zu: %s)\n",
                   i, error.line, error.text, r->line, r->part);
        UNIT_TRUE(!good && strstr(error.text, r->part));
        UNIT_EQUAL(error.line, r->line);
        UNIT_TRUE(s.mass == NULL && s.spring == NULL);
        if (good)
            scene_free(&s);
    }
}

/* Bytes that are no text: quoted so that they can be printed; no '\0'. */
TEST(test_bytes, "bytes that are no text")
{
    struct scene s;
    static const char zero[] = P0 "k2\0\0 1\n", odd[] = P0 "\x01\xff\x7f";
    UNIT_TRUE(!scene_parse(&s, zero, sizeof zero - 1, &error));
    UNIT_EQUAL(error.line, 2);
    UNIT_TRUE(!scene_parse(&s, odd, sizeof odd - 1, &error));
    UNIT_TRUE(strstr(error.text, "found '\?\?\?', expected") != NULL);
    char line[4000];
    memset(line, '7', sizeof line);
    UNIT_TRUE(!scene_parse(&s, line, sizeof line, &error));
    UNIT_TRUE(strstr(error.text, "777...', expected") != NULL);
    char *tight = malloc(sizeof P0 - 2); /* no room after the last byte */
    if (tight) {
        memcpy(tight, P0, sizeof P0 - 2);
        UNIT_TRUE(scene_parse(&s, tight, sizeof P0 - 2, &error));
        scene_free(&s);
    }
    free(tight);
}

/* ---- writing */

static const char *const path = "build/tests/scene-written.plist";

static bool write_to(const struct scene *s, const char *name)
{
    struct table *t = table_open("scene", name);
    if (!t)
        return false;
    scene_write(s, t);
    return table_close(t);
}

/* Any finite number, of any size and sign; sometimes a plain one. */
static double any(struct random *r)
{
    double x;
    do {
        const uint64_t bits = random_bits(r);
        memcpy(&x, &bits, sizeof x);
    } while (!isfinite(x));
    switch (random_below(r, 8)) {
    case 0: return 0;
    case 1: return -0.0;
    case 2: return 1;
    case 3: return ldexp(1 - 2 * random_uniform(r), -1070);
    case 4: return x;
    default: return 10 * random_uniform(r) - 5;
    }
}

static void fill(struct random *r, double *x, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        x[i] = any(r);
}

static void make_springs(struct scene *s, struct random *r)
{
    const size_t kinds = random_below(r, 4);
    for (size_t i = 0; i < kinds; ++i) {
        scene_add_kind(s, fabs(any(r)), fabs(any(r)));
        s->kind[i].colour[random_below(r, 3)] = random_uniform(r);
    }
    for (size_t i = random_below(r, 9); kinds && s->bodies > 1 && i; --i) {
        const size_t a = random_below(r, s->bodies);
        const size_t b =
            (a + 1 + random_below(r, s->bodies - 1)) % s->bodies;
        scene_add_spring(s, a, b, random_below(r, kinds), fabs(any(r)));
    }
}

static void make_box(struct scene *s, struct random *r)
{
    for (size_t k = 0; k < 3; ++k) {
        const double a = any(r), b = any(r);
        s->low[k] = a < b ? a : b;
        s->high[k] = a < b ? b : a;
        if (a < b || b < a)
            s->wall[k] = (enum scene_wall)random_below(r, 3);
    }
}

static void make_random(struct scene *s, struct random *r)
{
    const size_t n = 1 + random_below(r, 6);
    scene_create(s, n);
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] = fabs(any(r));
        s->radius[i] = fabs(any(r));
        s->species[i] = (uint32_t)(random_bits(r) >> random_below(r, 64));
        for (size_t k = 0; k < 3; ++k) {
            s->freedom[k * n + i] = random_below(r, 4) > 0;
            s->colour[k * n + i] = random_uniform(r);
        }
    }
    fill(r, s->charge, n);
    fill(r, s->position, 3 * n);
    fill(r, s->velocity, 3 * n);
    if (random_below(r, 2) && (s->carry = calloc(6 * n, sizeof(double))))
        fill(r, s->carry, random_below(r, 6 * n));
    if (random_below(r, 2) && (s->kept = calloc(3 * n, sizeof(double))))
        fill(r, s->kept, random_below(r, 3 * n));
    make_springs(s, r);
    make_box(s, r);
    fill(r, s->gravity, 3);
    s->k2 = fabs(any(r));
    s->softening = fabs(any(r));
    s->damping = fabs(any(r));
    s->dt = fabs(any(r));
    s->time = any(r);
    s->restitution = random_uniform(r);
    s->axial = random_below(r, 2);
    s->contact = random_below(r, 2);
    s->law = s->contact ? (enum scene_law)random_below(r, 3) : 0;
    s->stiffness = s->law ? 1e-9 + fabs(any(r)) : 0;
    s->dashpot = s->law == SCENE_LINEAR ? fabs(any(r)) : 0;
}

TEST(test_written, "what is written reads with the same bits")
{
    SEEDED(r, 8);
    for (int i = 0; i < 300; ++i) {
        FREED(scene) a, b, c;
        make_random(&a, &r);
        UNIT_TRUE(write_to(&a, path));
        UNIT_TRUE(scene_read(&b, "scene", path) && scene_same(&a, &b));
        UNIT_TRUE(scene_copy(&c, &b) && scene_same(&a, &c));
    }
    unlink(path);
}

/* What is written is read by people, too: a scene in which every sort of
   line has something to say, letter by letter. */
TEST(test_letters, "what is written, letter by letter")
{
    static const char text[] =
        "# pos body x y z mass charge radius colour\n"
        "pos 0 1 2 3 4 5 6 0 0.5 1\n"
        "pos 1 -1 -2 -3 7 0 0.25 0.25 0.75 1\n"
        "vel 1 0 0.5 0\n"
        "vfix 0 1 0 1\n"
        "species 1 3\n"
        "carry 0 0 0 0 0 0 0\n"
        "carry 1 1 2 3 4 5 6\n"
        "kept 0 1 2 3\n"
        "kept 1 0 0 0\n"
        "# s kind D c colour; sl body body kind rest\n"
        "s 0 9 0.5 1 0 0\n"
        "sl 1 0 0 2.5\n"
        "dashpot axial\n"
        "grav 0 -8 0\n"
        "damp 0.125\n"
        "k2 2\n"
        "soft 0.0625\n"
        "box -9 9 -8 8 -7 7\n"
        "walls hard periodic open\n"
        "contact\n"
        "restitution 0.5\n"
        "linear 11 12\n"
        "dt 0.03125\n"
        "time 13\n";
    FREED(scene) s;
    char written[2048];
    UNIT_TRUE(parse(&s, text));
    UNIT_TRUE(write_to(&s, path));
    FILE *file = fopen(path, "r");
    UNIT_TRUE(file != NULL);
    if (file) {
        written[fread(written, 1, sizeof written - 1, file)] = '\0';
        fclose(file);
        UNIT_SAYS(written, text);
    }
    scene_free(&s);
    remove(path);
    /* The last law of contacts counts, and has nothing of the one before.
     */
    UNIT_TRUE(parse(&s, "pos 0 1 2 3 4 5 6\nlinear 5 2\nhertz 3\n"));
    UNIT_TRUE(s.law == SCENE_HERTZ && s.contact);
    UNIT_TRUE(s.stiffness == 3 && s.dashpot == 0);
}

TEST(test_copy, "a copy is its own")
{
    struct scene a, b;
    UNIT_TRUE(scene_create(&a, 3));
    a.position[1] = 3;
    a.position[3 + 2] = 4;
    UNIT_TRUE(scene_add_kind(&a, 1, 2));
    for (int i = 0; i < 5; ++i)
        UNIT_TRUE(scene_add_spring(&a, 1, 2, 0, i == 0 ? -1 : i));
    UNIT_EQUAL(a.spring[0].rest, 5);
    UNIT_TRUE(scene_copy(&b, &a));
    for (int i = 0; i < 20; ++i) {
        UNIT_TRUE(scene_add_spring(&b, 0, 2, 0, 7));
        UNIT_TRUE(scene_add_kind(&b, 3, 4));
    }
    UNIT_EQUAL(a.springs, 5);
    UNIT_EQUAL(b.springs, 25);
    UNIT_EQUAL(b.spring[4].rest, 4);
    UNIT_EQUAL(b.kind[20].damping, 4);
    scene_free(&a);
    UNIT_EQUAL(b.spring[24].rest, 7);
    scene_free(&b);
    scene_free(&b); /* twice is harmless */
}

/* ---- files that cannot be read */

static int read_path(void *name)
{
    struct scene s;
    return scene_read(&s, "orbit", name) ? 0 : 1;
}

TEST(test_files, "files that cannot be read")
{
    struct child c = child_run(read_path, "build/tests/no such", NULL);
    UNIT_EQUAL(c.status, 1);
    UNIT_SAYS(c.err, "orbit: cannot read the scene build/tests/no "
                     "such: No such file or directory\n");
    c = child_run(read_path, "build", NULL);
    UNIT_TRUE(strstr(c.err, "Is a directory") != NULL);
    FILE *f = fopen(path, "w");
    if (f) {
        fputs(P0 "k2 1\nk2 1\n", f);
        fclose(f);
    }
    c = child_run(read_path, (void *)path, NULL);
    UNIT_EQUAL(c.status, 1);
    UNIT_SAYS(c.err, "orbit: build/tests/scene-written.plist:3: "
                     "found 'k2', expected it once only\n");
    unlink(path);
}

/* ---- the gallery */

static const char *build_pair(struct scene *s, const double value[])
{
    if (value[0] > value[1])
        return "--near is more than --far";
    if (!scene_create(s, 2))
        return "no memory";
    s->position[1] = value[1] - value[0];
    return NULL;
}

static const struct gallery_scene pairs[] = {
    {"pair",
     "two bodies",
     {{"near", 1, 0, 10, false, "a place, m"},
      {"far", 3, 0, 10, false, "another, m"}},
     build_pair},
    {0}};

TEST(test_gallery, "scenes and keys are found by name")
{
    struct scene s;
    double value[GALLERY_KEYS];
    const struct gallery_scene *g = gallery_find(pairs, "pair");
    UNIT_TRUE(g == pairs && gallery_find(pairs, "trio") == NULL);
    UNIT_EQUAL(gallery_usual(g, value), 2);
    UNIT_EQUAL(value[1], 3);
    UNIT_EQUAL(gallery_key(g, "far"), 1);
    UNIT_EQUAL(gallery_key(g, "fa"), 2);
    UNIT_TRUE(gallery_make(&s, g, NULL, 0) == NULL);
    UNIT_EQUAL(s.position[1], 2);
    scene_free(&s);
    UNIT_TRUE(gallery_make(&s, g, "near", 4) != NULL);
}
