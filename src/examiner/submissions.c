/* From chapters/B-grader.nw: edit there, then run make tangle. */
/* checksum 1156808427 of the lines below */
#include "examiner/submissions.h"
#include "examiner/marks.h"
#include "examiner/text.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int open_folder(int parent, const char *name)
{
    return openat(parent, name,
                  O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static size_t list_folder(int folder, char ***names)
{
    const int copy = dup(folder);
    DIR *list = copy < 0 ? NULL : fdopendir(copy);
    size_t count = 0;
    *names = NULL;
    if (!list)
        return 0;
    rewinddir(list);
    for (struct dirent *entry; (entry = readdir(list));) {
        if (entry->d_name[0] == '.')
            continue;
        *names = realloc(*names, (count + 1) * sizeof **names);
        if (!*names || !((*names)[count++] = strdup(entry->d_name)))
            text_fail("out of memory");
    }
    closedir(list);
    qsort(*names, count, sizeof **names, compare_names);
    return count;
}

static void free_names(char **names, size_t count)
{
    while (count > 0)
        free(names[--count]);
    free(names);
}
enum { DEPTH = 3 }; /* of folders below a student's that we look into */

static void set_remark(char **remark, const char *what, const char *name)
{
    char *text = marks_text(name, strlen(name), 200);
    free(*remark);
    *remark = malloc(strlen(what) + strlen(text) + 1);
    if (!*remark)
        text_fail("out of memory");
    strcat(strcpy(*remark, what), text);
    free(text);
}

static char *read_all(int file, size_t *length)
{
    char *bytes = malloc(SUBMISSIONS_BYTES + 1);
    ssize_t got = 1;
    *length = 0;
    while (bytes && got > 0 && *length <= SUBMISSIONS_BYTES) {
        got = read(file, bytes + *length, SUBMISSIONS_BYTES + 1 - *length);
        *length += got > 0 ? (size_t)got : 0;
    }
    if (got < 0 || *length > SUBMISSIONS_BYTES) {
        free(bytes);
        bytes = NULL;
    }
    return bytes;
}

static struct submission named(const char *entry, const char *name)
{
    const struct submission s = {strdup(entry),
                                 marks_text(name, strlen(name), 4096)};
    if (!s.entry)
        text_fail("out of memory");
    return s;
}

static bool is_folder(int parent, const char *name)
{
    struct stat about;
    return fstatat(parent, name, &about, AT_SYMLINK_NOFOLLOW) == 0 &&
           S_ISDIR(about.st_mode);
}

static bool is_exercise(const char *name, const char *exercise)
{
    const unsigned char *s = (const unsigned char *)name;
    const size_t length = strlen(name);
    return length > 4 && strcmp(name + length - 2, ".c") == 0 &&
           (exercise ? strncmp(name, exercise, 3) == 0
                     : isdigit(s[0]) && isdigit(s[1]) && islower(s[2])) &&
           !isalnum(s[3]);
}

size_t submissions_find(const char *folder, struct submission **list)
{
    const int open = open_folder(AT_FDCWD, folder);
    char **names;
    if (open < 0)
        text_fail("cannot read the folder '%s': %s", folder,
                  strerror(errno));
    size_t count = 0;
    const size_t entries = list_folder(open, &names);
    *list = calloc(entries + 1, sizeof **list);
    for (size_t i = 0; *list && i < entries; ++i)
        if (is_folder(open, names[i]))
            (*list)[count++] = named(names[i], names[i]);
    for (size_t i = 0; *list && count == 0 && i < entries; ++i)
        if (is_exercise(names[i], NULL)) {
            const char *slash = strrchr(folder, '/');
            (*list)[count++] = named(".", slash ? slash + 1 : folder);
        }
    free_names(names, entries);
    close(open);
    if (count == 0)
        text_fail("'%s' has neither folders of students nor files of "
                  "exercises (01a-....c)",
                  folder);
    return count;
}

static char *find_name(int folder, const char *exercise, const char *usual,
                       char **remark)
{
    char **names, *found = NULL;
    int matches = 0;
    const size_t count = list_folder(folder, &names);
    for (size_t i = 0; i < count; ++i)
        if (is_exercise(names[i], exercise)) {
            ++matches;
            if (!found || strcmp(names[i], usual) == 0) {
                free(found);
                found = strdup(names[i]);
            }
        }
    free_names(names, count);
    if (matches > 1 && strcmp(found, usual) != 0) {
        set_remark(remark, "two files could be it, and none is called ",
                   usual);
        free(found);
        return NULL;
    }
    return found;
}

static int find_place(int folder, const char *exercise, const char *usual,
                      int depth, char **name, char **remark)
{
    *name = find_name(folder, exercise, usual, remark);
    if (*name || **remark)
        return folder;
    char **names;
    const size_t count = list_folder(folder, &names);
    int place = -1;
    for (size_t i = 0; depth > 0 && place < 0 && i < count; ++i) {
        static const char *const kits[] = {"tests",    "solutions", "src",
                                           "chapters", "build",     "plots",
                                           NULL};
        bool known = false;
        for (const char *const *kit = kits; *kit; ++kit)
            known |= strcmp(names[i], *kit) == 0;
        const int below = known ? -1 : open_folder(folder, names[i]);
        if (below >= 0)
            place =
                find_place(below, exercise, usual, depth - 1, name, remark);
    }
    free_names(names, count);
    close(folder);
    return place;
}

static char *read_regular(int folder, const char *name, size_t *length,
                          char **remark)
{
    struct stat about;
    const int file = openat(folder, name,
                            O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    char *bytes = NULL;
    if (file < 0 && errno != ELOOP)
        set_remark(remark, "cannot be read: ", strerror(errno));
    else if (file < 0 || fstat(file, &about) != 0 ||
             !S_ISREG(about.st_mode))
        set_remark(remark, "refused, since it is no regular file: ", name);
    else if (!(bytes = read_all(file, length)))
        set_remark(remark,
                   "refused, since it is larger than 1 MiB: ", name);
    else
        set_remark(remark, "", name);
    if (file >= 0)
        close(file);
    return bytes;
}

char *submissions_read(const char *folder, const struct submission *s,
                       const char *exercise, const char *usual,
                       size_t *length, char **remark)
{
    const int top = open_folder(AT_FDCWD, folder);
    const int own = top < 0 ? -1 : open_folder(top, s->entry);
    char *name = NULL, *bytes = NULL;
    int place = -1;
    *remark = strdup("");
    if (own >= 0)
        place = find_place(own, exercise, usual, DEPTH, &name, remark);
    else
        set_remark(remark, "the folder cannot be read: ", strerror(errno));
    if (name)
        bytes = read_regular(place, name, length, remark);
    else if (!**remark)
        set_remark(remark, "no file", "");
    free(name);
    if (place >= 0)
        close(place);
    if (top >= 0)
        close(top);
    return bytes;
}
