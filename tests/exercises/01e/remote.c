/* The remote calls of exercise 01e: see examiner/remote.h. The
   function that is tried stays with the judge; the sandbox asks for it,
   collision by collision. */
/* output: none */

#include "examiner/remote.h"

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2));

#ifdef REMOTE_SERVER

static void collide(double m1, double m2, double *v1, double *v2)
{
    remote_callback(0);
    remote_doubles(&m1, 1);
    remote_doubles(&m2, 1);
    remote_doubles(v1, 1);
    remote_doubles(v2, 1);
    remote_callback_wait();
    remote_doubles(v1, 1);
    remote_doubles(v2, 1);
}

void remote_serve(void)
{
    bool right = passes(collide);
    remote_reply();
    remote_bools(&right, 1);
}

#else

static void (*tried)(double m1, double m2, double *v1, double *v2);

void remote_serve_callback(int which)
{
    double m1, m2, v1, v2;
    (void)which;
    remote_doubles(&m1, 1);
    remote_doubles(&m2, 1);
    remote_doubles(&v1, 1);
    remote_doubles(&v2, 1);
    tried(m1, m2, &v1, &v2);
    remote_callback_reply();
    remote_doubles(&v1, 1);
    remote_doubles(&v2, 1);
}

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    bool right;
    tried = collide;
    remote_restart();
    remote_call();
    remote_wait();
    remote_bools(&right, 1);
    return right;
}

#endif
