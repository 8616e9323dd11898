/* Files of states: what is written is read again to the last bit, and what
   cannot be is refused with the line and the reason. */
#include "unit.h"

#include "box/states.h"

static const char path[] = "build/tests/states.table";

static void text(const char *words)
{
    FILE *file = fopen(path, "w");
    if (!file || fputs(words, file) < 0 || fclose(file) != 0)
        exit(1);
}

/* Disks that have flown since some last collision, some far from the box.
 */
static void make(struct disks *d, size_t dimensions,
                 enum disks_boundary boundary, double gravity)
{
    SEEDED(r, dimensions);
    UNIT_MUST(disks_create(d, dimensions, 5));
    d->boundary = boundary;
    d->gravity = gravity;
    d->now = 7.1;
    for (size_t k = 0; k < dimensions; ++k)
        d->box[k] = 10.1 + (double)k / 3;
    for (size_t i = 0; i < 5; ++i) {
        struct disk *a = &d->disk[i];
        d->mass[i] = random_between(&r, 1, 2);
        a->radius = random_uniform(&r);
        a->since = 7 + 0.1 * random_uniform(&r);
        for (size_t k = 0; k < dimensions; ++k) {
            a->position[k] = random_between(&r, 1, 9) +
                             (disks_wraps(d, k) ? 30 * (double)i : 0);
            a->velocity[k] = random_between(&r, -2, 2);
        }
    }
}

/* The columns have their names and units, and each row the number of its
   disk. */
static void check_columns(size_t D)
{
    static const char *const names[2][11] = {
        {"t [s]", "disk [1]", "mass [kg]", "radius [m]", "x [m]", "y [m]",
         "vx [m/s]", "vy [m/s]", "x0 [m]", "y0 [m]", "t0 [s]"},
        {"t [s]", "disk [1]", "mass [kg]", "radius [m]", "x [m]", "y [m]",
         "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]", "x0 [m]"}};
    FILE *file = fopen(path, "r");
    char line[1024], name[64];
    size_t columns = 0, rows = 0;
    UNIT_MUST(file);
    while (fgets(line, sizeof line, file)) {
        double number;
        if (columns < 11) {
            snprintf(name, sizeof name, "# %zu %s ", columns + 1,
                     names[D - 2][columns]);
            columns += strncmp(line, name, strlen(name)) == 0;
        }
        if (line[0] != '#' && sscanf(line, "%*f %lf", &number) == 1)
            UNIT_EQUAL(number, rows++ % 5 + 1);
    }
    fclose(file);
    UNIT_EQUAL(columns, 11);
    UNIT_EQUAL(rows, 10);
}

/* Two blocks: the last one counts. Under gravity the places are those of
   now. */
TEST(test_there_and_back, "what is written is read again")
{
    for (size_t D = 2; D <= 3; ++D)
        for (int n = 0; n < 5; ++n) {
            const enum disks_boundary boundary = n % 3;
            FREED(disks) d, back;
            char message[STATES_MESSAGE];
            double sides[DISKS_AXES] = {0};
            make(&d, D, boundary, n > 2 || boundary == DISKS_FLOOR);
            if (boundary == DISKS_PERIODIC)
                d.gravity = 0;
            struct table *out = table_open("states", path);
            UNIT_MUST(out);
            states_begin(out, &d);
            const double now = d.now;
            d.now = 7.05;
            for (size_t i = 0; i < 5; ++i)
                d.disk[i].since -= 0.1;
            states_write(out, &d);
            for (size_t i = 0; i < 5; ++i)
                d.disk[i].since += 0.1;
            d.now = now;
            table_print(out, "\n");
            states_write(out, &d);
            UNIT_TRUE(table_close(out));
            check_columns(D);
            UNIT_TRUE(states_read(&back, path, message));
            UNIT_EQUAL(back.count, 5);
            UNIT_EQUAL(back.dimensions, D);
            UNIT_EQUAL(back.now, now);
            UNIT_TRUE(back.boundary == boundary);
            memcpy(sides, d.box, D * sizeof *sides);
            for (size_t k = 0; k < 3; ++k)
                UNIT_EQUAL(back.box[k], sides[k]);
            for (size_t i = 0; i < 5; ++i) {
                const struct disk *a = &back.disk[i], *b = &d.disk[i];
                double place[DISKS_AXES], v[DISKS_AXES];
                disks_position(&d, i, place);
                disks_velocity(&d, i, v);
                disks_fold(&d, place);
                UNIT_EQUAL(back.mass[i], d.mass[i]);
                UNIT_EQUAL(a->radius, b->radius);
                UNIT_EQUAL(a->since, d.gravity > 0 ? now : b->since);
                for (size_t k = 0; k < 3; ++k) {
                    UNIT_EQUAL(a->position[k],
                               d.gravity > 0 ? place[k] : b->position[k]);
                    UNIT_EQUAL(a->velocity[k], v[k]);
                }
            }
        }
    remove(path);
}

TEST(test_texts, "what is read")
{
    static const struct {
        const char *text;
        size_t count;
        double box[3];
        enum disks_boundary boundary;
    } files[] = {
        {"1 1 2 .5 3 4 5 6\n", 1, {0}, DISKS_WALLS},
        {"# box 10 20 periodic\n1 1 2 .5 3 4 5 6\n1 2 2 .5 8 4 5 6 \t\r\n",
         2,
         {10, 20},
         DISKS_PERIODIC},
        {"# box 10 20 30 floor\n1 1 2 .5 3 4 4 5 6 6\n",
         1,
         {10, 20, 30},
         DISKS_FLOOR},
        {"# box 10 0 walls\n1 1 2 .5 3 4 5 6\n", 1, {10}, 0},
        {"# box -1 9.9e99 walls\n1 1 2 .5 3 4 5 6\n", 1, {0, 9.9e99}, 0},
        {"# box 1.01e100 inf nonsense\n1 1 2 .5 3 4 5 6\n", 1, {0}, 0},
        {"# box 5\n# boxes\n1 1 2 .5 3 4 5 6\n", 1, {0}, 0},
        {"1 1 2 .5 3 4 5 6\n \t\n\n2 1 2 .5 3 4 5 6\n\n", 1, {0}, 0},
        {"1 1 2 .5 3 4 5 6 3 4 1\n", 1, {0}, 0},
        {"1 1 2 .5 3 4 5 6 7 8 3 4 5 .5\n", 1, {0}, 0},
        {"1 1 2 0 3 4 5 6\n", 1, {0}, 0}};
    for (size_t n = 0; n < sizeof files / sizeof files[0]; ++n) {
        FREED(disks) d = {0};
        char message[STATES_MESSAGE] = "";
        text(files[n].text);
        UNIT_MUST(states_read(&d, path, message));
        UNIT_EQUAL(d.count, files[n].count);
        for (size_t k = 0; k < 3; ++k)
            UNIT_EQUAL(d.box[k], files[n].box[k]);
        UNIT_TRUE(d.boundary == files[n].boundary);
        UNIT_LIST(d.disk[0].position, 0, 3, 4);
        UNIT_EQUAL(d.mass[0], 2);
    }
    remove(path);
}

TEST(test_refused, "what is refused")
{
    static const char *const files[][2] = {
        {"", ": 0 rows of disks"},
        {"# box 10 20 walls\n\n", ": 0 rows of disks"},
        {"1 1 2 .5 3 4 5\n", ":1: 7 numbers in the row"},
        {"\n1 1 2 .5 3 4 5 6 7\n", ":2: 9 numbers"},
        {"1 1 2 .5 3 4 5 6 7 8 9 10\n", ":1: 12 numbers"},
        {"1 1 2 .5 3 4 5 6 7 8 9 10 11 12 13\n", ":1: 14 numbers"},
        {"1 1 2 .5 3 4 5 6x\n", ":1: 8 numbers"},
        {"1 1 2 .5 3 4 5 nan\n", ":1: 7 numbers"},
        {"1 1 2 .5 3 4 5 6\n1 1 2 .5 3 4 5 6 7 8\n", ":2: 10 numbers"},
        {"# box 1 2 3 walls\n1 1 2 .5 3 4 5 6\n",
         ": the box has 3 sides, the rows have 2 coordinates"},
        {"# box 1 2 walls\n1 1 2 .5 3 4 5 6 7 8\n",
         ": the box has 2 sides, the rows have 3 coordinates"},
        {"1 1 0 .5 3 4 5 6\n", ": disk 1 has mass 0,"},
        {"1 1 1 .5 3 4 5 6\n1 2 1 -1 3 4 5 6\n",
         ": disk 2 has mass 1, radius -1"},
        {"1 1 1 .5 3 4 5 6\n2 2 1 1 3 4 5 6\n",
         ": disk 2 has mass 1, radius 1 and times 2, 2;"},
        {"1 1 1 .5 3 4 5 6 3 4 2\n",
         ": disk 1 has mass 1, radius 0.5 and times 1, 2;"}};
    struct disks d;
    char message[STATES_MESSAGE];
    for (size_t n = 0; n < sizeof files / sizeof files[0]; ++n) {
        char said[STATES_MESSAGE];
        text(files[n][0]);
        UNIT_TRUE(!states_read(&d, path, message));
        snprintf(said, sizeof said, "%s%s", path, files[n][1]);
        UNIT_TRUE(strncmp(message, said, strlen(said)) == 0);
    }
    remove(path);
    UNIT_TRUE(!states_read(&d, path, message));
    UNIT_SAYS(message, "build/tests/states.table: "
                       "No such file or directory");
    /* A path that leaves no room for the reason does no harm. */
    char far[2 * STATES_MESSAGE];
    for (size_t length = STATES_MESSAGE - 4; length < sizeof far;
         length += length < STATES_MESSAGE + 4 ? 1 : 100) {
        memset(far, 'x', sizeof far);
        far[length] = '\0';
        UNIT_TRUE(!states_read(&d, far, message));
        UNIT_EQUAL(strlen(message), STATES_MESSAGE - 1);
    }
}
