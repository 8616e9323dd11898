/* Steps that choose their own length, and states within them. */
#ifndef ADAPTIVE_H
#define ADAPTIVE_H

#include "forces/stepping.h"

/* The state at one end of a step; each array [size], carry [2 * size]. */
struct adaptive_state {
    double *x, *v, *a; /* m, m/s, m/s^2 */
    double *carry;     /* rounding errors of the sums for x, then for v */
};

/* The state of a run by an adaptive method. Its members may be read. */
struct adaptive {
    const struct stepping_method *method;
    struct stepping_forces forces;
    double tolerance, dt;    /* dt in s; as in struct stepping */
    uint64_t taken, refused; /* steps so far */
    uint64_t evaluations;    /* of the forces */
    double t, h;             /* end and length of the last step, s */
    double shortest;         /* shortest accepted step, s; 0: none */
    /* ---- private */
    double start, owed, next; /* s; owed: rounding of t; next: proposed
                                 length */
    uint64_t before;          /* steps taken before start */
    double past, past_owed;   /* t and owed before the last step, s */
    double whole;             /* length of the step described by b, s */
    bool begun; /* false: the next step begins at x and v of the caller */
    struct adaptive_state from, to; /* ends of the last step */
    double noise;                   /* rounding in g_7 and g_8, m/s^2 */
    double *place, *speed, *stage;  /* at a stage, all accelerations */
    double *difference;             /* scratch, [size] */
    double *g, *b, *guess;          /* [stages * size] Radau's force in
                                       Newton's form, in powers, guessed */
    double *new_b, *new_guess;      /* b and guess of a trial step */
    struct adaptive_weights *weights;
    double *work;
    /* ---- may be set */
    /* NULL, or returns the longest step allowed from a state, s */
    double (*longest)(void *with, const double x[], const double v[],
                      const double a[]);
    void *with;
    double slack;  /* fraction by which the first step, and those limited by
                      `longest`, are shortened */
    uint64_t most; /* no step begins after more evaluations; 0: no limit */
};

/* Returns the data of an adaptive method m, or NULL if memory runs out. m
   and what the forces point to must outlive them. */
struct adaptive *adaptive_create(const struct stepping_method *m,
                                 struct stepping_forces f);

/* Begins at x, m, and v, m/s, at the time t, s. The pair keeps the
   estimated error of a coordinate in each step below `tolerance` times the
   largest coordinate, and likewise for velocities. For Radau's method
   `tolerance` is a calibrated scale and no bound: g_7, as a fraction of the
   largest acceleration, is kept below 50 times the root of `tolerance`.
   With tolerance 0 all steps have the length dt, s. */
void adaptive_begin(struct adaptive *s, double tolerance, double dt,
                    double t, const double x[], const double v[]);

/* Takes steps until one ends at or after the time t, s, and writes the
   state at t into x and v. The requested times change no step. Returns
   false, with x and v unchanged, if a step too short to change the time was
   still too long. */
bool adaptive_reach(struct adaptive *s, double t, double x[], double v[]);

/* Write the state of s into adaptive_notes numbers, and restore it: another
   s with this method and these forces then continues with equal bits. */
size_t adaptive_notes(const struct adaptive *s);
void adaptive_note(const struct adaptive *s, double note[]);
void adaptive_recall(struct adaptive *s, const double note[]);

/* Frees s, which may be NULL. */
void adaptive_free(struct adaptive *s);

enum { ADAPTIVE_DEGREE = 9 }; /* highest degree of a path */

/* Takes one step of at most `most`, s, or of dt if all steps are. Returns
   false as adaptive_reach does. */
bool adaptive_step(struct adaptive *s, double most);

/* Writes the control points of the path of each coordinate along the last
   step, (11.8, eq:gap-control): ADAPTIVE_DEGREE + 1 numbers, m, of which
   the first degree + 1 are used. Returns the degree. */
size_t adaptive_path(const struct adaptive *s, double control[]);

/* Replaces the last step by one of length h, s, which must not be longer,
   and sets x, m, and v, m/s, to the state at its end. No error is
   estimated. */
void adaptive_again(struct adaptive *s, double h, double x[], double v[]);

/* Replaces places, m, and velocities, m/s, at the end of the last step,
   after a collision. */
void adaptive_turn(struct adaptive *s, const double x[], const double v[]);

/* Writes the state at the time t within the last step, s, into x and v. */
void adaptive_look(const struct adaptive *s, double t, double x[],
                   double v[]);

#endif
