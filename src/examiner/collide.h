/* The elastic collision of two beads, for students' programs. */
#ifndef EXAMINER_COLLIDE_H
#define EXAMINER_COLLIDE_H

#ifdef EXAMINER_GIVES
void collide(double m1, double m2, double *v1, double *v2);
#else
/* Changes the velocities *v1 and *v2 [m/s] of two bodies with masses m1 and
   m2 [kg] by an elastic collision: in the frame of the centre of mass, both
   velocities are reversed (1.4, eq:reverse). */
static inline void collide(double m1, double m2, double *v1, double *v2)
{
    const double before = *v1 - *v2;
    *v1 -= 2.0 * before * (m2 / (m1 + m2));
    *v2 += 2.0 * before * (m1 / (m1 + m2));
}
#endif

#endif
