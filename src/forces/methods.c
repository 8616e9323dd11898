/* Defines the coefficients of the stepping methods and their table. */
#include "forces/stepping.h"

#include <math.h>
#include <string.h>

/* The coefficients of the methods. Programs that compute with more than
   double precision use the digits beyond the sixteenth. */
static const double leapfrog[] = {1};
static const double symplectic_euler_drift[] = {1};
static const double symplectic_euler_kick[] = {1, 0};

/* 1 / (2 - cbrt(2)), and 1 minus twice that number: (8.8,
   eq:triple-jump). */
static const double yoshida4[] = {1.3512071919596576340476878,
                                  -1.7024143839193152680953756,
                                  1.3512071919596576340476878};

/* Solution A of Yoshida (1990), with the digits given by Hairer, Lubich and
   Wanner (2006). */
static const double yoshida6[] = {
    0.78451361047755726381949763,  0.23557321335935813368479318,
    -1.17767998417887100694641568, 1.31518632068391121888424973,
    -1.17767998417887100694641568, 0.23557321335935813368479318,
    0.78451361047755726381949763};

/* Omelyan, Mryglod and Folk (2002). The method begins and ends with a
   drift, so its first and last kicks have length 0 and need no forces. */
#define XI 0.1786178958448091
#define LAMBDA (-0.2123418310626054)
#define CHI (-0.06626458266981849)
static const double pefrl_drift[] = {XI, CHI, 1 - 2 * (CHI + XI), CHI, XI};
static const double pefrl_kick[] = {0,      0.5 - LAMBDA, LAMBDA,
                                    LAMBDA, 0.5 - LAMBDA, 0};

/* Kahan and Li (1997), s17odr8a. */
static const double kahan_li8[] = {
    0.13020248308889008087881763,  0.56116298177510838456196441,
    -0.38947496264484728640807860, 0.15884190655515560089621075,
    -0.39590389413323757733623154, 0.18453964097831570709183254,
    0.25837438768632204729397911,  0.29501172360931029887096624,
    -0.60550853383003451169892108, 0.29501172360931029887096624,
    0.25837438768632204729397911,  0.18453964097831570709183254,
    -0.39590389413323757733623154, 0.15884190655515560089621075,
    -0.38947496264484728640807860, 0.56116298177510838456196441,
    0.13020248308889008087881763};

/* The method SBAB4 of Laskar and Robutel (2001): (sec:jacobi). Its kicks
   are the weights of Lobatto's quadrature. Its drifts, 1/2 - sqrt(3/28) and
   sqrt(3/28), are the distances between the nodes. */
static const double sbab4_drift[] = {
    0.17267316464601142810085377, 0.32732683535398857189914623,
    0.32732683535398857189914623, 0.17267316464601142810085377};
static const double sbab4_kick[] = {0.05, 49.0 / 180, 16.0 / 45, 49.0 / 180,
                                    0.05};

static const double euler_a[] = {0}, euler_b[] = {1};
static const double rk4_a[] = {0, 0,   0, 0, 0.5, 0, 0, 0,
                               0, 0.5, 0, 0, 0,   0, 1, 0};
static const double rk4_b[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
#define ROOT 0.28867513459481288225457439 /* sqrt(3) / 6 */
static const double gauss4_a[] = {0.25, 0.25 - ROOT, 0.25 + ROOT, 0.25};
static const double gauss4_b[] = {0.5, 0.5};
static const double midpoint_a[] = {0.5}, midpoint_b[] = {1};

/* The embedded pair of Dormand and Prince (1980), as printed by Hairer,
   Norsett and Wanner. The last stage has the weights of order 5.
   dopri5_error is the difference between these weights and those of order
   4, and dopri5_dense has Shampine's weights for dense output. A test
   checks the seventeen conditions of order 5 and the eight conditions of
   the dense weights. */
static const double dopri5_a[] = {
    /* stage 1 */
    0, 0, 0, 0, 0, 0, 0,
    /* stage 2 */
    1.0 / 5, 0, 0, 0, 0, 0, 0,
    /* stage 3 */
    3.0 / 40, 9.0 / 40, 0, 0, 0, 0, 0,
    /* stage 4 */
    44.0 / 45, -56.0 / 15, 32.0 / 9, 0, 0, 0, 0,
    /* stage 5 */
    19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729, 0, 0, 0,
    /* stage 6 */
    9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656,
    0, 0,
    /* stage 7, the end of the step */
    35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0};
static const double dopri5_error[] = {
    71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
    -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
static const double dopri5_dense[] = {
    -12715105075.0 / 11282082432.0,  0,
    87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0};

/* The zeros of (8.18, eq:radau), computed by Newton's method with fifty
   digits. A test verifies them with 113 bits. */
static const double radau15_node[] = {
    0.056262560536922146465652191, 0.18024069173689236498757994,
    0.35262471711316963737390777,  0.54715362633055538300144856,
    0.73421017721541053152321061,  0.88532094683909576809035976,
    0.9775206135612875018911745};
/* The weights that give v and x at the end of a step. They multiply the
   difference between the force at a node and the force at the start. Each
   of the seven nodes has two lines, for v and for x.

   Each weight is the sum of two doubles. The rounding error of a single
   double would be the same in all steps and visible in the energy after 1e5
   steps. The weights are computed for the rounded nodes: together with the
   force at the start, they integrate t^0 to t^7 exactly. */
static const double radau15_weight[] = {
    0.092679077401489687,  -6.9250597277834874e-19,
    0.08746471519868225,   1.2569814901812666e-18,
    0.15206531032339249,   -8.8887147275770614e-18,
    0.12465695360151906,   -3.2610478412430061e-18,
    0.18825877269455937,   7.3918563114457673e-18,
    0.12187407622906785,   -1.4568205914722731e-18,
    0.19578608372624673,   -6.629769515866781e-18,
    0.088661018030373115,  -2.849144709811723e-19,
    0.17350739781725066,   -5.6404902537018522e-18,
    0.046116500517662307,  -1.7533680008796797e-18,
    0.1248239506649325,    2.4388028082745613e-18,
    0.014314692474057891,  -2.5942757406741163e-22,
    0.057254407372128585,  1.0940827035134911e-18,
    0.0012870439486375449, -1.824978039945946e-20};

/* Macros that compute the counts of a method from the lengths of its lists.
   A composition of leapfrogs evaluates the forces once in each leapfrog.
   For any other splitting the table gives the number of evaluations
   (stages), because kicks of length 0 need no evaluation. */
#define LENGTH(list) (sizeof(list) / sizeof *(list))
#define COMPOSED(m)                                                        \
    .family = STEPPING_SPLITTING, .drifts = LENGTH(m),                     \
    .stages = LENGTH(m), .drift = m
#define SPLITTING(m)                                                       \
    .family = STEPPING_SPLITTING, .drifts = LENGTH(m##_drift),             \
    .drift = m##_drift, .kick = m##_kick
#define EXPLICIT(m)                                                        \
    .family = STEPPING_EXPLICIT, .stages = LENGTH(m##_b), .a = m##_a,      \
    .b = m##_b
#define IMPLICIT(m)                                                        \
    .family = STEPPING_IMPLICIT, .stages = LENGTH(m##_b), .a = m##_a,      \
    .b = m##_b
#define PAIR(m)                                                            \
    .family = STEPPING_PAIR, .stages = LENGTH(m##_error), .a = m##_a,      \
    .error = m##_error, .dense = m##_dense, .adaptive = true
#define RADAU(m)                                                           \
    .family = STEPPING_RADAU, .stages = LENGTH(m##_node),                  \
    .node = m##_node, .weight = m##_weight, .adaptive = true

/* The table of methods. The stability limits are computed with 113 bits
   from the matrix of a step: (8.5, eq:stability-limit). Tests verify all
   properties. */
const struct stepping_method stepping_methods[STEPPING_MOST + 1] = {
    {"euler", "straight on, and outwards", EXPLICIT(euler), .order = 1,
     .limit = 0},
    {"symplectic-euler", "a kick, then a drift",
     SPLITTING(symplectic_euler), .order = 1, .symplectic = true,
     .stages = 1, .limit = 2},
    {"leapfrog", "a drift between half kicks", COMPOSED(leapfrog),
     .order = 2, .symmetric = true, .symplectic = true, .limit = 2,
     .raced = true},
    {"rk4", "Runge and Kutta's", EXPLICIT(rk4), .order = 4,
     .limit = 2.8284271247461901},
    {"yoshida4", "leapfrogs, the triple jump", COMPOSED(yoshida4),
     .order = 4, .symmetric = true, .symplectic = true,
     .limit = 1.5734019474345401},
    {"yoshida6", "seven leapfrogs", COMPOSED(yoshida6), .order = 6,
     .symmetric = true, .symplectic = true, .limit = 2.2690579963976594,
     .raced = true},
    {"pefrl", "four kicks, small errors", SPLITTING(pefrl), .order = 4,
     .symmetric = true, .symplectic = true, .stages = 4,
     .limit = 2.9894495459067291, .raced = true},
    {"kahan-li8", "seventeen leapfrogs", COMPOSED(kahan_li8), .order = 8,
     .symmetric = true, .symplectic = true, .limit = 3.0964386800007322,
     .raced = true},
    {"implicit-midpoint", "for stiff springs", IMPLICIT(midpoint),
     .order = 2, .symmetric = true, .symplectic = true, .limit = INFINITY},
    {"gauss4", "for stiff springs, finer", IMPLICIT(gauss4), .order = 4,
     .symmetric = true, .symplectic = true, .limit = INFINITY},
    {"wisdom-holman", "leapfrog along ellipses", COMPOSED(leapfrog),
     .order = 2, .symmetric = true, .symplectic = true, .limit = 2,
     .orbits = true, .raced = true},
    {"sbab4", "the same, for small masses", SPLITTING(sbab4), .order = 2,
     .symmetric = true, .symplectic = true, .stages = 4,
     .limit = 2.9971371204864101, .orbits = true, .raced = true},
    {"dopri5", "steps of its own length", PAIR(dopri5), .order = 5,
     .raced = true},
    {"radau15", "such steps, to the last digits", RADAU(radau15),
     .order = 15, .raced = true}};

const struct stepping_method *stepping_find(const char *name)
{
    const struct stepping_method *m = stepping_methods;
    while (m->name && strcmp(m->name, name))
        ++m;
    return m->name ? m : NULL;
}

const struct stepping_method *stepping_next(const struct stepping_method *m)
{
    m = m ? m + 1 : stepping_methods;
    while (m->orbits || m->adaptive) /* the last row has neither */
        ++m;
    return m->name ? m : NULL;
}
