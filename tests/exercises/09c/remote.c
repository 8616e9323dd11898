/* The remote calls of exercise 09c: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"

double eccentric_anomaly(double e, double mean);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    double e, mean, anomaly;
    remote_doubles(&e, 1);
    remote_doubles(&mean, 1);
    anomaly = eccentric_anomaly(e, mean);
    remote_reply();
    remote_doubles(&anomaly, 1);
}

#else

double eccentric_anomaly(double e, double mean)
{
    double anomaly;
    remote_call();
    remote_doubles(&e, 1);
    remote_doubles(&mean, 1);
    remote_wait();
    remote_doubles(&anomaly, 1);
    return anomaly;
}

#endif
