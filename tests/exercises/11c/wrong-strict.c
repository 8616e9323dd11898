/* mistake: dt-itself-refused */
/* What touched just dt ago is refused. Found by a trial of the second
 * edition, when it earned full points. */

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
    if (!(depth > 0.0 && beta < 0.0 && ago < dt))
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
