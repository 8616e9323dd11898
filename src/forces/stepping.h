/* Stepping methods, and runs that step coordinates under forces. */
#ifndef STEPPING_H
#define STEPPING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    STEPPING_WATCH = 64, /* number of steps between checks for infinities */
    STEPPING_MOST = 64   /* largest number of methods in the table */
};

/* Forces on `size` coordinates. `accelerate` writes all accelerations (in
   m/s^2) into a[]. `damped` says whether they depend on v. */
struct stepping_forces {
    size_t size;
    bool damped;
    void (*accelerate)(void *what, const double x[], const double v[],
                       double a[]);
    void *what;
};

/* `ready` moves n coordinates, from index `from` on, to the positions at
   which the next step needs the forces. If `owing` is true, it first does
   the second half of the last step's kick. */
struct stepping_ahead {
    void (*ready)(void *step, size_t from, size_t n, bool owing);
    void *step;
};

/* Takes `steps` steps of leapfrog, except for the last half kick. Calls
   ahead->ready to move the coordinates in parts, just before it reads them
   for the forces. The speed for large systems is limited by memory:
   coordinates moved in a separate pass would have left the cache when the
   forces need them.

   In each step the function calls ahead->ready once for each coordinate,
   before it reads x and v or writes a there. In the first step `owing` is
   false. The calls may come from any thread, in any order. */
typedef void stepping_sweep(void *what, const double x[], const double v[],
                            double a[], const struct stepping_ahead *ahead,
                            uint64_t steps);

/* Moves x and v by the time dt (in s), along the part of the motion that
   is known in closed form. dt may be negative. `accelerate` computes only
   the other forces. */
typedef void stepping_flow(void *what, double dt, double x[], double v[]);

enum stepping_family {
    STEPPING_SPLITTING, /* kicks and drifts */
    STEPPING_EXPLICIT,  /* Runge-Kutta, stage after stage */
    STEPPING_IMPLICIT,  /* Runge-Kutta, all stages at once */
    STEPPING_PAIR,      /* explicit, with an estimate of its error */
    STEPPING_RADAU      /* the force as a polynomial in time */
};

/* A method: its properties and its coefficients. */
struct stepping_method {
    const char *name, *about; /* about: a phrase, for --help */
    enum stepping_family family;
    int order;
    bool symmetric, symplectic;
    size_t stages;       /* number of force evaluations in a step without
                            friction; a lower limit for implicit methods */
    size_t drifts;       /* number of drifts of a splitting */
    const double *drift; /* [drifts], in units of dt */
    const double *kick;  /* [drifts + 1] before, between and after the
                            drifts; if NULL, means of adjacent drifts */
    const double *a, *b; /* Runge-Kutta: tableau by rows, weights */
    double limit;        /* largest stable omega dt; 0 if there is none */
    bool orbits;         /* drifts follow ellipses; for gravity only */
    bool adaptive;       /* can choose the length of its steps */
    bool raced;          /* tried in the search for the cheapest method */
    const double *error, *dense; /* [stages] weights of a pair, for
                                    the error (8.15, eq:embedded)
                                    and (8.17, eq:dense) */
    const double *node;          /* [stages] of Radau's method */
    const double *weight;        /* [4 * stages] of Radau's method,
                                    explained in methods.c */
};

enum stepping_end {
    STEPPING_DONE,
    STEPPING_INFINITE, /* a coordinate or velocity is not finite */
    STEPPING_STUCK     /* the equations of an implicit step were not solved;
                          x and v are from before the step */
};

/* The state of a time-stepped run. Callers may read its members. */
struct stepping {
    const struct stepping_method *method;
    struct stepping_forces forces;
    double dt, start;      /* s; start may be set before the first step */
    uint64_t steps;        /* the time is start + steps * dt */
    double *x, *v;         /* [size], owned by the caller */
    bool compensated;      /* whether sums are compensated; set before the
                              first step */
    stepping_sweep *sweep; /* NULL, or computes accelerations in parts, for
                              leapfrog without compensation; set before the
                              first step */
    stepping_flow *flow; /* NULL for straight drifts, or the motion between
                            kicks; set before the first step */
    double *carry; /* [2 * size] rounding errors to be added to x, then v */
    double *acceleration; /* [size] last evaluated, m/s^2 */
    uint64_t evaluations; /* number of force evaluations so far */
    double tolerance;     /* of an adaptive method (adaptive.h); if 0, all
                             steps are dt; set before the first step */
    struct adaptive *own; /* state of an adaptive method, or NULL */
    /* ---- private */
    bool fresh; /* whether acceleration belongs to x (and v) */
    double *work;
    struct stepping_work *part;
};

/* All methods, followed by a row with the name NULL. */
extern const struct stepping_method stepping_methods[STEPPING_MOST + 1];

/* Returns the method of this name, or NULL. */
const struct stepping_method *stepping_find(const char *name);

/* Returns the next method after m, or the first if m is NULL, that needs
   only accelerations and takes equal steps. Returns NULL after the last. */
const struct stepping_method *stepping_next(
    const struct stepping_method *m);

/* Returns whether the method is leapfrog: (8.4, eq:verlet). */
bool stepping_is_leapfrog(const struct stepping_method *m);

/* Prepares to step x (in m) and v (in m/s) by dt (in s). The caller owns x
   and v. The method and what the forces point to must outlive s. Returns
   false, with nothing to free, if memory runs out. */
bool stepping_begin(struct stepping *s, const struct stepping_method *m,
                    struct stepping_forces f, double dt, double x[],
                    double v[]);

/* Continues a run after `steps` steps in another program. Must be called
   before the first step, with the x and v of that run. `carry` is that
   run's carry if it was compensated, otherwise NULL. `acceleration` is its
   acceleration if stepping_keeps is true, otherwise NULL. All bits then
   equal those of an uninterrupted run. */
void stepping_resume(struct stepping *s, uint64_t steps,
                     const double carry[], const double acceleration[]);

/* Returns whether each step begins with the acceleration stored at the end
   of the last step, because it cannot be computed from x and v. This is so
   for leapfrog if the forces depend on velocities: (8.13,
   eq:leapfrog-damped). */
bool stepping_keeps(const struct stepping *s);

/* Takes `steps` steps. Dividing them into several calls does not change the
   results. Checks whether all numbers are finite at the end, and after
   every STEPPING_WATCH steps of the run. */
enum stepping_end stepping_run(struct stepping *s, uint64_t steps);

/* Returns the time (in s) of x and v. */
double stepping_time(const struct stepping *s);

/* Must be called after the caller has changed x or v. */
void stepping_disturb(struct stepping *s);

void stepping_free(struct stepping *s);

/* stepping_note writes the state of s, between steps, into 5 * size + 1
   numbers. stepping_recall restores it. */
void stepping_note(const struct stepping *s, double note[]);
void stepping_recall(struct stepping *s, const double note[]);

/* Takes a part of a step, of length h (in s), without counting it in
   s->steps. When the parts add up to a step, the caller adds 1 to
   s->steps. A part of length dt equals a step to the last bit. Checks
   whether all numbers are finite. */
enum stepping_end stepping_part(struct stepping *s, double h);

/* Starts the adaptive method of s at x and v if it has not begun, or if the
   caller has changed x or v. Returns whether it was started. */
bool stepping_anew(struct stepping *s);

#endif
