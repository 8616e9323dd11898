/* Live figure of chapter 3: a histogram of one bead with error bars. */
#include "line/bonkers.h"
#include "line/statistics.h"
#include "page/page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BEADS = 10, BINS = 40, MOST = 200000 };
enum { BEAD, POSITION, EVERY, SEED }; /* indices into page_number */

/* Parameters: the number of the bead, from 1; 1 for a histogram of its
   position, 0 for its velocity; the time between samples, s; the seed. */
double page_number[PAGE_NUMBERS];

static struct start start;
static struct bonkers beads;
static double x[BEADS + 2], v[BEADS + 2];
static struct statistics_histogram *histogram;
static double sample[MOST], inefficiency, law[BINS];
static size_t samples, measured;
static double seen[8 + 3 * BINS + BEADS + 2];

/* Returns the probability density of bead k, up to a factor, at the
   fraction u of the range. The density of its velocity is (3.2,
   eq:velocity-law). That of its position is the beta distribution of the
   k-th of n positions (3.7, eq:beta). */
static double shape(size_t k, double u)
{
    if (page_number[POSITION] != 0)
        return pow(u, (double)k - 1) * pow(1 - u, (double)(BEADS - k));
    return pow(1 - (2 * u - 1) * (2 * u - 1), (BEADS - 3) / 2.0);
}

/* Averages the density over each bin. Since the bins cover the whole range,
   the factor follows from the sum over the bins. */
static void draw_law(size_t k, double range)
{
    enum { PARTS = 16 };
    double sum = 0;
    memset(law, 0, sizeof law);
    for (int i = 0; i < BINS * PARTS; ++i)
        law[i / PARTS] += shape(k, (i + 0.5) / (BINS * PARTS));
    for (int b = 0; b < BINS; ++b)
        sum += law[b] * range / BINS;
    for (int b = 0; b < BINS; ++b)
        law[b] /= sum;
}

/* Begins a histogram for bead k. The range of velocities ends at the speed
   of a bead that has all the energy. */
static bool begin_histogram(size_t k)
{
    const double energy = bonkers_energy(&beads);
    const double most = sqrt(2 * energy / start.mass[k - 1]);
    const bool places = page_number[POSITION] != 0;
    const double low = places ? start.wall[0] : -most;
    const double high = places ? start.wall[1] : most;
    free(histogram);
    histogram = statistics_histogram_create(low, high, BINS);
    samples = measured = 0;
    inefficiency = 1;
    draw_law(k, high - low);
    return histogram != NULL;
}

bool page_begin(void)
{
    const struct start_request request = {
        .kind = START_THERMAL, .seed = (uint64_t)page_number[SEED]};
    size_t wrong;
    bonkers_free(&beads);
    start_free(&start);
    return start_fill(&start, &request) &&
           bonkers_begin(&beads, &start, 1, BONKERS_AUTO, &wrong) &&
           begin_histogram((size_t)page_number[BEAD]);
}

/* Estimates the statistical inefficiency, the number of samples that are
   worth one independent sample, as the program histogram does. The error
   bars then allow for correlations. Repeats the estimate only when the
   number of samples has grown by 5 %, so that the total cost is a small
   multiple of the cost of the last estimate. */
static void measure(void)
{
    struct statistics_description d;
    if (samples < 32 || samples < measured + measured / 20)
        return;
    if (statistics_describe(samples, sample, true, &d))
        inefficiency = d.inefficiency;
    measured = samples;
}

/* Runs the beads; an event is a sample. There are at most MOST samples. */
double page_run(double until, double events)
{
    const size_t before = samples, k = (size_t)page_number[BEAD];
    while (samples < MOST && (double)(samples - before) < events) {
        const double next = (double)(samples + 1) * page_number[EVERY];
        if (next > until)
            break;
        bonkers_run(&beads, next, UINT64_MAX);
        bonkers_state(&beads, x, v);
        sample[samples] = page_number[POSITION] != 0 ? x[k] : v[k];
        statistics_histogram_add(histogram, sample[samples++]);
    }
    return (double)(samples - before);
}

/* Returns the time, the number of samples, their statistical inefficiency,
   the limits of the range, the numbers of bins and beads and the energy;
   then all densities, their errors and the law; then x of walls and
   beads. */
const double *page_look(void)
{
    double *next = seen + 8;
    measure();
    bonkers_state(&beads, x, v);
    seen[0] = beads.now;
    seen[1] = (double)samples;
    seen[2] = inefficiency;
    seen[3] = histogram->low;
    seen[4] = histogram->high;
    seen[5] = BINS;
    seen[6] = BEADS;
    seen[7] = bonkers_energy(&beads);
    for (size_t b = 0; b < BINS && samples > 0; ++b) {
        next[b] = statistics_histogram_density(histogram, b);
        next[BINS + b] =
            statistics_histogram_error(histogram, b, inefficiency);
    }
    memcpy(next + 2 * BINS, law, sizeof law);
    memcpy(next + 3 * BINS, x, sizeof x);
    return seen;
}
