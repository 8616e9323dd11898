/* Finds the exercises of a course and their files. */
#include "examiner/course.h"
#include "examiner/sum.h"
#include "examiner/text.h"

#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Sets path to the file that matches the pattern `where`, with `name` in
   place of %s, or to "" if there is none. If two files match, asks the
   student to move one, which may be a copy. Refuses files that are not
   plain: opening a named pipe would wait for its writer. */
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

/* If the file is missing, looks for one with a similar name, such as
   01a_collide.c. */
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

/* The stub must exist: an exercise counts as begun if the student's file
   differs from its stub. */
static void find_files(struct exercise *e)
{
    find_one("tests/exercises/%s/stub.c", e->name, e->stub);
    if (!*e->stub)
        text_fail("exercise %s has no tests/exercises/%s/stub.c", e->name,
                  e->name);
    find_one("solutions/%s-*.c", e->name, e->solution);
    course_find_file(e);
}

/* Reads the title, tests and minutes of an exercise from
   build/check/NAME.list. The strings point into the text of that file. The
   list also contains the usual name of the student's file, in case the
   student has deleted that file. tests/lists.awk makes the lists from the
   sources of the suites, because building forty runners to print them took
   half a minute. A test compares these lists with those that the runners
   print. */
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

struct course course_learn(void)
{
    struct course course = {NULL, 0};
    glob_t found = {0};
    glob("tests/exercises/[0-9][0-9][a-z]", 0, NULL, &found);
    glob("tests/exercises/P[0-9]", GLOB_APPEND, NULL, &found);
    course.exercises =
        text_must(calloc(found.gl_pathc + 1, sizeof *course.exercises));
    for (size_t i = 0; i < found.gl_pathc; ++i)
        if (read_about(&course.exercises[course.count],
                       strrchr(found.gl_pathv[i], '/') + 1))
            ++course.count;
    globfree(&found);
    if (course.count == 0)
        text_fail("no suites in build/check; start me with make check");
    return course;
}

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

/* Compares the file with its stub. File times do not show whether the file
   was changed: git clone gives all files the same time. A search for
   NOT_DONE_YET does not show it either: a stub may be a whole program with
   a mistake in it. */
bool course_touched(const struct exercise *e)
{
    return *e->file && sum_file(0, e->file) != sum_file(0, e->stub);
}
