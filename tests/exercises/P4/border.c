/* Project P4: nothing crosses but its arguments, its file and its table,
   see examiner/run.h. Here is what it is given in place of the header's
   force: laws that count how often they are asked, for project P4. */
/* place: none */

#include "examiner/run.h"

#ifdef BORDER_GIVEN

#include <fcntl.h>
#include <math.h>
#include <sys/mman.h>
#include <unistd.h>

static void count_call(void)
{
    static long none, *calls;
    if (!calls) {
        const int file = open(RUN_CALLS, O_RDWR | O_CREAT, 0600);
        void *shared = MAP_FAILED;
        if (file >= 0 && ftruncate(file, sizeof *calls) == 0)
            shared = mmap(NULL, sizeof *calls, PROT_READ | PROT_WRITE,
                          MAP_SHARED, file, 0);
        calls = shared == MAP_FAILED ? &none : shared;
    }
    ++*calls;
}

/* Each pair pulls along its line, by a force that depends on the masses and
   the square of the distance, over the distance. */
static void all_pairs(int n, const double m[], const double x[], double f[],
                      double law(double mm, double dd))
{
    count_call();
    for (int c = 0; c < 2 * n; ++c)
        f[c] = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) {
            const double dx = x[2 * j] - x[2 * i];
            const double dy = x[2 * j + 1] - x[2 * i + 1];
            const double pull = law(m[i] * m[j], dx * dx + dy * dy);
            f[2 * i] += pull * dx;
            f[2 * i + 1] += pull * dy;
            f[2 * j] -= pull * dx;
            f[2 * j + 1] -= pull * dy;
        }
}

static double gravity(double mm, double dd)
{
    return mm / (dd * sqrt(dd));
}

static double softened(double mm, double dd)
{
    return gravity(mm, dd + 0.04);
}

static double springs(double mm, double dd)
{
    (void)dd;
    return mm;
}

static double nothing(double mm, double dd)
{
    (void)mm, (void)dd;
    return 0.0;
}

void force_0(int n, const double m[], const double x[], double f[]);
void force_1(int n, const double m[], const double x[], double f[]);
void force_2(int n, const double m[], const double x[], double f[]);
void force_3(int n, const double m[], const double x[], double f[]);

void force_0(int n, const double m[], const double x[], double f[])
{
    all_pairs(n, m, x, f, gravity);
}

void force_1(int n, const double m[], const double x[], double f[])
{
    all_pairs(n, m, x, f, softened);
}

void force_2(int n, const double m[], const double x[], double f[])
{
    all_pairs(n, m, x, f, springs);
}

void force_3(int n, const double m[], const double x[], double f[])
{
    all_pairs(n, m, x, f, nothing);
}

#endif
