/* Adds up points, and reads and writes files of marks. */
#include "examiner/marks.h"
#include "examiner/text.h"
#include "toolbox/replace.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int marks_earned(const struct marks *marks, bool hidden)
{
    int points = 0;
    for (int i = 0; i < marks->count; ++i)
        if (marks->marks[i].hidden == hidden &&
            marks->marks[i].state == PASSED)
            points += marks->marks[i].points;
    return points;
}

int marks_possible(const struct marks *marks, bool hidden)
{
    int points = 0;
    for (int i = 0; i < marks->count; ++i)
        if (marks->marks[i].hidden == hidden)
            points += marks->marks[i].points;
    return points;
}

bool marks_late(const struct marks *marks)
{
    if (marks->late || marks->state == TIMED_OUT)
        return true;
    for (int i = 0; i < marks->count; ++i)
        if (marks->marks[i].state == TIMED_OUT)
            return true;
    return false;
}

/* Escaped bytes are shown as two hexadecimal digits, not as a question
   mark: a student who prints values to find an error needs to know the
   byte. */
char *marks_text(const char *bytes, size_t length, size_t most)
{
    const size_t kept = length < most ? length : most;
    char *text = text_escaped(bytes, kept);
    if (kept == length)
        return text;
    const size_t end = strlen(text);
    char *longer = text_must(realloc(text, end + 80));
    sprintf(longer + end, "\n... (%zu bytes in all)", length);
    return longer;
}

/* Returns a test's mark as JSON. A state is written as its name, so that a
   file stays valid if the numbers of the states change. */
static json_t *json_of_mark(const struct mark *mark)
{
    return json_pack("{s:s, s:b, s:i, s:s, s:s, s:f}", "name", mark->name,
                     "hidden", mark->hidden, "points", mark->points,
                     "state", state_name(mark->state), "story", mark->story,
                     "seconds", mark->seconds);
}

static json_t *json_of_marks(const struct marks *m, const char *key)
{
    json_t *list = json_array();
    for (int i = 0; i < m->count; ++i)
        json_array_append_new(list, json_of_mark(&m->marks[i]));
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, "
                     "s:f, s:f, s:i, s:b, s:o}",
                     "key", key, "student", m->student, "exercise",
                     m->exercise, "title", m->title, "file", m->file,
                     "note", m->note, "state", state_name(m->state),
                     "story", m->story, "prints", m->prints, "advice",
                     m->advice, "seconds", m->seconds, "build_seconds",
                     m->build_seconds, "tries", m->tries, "late", m->late,
                     "tests", list);
}

void marks_write(const struct marks *marks, const char *key,
                 const char *path)
{
    json_t *json = json_of_marks(marks, key);
    char *text = json ? json_dumps(json, JSON_INDENT(1)) : NULL;
    if (!text || !replace_file(path, text, strlen(text), 0600, false))
        text_fail("cannot write '%s': %s", path, strerror(errno));
    free(text);
    json_decref(json);
}

static enum state state_of(const char *name)
{
    enum state state = NOT_BEGUN;
    while (state < PASSED && strcmp(state_name(state), name) != 0)
        ++state;
    return state;
}

/* Reads a test's mark. Returns false if anything is missing, because the
   disk was full or somebody has edited the file. The exercise is then
   graded again. */
static bool mark_of_json(struct mark *mark, json_t *json)
{
    const char *name, *state, *story;
    int hidden;
    if (json_unpack(json, "{s:s, s:b, s:i, s:s, s:s, s:f}", "name", &name,
                    "hidden", &hidden, "points", &mark->points, "state",
                    &state, "story", &story, "seconds",
                    &mark->seconds) != 0)
        return false;
    mark->name = strdup(name);
    mark->hidden = hidden;
    mark->state = state_of(state);
    mark->story = strdup(story);
    return true;
}

static bool marks_of_json(struct marks *m, json_t *json, const char *key)
{
    const char *its, *state, *texts[8];
    char **places[] = {&m->student, &m->exercise, &m->title,  &m->file,
                       &m->note,    &m->story,    &m->prints, &m->advice};
    json_t *list;
    int late;
    if (json_unpack(
            json,
            "{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:f, s:f, "
            "s:i, s:b, s:o}",
            "key", &its, "student", &texts[0], "exercise", &texts[1],
            "title", &texts[2], "file", &texts[3], "note", &texts[4],
            "state", &state, "story", &texts[5], "prints", &texts[6],
            "advice", &texts[7], "seconds", &m->seconds, "build_seconds",
            &m->build_seconds, "tries", &m->tries, "late", &late, "tests",
            &list) != 0 ||
        (key && strcmp(its, key) != 0))
        return false;
    m->state = state_of(state);
    m->late = late;
    for (int i = 0; i < 8; ++i)
        *places[i] = strdup(texts[i]);
    bool whole = json_array_size(list) <= MARKS_MOST;
    for (size_t i = 0; whole && i < json_array_size(list); ++i) {
        whole = mark_of_json(&m->marks[i], json_array_get(list, i));
        m->count += whole;
    }
    return whole;
}

bool marks_read(struct marks *marks, const char *key, const char *path)
{
    json_t *json = json_load_file(path, 0, NULL);
    *marks = (struct marks){0};
    const bool whole = json && marks_of_json(marks, json, key);
    json_decref(json);
    if (!whole)
        marks_free(marks);
    return whole;
}

void marks_free(struct marks *marks)
{
    char *texts[] = {marks->student, marks->exercise, marks->title,
                     marks->file,    marks->note,     marks->story,
                     marks->prints,  marks->advice};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; ++i)
        free(texts[i]);
    for (int i = 0; i < marks->count; ++i) {
        free(marks->marks[i].name);
        free(marks->marks[i].story);
    }
    *marks = (struct marks){0};
}
