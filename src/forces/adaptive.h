/* Methods with adaptive time steps, and interpolation within a step. */
#ifndef ADAPTIVE_H
#define ADAPTIVE_H

#include "forces/stepping.h"

/* The state at one end of a step. */
struct adaptive_state {
    double *x, *v, *a; /* [size] each; m, m/s, m/s^2 */
    double *carry;     /* [2 * size] rounding errors to be added to x, v */
};

/* The state of a run by an adaptive method. Its members may be read. */
struct adaptive {
    const struct stepping_method *method;
    struct stepping_forces forces;
    double tolerance, dt;    /* tolerance and step (s), as in struct
                                stepping */
    uint64_t taken, refused; /* numbers of accepted and rejected steps */
    uint64_t evaluations;    /* number of force evaluations */
    double t, h;             /* end and length of the last step, s */
    double shortest;         /* shortest accepted step, s; 0: none */
    /* ---- private */
    double start,           /* time at which the run began, s */
        owed,               /* rounding error of t, s */
        next;               /* proposed length of the next step, s */
    uint64_t before;        /* number of steps taken before start */
    double past, past_owed; /* t and owed before the last step, s */
    double whole;           /* length of the step described by b, s */
    bool begun;             /* whether the forces at the start are known */
    struct adaptive_state from, to; /* beginning and end of the last step */
    double noise;          /* effect of rounding errors on g_8, m/s^2 */
    double *place, *speed, /* [size] displacement or state at a stage */
        *stage;            /* [stages * size] accelerations at all stages */
    double *difference;    /* [size] scratch */
    double *g,             /* [stages * size] g_k, Radau's force in Newton
                              polynomials */
        *b,                /* [stages * size] the same force in powers of
                              s */
        *guess;            /* [stages * size] the guess of b */
    double *new_b, *new_guess; /* b and guess of a trial step */
    struct adaptive_weights *weights;
    double *work;
    /* ---- may be set */
    /* NULL, or a function that returns the longest step (in s) allowed from
       the state x, v, a */
    double (*longest)(void *with, const double x[], const double v[],
                      const double a[]);
    void *with;
    double slack;  /* fraction by which first and limited steps are
                      shortened */
    uint64_t most; /* steps fail after this number of evaluations; 0: no
                      limit */
};

/* Creates the data for runs by the adaptive method m with the forces f.
   Returns NULL if memory runs out. m and the data that f points to must
   outlive the result. */
struct adaptive *adaptive_create(const struct stepping_method *m,
                                 struct stepping_forces f);

/* Begins a run at the time t (in s), with positions x (in m) and velocities
   v (in m/s).

   In each step, an embedded pair keeps the estimated error of every
   coordinate below `tolerance` times the largest coordinate, and likewise
   for velocities. For Radau's method `tolerance` does not bound the error:
   g_7 and g_8, divided by the largest acceleration, are kept below 50 times
   the square root of `tolerance`. If `tolerance` is 0, all steps have the
   length dt (in s). */
void adaptive_begin(struct adaptive *s, double tolerance, double dt,
                    double t, const double x[], const double v[]);

/* Takes steps until one ends at or after the time t (in s), and writes the
   state at t into x and v. The choice of t does not affect the steps.
   Returns false, with x and v unchanged, if even the shortest step that
   changes the time exceeds the tolerance, or if the limit of evaluations is
   exceeded. */
bool adaptive_reach(struct adaptive *s, double t, double x[], double v[]);

/* Returns how many numbers adaptive_note writes. */
size_t adaptive_notes(const struct adaptive *s);

/* Writes the state of s into note[]. */
void adaptive_note(const struct adaptive *s, double note[]);

/* Restores a state written for the same method and forces. All later steps
   are bit-identical to those of an uninterrupted run. */
void adaptive_recall(struct adaptive *s, const double note[]);

/* Frees s, which may be NULL. */
void adaptive_free(struct adaptive *s);

enum { ADAPTIVE_DEGREE = 9 }; /* highest degree of a path */

/* Takes one step, not longer than `most` (in s). With tolerance 0 its
   length is dt. Returns false in the same cases as adaptive_reach. */
bool adaptive_step(struct adaptive *s, double most);

/* Writes the control points of each coordinate's path along the last step:
   (11.8, eq:gap-control). Returns the degree d of the paths. Each
   coordinate has ADAPTIVE_DEGREE + 1 numbers in control[] (in m), but only
   the first d + 1 are used. */
size_t adaptive_path(const struct adaptive *s, double control[]);

/* Replaces the last step by a step of length h (in s), which must not be
   longer. Sets x (in m) and v (in m/s) to the state at its end. Does not
   check the error. */
void adaptive_again(struct adaptive *s, double h, double x[], double v[]);

/* Replaces the positions (in m) and velocities (in m/s) at the end of the
   last step, as needed after a collision. */
void adaptive_turn(struct adaptive *s, const double x[], const double v[]);

/* Writes the state at the time t (in s), within the last step, into x and
   v. */
void adaptive_look(const struct adaptive *s, double t, double x[],
                   double v[]);

#endif
