/* Gravity summed on another device, by OpenCL. */
#ifndef OPENCL_H
#define OPENCL_H

#include <stdbool.h>
#include <stddef.h>

/* How bodies are distributed among the work items of the device. Which of
   the two ways is faster depends on the device. Tests use both. */
enum opencl_way {
    OPENCL_AUTO,   /* tiles on a graphics card, otherwise blocks */
    OPENCL_BLOCKS, /* a vector of bodies per item: for processors */
    OPENCL_TILES   /* one body per item, shared sources: for cards */
};

/* The parameters of the sum, as for gravity_create. */
struct opencl_order {
    size_t bodies;
    const double *mass; /* [bodies] */
    double k2;          /* acceleration due to mass 1, times squared
                           distance */
    double softening;   /* m; 0: none */
    bool single;        /* use compensated single precision */
    enum opencl_way way;
};

struct opencl;

enum { OPENCL_MESSAGE = 2000 }; /* size of an error message in bytes */

/* Opens a device, preferably a graphics card, and compiles the program for
   it. Returns NULL, with an error in message, if there is no library, no
   driver or no suitable device, or the program does not compile. */
struct opencl *opencl_open(const struct opencl_order *order,
                           char message[OPENCL_MESSAGE]);

/* Frees what opencl_open allocated, and sets the pointer to NULL. */
void opencl_close(struct opencl **device);

/* Adds to a[] the accelerations of the bodies at x[]: (9.2,
   eq:softened-force). Each array has 3 * bodies numbers, axis by axis.
   Double precision gives the same bits as the portable kernel. If the
   device fails, a[] becomes NaN, and opencl_failure returns the error
   message. Otherwise opencl_failure returns NULL. */
void opencl_add(void *device, const double x[], double a[]);
const char *opencl_failure(const struct opencl *device);

/* Returns the name that the device gives itself. */
const char *opencl_name(const struct opencl *device);

#endif
