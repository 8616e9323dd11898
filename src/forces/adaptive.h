/* Steps that choose their own length, and the places between their ends. */
#ifndef ADAPTIVE_H
#define ADAPTIVE_H

#include "forces/stepping.h"

/* One end of a step; each [size], carry [2 * size]. */
struct adaptive_state {
    double *x, *v, *a; /* m, m/s, m/s^2 */
    double *carry;     /* what compensated sums still owe x, then v */
};

/* A system that an adaptive method steps. Its fields may be read. */
struct adaptive {
    const struct stepping_method *method;
    struct stepping_forces forces;
    double tolerance, dt;    /* s; as in struct stepping */
    uint64_t taken, refused; /* steps so far */
    uint64_t evaluations;    /* of the forces */
    double t, h;             /* s: end of the last step, its length */
    double shortest;         /* s, of the steps taken; 0: none */
    /* ---- private */
    double start, owed, next; /* s; the rounding error of t; the length
                                 proposed for the next step */
    uint64_t before;          /* steps taken before start */
    double past, past_owed;   /* s; t and owed before the last step */
    double whole;             /* s; the length to which b belongs */
    bool begun; /* false: the next step begins at the caller's x and v */
    struct adaptive_state from, to; /* of the last step */
    double noise;                   /* rounding in g_7 and g_8, m/s^2 */
    double *place, *speed, *stage;  /* at a stage, accelerations there */
    double *difference;             /* memory for one of them, [size] */
    double *g, *b, *guess;     /* Radau's, [stages * size]: the force as a
                                  polynomial, Newton's form and powers */
    double *new_b, *new_guess; /* the same of a step that is tried */
    struct adaptive_weights *weights;
    double *work;
    /* ---- may be set */
    /* NULL, or returns the longest step from these places, s */
    double (*longest)(void *with, const double x[], const double v[],
                      const double a[]);
    void *with;
    double slack;  /* by what fraction the first step, and those that
                      `longest' bounds, are shorter than they may be */
    uint64_t most; /* evaluations after which no step is taken; 0: none */
};

/* Returns what an adaptive method m needs, or NULL if memory runs out. m
   and what the forces point to must outlive it. */
struct adaptive *adaptive_create(const struct stepping_method *m,
                                 struct stepping_forces f);

/* Begins at x, m, and v, m/s, at the time t, s. In a step of its own the
   pair keeps its estimate of the error of a coordinate below `tolerance`
   times the largest one, that of a velocity likewise. For Radau's method
   `tolerance` is a calibrated scale and no bound: g_7, as a fraction of
   the largest acceleration, is kept below 50 times its root. With 0 all
   steps are dt long, s. */
void adaptive_begin(struct adaptive *s, double tolerance, double dt,
                    double t, const double x[], const double v[]);

/* Takes steps until one ends at the time t, s, or behind it, and writes
   place and velocity at that time into x and v. Which times are asked for
   changes no step. Returns false, and leaves x and v alone, when a step so
   short that it no longer changes the time was still too long. */
bool adaptive_reach(struct adaptive *s, double t, double x[], double v[]);

/* Write the state of s into adaptive_notes numbers, and restore it: another
   s of the same method and forces then goes on with the same bits. */
size_t adaptive_notes(const struct adaptive *s);
void adaptive_note(const struct adaptive *s, double note[]);
void adaptive_recall(struct adaptive *s, const double note[]);

/* Frees s, which may be NULL. */
void adaptive_free(struct adaptive *s);

enum { ADAPTIVE_DEGREE = 9 }; /* the highest degree of a path */

/* Takes one step, of at most `most`, s, unless all are dt long. Returns
   false as adaptive_reach does. */
bool adaptive_step(struct adaptive *s, double most);

/* Writes the control points of the path of each coordinate along the last
   step, (11.8, eq:gap-control): ADAPTIVE_DEGREE + 1 numbers, m, of which
   the first degree + 1 count. Returns the degree. */
size_t adaptive_path(const struct adaptive *s, double control[]);

/* Replaces the last step by one of length h, s, which must not be longer
   than it, and sets x, m, and v, m/s, to the state at its end. No error is
   estimated. */
void adaptive_again(struct adaptive *s, double h, double x[], double v[]);

/* Replaces places, m, and velocities, m/s, at the end of the last step,
   after a collision. */
void adaptive_turn(struct adaptive *s, const double x[], const double v[]);

/* Writes place and velocity at a time t within the last step, s, as
   adaptive_reach does. */
void adaptive_look(const struct adaptive *s, double t, double x[],
                   double v[]);

#endif
