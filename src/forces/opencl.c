/* Loads OpenCL at run time, compiles the sum for a device, and runs it. */
#include "forces/opencl.h"

#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The library is loaded only when a run requests it, so the kit is built in
   the same way everywhere, without OpenCL's headers. There is no silent
   fallback: a requested device is used, or an error says why not.

   Speeds were measured without a graphics card, with pocl 3.1 on the
   processor and 3073 bodies. In 1e9 ordered pairs per second of processor
   time they are 0.71 for the portable kernel, 0.69 for opencl and 2.2 for
   opencl-float. The accelerations of opencl-float have a root mean square
   error of 6e-7.

   On the processor, OPENCL_TILES reaches only 0.34 (opencl) and 0.30
   (opencl-float). It is meant for graphics cards, but neither OPENCL_TILES
   nor OPENCL_BLOCKS has been run on a card. */

/* The part of OpenCL's header that is used here, according to the standard
   OpenCL 1.2. Objects of OpenCL are opaque pointers. */
typedef int32_t answer;
enum {
    CL_DEVICE_TYPE = 0x1000,
    CL_DEVICE_NAME = 0x102B,
    CL_DEVICE_EXTENSIONS = 0x1030,
    CL_BUILD_LOG = 0x1183,
    CL_GPU = 4,
    CL_ALL = -1,
    CL_READ_WRITE = 1,
    CL_READ_ONLY = 4,
    CL_NO_DRIVER = -1001
};

/* The functions of OpenCL that are used. The list is expanded into a struct
   of pointers and, below, into the statements that look up the functions in
   the library. */
#define CALLS(CALL)                                                        \
    CALL(answer, GetPlatformIDs, (uint32_t, void **, uint32_t *))          \
    CALL(answer, GetDeviceIDs,                                             \
         (void *, uint64_t, uint32_t, void **, uint32_t *))                \
    CALL(answer, GetDeviceInfo,                                            \
         (void *, uint32_t, size_t, void *, size_t *))                     \
    CALL(                                                                  \
        void *, CreateContext,                                             \
        (const void *, uint32_t, void *const *, void *, void *, answer *)) \
    CALL(void *, CreateCommandQueue, (void *, void *, uint64_t, answer *)) \
    CALL(void *, CreateProgramWithSource,                                  \
         (void *, uint32_t, const char **, const size_t *, answer *))      \
    CALL(answer, BuildProgram,                                             \
         (void *, uint32_t, void *const *, const char *, void *, void *))  \
    CALL(answer, GetProgramBuildInfo,                                      \
         (void *, void *, uint32_t, size_t, void *, size_t *))             \
    CALL(void *, CreateKernel, (void *, const char *, answer *))           \
    CALL(void *, CreateBuffer,                                             \
         (void *, uint64_t, size_t, void *, answer *))                     \
    CALL(answer, SetKernelArg, (void *, uint32_t, size_t, const void *))   \
    CALL(answer, EnqueueWriteBuffer,                                       \
         (void *, void *, uint32_t, size_t, size_t, const void *,          \
          uint32_t, const void *, void *))                                 \
    CALL(answer, EnqueueReadBuffer,                                        \
         (void *, void *, uint32_t, size_t, size_t, void *, uint32_t,      \
          const void *, void *))                                           \
    CALL(answer, EnqueueNDRangeKernel,                                     \
         (void *, void *, uint32_t, const size_t *, const size_t *,        \
          const size_t *, uint32_t, const void *, void *))                 \
    CALL(answer, ReleaseMemObject, (void *))                               \
    CALL(answer, ReleaseKernel, (void *))                                  \
    CALL(answer, ReleaseProgram, (void *))                                 \
    CALL(answer, ReleaseCommandQueue, (void *))                            \
    CALL(answer, ReleaseContext, (void *))

#define POINTER(result, name, arguments) result(*name) arguments;
struct calls {
    CALLS(POINTER)
};

struct opencl {
    struct calls cl;
    void *library, *id, *context, *queue, *program, *kernel;
    void *x, *mass, *a; /* buffers on the device */
    void *host;         /* [3 * padded] doubles or floats to transfer */
    size_t bodies, padded, width, size;
    uint32_t *order; /* [bodies] the caller's number of each body */
    double k2;
    bool single;
    char name[120], failure[OPENCL_MESSAGE];
};

/* The program for the device, in OpenCL C. LINES turns code into text. The
   width is eight doubles or sixteen floats for a processor, and 1 for a
   card. The operations are those of pull_by (pull.h) in the same order and
   without contraction, so double precision gives the same bits as the
   portable kernel. */
#define LINES(...) #__VA_ARGS__
static const char *const source[] = {
    "#pragma OPENCL FP_CONTRACT OFF\n"
    "#if DOUBLE\n"
    "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n"
    "#endif\n",
    /* The sums of the accelerations, and their rounding errors. Single
       precision compensates these errors: (sec:gravity-single). Otherwise
       small pulls would lose their last digits when they are added to the
       sum of thousands of others. Double precision must have the bits of
       the portable kernel and therefore does not compensate them. */
    LINES(struct sums { wide a, b, c, lost_a, lost_b, lost_c; };),
    LINES(void add(wide *sum, wide *lost, wide term) {
        if (DOUBLE)
            *sum += term;
        else {
            const wide y = term - *lost;
            const wide t = *sum + y;
            *lost = (t - *sum) - y;
            *sum = t;
        }
    }),

    LINES(void pull(struct sums *o, wide x, wide y, wide z, real px,
                    real py, real pz, real m, wide least) {
        const wide dx = px - x;
        const wide dy = py - y;
        const wide dz = pz - z;
        const wide s = dx * dx + dy * dy + dz * dz + least;
        const wide w = m / (s * sqrt(s));
        add(&o->a, &o->lost_a, w * dx);
        add(&o->b, &o->lost_b, w * dy);
        add(&o->c, &o->lost_c, w * dz);
    }),

    /* OPENCL_BLOCKS: each work item computes a block of bodies, one in each
       lane, and adds the pulls of all bodies in order. For the pull of a
       body on itself, 1 replaces the squared softening, which may be 0: the
       result is then 0 instead of 0/0. */
    "\n#if WIDTH > 1\n",
    LINES(kernel void sum(global const real *x, global const real *mass,
                          global real *a, uint n, uint padded, real least) {
        const uint i = get_global_id(0) * WIDTH;
        const wide ox = LOAD(0, x + i);
        const wide oy = LOAD(0, x + padded + i);
        const wide oz = LOAD(0, x + 2 * padded + i);
        struct sums o = {0, 0, 0, 0, 0, 0};
        for (uint j = 0; j < n; ++j) {
            wide apart = least;
            if (j >= i && j < i + WIDTH)
                ((real *)&apart)[j - i] = 1;
            pull(&o, ox, oy, oz, x[j], x[padded + j], x[2 * padded + j],
                 mass[j], apart);
        }
        STORE(o.a, 0, a + i);
        STORE(o.b, 0, a + padded + i);
        STORE(o.c, 0, a + 2 * padded + i);
    }),

    /* OPENCL_TILES: each work item computes one body. Groups of TILE items
       share the sources: each item loads one source, and after a barrier
       every item uses all of them. */
    "\n#else\n",
    LINES(kernel void sum(global const real *x, global const real *mass,
                          global real *a, uint n, uint padded, real least) {
        local real tile[4][TILE];
        const uint i = get_global_id(0);
        const uint me = get_local_id(0);
        struct sums o = {0, 0, 0, 0, 0, 0};
        for (uint first = 0; first < n; first += TILE) {
            barrier(CLK_LOCAL_MEM_FENCE);
            for (uint k = 0; k < 3; ++k)
                tile[k][me] = x[k * padded + first + me];
            tile[3][me] = mass[first + me];
            barrier(CLK_LOCAL_MEM_FENCE);
            for (uint k = 0; k < TILE && first + k < n; ++k)
                pull(&o, x[i], x[padded + i], x[2 * padded + i], tile[0][k],
                     tile[1][k], tile[2][k], tile[3][k],
                     first + k == i ? 1 : least);
        }
        a[i] = o.a;
        a[padded + i] = o.b;
        a[2 * padded + i] = o.c;
    }),
    "\n#endif\n"};

enum { TILE = 64 };

static bool find_library(struct opencl *d, char *message)
{
    static const char *const names[] = {"libOpenCL.so.1", "libOpenCL.so"};
    for (size_t k = 0; k < 2 && !d->library; ++k)
        d->library = dlopen(names[k], RTLD_NOW | RTLD_LOCAL);
    if (!d->library) {
        snprintf(message, OPENCL_MESSAGE,
                 "no library libOpenCL.so.1 is found; apt-get install "
                 "--no-install-recommends ocl-icd-libopencl1, and the "
                 "driver of a device");
        return false;
    }
#define LOOK_UP(result, name, arguments)                                   \
    *(void **)&d->cl.name = dlsym(d->library, "cl" #name);                 \
    if (!d->cl.name) {                                                     \
        snprintf(message, OPENCL_MESSAGE,                                  \
                 "libOpenCL.so.1 has no cl" #name);                        \
        return false;                                                      \
    }
    CALLS(LOOK_UP)
    return true;
}

/* Returns whether the device has the requested precision; not all cards
   have double precision. Sets *kind to the type of the device, and writes
   its name. */
static bool suits(const struct opencl *d, void *id, uint64_t *kind,
                  char *name, size_t size)
{
    char can[8192] = "";
    *kind = 0;
    *name = '\0';
    d->cl.GetDeviceInfo(id, CL_DEVICE_TYPE, sizeof *kind, kind, NULL);
    d->cl.GetDeviceInfo(id, CL_DEVICE_NAME, size, name, NULL);
    d->cl.GetDeviceInfo(id, CL_DEVICE_EXTENSIONS, sizeof can, can, NULL);
    can[sizeof can - 1] = '\0';
    return d->single || strstr(can, "cl_khr_fp64");
}

enum { PLATFORMS = 8, DEVICES = 16 };

/* Chooses the first suitable graphics card of a platform, or else the first
   suitable device. Returns the platform's number of devices. */
static uint32_t look_at(struct opencl *d, void *platform, uint64_t *kind)
{
    void *id[DEVICES];
    uint32_t ids = 0;
    if (d->cl.GetDeviceIDs(platform, (uint64_t)CL_ALL, DEVICES, id, &ids))
        return 0;
    for (uint32_t k = 0; k < ids && k < DEVICES; ++k) {
        uint64_t what;
        char name[sizeof d->name];
        if (!suits(d, id[k], &what, name, sizeof name) ||
            (d->id && !(what & CL_GPU && !(*kind & CL_GPU))))
            continue;
        d->id = id[k];
        *kind = what;
        memcpy(d->name, name, sizeof name);
    }
    return ids;
}

static bool find_device(struct opencl *d, uint64_t *kind, char *message)
{
    void *platform[PLATFORMS];
    uint32_t platforms = 0, seen = 0;
    const answer no = d->cl.GetPlatformIDs(PLATFORMS, platform, &platforms);
    for (uint32_t p = 0; no == 0 && p < platforms && p < PLATFORMS; ++p)
        seen += look_at(d, platform[p], kind);
    if (no == CL_NO_DRIVER || (no == 0 && platforms == 0))
        snprintf(message, OPENCL_MESSAGE,
                 "there is no driver of a device; for the processor: "
                 "apt-get install --no-install-recommends pocl-opencl-icd");
    else if (no || seen == 0)
        snprintf(message, OPENCL_MESSAGE,
                 "there is a driver, but no device (answer %d)", (int)no);
    else if (!d->id)
        snprintf(message, OPENCL_MESSAGE,
                 "none of %u devices has numbers of double precision; "
                 "there is --kernel opencl-float",
                 (unsigned)seen);
    return d->id;
}

/* Writes the compiler's options: the width and the type of the numbers.
   Returns false if they do not fit into text. */
static bool write_flags(const struct opencl *d, char *text, size_t size)
{
    const char *type = d->single ? "float" : "double";
    char wide[32] = "", vectors[80] = "";
    if (d->width > 1) {
        snprintf(wide, sizeof wide, "%u", (unsigned)d->width);
        snprintf(vectors, sizeof vectors,
                 " -DLOAD=vload%s -DSTORE=vstore%s", wide, wide);
    }
    return snprintf(text, size,
                    "-DDOUBLE=%d -Dreal=%s -Dwide=%s%s -DWIDTH=%u "
                    "-DTILE=%d%s",
                    !d->single, type, type, wide, (unsigned)d->width, TILE,
                    vectors) < (int)size;
}

static bool explain_refusal(struct opencl *d, answer no, char *message)
{
    char log[OPENCL_MESSAGE - 200] = "";
    d->cl.GetProgramBuildInfo(d->program, d->id, CL_BUILD_LOG,
                              sizeof log - 1, log, NULL);
    snprintf(message, OPENCL_MESSAGE,
             "%s does not compile the program (answer %d): %s", d->name,
             (int)no, log);
    return false;
}

static bool build(struct opencl *d, char *message)
{
    char flags[300];
    answer no = 0;
    d->context = d->cl.CreateContext(NULL, 1, &d->id, NULL, NULL, &no);
    if (d->context)
        d->queue = d->cl.CreateCommandQueue(d->context, d->id, 0, &no);
    if (d->queue && write_flags(d, flags, sizeof flags))
        d->program = d->cl.CreateProgramWithSource(
            d->context, sizeof source / sizeof *source,
            (const char **)(uintptr_t)source, NULL, &no);
    if (d->program) {
        no = d->cl.BuildProgram(d->program, 1, &d->id, flags, NULL, NULL);
        if (no)
            return explain_refusal(d, no, message);
        d->kernel = d->cl.CreateKernel(d->program, "sum", &no);
    }
    if (!d->kernel)
        snprintf(message, OPENCL_MESSAGE, "%s cannot be used (answer %d)",
                 d->name, (int)no);
    return d->kernel;
}

/* Sets the order in which the device adds the pulls. In single precision
   the heaviest body, such as a planet, comes last. If its pull came first,
   the pulls of light bodies would be below the last digit of the sum:
   (9.17, eq:unseen). */
static void put_in_order(struct opencl *d, const double mass[])
{
    const size_t n = d->bodies;
    size_t last = n - 1;
    for (size_t i = 0; i < n; ++i)
        d->order[i] = (uint32_t)i;
    for (size_t i = 0; i < n; ++i)
        if (mass[i] > mass[last])
            last = i;
    if (!d->single)
        return;
    d->order[last] = (uint32_t)(n - 1);
    d->order[n - 1] = (uint32_t)last;
}

/* Copies one number of each body into d->host, from index `to` on, in the
   device's order and precision. */
static void lay_out(const struct opencl *d, const double from[], size_t to)
{
    float *narrow = d->host;
    double *wide = d->host;
    for (size_t p = 0; p < d->bodies; ++p)
        if (d->single)
            narrow[to + p] = (float)from[d->order[p]];
        else
            wide[to + p] = from[d->order[p]];
}

/* Sets the kernel's arguments. Memory on the device is padded with bodies
   of mass 0 to a multiple of TILE bodies, so no item needs a bounds
   check. */
static answer set_arguments(struct opencl *d, double least)
{
    const uint32_t n = (uint32_t)d->bodies, padded = (uint32_t)d->padded;
    const float narrow = (float)least;
    return d->cl.SetKernelArg(d->kernel, 0, sizeof d->x, &d->x) |
           d->cl.SetKernelArg(d->kernel, 1, sizeof d->mass, &d->mass) |
           d->cl.SetKernelArg(d->kernel, 2, sizeof d->a, &d->a) |
           d->cl.SetKernelArg(d->kernel, 3, sizeof n, &n) |
           d->cl.SetKernelArg(d->kernel, 4, sizeof padded, &padded) |
           (d->single
                ? d->cl.SetKernelArg(d->kernel, 5, sizeof narrow, &narrow)
                : d->cl.SetKernelArg(d->kernel, 5, sizeof least, &least));
}

static answer take_memory(struct opencl *d)
{
    const size_t all = 3 * d->padded * d->size, one = d->padded * d->size;
    answer no = 0;
    d->x = d->cl.CreateBuffer(d->context, CL_READ_ONLY, all, NULL, &no);
    if (d->x)
        d->mass =
            d->cl.CreateBuffer(d->context, CL_READ_ONLY, one, NULL, &no);
    if (d->mass)
        d->a =
            d->cl.CreateBuffer(d->context, CL_READ_WRITE, all, NULL, &no);
    if (d->a)
        no = d->cl.EnqueueWriteBuffer(d->queue, d->mass, 1, 0, one, d->host,
                                      0, NULL, NULL);
    return no;
}

static bool fill(struct opencl *d, const struct opencl_order *order,
                 char *message)
{
    d->order = malloc(d->bodies * sizeof *d->order);
    d->host = calloc(3 * d->padded, d->size);
    if (!d->order || !d->host) {
        snprintf(message, OPENCL_MESSAGE, "no memory for %zu bodies",
                 d->bodies);
        return false;
    }
    put_in_order(d, order->mass);
    lay_out(d, order->mass, 0);
    answer no = take_memory(d);
    if (!no)
        no = set_arguments(d, order->softening * order->softening);
    if (no || !d->a)
        snprintf(message, OPENCL_MESSAGE,
                 "%s does not take %zu bodies (answer %d)", d->name,
                 d->bodies, (int)no);
    return !no && d->a;
}

struct opencl *opencl_open(const struct opencl_order *order,
                           char message[OPENCL_MESSAGE])
{
    struct opencl *d = calloc(1, sizeof *d);
    uint64_t kind = 0;
    if (!d) {
        snprintf(message, OPENCL_MESSAGE, "no memory for a device");
        return NULL;
    }
    d->bodies = order->bodies;
    d->single = order->single;
    d->k2 = order->k2;
    d->size = d->single ? sizeof(float) : sizeof(double);
    d->padded = (d->bodies + TILE - 1) / TILE * TILE;
    if (find_library(d, message) && find_device(d, &kind, message)) {
        const bool tiles = order->way == OPENCL_TILES ||
                           (order->way == OPENCL_AUTO && kind & CL_GPU);
        d->width = tiles ? 1 : d->single ? 16 : 8;
        if (build(d, message) && fill(d, order, message))
            return d;
    }
    opencl_close(&d);
    return NULL;
}

void opencl_close(struct opencl **device)
{
    struct opencl *d = *device;
    *device = NULL;
    if (!d)
        return;
    void *const buffer[] = {d->x, d->mass, d->a};
    for (size_t k = 0; k < 3; ++k)
        if (buffer[k])
            d->cl.ReleaseMemObject(buffer[k]);
    if (d->kernel)
        d->cl.ReleaseKernel(d->kernel);
    if (d->program)
        d->cl.ReleaseProgram(d->program);
    if (d->queue)
        d->cl.ReleaseCommandQueue(d->queue);
    if (d->context)
        d->cl.ReleaseContext(d->context);
    free(d->order);
    free(d->host);
    free(d);
}

void opencl_add(void *device, const double x[], double a[])
{
    struct opencl *d = device;
    const size_t n = d->bodies, all = 3 * d->padded * d->size;
    const size_t items = d->padded / d->width;
    const size_t group = d->width == 1 ? TILE : TILE / d->width;
    for (size_t k = 0; k < 3; ++k)
        lay_out(d, x + k * n, k * d->padded);
    const answer no =
        d->cl.EnqueueWriteBuffer(d->queue, d->x, 1, 0, all, d->host, 0,
                                 NULL, NULL) |
        d->cl.EnqueueNDRangeKernel(d->queue, d->kernel, 1, NULL, &items,
                                   &group, 0, NULL, NULL) |
        d->cl.EnqueueReadBuffer(d->queue, d->a, 1, 0, all, d->host, 0, NULL,
                                NULL);
    if (no)
        snprintf(d->failure, sizeof d->failure, "%s failed (answer %d)",
                 d->name, (int)no);
    for (size_t k = 0; k < 3; ++k)
        for (size_t p = 0; p < n; ++p) {
            const size_t at = k * d->padded + p;
            const double sum = d->single ? ((const float *)d->host)[at]
                                         : ((const double *)d->host)[at];
            a[k * n + d->order[p]] += no ? NAN : d->k2 * sum;
        }
}

const char *opencl_failure(const struct opencl *device)
{
    return *device->failure ? device->failure : NULL;
}

const char *opencl_name(const struct opencl *device)
{
    return device->name;
}
