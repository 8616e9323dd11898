/* What crosses the border of exercise 09c: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"

double eccentric_anomaly(double e, double mean);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    double e, mean, anomaly;
    border_doubles(&e, 1);
    border_doubles(&mean, 1);
    anomaly = eccentric_anomaly(e, mean);
    border_reply();
    border_doubles(&anomaly, 1);
}

#else

double eccentric_anomaly(double e, double mean)
{
    double anomaly;
    border_call();
    border_doubles(&e, 1);
    border_doubles(&mean, 1);
    border_wait();
    border_doubles(&anomaly, 1);
    return anomaly;
}

#endif
