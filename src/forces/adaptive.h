/* From chapters/works/08-stepping.nw: edit there, then run make tangle. */
/* checksum 1052861228 of the lines below */
/* Steps that choose their own length, and places between their ends. */
#ifndef ADAPTIVE_H
#define ADAPTIVE_H

#include "forces/stepping.h"

/* Where a step begins or ends; each [size], carry [2 * size]. */
struct adaptive_state {
    double *x, *v, *a; /* m, m/s, m/s^2 */
    double *carry;     /* what is still to be added to x, to v */
};

/* A system under way by an adaptive method. Its fields may be read. */
struct adaptive {
    const struct stepping_method *method;
    struct stepping_forces forces;
    double tolerance, dt;    /* s; as in struct stepping */
    uint64_t taken, refused; /* steps so far */
    uint64_t evaluations;    /* of the forces */
    double t, h;             /* s: end of the last step, its length */
    double shortest;         /* s, of the steps taken; 0: none */
    /* ---- private */
    double start, owed, next; /* s; owed by t; the step to come */
    uint64_t before;          /* steps taken before start */
    double past, past_owed;   /* t and owed where the last began, s */
    double whole;             /* length that b belongs to, s */
    bool begun; /* false: the next reach begins where the caller is */
    struct adaptive_state from, to; /* of the last step */
    double blur;                    /* what rounding makes of g, m/s^2 */
    double *place, *speed, *stage;  /* at a stage; accelerations there */
    double *difference;             /* room for one of them, [size] */
    double *g, *b, *guess;     /* of Radau's, [stages * size]: the force */
    double *new_b, *new_guess; /* in the last step, and in a trial */
    struct adaptive_weights *weights;
    double *work;
    /* ---- may be set: NULL, or the longest step from these places and
       velocities, s; by what share the first step and those that a bound
       cuts off are shorter than they may be; and 0, or so many evaluations
       after which no step is taken */
    double (*longest)(void *with, const double x[], const double v[],
                      const double a[]);
    void *with;
    double slack;
    uint64_t most;
};

/* Prepares for an adaptive method m, which has to outlive it, as what the
   forces point to. NULL without memory. */
struct adaptive *adaptive_create(const struct stepping_method *m,
                                 struct stepping_forces f);

/* Begins at x, m, and v, m/s, at the time t, s. In a step of its own the
   pair keeps its estimate of the error of a coordinate below `tolerance`
   times the largest one, that of a velocity likewise. For Radau's method
   `tolerance` is a calibrated scale and no bound: g_7, as a share of the
   largest acceleration, is kept below 50 times its root. With 0 all steps
   are dt long, s. */
void adaptive_begin(struct adaptive *s, double tolerance, double dt,
                    double t, const double x[], const double v[]);

/* Takes steps until one ends at the time t, s, or behind it, and puts
   place and velocity at that time into x and v. Which times are asked for
   changes no step. false: a step so short that time stands still was still
   too long; x and v are left alone. */
bool adaptive_reach(struct adaptive *s, double t, double x[], double v[]);

/* Puts down where s is, into adaptive_notes numbers, or goes there: another
   s of the same method and forces then goes on with the same bits. */
size_t adaptive_notes(const struct adaptive *s);
void adaptive_note(const struct adaptive *s, double note[]);
void adaptive_recall(struct adaptive *s, const double note[]);

/* s may be NULL. */
void adaptive_free(struct adaptive *s);

enum { ADAPTIVE_DEGREE = 9 }; /* of a path, at most */

/* Takes one step; where it may choose, of at most `most`, s. false: as
   above. */
bool adaptive_step(struct adaptive *s, double most);

/* Writes the control points of all places along the last step: for each
   coordinate ADAPTIVE_DEGREE + 1 numbers, m, of which the first degree + 1
   count (11.8, eq:gap-control). Returns the degree. */
size_t adaptive_path(const struct adaptive *s, double control[]);

/* Takes the last step again, h, s, long, from 0 to the length it had: it
   ends there from then on, at x, m, and v, m/s. Nothing is estimated. */
void adaptive_again(struct adaptive *s, double h, double x[], double v[]);

/* Goes on from the end of the last step with other places, m, and
   velocities, m/s. */
void adaptive_turn(struct adaptive *s, const double x[], const double v[]);

/* What adaptive_reach puts into x and v, of a time t within the last
   step, s. */
void adaptive_look(const struct adaptive *s, double t, double x[],
                   double v[]);

#endif
