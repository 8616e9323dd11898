/* Exercise 11c, worked: going back.

   As seen from the first sphere the second one is at d and has come with
   the velocity u. A time t ago it was at d - t u, and they touched when
   this was as long as both radii. With beta = d.u and depth = s^2 - d^2
   that is u^2 t^2 - 2 beta t - depth = 0. They overlap, so depth > 0 and
   the two roots have different signs: one contact lies in the past, the
   other, where they would leave each other, in the future. They approach,
   beta < 0, so the past one is (root + beta)/u^2 with the root of
   beta^2 + u^2 depth: a difference. Multiplied by root - beta, above and
   below, it becomes depth/(root - beta), in which nothing cancels.

   Then the line of centres as it WAS. Along it momentum is exchanged, as in
   chapter 1, and inverse masses let a wall be a wall.

   To fly back with the old velocity and forward with the new one is to add
   t times the change of the velocity. Both need not be done.

   It is one rule for one pair. With three that overlap, who went back
   first is a matter of taste. */

#include "exercise.h"
#include <math.h>

struct sphere {
    double im, r, x[3], v[3];
};

double go_back(struct sphere *a, struct sphere *b, double dt)
{
    double near = 0.0, beta = 0.0, line[3];
    double fast = 0.0, blow = 0.0;
    for (int k = 2; k >= 0; --k) {
        line[k] = -(a->x[k] - b->x[k]);
        const double u = b->v[k] - a->v[k];
        near += line[k] * line[k];
        beta += line[k] * u;
        fast += u * u;
    }
    const double reach = a->r + b->r, depth = reach * reach - near;
    const double root = sqrt(fast * depth + beta * beta);
    const double ago = depth / (root - beta);
    if (!(depth > 0.0 && beta < 0.0 && ago <= dt))
        return -1.0;
    for (int k = 2; k >= 0; --k) {
        line[k] -= ago * (b->v[k] - a->v[k]);
        blow += line[k] * (b->v[k] - a->v[k]);
    }
    blow *= 2.0 / (reach * reach * (a->im + b->im));
    for (int k = 2; k >= 0; --k) {
        a->v[k] += blow * a->im * line[k];
        a->x[k] += ago * blow * a->im * line[k];
        b->v[k] -= blow * b->im * line[k];
        b->x[k] -= ago * blow * b->im * line[k];
    }
    return ago;
}
