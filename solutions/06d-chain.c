/* Exercise 06d, worked: a push that is handed on.

   How far can disk i go? A disk that stands aside by no less than sigma is
   never touched. Otherwise they touch when the centres are sigma apart, and
   by Pythagoras i is then sqrt(sigma^2 - aside^2) behind. In a box without
   edges "aside" is the shorter way across, and "ahead" the way to the
   right, between 0 and the width, even to a disk whose x is smaller.

   The nearest of these touches is what happens next, if the rest of the
   length reaches that far. Then i stays where it is, the rest is shorter by
   what it has gone, and the other one goes on, from where it stands.

   After a touch the two are as near as they can be, and a rounding may have
   them nearer: no way is shorter than zero. The disk that has just handed
   on is behind, and so almost a whole width ahead.

   Nothing is ever drawn here but what the caller has drawn: the disk, the
   axis and the length. Nothing is rejected. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first, double length)
{
    size_t handed = 0;
    for (size_t now = first;; ++handed) {
        size_t touched = now;
        double free = length;
        for (size_t other = n; other-- > 0;) {
            const double aside = remainder(y[other] - y[now], height);
            const double ahead = x[other] - x[now];
            if (other == now || fabs(aside) >= sigma)
                continue;
            const double way = (ahead < 0.0 ? ahead + width : ahead) -
                               sqrt(sigma * sigma - aside * aside);
            if (way < free) {
                free = fmax(way, 0.0);
                touched = other;
            }
        }
        x[now] = fmod(x[now] + free, width);
        if (touched == now)
            return handed;
        length -= free;
        now = touched;
    }
}
