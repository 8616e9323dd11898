/* Integrates the model of a piston; measures pistons in tables. */
#include "line/piston.h"
#include "toolbox/bench.h"
#include "toolbox/study.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "piston"

enum { MOST = 8 }; /* maximum number of values of --at */

typedef bool stepper(const struct piston *p, struct piston_state *s,
                     double dt);
static stepper *const steppers[] = {piston_step, piston_step_rk4};
static const char *const stepper_names[] = {"leapfrog", "rk4", NULL};

static struct {
    size_t method;
    struct piston piston;
    double energies[2], masses[2]; /* of the gases, J; kg */
    struct piston_state start;
    double step, every, until;
    const char *path; /* path of the table to be measured */
    size_t body;
    double window; /* averaging time, s */
    double at[MOST], fit[2];
    size_t at_count;
} own = {.piston = {40, 12, {0, 0, 0}, {0, 0, 0}},
         .energies = {10.0 / 3, 10.0 / 3},
         .masses = {20.0 / 3, 20.0 / 3},
         .start = {NAN, 1},
         .step = 0.01,
         .every = 0.1,
         .until = 40,
         .body = 6,
         .window = 10.15,
         .fit = {0.1, 0.01}};

static void read_pair(struct options *o, double pair[2], double low)
{
    if (options_list(o, pair, 2) != 2 || !(fmin(pair[0], pair[1]) >= low) ||
        !(fmax(pair[0], pair[1]) <= 1e9))
        options_fail(o, "'%s' is not two numbers from %g to 1e9",
                     options_text(o), low);
}

/* Returns the initial state. As the piston sets the gases in motion, its
   velocity falls from V to V M / M'. The moving mass M' includes the added
   mass of the gases (4.10, eq:added-mass). */
static struct piston_state first_state(const struct piston *p)
{
    struct piston_state state = own.start;
    state.v *= p->mass / piston_inertia(p);
    return state;
}

enum { POINTS = 64 }; /* quadrature points, more than needed */

static double large_period(const struct piston *p, size_t points)
{
    const struct piston_state state = first_state(p);
    return piston_period(p, piston_energy(p, &state), points);
}

/* Writes the periods from all theories, without and with the masses of the
   gases. */
static void summarise_periods(struct table *summary)
{
    struct piston bare = own.piston;
    bare.left.mass = bare.right.mass = 0;
    const double small = 2 * acos(-1) / piston_frequency(&bare);
    TABLE_RESULTS(summary, {"period_isothermal", sqrt(3) * small},
                  {"period_small", small},
                  {"period_large", large_period(&bare, POINTS)},
                  {"period_small_added",
                   2 * acos(-1) / piston_frequency(&own.piston)},
                  {"period_large_added", large_period(&own.piston, POINTS)},
                  {"period_acoustic",
                   2 * acos(-1) / piston_frequency_acoustic(&own.piston)});
}

enum { SWING = 3 }; /* study_cost omits the first SWING keys */

static const struct table_key run_keys[] = {
    {"x_min", "m", "leftmost place of the piston"},
    {"x_max", "m", "rightmost"},
    {"energy_error", "1", "largest relative error"},
    {"period_isothermal", "s", "small swings, gases kept at a temperature"},
    {"period_small", "s", "small swings, gases of no mass"},
    {"period_large", "s", "swings of this run, the same"},
    {"period_small_added", "s", "small swings, with a third of the gases"},
    {"period_large_added", "s", "swings of this run, the same"},
    {"period_acoustic", "s", "small swings, with sound in the gases"},
    {0}};

/* Writes the rows of a run of the model. Shortens the step, so that the
   time between rows is a whole number of steps. The largest energy error
   and the extreme positions are taken over all steps, not only over the
   rows. */
static void study_run(struct study *s)
{
    const struct piston *p = &own.piston;
    struct piston_state state = first_state(p);
    const double steps = ceil(own.every / own.step);
    const double start = piston_energy(p, &state);
    double worst = 0, low = state.x, high = state.x;
    TABLE_COLUMNS(
        s->out, {"t", "s", "time"}, {"x", "m", "position of the piston"},
        {"v", "m/s", "its velocity"}, {"TL", "J", "energy of the left gas"},
        {"TR", "J", "energy of the right gas"},
        {"TP", "J", "energy of the moving mass"});
    for (double row = 0; row * own.every <= own.until; ++row) {
        const double left = piston_gas_energy(&p->left, state.x);
        const double right =
            piston_gas_energy(&p->right, p->length - state.x);
        TABLE_ROW(s->out, row * own.every, state.x, state.v, left, right,
                  piston_energy(p, &state) - left - right);
        for (double k = 0; k < steps; ++k) {
            if (progress_signal())
                return;
            if (!steppers[own.method](p, &state, own.every / steps)) {
                program_say("--step: %.3g s leads into a wall at t = %.6g "
                            "s, x = %.6g m",
                            own.every / steps,
                            (row + k / steps) * own.every, state.x);
                s->broken = true;
                return;
            }
            worst = fmax(worst, fabs(piston_energy(p, &state) / start - 1));
            low = fmin(low, state.x);
            high = fmax(high, state.x);
        }
    }
    TABLE_RESULTS(s->summary, {"x_min", low}, {"x_max", high},
                  {"energy_error", worst});
    summarise_periods(s->summary);
}

/* Returns the period found with steps of dt, or NAN if a step fails. The
   piston starts to the right. The period ends when it passes its starting
   position in the same direction, which usually happens between two steps.
   Therefore the last step is shortened by Newton's method until it ends at
   this position. Six iterations suffice, because each doubles the number of
   correct digits. The shortened step is as accurate as the others. */
static double stepped_period(const struct piston *p, stepper *step,
                             double dt)
{
    const struct piston_state start = first_state(p);
    struct piston_state now = start, next = start;
    double steps = 0;
    for (bool left = false; !(left && next.x >= start.x); ++steps) {
        now = next;
        if (!(next.v != 0 && step(p, &next, dt)))
            return NAN;
        left = left || next.x < start.x;
    }
    double part = (start.x - now.x) / now.v;
    for (int k = 0; k < 6; ++k) {
        next = now;
        step(p, &next, part);
        part += (start.x - next.x) / next.v;
    }
    return (steps - 1) * dt + part;
}

enum way { LEAPFROG, RK4, QUADRATURE, SMALL, ACOUSTIC, WAYS };

static const char *const way_names[WAYS] = {"leapfrog", "rk4", "quadrature",
                                            "small", "acoustic"};

/* Returns the period, computed by the given method. `number` is the time
   step (in s) of leapfrog and rk4, or the number of quadrature points. The
   formulas ignore it. */
static double period_by(enum way way, const struct piston *p, double number)
{
    switch (way) {
    case LEAPFROG: return stepped_period(p, piston_step, number);
    case RK4: return stepped_period(p, piston_step_rk4, number);
    case QUADRATURE: return large_period(p, (size_t)number);
    case SMALL: return 2 * acos(-1) / piston_frequency(p);
    default: return 2 * acos(-1) / piston_frequency_acoustic(p);
    }
}

/* Returns the processor time for computing one period (in s): the median of
   five rounds after a discarded warm-up round. A formula takes less time
   than the clock resolves, so each round repeats it for 10 ms. Reading the
   clock takes longer than evaluating a formula, so the times of the two
   formulas are upper limits. */
static double cost_of(enum way way, const struct piston *p, double number)
{
    double rounds[BENCH_ROUNDS];
    volatile double kept; /* keeps the calls from being optimised away */
    for (int round = -1; round < BENCH_ROUNDS; ++round) {
        const double start = bench_seconds();
        double calls = 0, seconds = 0;
        for (; seconds < 0.01; ++calls) {
            kept = period_by(way, p, number);
            seconds = bench_seconds() - start;
        }
        rounds[round < 0 ? 0 : round] = seconds / calls;
    }
    (void)kept;
    return bench_median(rounds, BENCH_ROUNDS);
}

/* Writes the period and its cost for each method, without and with the
   masses of the gases. Halves the steps and doubles the number of points
   until only the last digits of leapfrog's result change. After a signal
   the study ends, and the rows already written are kept. */
static void study_cost(struct study *s)
{
    static const double first[WAYS] = {1, 1, 1, 0, 0};
    static const double factor[WAYS] = {0.5, 0.5, 2, 0, 0};
    static const int count[WAYS] = {13, 10, 7, 1, 1};
    struct piston bare = own.piston;
    bare.left.mass = bare.right.mass = 0;
    bench_machine(s->out);
    TABLE_COLUMNS(s->out, {"way", "", "how the period was found"},
                  {"masses", "", "1: the gases have masses"},
                  {"number", "", "step in s, or points"},
                  {"period", "s", ""},
                  {"cost", "s", "processor time for it"});
    for (int way = 0; way < WAYS; ++way)
        for (int masses = 0; masses < 2; ++masses) {
            const struct piston *p = masses ? &own.piston : &bare;
            double number = first[way];
            for (int k = 0; k < count[way]; ++k, number *= factor[way]) {
                if (progress_signal())
                    return;
                table_print(s->out, "%-10s %d %-14.9g %.12g %.3g\n",
                            way_names[way], masses, number,
                            period_by(way, p, number),
                            cost_of(way, p, number));
            }
        }
    summarise_periods(s->summary);
}

enum { MOVERS = 4096, KEPT = 6 };

/* The values kept from each row of a table that bonkers wrote: the time
   (s), position (m) and velocity (m/s) of the piston, and the energies (J)
   of the piston, the left gas and the right gas. */
struct run_rows {
    size_t rows, capacity, movers;
    double (*row)[KEPT];
};

/* Numbers of the columns that are read: the piston's position (place), and
   the velocities (column[0]) and energies (column[1]) of the movers from
   left to right. The table of an ensemble has energies: T6 is the mean for
   body 6. The table of a single run has velocities, and the masses in its
   head. */
struct columns {
    size_t place, count[2], column[2][MOVERS];
    size_t masses;
    double mass[MOVERS]; /* kg, used if the table has no energies */
};

/* Reads a line of the head, which contains the masses or describes a
   column, such as "# 5 T1 [J] ...". The symbol of a mover's column is a
   letter and a number. A wall has a letter instead of the number, as in xL.
   The movers are in order. */
static void read_head(const char *line, size_t body, struct columns *c)
{
    static const char masses[] = "# masses:";
    size_t column, number;
    char symbol, *end;
    if (strncmp(line, masses, strlen(masses)) == 0) {
        for (line += strlen(masses); c->masses < MOVERS; line = end) {
            c->mass[c->masses] = strtod(line, &end);
            if (end == line)
                break;
            ++c->masses;
        }
    } else if (sscanf(line, "# %zu %c%zu ", &column, &symbol, &number) ==
               3) {
        const int kind = symbol == 'T';
        if (symbol == 'x' && number == body)
            c->place = column;
        if ((kind || symbol == 'v') && number == c->count[kind] + 1 &&
            number <= MOVERS)
            c->column[kind][c->count[kind]++] = column;
    }
}

/* Reads a row and sums the energies of each gas. The movers before the
   piston belong to the left gas, those after it to the right gas. Returns
   false if numbers are missing. */
static bool read_row(const char *line, size_t body, const struct columns *c,
                     double kept[KEPT])
{
    const int kind = c->count[1] > 0;
    size_t next = 0;
    char *end;
    memset(kept, 0, KEPT * sizeof kept[0]);
    for (size_t column = 1;; ++column, line = end) {
        const double value = strtod(line, &end);
        if (end == line)
            break;
        if (column == 1)
            kept[0] = value;
        else if (column == c->place)
            kept[1] = value;
        else if (column == c->column[0][body - 1])
            kept[2] = value;
        if (next < c->count[kind] && column == c->column[kind][next]) {
            ++next;
            const int part = next == body ? 3 : next < body ? 4 : 5;
            kept[part] +=
                kind ? value : c->mass[next - 1] * value * value / 2;
        }
    }
    return next == c->count[kind];
}

/* Reads the table. The head is checked at each row, because it is complete
   only when the rows begin. On failure prints the reason, frees everything
   and returns false. */
static bool read_table(struct study *study, struct run_rows *r)
{
    static struct columns c;
    char *line = NULL;
    const char *wrong = NULL;
    size_t capacity = 0, number = 0;
    FILE *file = strcmp(own.path, "-") == 0 ? stdin : fopen(own.path, "r");
    if (!file)
        wrong = strerror(errno);
    while (!wrong && getline(&line, &capacity, file) > 0) {
        ++number;
        if (line[0] == '#') {
            read_head(line, own.body, &c);
            continue;
        }
        if (r->rows == r->capacity) {
            r->capacity = 2 * r->capacity + 1024;
            void *more = realloc(r->row, r->capacity * sizeof r->row[0]);
            if (!more) {
                wrong = "no memory for so many rows";
                break;
            }
            r->row = more;
        }
        if (c.place == 0 || c.count[0] < own.body ||
            (c.count[1] != c.count[0] && c.masses != c.count[0]))
            wrong = "the head names no x, v and T or masses of that body";
        else if (!read_row(line, own.body, &c, r->row[r->rows++]))
            wrong = "a row without all its numbers";
    }
    if (!wrong && r->rows < 3)
        wrong = "fewer than three rows";
    free(line);
    if (file && file != stdin)
        fclose(file);
    r->movers = c.count[c.count[1] > 0];
    if (wrong) {
        program_say("reading a table: %s%s%.0zu: %s", own.path,
                    number ? ":" : "", number, wrong);
        free(r->row);
        study->broken = true;
    }
    return !wrong;
}

/* Writes the rows of the table for the state diagram, with the temperature
   2 K / N and the pressure 2 K / l of each gas. The left gas has body - 1
   movers. */
static void study_gases(struct study *s)
{
    struct run_rows r = {0};
    if (!read_table(s, &r))
        return;
    TABLE_COLUMNS(s->out, {"t", "s", "time"},
                  {"x", "m", "the piston: length of the left gas"},
                  {"v", "m/s", "its velocity"}, {"TP", "J", "its energy"},
                  {"TL", "J", "energy of the left gas"},
                  {"TR", "J", "energy of the right gas"},
                  {"kTL", "J", "temperature of the left gas"},
                  {"kTR", "J", "temperature of the right gas"},
                  {"PL", "N", "pressure of the left gas"},
                  {"PR", "N", "pressure of the right gas"});
    for (size_t i = 0; i < r.rows; ++i) {
        const double *row = r.row[i];
        const double length = own.piston.length - row[1];
        const double left = (double)(own.body - 1);
        const double right = (double)(r.movers - own.body);
        TABLE_ROW(s->out, row[0], row[1], row[2], row[3], row[4], row[5],
                  2 * row[4] / left, 2 * row[5] / right,
                  2 * row[4] / row[1], 2 * row[5] / length);
    }
    free(r.row);
}

enum { CROSSINGS = 8 };

/* Writes how often the piston crosses the middle, up to CROSSINGS times,
   and its periods. Interpolates the times of crossings linearly between
   rows. Omits the periods if there are fewer than four crossings, because
   one period has no spread. */
static void summarise_crossings(struct table *summary,
                                const struct run_rows *r)
{
    double times[CROSSINGS], sum = 0, square = 0;
    const double middle = own.piston.length / 2;
    size_t n = 0;
    for (size_t i = 0; i + 1 < r->rows && n < CROSSINGS; ++i) {
        const double *a = r->row[i], *b = r->row[i + 1];
        if ((a[1] < middle) != (b[1] < middle))
            times[n++] =
                a[0] + (middle - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    }
    table_count(summary, "crossings", n);
    for (size_t i = 2; i < n; ++i) {
        sum += times[i] - times[i - 2];
        square += (times[i] - times[i - 2]) * (times[i] - times[i - 2]);
    }
    if (n < 4)
        return;
    const double count = (double)(n - 2), mean = sum / count;
    TABLE_RESULTS(
        summary, {"first_half", times[1] - times[0]},
        {"second_half", times[2] - times[1]}, {"period", mean},
        {"period_spread", sqrt(fmax(0, square / count - mean * mean))});
}

static double piston_fraction(const double row[KEPT])
{
    return row[3] / (row[3] + row[4] + row[5]);
}

/* Returns the piston's fraction of the energy, averaged over the rows from
   time t to t + window, or NAN if the table ends earlier. A window of half
   a period averages out the swing. The ends of the window are shifted by
   1e-9 of its length, so that rounding does not decide which rows belong to
   it. */
static double mean_fraction(const struct run_rows *r, double t)
{
    const double margin = 1e-9 * own.window;
    double sum = 0, count = 0;
    if (!(t + own.window <= r->row[r->rows - 1][0] + margin))
        return NAN;
    for (size_t i = 0; i < r->rows; ++i)
        if (r->row[i][0] >= t - margin &&
            r->row[i][0] < t + own.window - margin) {
            sum += piston_fraction(r->row[i]);
            ++count;
        }
    return sum / count;
}

enum { FEWEST_WINDOWS = 3 }; /* minimum for a fit */

struct fit {
    size_t n;
    double tau, error, amplitude; /* excess = amplitude exp(-t/tau) */
};

/* Fits an exponential to the piston's fraction of the energy minus 1 /
   movers, called the excess. The windows do not overlap. The fit begins at
   the first window with an excess below fit[0] and ends before the first
   with an excess below fit[1].

   The logarithm of the excess is fitted by least squares. Its slope is
   -1/tau, so the error of tau is tau^2 times the error of the slope. At
   least three windows are needed, because two determine a line but not the
   scatter about it. */
static struct fit fit_decay(const struct run_rows *r)
{
    struct fit f = {0, NAN, NAN, NAN};
    double st = 0, sy = 0, stt = 0, sty = 0, syy = 0;
    bool begun = false;
    for (double t = 0;; t += own.window) {
        const double excess = mean_fraction(r, t) - 1 / (double)r->movers;
        if (!(excess >= own.fit[1]))
            break;
        begun = begun || excess < own.fit[0];
        if (!begun)
            continue;
        const double y = log(excess), at = t + own.window / 2;
        ++f.n;
        st += at;
        sy += y;
        stt += at * at;
        sty += at * y;
        syy += y * y;
    }
    if (f.n < FEWEST_WINDOWS)
        return f;
    const double n = (double)f.n;
    const double xx = stt - st * st / n, xy = sty - st * sy / n;
    const double slope = xy / xx;
    const double left = syy - sy * sy / n - slope * xy;
    f.tau = -1 / slope;
    f.amplitude = exp((sy - slope * st) / n);
    f.error = sqrt(fmax(0, left) / (n - 2) / xx) / (slope * slope);
    return f;
}

static void study_measure(struct study *s)
{
    struct run_rows r = {0};
    if (!read_table(s, &r))
        return;
    const struct fit f = fit_decay(&r);
    TABLE_COLUMNS(s->out, {"t", "s", "middle of a window"},
                  {"share", "", "the piston's, mean of the window"});
    /* Without a fit, explain the missing column in the head. */
    const bool fitted = f.n >= FEWEST_WINDOWS;
    if (fitted)
        table_column(s->out, "fit", "", "the fitted decay");
    else
        table_print(s->out,
                    "# no fit: %zu windows between its bounds, %d needed\n",
                    f.n, FEWEST_WINDOWS);
    for (double t = 0; mean_fraction(&r, t) >= 0; t += own.window) {
        const double at = t + own.window / 2;
        table_row(s->out, fitted ? 3 : 2,
                  (double[]){at, mean_fraction(&r, t),
                             1 / (double)r.movers +
                                 f.amplitude * exp(-at / f.tau)});
    }
    double reach = 0;
    for (size_t i = 0; i < r.rows; ++i)
        reach = fmax(reach, fabs(r.row[i][1] - own.piston.length / 2));
    table_count(s->summary, "movers", r.movers);
    TABLE_RESULTS(s->summary, {"share_start", piston_fraction(r.row[0])},
                  {"reach", reach});
    summarise_crossings(s->summary, &r);
    for (size_t i = 0; i < own.at_count; ++i)
        table_keyed(s->summary,
                    mean_fraction(&r, own.at[i] - own.window / 2),
                    "share_%zu", i + 1);
    table_count(s->summary, "windows", f.n);
    TABLE_RESULTS(s->summary, {"tau", f.tau}, {"tau_error", f.error});
    free(r.row);
}

static const struct study_entry studies[] = {
    {"run", study_run, "the swing of the model", run_keys},
    {"cost", study_cost, "ways to find its period", run_keys + SWING},
    {"measure", study_measure, "period and decay in a table",
     STUDY_KEYS(
         {"movers", "1", "bodies between the walls"},
         {"share_start", "1", "of the energy, the piston's"},
         {"reach", "m", "farthest place from the middle"},
         {"crossings", "1", "of the middle, 8 at most"},
         {"windows", "1", "of the fit"},
         {"tau", "s", "of the decay; nan: under 3 windows"},
         {"tau_error", "s", "its standard error"},
         {"", "", "if there are 4 crossings:"},
         {"first_half", "s", "first crossing to second"},
         {"second_half", "s", "second to third"}, {"period", "s", "mean"},
         {"period_spread", "s", "standard deviation"}, {"", "", "if --at:"},
         {"share_<i>", "1", "the piston's in window i; nan: none"})},
    {"gases", study_gases, "the gases in a table", NULL},
    {0}};

static const struct options_entry entries[] = {
    {"length", 'L', "L", "m, of the box (12)"},
    {"", 0, NULL, "--study run, cost"},
    {"mass", 'M', "M", "kg, of the piston (40)"},
    {"energies", 'K', "KL,KR", "J, of the gases at the start (10/3 each)"},
    {"gas-masses", 'g', "mL,mR", "kg, of the gases (20/3 each)"},
    {"start", 'x', "X", "m, where the piston starts (the middle)"},
    {"velocity", 'v', "V", "m/s, of the piston at the start (1)"},
    {"", 0, NULL, "--study run"},
    {"method", 'm', "NAME", "leapfrog or rk4 (leapfrog)"},
    {"step", 'h', "DT", "s, the longest step (0.01)"},
    {"every", 'e', "DT", "s, between rows (0.1)"},
    {"until", 'u', "T", "s (40)"},
    {"", 0, NULL, "--study measure, gases"},
    {"table", 'f', "FILE", "from bonkers, to be measured; - is input"},
    {"body", 'b', "N", "the piston's number in it (6)"},
    {"", 0, NULL, "--study measure"},
    {"window", 'w', "T", "s, half a period (10.15)"},
    {"at", 'a', "T1,..", "s, middles of windows to report"},
    {"fit", 'F', "A,B", "excess of the share (0.1,0.01)"},
    {0}};

/* Reads the value of an option. The limits admit every real piston and
   exclude overflow. */
static void take_option(struct options *o, int letter)
{
    switch (letter) {
    case 'M': own.piston.mass = options_real(o, 1e-9, 1e9); break;
    case 'L': own.piston.length = options_real(o, 1e-9, 1e9); break;
    case 'K': read_pair(o, own.energies, 1e-9); break;
    case 'g': read_pair(o, own.masses, 0); break;
    case 'x': own.start.x = options_real(o, 0, 1e9); break;
    case 'v': own.start.v = options_real(o, -1e9, 1e9); break;
    case 'm': own.method = options_choice(o, stepper_names); break;
    case 'h': own.step = options_real(o, 1e-9, 1e9); break;
    case 'e': own.every = options_real(o, 1e-9, 1e9); break;
    case 'u': own.until = options_real(o, 0, 1e9); break;
    case 'f': own.path = options_input(o); break;
    case 'b': own.body = options_count(o, 1, 4096); break;
    case 'w': own.window = options_real(o, 1e-9, 1e9); break;
    case 'a': own.at_count = options_list(o, own.at, MOST); break;
    case 'F': read_pair(o, own.fit, 1e-9); break;
    }
}

/* Completes and checks the settings after all options have been read. The
   start of the piston determines the lengths of the gases. */
static void check_settings(struct options *o, const char *study)
{
    const double length = own.piston.length;
    if (isnan(own.start.x))
        own.start.x = length / 2;
    if (!(own.start.x > 0 && own.start.x < length))
        options_fail(o, "--start: %g is not inside the box, 0 to %g",
                     own.start.x, length);
    if (strcmp(study, "cost") == 0 && !(own.start.v > 0))
        options_fail(o,
                     "--velocity: %g, but a cost is measured from a "
                     "start to the right",
                     own.start.v);
    if ((strcmp(study, "measure") == 0 || strcmp(study, "gases") == 0) &&
        !own.path)
        options_fail(o, "--study %s needs --table", study);
    if (!(own.fit[0] > own.fit[1]))
        options_fail(o, "--fit: from %g to %g is no decay", own.fit[0],
                     own.fit[1]);
    own.piston.left =
        (struct piston_gas){own.energies[0], own.start.x, own.masses[0]};
    own.piston.right = (struct piston_gas){
        own.energies[1], length - own.start.x, own.masses[1]};
}

/* The defaults describe eleven particles. The sixth is the piston. */
STUDY_MAIN(.name = PROGRAM,
           .purpose = "A piston between two adiabatic springs of gas.",
           .events = "steps", .studies = studies, .usual = "run",
           .options = entries, .take = take_option, .check = check_settings)
