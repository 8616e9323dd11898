/* The suite of exercise 07b, "Pressure without walls". */

#include "examiner/check.h"
#include "call.h"

enum { MOST = 200 };

struct record {
    int dimensions;
    size_t n;
    double box[3], energy, time;
    size_t count;
    struct collision c[MOST + 1];
};

/* What the student's function answers; an untouched place reads as NaN.
   Behind the record stands a violent collision that does not belong to it.
 */
struct answer {
    double z, pressure;
};

static struct answer answer(const struct record *r)
{
    struct answer a = {CHECK_EMPTY, CHECK_EMPTY};
    struct record q = *r;
    q.c[r->count] = (struct collision){
        {1e3, 1e3}, {1.0, 1.0, 1.0}, {1e3, 1e3, 1e3}, {0.0, 0.0, 0.0}};
    a.z = compressibility(q.dimensions, q.box, q.n, q.energy, q.time,
                          q.count, q.c, &a.pressure);
    return a;
}

static const char *vector(const double v[3])
{
    return check_text("(%g, %g, %g)", v[0], v[1], v[2]);
}

static const char *input(const struct record *r)
{
    const char *first = "";
    if (r->count > 0)
        first = check_text(
            ": masses %g and %g kg, apart %s m, velocities %s and %s m/s%s",
            r->c[0].mass[0], r->c[0].mass[1], vector(r->c[0].apart),
            vector(r->c[0].first), vector(r->c[0].second),
            r->count > 1 ? "; ..." : "");
    return check_text(
        "%d dimensions, box %s m, n = %zu, %g J, %g s, %zu collision%s%s",
        r->dimensions, vector(r->box), r->n, r->energy, r->time, r->count,
        r->count == 1 ? "" : "s", first);
}

static double dot(const double a[], const double b[], int dimensions)
{
    double sum = 0.0;
    for (int k = 0; k < dimensions; ++k)
        sum += a[k] * b[k];
    return sum;
}

static double length(const double a[], int dimensions)
{
    return sqrt(dot(a, a, dimensions));
}

/* What one collision adds, right or with a slip. */

/* The two collide as seen from their centre of mass, where the first one is
   turned round along the line of centres. */
static double right(const struct collision *c, int dimensions)
{
    const double all = c->mass[0] + c->mass[1];
    const double sigma = length(c->apart, dimensions);
    double own[3] = {0}, towards[3] = {0};
    for (int k = 0; k < dimensions; ++k) {
        const double centre =
            (c->mass[0] * c->first[k] + c->mass[1] * c->second[k]) / all;
        own[k] = c->first[k] - centre;
        towards[k] = c->apart[k] / sigma;
    }
    return sigma * 2.0 * c->mass[0] * dot(own, towards, dimensions);
}

static double half(const struct collision *c, int dimensions)
{
    return 0.5 * right(c, dimensions);
}

static double negative(const struct collision *c, int dimensions)
{
    return -right(c, dimensions);
}

static double no_distance(const struct collision *c, int dimensions)
{
    return right(c, dimensions) / length(c->apart, dimensions);
}

static double not_normalised(const struct collision *c, int dimensions)
{
    return right(c, dimensions) * length(c->apart, dimensions);
}

/* As if twice the reduced mass were another one. */
static double with_mass(const struct collision *c, int dimensions,
                        double mass)
{
    const double sum = c->mass[0] + c->mass[1];
    return right(c, dimensions) * mass * sum /
           (2.0 * c->mass[0] * c->mass[1]);
}

static double first_mass(const struct collision *c, int dimensions)
{
    return with_mass(c, dimensions, c->mass[0]);
}

static double mean_mass(const struct collision *c, int dimensions)
{
    return with_mass(c, dimensions, 0.5 * (c->mass[0] + c->mass[1]));
}

static double whole_speed(const struct collision *c, int dimensions)
{
    double w[3] = {0};
    for (int k = 0; k < dimensions; ++k)
        w[k] = c->second[k] - c->first[k];
    return right(c, dimensions) * length(w, dimensions) *
           length(c->apart, dimensions) / -dot(w, c->apart, dimensions);
}

static double third_number(const struct collision *c, int dimensions)
{
    (void)dimensions;
    return right(c, 3);
}

/* Z - 1, if each collision adds what the function says. */
static double excess(const struct record *r,
                     double (*adds)(const struct collision *, int))
{
    const double n = (double)r->n;
    double sum = 0.0;
    for (size_t i = 0; i < r->count; ++i)
        sum += adds(&r->c[i], r->dimensions);
    return sum * (n - 1.0) / (2.0 * r->energy * n * r->time);
}

/* The roundings of the products that are summed, before any of them cancel:
   a few for each, and one for each sum that it has gone through. */
static double tolerance(const struct record *r)
{
    const double n = (double)r->n;
    double sum = 0.0;
    for (size_t i = 0; i < r->count; ++i) {
        const struct collision *c = &r->c[i];
        const double reduced =
            c->mass[0] * c->mass[1] / (c->mass[0] + c->mass[1]);
        sum += 2.0 * reduced * length(c->apart, r->dimensions) *
               (length(c->first, r->dimensions) +
                length(c->second, r->dimensions));
    }
    sum *= (n - 1.0) / (2.0 * r->energy * n * r->time);
    return DBL_EPSILON * (16.0 + (16.0 + (double)r->count) * sum);
}

/* The mistake whose value was got, or one without a name. */
static struct check_mistake mistake(const struct record *r, double got)
{
    const double e = excess(r, right), n = (double)r->n;
    const struct check_mistake all[] = {
        {"half-the-impulse", 1.0 + excess(r, half),
         "Half of it. That momentum would stop the two; what do they do "
         "instead?"},
        {"first-mass-for-both", 1.0 + excess(r, first_mass),
         "This would be right if both had the mass of the first. Look from "
         "the centre of mass: which mass goes with the relative velocity?"},
        {"mean-of-the-masses", 1.0 + excess(r, mean_mass),
         "This takes the mean of the two masses. Let one become very "
         "heavy: does the momentum that a light one exchanges with it grow "
         "without end?"},
        {"whole-speed", 1.0 + excess(r, whole_speed),
         "This takes all of the relative velocity. Which part of it do two "
         "smooth disks feel when they graze each other?"},
        {"third-number-read", 1.0 + excess(r, third_number),
         "In the plane a third number got into the sum. How many "
         "components does your loop take, and who tells it?"},
        {"momentum-forgotten", 1.0 + e * n / (n - 1.0),
         "This is right for n particles with as many free motions. The "
         "momentum of them all is zero: how many can still move as they "
         "like?"},
        {"dimensions-forgotten", 1.0 + e * r->dimensions,
         "Z - 1 is as many times too large as there are dimensions. In "
         "each direction, which part of distance times momentum counts, on "
         "average?"},
        {"plane-for-space", 1.0 + e * 2.0 / r->dimensions,
         "This is the temperature of a gas in the plane. Among how many "
         "directions is the energy shared here?"},
        {"ideal-part-forgotten", e,
         "The collisions alone give this. Which pressure has a gas that "
         "has none?"},
        {"distance-forgotten", 1.0 + excess(r, no_distance),
         "This sums the momentum that was exchanged. Over which distance "
         "did it jump? Which unit must the virial have?"},
        {"not-normalised", 1.0 + excess(r, not_normalised),
         "One length too many. Is what you multiply the velocity with a "
         "direction, of length 1?"},
        {"pull-for-push", 1.0 + excess(r, negative),
         "Your collisions pull. The centres approach: which sign has the "
         "scalar product of the way from one to the other and the relative "
         "velocity?"}};
    const double slack = tolerance(r);
    for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k)
        if (fabs(got - all[k].value) <= slack + 1e-9 * fabs(got) &&
            fabs(all[k].value - (1.0 + e)) > 1e-6 * fabs(e))
            return all[k];
    return (struct check_mistake){NULL, 0.0, NULL};
}

static void check_z(const struct record *r, double expected)
{
    const double got = answer(r).z;
    CHECK_NEAR(got, .quantity = "Z", .input = input(r),
               .expected = expected, .tolerance = tolerance(r),
               .because = "16 epsilons, and one for each collision, of the "
                          "sum without signs",
               .mistakes = {mistake(r, got)});
}

static double ideal(const struct record *r, int sides)
{
    const double n = (double)r->n;
    const double kt = 2.0 * r->energy / (r->dimensions * (n - 1.0));
    const double area = r->box[0] * r->box[1];
    return n * kt / (sides == 3 ? area * r->box[2] : area);
}

static void check_pressure(const struct record *r, double z)
{
    const double n = (double)r->n, p = ideal(r, r->dimensions);
    CHECK_NEAR(
        answer(r).pressure, .quantity = "*pressure",
        .unit = r->dimensions == 3 ? "N/m^2" : "N/m", .input = input(r),
        .expected = z * p,
        .tolerance = p * (tolerance(r) + 16.0 * DBL_EPSILON * z),
        .because = "that of Z, times n kT/V, and 16 epsilons",
        .mistakes = {{"third-side-read", z * ideal(r, 3),
                      "In the plane the box has an area. How many of its "
                      "sides have you multiplied?"},
                     {"pressure-of-collisions-only", (z - 1.0) * p,
                      "This is what the collisions add. Which pressure has "
                      "a gas without any?"},
                     {"pressure-without-collisions", p,
                      "This is the pressure of an ideal gas. What does Z "
                      "say about this one?"},
                     {"pressure-of-one", z * p / n,
                      "This is the pressure of one particle. How many of "
                      "them are in the box?"},
                     {"momentum-forgotten", z * p * (n - 1.0) / n,
                      "Here kT is shared among n particles. What does the "
                      "zero momentum do to the number of free motions?"},
                     {"left-empty", CHECK_EMPTY,
                      "Not a number: was *pressure filled in, even when "
                      "nothing has collided?"}});
}

static const struct record thin = {.dimensions = 2,
                                   .n = 5,
                                   .box = {4.0, 3.0, 7.0},
                                   .energy = 20.0,
                                   .time = 3.0};

static void test_none(void)
{
    check_ask("Nothing has collided, and the gas is ideal. What are P V/(N "
              "kT) and P?");
    check_z(&thin, 1.0);
    check_pressure(&thin, 1.0);
}

/* The gas above with one collision. */
static struct record one(struct collision c)
{
    struct record r = thin;
    r.count = 1;
    r.c[0] = c;
    return r;
}

/* Head on: 2 kg times 4 m/s, over 1.5 m, is 12 J s. Divided by D N kT t,
   which is 2 * 5 * 5 J * 3 s, that makes 0.08. */
static void test_head_on(void)
{
    const struct record r = one((struct collision){
        {2.0, 2.0}, {1.5, 0.0, 0.0}, {3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
    const struct record up = one((struct collision){
        {2.0, 2.0}, {0.0, -3.0, 0.0}, {1.0, -2.0, 0.0}, {1.0, 0.0, 0.0}});
    check_ask("Two equal disks meet head on and exchange their velocities. "
              "Which momentum has jumped, over which distance?");
    check_z(&r, 1.08);
    check_z(&up, 1.08);
}

/* Twice the reduced mass is 1.5 kg: 1.5 * 4 * 1.5 = 9 J s and 0.06. */
static void test_masses(void)
{
    const struct record r = one((struct collision){
        {3.0, 1.0}, {1.5, 0.0, 0.0}, {3.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
    const struct record q = one((struct collision){
        {2.0, 6.0}, {0.0, 2.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}});
    check_ask("Look at the two from their centre of mass. By how much does "
              "the momentum of either change?");
    check_z(&r, 1.06);
    check_z(&q, 1.08);
}

/* The line of centres is 5 m long, (3, 4): the velocity of approach is
   3/5 of 2 m/s, or 4/5 of it. */
static void test_oblique(void)
{
    const struct record r = one((struct collision){
        {3.0, 6.0}, {3.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
    const struct record q = one((struct collision){
        {3.0, 6.0}, {3.0, 4.0, 0.0}, {5.0, 0.0, 0.0}, {5.0, -2.0, 0.0}});
    check_ask("They meet at an angle. How fast does the distance of the "
              "centres shrink?");
    check_z(&r, 1.0 + 4.0 * 6.0 / 150.0);
    check_z(&q, 1.0 + 4.0 * 8.0 / 150.0);
}

static struct collision exchanged(struct collision c)
{
    struct collision x = {{c.mass[1], c.mass[0]}, {0}, {0}, {0}};
    for (int k = 0; k < 3; ++k) {
        x.apart[k] = -c.apart[k];
        x.first[k] = c.second[k];
        x.second[k] = c.first[k];
    }
    return x;
}

static void test_order(void)
{
    const struct collision c = {
        {3.0, 6.0}, {3.0, 4.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    const struct collision d = {
        {1.0, 4.0}, {-1.0, 0.5, 0.0}, {-1.0, 2.0, 0.0}, {3.0, 1.0, 0.0}};
    struct record r = one(c), q = one(exchanged(c));
    r.count = q.count = 2;
    r.c[1] = exchanged(d);
    q.c[1] = d;
    check_ask("This is a record in which the two of a pair have changed "
              "places. What in your formula knows who comes first?");
    check_z(&r, 1.0 + (24.0 + 7.2) / 150.0);
    check_z(&q, 1.0 + (24.0 + 7.2) / 150.0);
}

/* The collision of test_head_on, with third numbers that mean nothing. */
static void test_plane(void)
{
    const struct record r = one((struct collision){
        {2.0, 2.0}, {1.5, 0.0, 8.0}, {3.0, 0.0, 9.0}, {-1.0, 0.0, 2.0}});
    check_ask("In the plane a vector has two components. What do you do "
              "with the third number?");
    check_z(&r, 1.08);
    check_pressure(&r, 1.08);
}

/* r.w is -(1 * 2 + 2 * 1 + 2 * 3) = -10, twice the reduced mass 3 kg: 30 J
   s. D N kT t is 2 * 18 J * 5/4 * 2 s = 90. */
static void test_space(void)
{
    const struct record r = {.dimensions = 3,
                             .n = 5,
                             .box = {4.0, 3.0, 2.0},
                             .energy = 18.0,
                             .time = 2.0,
                             .count = 1,
                             .c = {{{6.0, 2.0},
                                    {1.0, 2.0, 2.0},
                                    {2.0, 0.0, 1.0},
                                    {0.0, -1.0, -2.0}}}};
    check_ask("These are spheres. Which of your numbers depend on the "
              "number of dimensions, and does Z?");
    check_z(&r, 1.0 + 30.0 / 90.0);
    check_pressure(&r, 1.0 + 30.0 / 90.0);
}

/* Two disks on one line, with zero momentum: they meet with the relative
   velocity u on one side and then, across the seam, on the other. Between
   two collisions u covers what is left of the box, L - 2 sigma. So the sum
   over the time is 2 m u^2 sigma/(L - 2 sigma), and with K = m u^2/2 and
   two disks Z is (L - sigma)/(L - 2 sigma), whatever the masses. */
static void check_two(double m0, double m1, double sigma)
{
    const double side = 10.0, u = 3.0, reduced = m0 * m1 / (m0 + m1);
    struct record r = {.dimensions = 2,
                       .n = 2,
                       .box = {side, 5.0, 0.0},
                       .energy = 0.5 * reduced * u * u,
                       .time = 100.0 * (side - 2.0 * sigma) / u,
                       .count = 100};
    for (size_t i = 0; i < r.count; ++i) {
        const double way = i % 2 ? -1.0 : 1.0;
        r.c[i] = (struct collision){{m0, m1},
                                    {way * sigma, 0.0, 0.0},
                                    {way * u * m1 / (m0 + m1), 0.0, 0.0},
                                    {-way * u * m0 / (m0 + m1), 0.0, 0.0}};
    }
    check_ask("Two disks go to and fro and meet on both sides. How often "
              "do they, and what does each collision add?");
    check_z(&r, (side - sigma) / (side - 2.0 * sigma));
}

/* limit: 2 particles */
static void test_to_and_fro(void)
{
    check_two(1.0, 1.0, 1.0);
    check_two(1.0, 3.0, 1.0);
    check_two(5.0, 0.2, 4.0);
}

static void draw_vector(double v[3], double most)
{
    for (int k = 0; k < 3; ++k)
        v[k] = check_draw(-most, most);
}

/* A collision that is made for what it adds: the distance of the centres,
   along the direction e, times the momentum exchanged, which is 2 m u for
   the reduced mass m and the speed of approach u. Across e the two may move
   as they like, and both together too. In the plane the third numbers mean
   nothing. */
static struct collision draw_collision(int dimensions, double *adds)
{
    const double m0 = check_draw(0.1, 5.0), m1 = check_draw(0.1, 5.0);
    const double sigma = check_draw(0.1, 2.0), u = check_draw(0.05, 3.0);
    struct collision c = {{m0, m1}, {0}, {0}, {0}};
    double e[3], w[3], common[3];
    do
        draw_vector(e, 1.0);
    while (length(e, dimensions) < 0.2);
    draw_vector(w, 2.0);
    draw_vector(common, 2.0);
    const double size = length(e, dimensions);
    const double along = dot(w, e, dimensions) / (size * size);
    for (int k = 0; k < 3; ++k) {
        w[k] += (u / size - along) * e[k];
        c.apart[k] = sigma * e[k] / size;
        c.first[k] = common[k] + m1 / (m0 + m1) * w[k];
        c.second[k] = common[k] - m0 / (m0 + m1) * w[k];
    }
    *adds = 2.0 * m0 * m1 / (m0 + m1) * u * sigma;
    return check_draw_whole(0, 1) ? exchanged(c) : c;
}

static struct record draw_record(double *z)
{
    struct record r = {.dimensions = check_draw_whole(2, 3),
                       .n = (size_t)check_draw_whole(2, 100),
                       .energy = check_draw(10.0, 90.0),
                       .time = check_draw(1.0, 20.0),
                       .count = (size_t)check_draw_whole(1, 60)};
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
        r.box[k] = check_draw(3.0, 9.0);
    for (size_t i = 0; i < r.count; ++i) {
        double adds;
        r.c[i] = draw_collision(r.dimensions, &adds);
        sum += adds;
    }
    *z = 1.0 + sum / (2.0 * r.energy * r.time) * (1.0 - 1.0 / r.n);
    return r;
}

CHECK_TIMES(20, test_drawn, i)
{
    double z;
    const struct record r = draw_record(&z);
    check_ask("These are collisions of all kinds. Does every one of them "
              "add what it should?");
    check_z(&r, z);
    check_ask("Z is right. What has P to do with Z, n, kT and the size of "
              "the box?");
    check_pressure(&r, z);
}

const struct check_suite check_suite = {
    .file = "07b-virial.c",
    .title = "Pressure without walls",
    .minutes = 30,
    .equation = "eq:virial",
    .tests =
        {{"a gas without collisions is ideal", test_none, 1, 0},
         {"two equal disks head on are as worked out by hand", test_head_on,
          2, 0},
         {"the reduced mass counts when masses differ", test_masses, 1, 0},
         {"only the approach of the centres counts", test_oblique, 1, 0},
         {"it does not matter who of a pair comes first", test_order, 1, 0},
         {"in the plane the third numbers mean nothing", test_plane, 1, 0},
         {"in space there are three", test_space, 1, 0},
         {"two disks that go to and fro have an exact Z", test_to_and_fro,
          2, 0},
         {"many collisions add up, and give the pressure", test_drawn, 2,
          3},
         {0}},
};
