/* Project P4: nothing crosses but its arguments, its file and its table,
   see examiner/run.h. Here is what it is given in place of the header's
   force: laws that are counted, for project P4. */
/* output: none */

#include "examiner/run.h"

#if defined REMOTE_GIVEN || defined REMOTE_SERVER

#include <math.h>

/* A force that depends on the product of the masses, the square of the
   distance and a constant of the law; over the distance. */
typedef double law(double mm, double dd, double constant);

/* Each pair pulls along its line. */
static void all_pairs(int n, const double m[], const double x[], double f[],
                      law *pull_of, double constant)
{
    for (int c = 0; c < 2 * n; ++c)
        f[c] = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) {
            const double dx = x[2 * j] - x[2 * i];
            const double dy = x[2 * j + 1] - x[2 * i + 1];
            const double pull =
                pull_of(m[i] * m[j], dx * dx + dy * dy, constant);
            f[2 * i] += pull * dx;
            f[2 * i + 1] += pull * dy;
            f[2 * j] -= pull * dx;
            f[2 * j + 1] -= pull * dy;
        }
}

static double gravity(double mm, double dd, double constant)
{
    (void)constant;
    return mm / (dd * sqrt(dd));
}

static double softened(double mm, double dd, double constant)
{
    return gravity(mm, dd + constant, 0.0);
}

static double springs(double mm, double dd, double constant)
{
    (void)dd;
    return constant * mm;
}

static double nothing(double mm, double dd, double constant)
{
    (void)mm, (void)dd, (void)constant;
    return 0.0;
}

#endif

#ifdef REMOTE_GIVEN

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

/* The page in which calls are counted; or NULL where they are asked for in
   another process, which does the counting. */
static long *counter(void)
{
    static long none, *calls;
    static int looked;
    struct stat about;
    if (looked++)
        return calls;
    if (fstat(RUN_COUNTER, &about) != 0 || !S_ISSOCK(about.st_mode)) {
        void *shared = mmap(NULL, sizeof *calls, PROT_READ | PROT_WRITE,
                            MAP_SHARED, RUN_COUNTER, 0);
        calls = shared == MAP_FAILED ? &none : shared;
    }
    return calls;
}

static void ask(int n, const double m[], const double x[], double f[])
{
    double question[1 + 3 * RUN_BODIES];
    const size_t masses = (size_t)n * sizeof *m;
    if (n < 0 || n > RUN_BODIES)
        exit(EXIT_FAILURE);
    question[0] = n;
    memcpy(question + 1, m, masses);
    memcpy(question + 1 + n, x, 2 * masses);
    if (send(RUN_COUNTER, question, sizeof *question + 3 * masses, 0) < 0 ||
        recv(RUN_COUNTER, f, 2 * masses, 0) != (ssize_t)(2 * masses))
        exit(EXIT_FAILURE);
}

static void count_pairs(int n, const double m[], const double x[],
                        double f[], law *pull_of, double constant)
{
    long *calls = counter();
    if (!calls) {
        ask(n, m, x, f);
        return;
    }
    ++*calls;
    all_pairs(n, m, x, f, pull_of, constant);
}

void force_0(int n, const double m[], const double x[], double f[]);
void force_1(int n, const double m[], const double x[], double f[]);
void force_2(int n, const double m[], const double x[], double f[]);
void force_3(int n, const double m[], const double x[], double f[]);

void force_0(int n, const double m[], const double x[], double f[])
{
    count_pairs(n, m, x, f, gravity, 0.0);
}

void force_1(int n, const double m[], const double x[], double f[])
{
    count_pairs(n, m, x, f, softened, 0.04);
}

void force_2(int n, const double m[], const double x[], double f[])
{
    count_pairs(n, m, x, f, springs, 1.0);
}

void force_3(int n, const double m[], const double x[], double f[])
{
    count_pairs(n, m, x, f, nothing, 0.0);
}

#endif

#ifdef REMOTE_SERVER

void run_law(int which, double constant, int n, const double m[],
             const double x[], double f[])
{
    static law *const laws[] = {gravity, softened, springs, nothing};
    all_pairs(n, m, x, f, laws[which & 3], constant);
}

#endif
