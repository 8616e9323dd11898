/* Finds the exercises of a course and their files. */
#include "examiner/course.h"
#include "examiner/sum.h"
#include "examiner/text.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Finds the one plain file whose name fits. Where two fit, a copy made in
   haste perhaps, nobody can know which one is meant, so it is asked. A
   named pipe would have to be waited for. */
static void find_one(const char *where, const char *name,
                     char path[COURSE_PATH])
{
    glob_t found = {0};
    char pattern[64];
    snprintf(pattern, sizeof pattern, where, name);
    path[0] = '\0';
    if (glob(pattern, 0, NULL, &found) == 0)
        snprintf(path, COURSE_PATH, "%s", found.gl_pathv[0]);
    if (*path && !text_plain(path))
        text_fail("'%s' is not a plain file; move it out of the folder",
                  path);
    if (found.gl_pathc > 1)
        text_fail("'%s' and '%s' are the same exercise; move one of them "
                  "out of the folder",
                  found.gl_pathv[0], found.gl_pathv[1]);
    globfree(&found);
}

/* Finds the student's file. A missing file is looked for once more with a
   wider pattern: 01a_collide.c is a slip of one letter. */
void course_find_file(struct exercise *e)
{
    find_one("exercises/%s-*.c", e->name, e->file);
    e->stray[0] = '\0';
    if (!*e->file)
        find_one("exercises/%s*.c", e->name, e->stray);
}

static void learn_test(struct exercise *e, const char *text)
{
    char *name;
    e->worth[e->count] = (int)strtol(text, &name, 10);
    e->points += e->worth[e->count];
    strtol(name, &name, 10);
    e->idle[e->count] = strtol(name, &name, 10) != 0;
    e->tests[e->count++] = name + strspn(name, " ");
}

/* Finds the stub and the solution of an exercise. Without a stub nobody
   could tell what is begun; without a solution there is none to show. */
static void find_files(struct exercise *e)
{
    find_one("tests/exercises/%s/stub.c", e->name, e->stub);
    if (!*e->stub)
        text_fail("exercise %s has no tests/exercises/%s/stub.c", e->name,
                  e->name);
    find_one("solutions/%s-*.c", e->name, e->solution);
    course_find_file(e);
}

/* Reads the description of a suite from its list; the strings of the
   structure point into the list's text. The name of the exercise's file
   comes from there too, because a student may have deleted the file. The
   lists are made from the source of the suites (tests/lists.awk), and a
   test compares them with what the runners print: building forty runners
   only to ask them delayed the first check by half a minute. */
static bool read_about(struct exercise *e, const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "build/check/%s.list", name);
    char *rest = text_read(path);
    const char *text;
    if (!rest && access(path, F_OK) != 0)
        return false;
    memcpy(e->name, name, 3);
    e->usual = e->title = "";
    for (char *line; (line = text_line(&rest));)
        if ((text = text_after(line, "file ")))
            e->usual = text;
        else if ((text = text_after(line, "title ")))
            e->title = text;
        else if ((text = text_after(line, "minutes ")))
            e->minutes = atoi(text);
        else if ((text = text_after(line, "test ")) &&
                 e->count < CHECK_TESTS)
            learn_test(e, text);
    if (!*e->usual || !e->count)
        text_fail("%s is not complete; remove it and make check again",
                  path);
    find_files(e);
    return true;
}

/* Reads which exercises there are. The exercises are the folders of
   tests/exercises; a table would be a second place for the same fact. One
   without a list is passed over. */
struct course course_learn(void)
{
    struct course course = {NULL, 0};
    glob_t found = {0};
    glob("tests/exercises/[0-9][0-9][a-z]", 0, NULL, &found);
    glob("tests/exercises/P[0-9]", GLOB_APPEND, NULL, &found);
    course.exercises = calloc(found.gl_pathc + 1, sizeof *course.exercises);
    if (!course.exercises)
        text_fail("out of memory");
    for (size_t i = 0; i < found.gl_pathc; ++i)
        if (read_about(&course.exercises[course.count],
                       strrchr(found.gl_pathv[i], '/') + 1))
            ++course.count;
    globfree(&found);
    if (course.count == 0)
        text_fail("no suites in build/check; start me with make check");
    return course;
}

/* Marks the exercises of a name as chosen. A name that is not known is
   answered with all that are: the commonest reason is a slip of one
   letter. */
struct exercise *course_choose(struct course *course, const char *name)
{
    struct exercise *first = NULL;
    const size_t length = strlen(name) == 2 ? 2 : 4;
    for (size_t i = course->count; i-- > 0;)
        if (strncmp(course->exercises[i].name, name, length) == 0) {
            first = &course->exercises[i];
            first->chosen = true;
        }
    if (first)
        return first;
    fprintf(stderr, "examine: there is no exercise '%s'; there are", name);
    for (size_t i = 0; i < course->count; ++i)
        fprintf(stderr, " %s", course->exercises[i].name);
    fputc('\n', stderr);
    exit(2);
}

/* Compares with the stub, which needs no compiler. The date says nothing:
   git clone gives all files one. It is the only way for an exercise whose
   stub is a whole program with a mistake in it, which has no gap to
   reach. */
bool course_touched(const struct exercise *e)
{
    return *e->file && sum_file(0, e->file) != sum_file(0, e->stub);
}
