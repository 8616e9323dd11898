/* mistake: numbered-from-the-right */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    for (size_t ghost = 0, k; ghost < n; ++ghost) {
        double place = fmod(x0[ghost] + v0[ghost] * t, 2.0 * length);
        double velocity = v0[ghost];
        if (place < 0.0)
            place += 2.0 * length;
        if (place > length) {
            place = 2.0 * length - place;
            velocity = -velocity;
        }
        for (k = ghost; k > 0 && x[k - 1] < place; --k) {
            x[k] = x[k - 1];
            v[k] = v[k - 1];
        }
        x[k] = place;
        v[k] = velocity;
    }
}
