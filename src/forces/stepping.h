/* Stepping methods, and runs that step coordinates under forces. */
#ifndef STEPPING_H
#define STEPPING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    STEPPING_WATCH = 64, /* steps after which numbers are checked */
    STEPPING_MOST = 64   /* methods for which the table has room */
};

/* Forces on `size` coordinates: accelerate writes all of a, the second
   derivative of x, m/s^2. damped: it depends on v. */
struct stepping_forces {
    size_t size;
    bool damped;
    void (*accelerate)(void *what, const double x[], const double v[],
                       double a[]);
    void *what;
};

/* A function that moves n coordinates, from number `from` on, to the places
   at which the forces of the next step are computed; owing: the second half
   of the last step's kick comes first. */
struct stepping_ahead {
    void (*ready)(void *step, size_t from, size_t n, bool owing);
    void *step;
};

/* Computes the accelerations of `steps` steps of leapfrog, and moves the
   coordinates part by part, just before it reads them: a large system is as
   slow as its memory, and a number that is moved in a pass of its own has
   left the cache when the forces need it. It calls ahead->ready for each
   coordinate once in a step, before it reads x and v or writes a there; in
   the first step with owing = false, from any thread, in any order. */
typedef void stepping_sweep(void *what, const double x[], const double v[],
                            double a[], const struct stepping_ahead *ahead,
                            uint64_t steps);

/* Moves x and v on by the time dt, s, of either sign, along the part of the
   motion that a system knows in closed form; accelerate has the rest. */
typedef void stepping_flow(void *what, double dt, double x[], double v[]);

enum stepping_family {
    STEPPING_SPLITTING, /* kicks and drifts */
    STEPPING_EXPLICIT,  /* Runge-Kutta, stage after stage */
    STEPPING_IMPLICIT,  /* Runge-Kutta, all stages at once */
    STEPPING_PAIR,      /* explicit, with an estimate of its error */
    STEPPING_RADAU      /* the force as a polynomial in time */
};

/* A method is a row of numbers. */
struct stepping_method {
    const char *name, *about; /* about: a phrase, for --help */
    enum stepping_family family;
    int order;
    bool symmetric, symplectic;
    size_t stages; /* force evaluations in a step without friction; for an
                      implicit method the least possible number */
    size_t drifts; /* of a splitting */
    const double *drift; /* [drifts], in units of dt */
    const double *kick;  /* [drifts + 1]: before, between and after the
                            drifts; NULL: each kick is the mean of the
                            adjacent drifts */
    const double *a, *b; /* Runge-Kutta: the tableau by rows, the weights */
    double limit;  /* of omega dt for an oscillator; INFINITY: none, 0: it
                      is never stable */
    bool orbits;   /* a splitting for bodies that attract each other, and
                      for nothing else: it drifts along a flow */
    bool adaptive; /* its steps can choose their own length */
    bool raced;    /* tried where the cheapest method is looked for */
    const double *error, *dense; /* [stages], of a pair:
                                    (8.15, eq:embedded),
                                    (8.17, eq:dense) */
    const double *node;          /* of Radau's, [stages] */
    const double *weight;        /* of Radau's, [4 * stages]: for v and for
                                    x, head and tail of each weight */
};

enum stepping_end {
    STEPPING_DONE,
    STEPPING_INFINITE, /* a coordinate or velocity is no longer finite */
    STEPPING_STUCK     /* the equations of an implicit step have not been
                          solved: x and v are those before that step */
};

/* A system under way. Its fields may be read. */
struct stepping {
    const struct stepping_method *method;
    struct stepping_forces forces;
    double dt, start; /* s; start is 0 unless written before the first
                         step */
    uint64_t steps;   /* the time is start + steps * dt */
    double *x, *v;    /* of the caller, [size] */
    bool compensated; /* sums carry their rounding errors; to be set before
                         the first step */
    stepping_sweep *sweep; /* NULL, or a way to find the accelerations of
                              forces.what in parts: same bits, for leapfrog
                              that is not compensated; to be set as well */
    stepping_flow *flow; /* NULL: drifts go straight on; or how forces.what
                            moves between kicks; to be set as well */
    double *carry; /* [2 * size]: what is still to be added to x, to v */
    double *acceleration; /* [size] of the last evaluation */
    uint64_t evaluations; /* of the forces so far */
    double tolerance;     /* of an adaptive method: of its own steps, see
                             adaptive.h; 0: they are all dt long. To be set
                             before the first step */
    struct adaptive *own; /* of an adaptive method, or NULL */
    /* ---- private */
    bool fresh; /* acceleration belongs to x (and v) as they are */
    double *work;
    struct stepping_work *part;
};

/* All methods; behind the last one is a row with the name NULL. */
extern const struct stepping_method stepping_methods[STEPPING_MOST + 1];

/* Returns the method of this name, or NULL. */
const struct stepping_method *stepping_find(const char *name);

/* Returns the method after m (the first one if m is NULL) that needs
   nothing but accelerations and takes equal steps; NULL after the last. */
const struct stepping_method *stepping_next(
    const struct stepping_method *m);

/* Returns whether the steps are those of leapfrog: (8.4, eq:verlet). */
bool stepping_is_leapfrog(const struct stepping_method *m);

/* Prepares to step x (m) and v (m/s), which stay the caller's, by dt, s.
   The method and what the forces point to must outlive s. Returns false,
   with nothing to free, when there is no memory. */
bool stepping_begin(struct stepping *s, const struct stepping_method *m,
                    struct stepping_forces f, double dt, double x[],
                    double v[]);

/* Lets a run go on after `steps` steps in another program. With its x and
   v, its carry if it was compensated, and its acceleration if
   stepping_keeps it (NULL for what is not needed), all bits are those of an
   uninterrupted run. To be called before the first step. */
void stepping_resume(struct stepping *s, uint64_t steps,
                     const double carry[], const double acceleration[]);

/* Returns whether a step begins with the acceleration at the end of the
   last one, which does not follow from x and v: so it is for leapfrog, if
   the forces depend on the velocity: (8.13, eq:leapfrog-damped). */
bool stepping_keeps(const struct stepping *s);

/* Takes `steps` steps; the number of calls they are divided into does not
   affect the results. Checks whether all numbers are finite at the end, and
   whenever STEPPING_WATCH steps have been taken in all. */
enum stepping_end stepping_run(struct stepping *s, uint64_t steps);

/* Returns the time of x and v, s. */
double stepping_time(const struct stepping *s);

/* Must be called after x or v were changed from outside. */
void stepping_disturb(struct stepping *s);

void stepping_free(struct stepping *s);

/* Writes the state of s, between steps, into 5 * size + 1 numbers; and
   restores it. */
void stepping_note(const struct stepping *s, double note[]);
void stepping_recall(struct stepping *s, const double note[]);

/* Takes a part of a step, h, s, long, that is not counted in steps: when
   the parts add up to a step, the caller adds 1 to steps. A part of the
   length dt has the bits of a step. Checks that all numbers are
   finite. */
enum stepping_end stepping_part(struct stepping *s, double h);

/* Lets the adaptive method of s begin at x and v if it has not begun, or if
   these were changed from outside. Returns whether it did. */
bool stepping_anew(struct stepping *s);

#endif
