/* What crosses the border of exercise 01b: see examiner/border.h. */
/* place: measure_collision mass_ratio 1 */
/* place: measure_collision restitution 1 */

#include "examiner/border.h"

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution);

/* The arguments; the two places follow. */
struct call {
    double u1, u2, v1, v2;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->u1, 1);
    border_doubles(&c->u2, 1);
    border_doubles(&c->v1, 1);
    border_doubles(&c->v2, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *mass_ratio = border_place_doubles("mass_ratio", 1);
    double *restitution = border_place_doubles("restitution", 1);
    bool told =
        measure_collision(c.u1, c.u2, c.v1, c.v2, mass_ratio, restitution);
    border_reply();
    border_bools(&told, 1);
    border_doubles(mass_ratio, 1);
    border_doubles(restitution, 1);
}

#else

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    struct call c = {u1, u2, v1, v2};
    bool told = false;
    border_call();
    move_arguments(&c);
    border_doubles(mass_ratio, 1);
    border_doubles(restitution, 1);
    border_wait();
    border_bools(&told, 1);
    border_doubles(mass_ratio, 1);
    border_doubles(restitution, 1);
    return told;
}

#endif
