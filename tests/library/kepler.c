/* Kepler's equation against values of 18 digits (computed for this book
   with 40), cosine and sine against the library, places and velocities
   against each other. */
#include "unit.h"

#include <forces/kepler.c> /* of src: what the search begins with */

#include <float.h>

/* A few units in the last place: two roundings of E, one of e sin E,
   divided by the slope 1 - e cos E, which is 0.33 at least here. */
TEST(test_anomaly, "Kepler's equation has its known roots")
{
    static const double known[][5] = {
        {0.1, 2.5, 2.55532553507637626, -0.933011714714304616,
         0.550482123521960192},
        {0.5, 1.0, 1.49870113351784831, -0.427967245561113551,
         0.863775701045103672},
        {0.9, 0.1, 0.630843527563153431, -0.0924697389423499145,
         0.257099254608937101},
        {0.99, 1.0, 1.92763555069583492, -1.33931431819182869,
         0.132180907060789001}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        const double *row = known[i], turn = 2 * KEPLER_PI;
        double x[3], v[3];
        UNIT_NEAR(kepler_anomaly(row[0], row[1]), row[2], 2e-15);
        UNIT_NEAR(kepler_anomaly(row[0], -row[1]), -row[2], 2e-15);
        UNIT_NEAR(kepler_anomaly(row[0], row[1] + 3 * turn),
                  row[2] + 3 * turn, 3e-14);
        kepler_place(
            1, &(struct kepler_elements){1, row[0], 0, 0, 0, row[1]}, x, v);
        UNIT_LIST(x, 2e-15, row[3], row[4]);
    }
}

TEST(test_residual, "and every root solves it")
{
    double worst = 0;
    for (int i = 0; i <= 60; ++i) {
        const double e = 1 - pow(2, -i / 1.5);
        if (e >= 1)
            break;
        for (double m = -10; m < 10; m += 0.0173) {
            const long double a = kepler_anomaly(e, m);
            worst = fmax(worst, (double)fabsl(a - e * sinl(a) - m));
        }
        for (double m = 1e-18; m < 1; m *= 3) { /* small times */
            const long double a = kepler_anomaly(e, m);
            worst = fmax(worst, (double)fabsl(a - e * sinl(a) - m));
        }
    }
    UNIT_NEAR(worst, 0, 20 * DBL_EPSILON);
    UNIT_EQUAL(kepler_anomaly(0.99, 0), 0);
    UNIT_EQUAL(kepler_anomaly(0, 1.25), 1.25);
}

TEST(test_turn, "cosine and sine are right to a rounding")
{
    double worst = 0, c, s;
    for (int i = -200000; i <= 200000; ++i) {
        const double angle = i * 0.4987654321;
        kepler_turn(angle, &c, &s);
        worst = fmax(worst, (double)fabsl(c - cosl(angle)));
        worst = fmax(worst, (double)fabsl(s - sinl(angle)));
    }
    UNIT_NEAR(worst, 0, 2.3e-16);
    kepler_turn(0, &c, &s);
    UNIT_EQUAL(c, 1);
    UNIT_EQUAL(s, 0);
}

TEST(test_shape, "a place gives back the shape of its orbit")
{
    for (double e = 0; e < 1; e += 0.07)
        for (double m = -3; m < 3; m += 0.7) {
            const struct kepler_elements o = {1.7, e, 0.4, 1.1, 2.3, m};
            double x[3], v[3], a, got;
            kepler_place(2, &o, x, v);
            kepler_shape(2, x, v, &a, &got);
            UNIT_NEAR(a, 1.7, 4e-14); /* 2/r is 30/a at e = 0.98 */
            UNIT_NEAR(got, e, e > 0.01 ? 3e-14 : 1e-14);
        }
    double a, e;
    kepler_shape(1, (double[]){1, 0, 0}, (double[]){0, 2, 0}, &a, &e);
    UNIT_TRUE(a < 0 && e > 1);
}

/* From one place to another, forwards and back, is what the elements say:
   20 rad, with a few roundings in the axis that n comes from, and more of
   them where 2/r is large. */
TEST(test_move, "the closed form goes from place to place")
{
    static const double e[] = {0, 1e-9, 0.2, 0.7, 0.99};
    for (int i = 0; i < 5; ++i)
        for (double m = -3; m < 3; m += 0.41)
            for (double by = -20; by < 20; by += 1.7) {
                const double speed = (1 + e[i]) / (1 - e[i]);
                struct kepler_elements o = {1, e[i], 0.3, 0.2, 1.1, m};
                double x[3], v[3], right[3], u[3];
                kepler_place(1, &o, x, v);
                kepler_move(1, by, x, v);
                o.mean_anomaly = m + by;
                kepler_place(1, &o, right, u);
                for (int k = 0; k < 3; ++k)
                    UNIT_NEAR(x[k], right[k], 1e-13 * speed * speed);
            }
}

/* What the first guess of the search is wrong by is of the third order in
   the time: an eighth of it for half the time, and the next order takes 1
   part in 50 here. */
TEST(test_guess, "its search begins close by")
{
    static const double e[] = {0.1, 0.5, 0.9};
    for (int i = 0; i < 3; ++i)
        for (double at = -3; at < 3.1; at += 0.75) {
            const double p = e[i] * cos(at), q = e[i] * sin(at);
            double miss[2];
            for (int k = 0; k < 2; ++k) {
                const double d = ldexp(2e-3 * (1 - e[i]), -k);
                const double m = d - p * sin(d) + q * (1 - cos(d));
                miss[k] = first_guess(p, q, m) - d;
            }
            UNIT_NEAR(miss[0] / miss[1], 8, 0.16);
        }
}

/* After a period all is as it was, to the last bit where the mean motion
   is 1; and where there is no period, on a parabola, nothing but x is
   written. */
TEST(test_period, "a period changes no bit")
{
    double x[3] = {1, 0, 0}, v[3] = {0, 1, 0};
    kepler_move(1, 2 * KEPLER_PI, x, v);
    UNIT_LIST(x, 0, 1, 0);
    UNIT_LIST(v, 0, 0, 1);
    x[0] = 2;
    kepler_move(1, 1, x, v);
    UNIT_TRUE(isnan(x[0]));
    UNIT_EQUAL(x[1], 0);
    UNIT_EQUAL(v[1], 1);
}
