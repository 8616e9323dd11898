/* Project P1: nothing crosses but its arguments, its files and its table,
   see examiner/run.h. Here is what it is given in place of the header's
   collide: right ones, 0 and 7, and wrong ones. */
/* output: none */

#include "examiner/run.h"

#ifdef REMOTE_GIVEN

void collide_0(double m1, double m2, double *v1, double *v2);
void collide_1(double m1, double m2, double *v1, double *v2);
void collide_2(double m1, double m2, double *v1, double *v2);
void collide_3(double m1, double m2, double *v1, double *v2);
void collide_4(double m1, double m2, double *v1, double *v2);
void collide_5(double m1, double m2, double *v1, double *v2);
void collide_6(double m1, double m2, double *v1, double *v2);
void collide_7(double m1, double m2, double *v1, double *v2);

void collide_0(double m1, double m2, double *v1, double *v2)
{
    const double still = (m1 * *v1 + m2 * *v2) / (m1 + m2);
    *v1 = still - (*v1 - still);
    *v2 = still - (*v2 - still);
}

/* A millionth of the relative velocity is lost. */
void collide_1(double m1, double m2, double *v1, double *v2)
{
    const double still = (m1 * *v1 + m2 * *v2) / (m1 + m2);
    *v1 = still - 0.999999 * (*v1 - still);
    *v2 = still - 0.999999 * (*v2 - still);
}

/* What comes is no number. */
void collide_2(double m1, double m2, double *v1, double *v2)
{
    const double none = m1 - m1;
    (void)m2;
    *v1 = *v2 = none / none;
}

/* Nothing happens. */
void collide_3(double m1, double m2, double *v1, double *v2)
{
    (void)m1, (void)m2, (void)v1, (void)v2;
}

/* Both turn back. */
void collide_4(double m1, double m2, double *v1, double *v2)
{
    (void)m1, (void)m2;
    *v1 = -*v1;
    *v2 = -*v2;
}

/* They exchange their velocities, whatever they weigh. */
void collide_5(double m1, double m2, double *v1, double *v2)
{
    const double first = *v1;
    (void)m1, (void)m2;
    *v1 = *v2;
    *v2 = first;
}

/* Right three thousand times, and then a hundredth is lost. */
void collide_6(double m1, double m2, double *v1, double *v2)
{
    static int times;
    if (++times <= 3000)
        collide_0(m1, m2, v1, v2);
    else {
        const double still = (m1 * *v1 + m2 * *v2) / (m1 + m2);
        *v1 = still - 0.99 * (*v1 - still);
        *v2 = still - 0.99 * (*v2 - still);
    }
}

/* Right, and rounded in another way. */
void collide_7(double m1, double m2, double *v1, double *v2)
{
    const double blow = 2.0 * (*v1 - *v2) / (1.0 / m1 + 1.0 / m2);
    *v1 -= blow / m1;
    *v2 += blow / m2;
}

#endif
