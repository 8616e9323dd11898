/* Gravity summed on another device, by OpenCL. */
#ifndef OPENCL_H
#define OPENCL_H

#include <stdbool.h>
#include <stddef.h>

/* How bodies are shared out among the items of work of the device. Which is
   faster depends on the device; the tests ask for either. */
enum opencl_way {
    OPENCL_AUTO,   /* tiles on a graphics card, else blocks */
    OPENCL_BLOCKS, /* a vector of bodies in an item: for processors */
    OPENCL_TILES   /* one body each, sources shared: for graphics cards */
};

/* The bodies to be summed, as for gravity_create. */
struct opencl_order {
    size_t bodies;
    const double *mass; /* [bodies] */
    double k2;          /* acceleration times distance squared, of the
                           mass 1 */
    double softening;   /* m; 0: none */
    bool single;        /* in float, with compensated sums */
    enum opencl_way way;
};

struct opencl;

enum { OPENCL_MESSAGE = 2000 }; /* size of an error's text, with its NUL */

/* Opens a device, a graphics card before others, and makes the program for
   it. Returns NULL, with one line in message, when there is no library, no
   driver, no device that can do it, or the program is refused there. */
struct opencl *opencl_open(const struct opencl_order *order,
                           char message[OPENCL_MESSAGE]);

/* Frees what opencl_open took, and sets the pointer to NULL. */
void opencl_close(struct opencl **device);

/* Adds to a[] the accelerations of the bodies at x[], both of 3 * bodies
   numbers, axis by axis; in double precision the bits of the portable
   kernel. If the device fails they are NaN, and opencl_failure() returns
   what it said, else NULL. Source: (9.2, eq:softened-force). */
void opencl_add(void *device, const double x[], double a[]);
const char *opencl_failure(const struct opencl *device);

/* Returns the name that the device gives itself. */
const char *opencl_name(const struct opencl *device);

#endif
