/* From chapters/08-stepping.nw: edit there, then run make tangle. */
/* checksum 3168270343 of the lines below */
/* Stepping methods, and runs that step coordinates under forces. */
#ifndef STEPPING_H
#define STEPPING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    STEPPING_WATCH = 64, /* steps from one look to the next */
    STEPPING_MOST = 64   /* methods: there is room for so many */
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

/* Who moves n coordinates from number `from` on to where the forces are
   asked for; owing: with the other half of the last step's kick. */
struct stepping_ahead {
    void (*ready)(void *step, size_t from, size_t n, bool owing);
    void *step;
};

/* As accelerate for so many steps, with x and v that are not ready: before
   it reads any of them, or writes a there, it has that part made ready,
   each coordinate once in a step, and owing but in the first; from any
   thread and in any order. */
typedef void stepping_sweep(void *what, const double x[], const double v[],
                            double a[], const struct stepping_ahead *ahead,
                            uint64_t steps);

/* Moves x and v on by the time dt, s, of either sign, as they move without
   what accelerate says. */
typedef void stepping_flow(void *what, double dt, double x[], double v[]);

enum stepping_family {
    STEPPING_SPLITTING, /* kicks and drifts */
    STEPPING_EXPLICIT,  /* Runge-Kutta, stage after stage */
    STEPPING_IMPLICIT,  /* Runge-Kutta, all stages at once */
    STEPPING_PAIR,      /* explicit, with an estimate of its error */
    STEPPING_RADAU      /* the force as a polynomial in time */
};

/* A method is data. */
struct stepping_method {
    const char *name, *about; /* about: a phrase, for --help */
    enum stepping_family family;
    int order;
    bool symmetric, symplectic;
    size_t stages; /* evaluations of the forces in a step without friction;
                      of an implicit method at least so many */
    size_t drifts; /* of a splitting */
    const double *drift; /* [drifts], in units of dt */
    const double *kick;  /* [drifts + 1]: one before, between and after the
                            drifts; NULL: the means of their neighbours */
    const double *a, *b; /* Runge-Kutta: the tableau by rows, the weights */
    double limit;  /* of omega dt for an oscillator; INFINITY: none, 0: it
                      is never stable */
    bool orbits;   /* a splitting for bodies that attract each other, and
                      for nothing else: it drifts along a flow */
    bool adaptive; /* its steps can choose their own length */
    bool raced;    /* whoever looks for the cheapest method tries it */
    const double *error, *dense; /* [stages], of a pair:
                                    (8.15, eq:embedded),
                                    (8.17, eq:dense) */
    const double *node;          /* of Radau's, [stages] */
    const double *weight;        /* of it, [4 * stages]: head and tail of a
                                    node's weight for v, and for x */
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

/* The methods that there are; the last one is followed by a name NULL. */
extern const struct stepping_method stepping_methods[STEPPING_MOST + 1];

/* The method of this name, or NULL. */
const struct stepping_method *stepping_find(const char *name);

/* The first method that asks nothing of the forces but accelerations and
   takes equal steps, or the next one after m; NULL after the last. */
const struct stepping_method *stepping_next(
    const struct stepping_method *m);

/* Are its steps those of leapfrog, (8.4, eq:verlet)? */
bool stepping_is_leapfrog(const struct stepping_method *m);

/* Prepares to step x (m) and v (m/s), which stay the caller's, by dt, s.
   The method and what the forces point to must outlive s. Returns false,
   with nothing to free, without memory. */
bool stepping_begin(struct stepping *s, const struct stepping_method *m,
                    struct stepping_forces f, double dt, double x[],
                    double v[]);

/* Lets a run go on that has taken `steps` steps elsewhere, before the
   first step here: with the same x and v, the same carry if it was
   compensated, the same acceleration if stepping_keeps it (NULL for what
   is not needed) all bits are those of the run in one piece. */
void stepping_resume(struct stepping *s, uint64_t steps,
                     const double carry[], const double acceleration[]);

/* Does a step begin with the acceleration that the last one ended with, and
   that x and v do not tell? Leapfrog's does, if the forces depend on the
   velocity: (8.13, eq:leapfrog-damped). */
bool stepping_keeps(const struct stepping *s);

/* Takes so many steps; how many calls they are divided into changes no
   bit. Looks for numbers that are not finite at the end, and whenever
   STEPPING_WATCH steps have been taken in all. */
enum stepping_end stepping_run(struct stepping *s, uint64_t steps);

/* The time of x and v, s. */
double stepping_time(const struct stepping *s);

/* To be called after x or v were changed from outside. */
void stepping_disturb(struct stepping *s);

void stepping_free(struct stepping *s);

/* Puts down where s is, into 5 * size + 1 numbers, and goes back there. */
void stepping_note(const struct stepping *s, double note[]);
void stepping_recall(struct stepping *s, const double note[]);

/* Takes one step of the length h, s, with the method of s, that neither
   steps nor the time count: parts of a step add up to one, and then the
   caller adds 1 to steps. A part of the length dt has the bits of a step.
   Looks for numbers that are not finite. */
enum stepping_end stepping_part(struct stepping *s, double h);

/* Lets the adaptive method of s begin at x and v if it has not begun, or if
   they were changed from outside. Returns whether it does. */
bool stepping_anew(struct stepping *s);
#endif
