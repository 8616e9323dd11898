/* Finds the files to grade in a folder of submissions. */
#include "examiner/submissions.h"
#include "examiner/marks.h"
#include "examiner/text.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <regex.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* Opens the folder `name` in the folder `parent`. A student's file might be
   a link to /etc/passwd, or a named pipe. So all functions here use
   descriptors and follow no links: nobody can replace a file between its
   check and its opening, and no name is given to a shell. */
static int open_folder(int parent, const char *name)
{
    return openat(parent, name,
                  O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static bool is_ours(const char *name)
{
    static const char *const not_ours[] = {
        ".",         "..",          ".git",     "__MACOSX",
        ".DS_Store", "desktop.ini", "Thumbs.db"};
    for (size_t i = 0; i < sizeof not_ours / sizeof not_ours[0]; ++i)
        if (strcmp(name, not_ours[i]) == 0)
            return false;
    return !text_after(name, "._");
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
        if (!is_ours(entry->d_name))
            continue;
        *names = text_must(realloc(*names, (count + 1) * sizeof **names));
        (*names)[count++] = text_must(strdup(entry->d_name));
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

/* The maximum number of notes on one student. If there are more, a last
   line says so. */
enum { NOTES = 12 };

/* Returns a formatted line; the caller frees it. Also escapes line ends,
   which a file's name may contain and marks_text would keep. */
static char *compose(const char *format, ...)
{
    char raw[8192], *text, *line, *end;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(raw, sizeof raw, format, arguments);
    va_end(arguments);
    text = marks_text(raw, strlen(raw), sizeof raw);
    line = end = text_must(malloc(4 * strlen(text) + 1));
    for (const char *c = text; *c; ++c)
        end += sprintf(end, *c == '\n' ? "\\x0a" : "%c", *c);
    *end = '\0';
    free(text);
    return line;
}

/* Returns a path without the student's folder, which every note names
   anyway. */
static const char *below(const char *path)
{
    const char *slash = strchr(path, '/');
    return slash ? slash + 1 : path;
}

static void note(struct submission *s, const char *what, const char *path)
{
    char *line = compose("%s%s", what, below(path)), *all = s->notes;
    if (++s->noted > NOTES + 1) {
        free(line);
        return;
    }
    s->notes = text_must(malloc(strlen(all) + strlen(line) + 16));
    sprintf(s->notes, "%s%s\n", all,
            s->noted > NOTES ? "... and more" : line);
    free(line);
    free(all);
}

static bool is_page(const char *name)
{
    return toupper((unsigned char)name[0]) == 'P' &&
           isdigit((unsigned char)name[1]) &&
           (strcasecmp(name + 2, ".gp") == 0 ||
            strcasecmp(name + 2, ".txt") == 0);
}

static bool is_exercise(const char *name)
{
    const unsigned char *s = (const unsigned char *)name;
    if (toupper(s[0]) == 'P')
        return isdigit(s[1]) && (s[2] == '-' || is_page(name));
    return isdigit(s[0]) && isdigit(s[1]) && isalpha(s[2]) &&
           !isalnum(s[3]);
}

/* Returns where the name of an exercise begins in a file's name, or NULL.
   The name may be in capitals, as on Windows: 01A-SOMETHING.C. A platform
   may have put a prefix that ends in _ before it. */
static const char *find_exercise(const char *name)
{
    const char *found = is_exercise(name) ? name : NULL;
    for (const char *c = name; !is_exercise(name) && *c; ++c)
        if (*c == '_' && is_exercise(c + 1))
            found = c + 1;
    return found;
}

static bool ends(const char *name, const char *const endings[])
{
    const size_t length = strlen(name);
    for (; *endings; ++endings) {
        const size_t its = strlen(*endings);
        if (length > its && strcasecmp(name + length - its, *endings) == 0)
            return true;
    }
    return false;
}

static const char *const c_endings[] = {".c", NULL};
static const char *const source_endings[] = {".c", ".cpp", ".cc", ".cxx",
                                             NULL};
static const char *const archives[] = {
    ".zip", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".7z", ".rar", NULL};
static const char *const made[] = {".o", ".exe", ".out", ".h", NULL};

static const char canvas[] =
    "^((LATE_)?anon_[[:alnum:]]+|[^_]+(_LATE)?_[0-9]+)_[0-9]+_";

/* The owner of a file, read from the name of the file or its folder. Moodle
   puts the student's name, a number and assignsubmission_file_ before the
   file's name, or makes a folder with such a name. Canvas puts the
   student's name, LATE if the file was late, and the numbers of the user
   and the file before it. If names are hidden, Canvas replaces the
   student's name with anon and some letters. Any other text before the name
   of an exercise is taken for the owner's name, with a note: one student
   too many is better than one too few. */
struct owner {
    char name[256]; /* the student's name, without LATE_ */
    bool late, guessed, canvas;
    long long attempt; /* date or number in the name, or 0 */
};

/* Regular expressions for names with a date. Blackboard writes
   TASK_USER_attempt_2026-11-28-09-05-00_FILE. Brightspace writes 123-456 -
   NAME - Nov 28, 2026 905 AM - FILE, or makes a folder of that name without
   the file. */
static const char blackboard[] =
    "^(.+)_attempt_([0-9]{4}-[0-9]{2}-[0-9]{2}-[0-9]{2}-[0-9]{2}-[0-9]{2})"
    "(_(.*)|\\.txt)?$";
static const char brightspace[] =
    "^([0-9]+-[0-9]+ ?- ?.+) ?- ?([A-Z][a-z]{2}[a-z]* [0-9]+, [0-9]{4} "
    "[0-9]{1,2}:?[0-9]{2} [AP]M)( ?- ?(.*))?$";

/* Returns the digits of a date as one number. */
static long long count_digits(const char *text, size_t length)
{
    long long number = 0;
    for (size_t i = 0; i < length; ++i)
        if (isdigit((unsigned char)text[i]))
            number = 10 * number + (text[i] - '0');
    return number;
}

/* Returns the date Nov 28, 2026 905 AM as 202611280905. */
static long long read_date(const char *text)
{
    static const char months[] = "JanFebMarAprMayJunJulAugSepOctNovDec";
    char month[4] = "", half = 'A';
    int day = 0, year = 0, clock = 0, minutes = -1;
    if (sscanf(text, "%3s%*[a-z] %d, %d %d:%d %c", month, &day, &year,
               &clock, &minutes, &half) < 5 &&
        sscanf(text, "%3s %d, %d %d:%d %c", month, &day, &year, &clock,
               &minutes, &half) < 5) {
        minutes = -1;
        if (sscanf(text, "%3s%*[a-z] %d, %d %d %c", month, &day, &year,
                   &clock, &half) < 5)
            sscanf(text, "%3s %d, %d %d %c", month, &day, &year, &clock,
                   &half);
    }
    if (minutes >= 0)
        clock = 100 * clock + minutes;
    clock = clock % 1200 + (half == 'P' ? 1200 : 0);
    const char *found = strstr(months, month);
    const long long which = found ? (found - months) / 3 + 1 : 0;
    return ((year * 100LL + which) * 100 + day) * 10000 + clock;
}

/* Returns whether a name matches the regular expression `form`, and stores
   the positions of its groups in part[]. */
static bool matches(const char *name, const char *form, regmatch_t part[5])
{
    regex_t compiled;
    if (regcomp(&compiled, form, REG_EXTENDED) != 0)
        text_fail("out of memory");
    const bool found = regexec(&compiled, name, 5, part, 0) == 0;
    regfree(&compiled);
    return found;
}

/* Reads the owner and the date of the attempt from a name. Returns the
   rest of the name, which is "" for a folder. Returns NULL if there is no
   date. */
static const char *part_attempt(const char *name, struct owner *owner)
{
    regmatch_t part[5];
    const bool board =
        strstr(name, "_attempt_") && matches(name, blackboard, part);
    if (!board && !(isdigit((unsigned char)*name) && strchr(name, ',') &&
                    matches(name, brightspace, part)))
        return NULL;
    size_t length = (size_t)part[1].rm_eo;
    while (length > 0 && strchr(" -", name[length - 1]))
        --length;
    const char *date = name + part[2].rm_so;
    *owner = (struct owner){
        .attempt = board ? count_digits(date, (size_t)(part[2].rm_eo -
                                                       part[2].rm_so))
                         : read_date(date)};
    snprintf(owner->name, sizeof owner->name, "%.*s", (int)length, name);
    return part[4].rm_so < 0 ? "" : name + part[4].rm_so;
}

/* Reads the owner from a name. Returns the rest of the name, or NULL if it
   contains no owner. */
static const char *part_name(const char *name, struct owner *owner)
{
    static regex_t compiled;
    static bool ready;
    const char *moodle = strstr(name, "_assignsubmission_"), *rest;
    regmatch_t found[2];
    if (!ready && regcomp(&compiled, canvas, REG_EXTENDED) != 0)
        text_fail("out of memory");
    ready = true;
    size_t length = 0;
    *owner = (struct owner){0};
    if ((rest = part_attempt(name, owner)))
        return rest;
    if (moodle) {
        rest = moodle + strlen("_assignsubmission_");
        rest += strspn(rest, "abcdefghijklmnopqrstuvwxyz");
        rest += *rest == '_';
        length = (size_t)(moodle - name);
    } else if (regexec(&compiled, name, 2, found, 0) == 0) {
        rest = name + found[1].rm_eo + 1;
        rest += strspn(rest, "0123456789") + 1;
        length = (size_t)found[1].rm_eo;
        owner->canvas = true;
    } else {
        rest = find_exercise(name);
        length = rest > name ? (size_t)(rest - name - 1) : 0;
        rest = length > 0 ? rest : NULL;
        owner->guessed = true;
    }
    snprintf(owner->name, sizeof owner->name, "%.*s", (int)length, name);
    char *word = strstr(owner->name, "LATE_");
    owner->late = word && !moodle && !owner->guessed;
    if (owner->late)
        memmove(word, word + 5, strlen(word + 5) + 1);
    return rest;
}

/* Terms of an answer's rank, which is their sum; the lowest rank is best.
   DEEPER is added for each folder above the file, ELSEWHERE if the folder
   is not called exercises, UNUSUAL for an unusual name, and MISNAMED for a
   name that does not end in .c. */
enum { DEEPER = 4, ELSEWHERE = 2, UNUSUAL = 1, MISNAMED = 1000 };

/* Returns the number that Canvas adds to the name of a file handed in
   again: 2 for 01a-collide-2.c. Returns 0 for any other name. */
static long long canvas_attempt(const char *ex, const char *its)
{
    const size_t stem = strlen(its) - 2; /* length without .c */
    char *end;
    if (strncasecmp(ex, its, stem) != 0 || ex[stem] != '-' ||
        !isdigit((unsigned char)ex[stem + 1]))
        return 0;
    const long number = strtol(ex + stem + 1, &end, 10);
    return strcasecmp(end, ".c") == 0 ? number : 0;
}

static const char *find_usual(const char *const usual[], const char *ex)
{
    while (*usual && strncasecmp(*usual, ex, 3) != 0)
        ++usual;
    return *usual;
}

static void add_answer(struct submission *s, const char *path,
                       const char *ex, const char *its, int depth)
{
    const char *name = strrchr(path, '/');
    const char *folder = "exercises/";
    const size_t before = name ? (size_t)(name + 1 - path) : 0;
    const size_t length = strlen(folder);
    const bool home = before >= length &&
                      strncmp(path + before - length, folder, length) == 0;
    s->answers =
        text_must(realloc(s->answers, (s->count + 1) * sizeof *s->answers));
    struct answer *answer = &s->answers[s->count++];
    const long long again =
        s->canvas && strlen(its) > 3 ? canvas_attempt(ex, its) : 0;
    *answer = (struct answer){
        .path = strdup(path),
        .attempt = again ? again : s->attempt,
        .rank = depth * DEEPER + (home ? 0 : ELSEWHERE) +
                (strcmp(ex, its) == 0 || again ? 0 : UNUSUAL) +
                (ends(ex, c_endings) ? 0 : MISNAMED)};
    memcpy(answer->exercise, its, 3);
}

/* Returns "P1g" for the file P1.gp, "P1t" for P1.txt. */
static const char *page_key(const char *name)
{
    static char key[4] = "P";
    key[1] = name[1];
    key[2] = (char)tolower((unsigned char)name[3]);
    return key;
}

/* Adds a file to the student's answers, or a note that says why not. A text
   or C++ file with the name of an exercise is added, too: if there is no
   better file, a note mentions it. */
static void take(struct submission *s, const char *const usual[],
                 const char *path, const char *name, mode_t mode, int depth)
{
    const char *ex = find_exercise(name);
    const char *its = ex ? find_usual(usual, ex) : NULL;
    const bool source = ends(name, source_endings);
    const bool hidden = *name == '.' || strstr(path, "/.");
    ++s->others;
    if (hidden && ((its && source) || ends(name, archives)))
        note(s, "hidden, and not graded: ", path);
    else if (hidden)
        return;
    else if (ends(name, archives))
        note(s, "an archive that is not unpacked: ", path);
    else if (ex && is_page(ex))
        add_answer(s, path, ex, page_key(ex), depth);
    else if (its && !ends(name, made) && (source || strchr(ex, '.')))
        add_answer(s, path, ex, its, depth);
    else if (S_ISLNK(mode) || mode == 0)
        note(s,
             mode ? "a link, which is not followed: "
                  : "cannot be looked at: ",
             path);
    else if (source)
        note(s,
             ex ? "there is no such exercise: "
                : "not taken for any exercise: ",
             path);
}

enum { DEPTH = 3 }; /* levels searched below a student's folder */

static mode_t mode_of(int folder, const char *name)
{
    struct stat about;
    const int asked = fstatat(folder, name, &about, AT_SYMLINK_NOFOLLOW);
    return asked == 0 ? about.st_mode : 0;
}

/* Returns whether a folder is part of a copy of the whole kit: its name is
   one of the kit's, and a folder `exercises` is beside it. In such a
   folder, files that look like answers, some of them solutions, are not the
   student's. */
static bool is_kit(int folder, const char *name)
{
    static const char *const kit[] = {"tests",    "solutions", "src",
                                      "chapters", "build",     "plots"};
    for (size_t i = 0; i < sizeof kit / sizeof kit[0]; ++i)
        if (strcmp(name, kit[i]) == 0)
            return S_ISDIR(mode_of(folder, "exercises"));
    return false;
}

static void walk(struct submission *s, const char *const usual[],
                 int parent, const char *name, const char *path, int depth)
{
    const int folder = depth > DEPTH ? -1 : open_folder(parent, name);
    char **names;
    if (folder < 0) {
        note(s,
             depth > DEPTH ? "too deep, not looked into: "
                           : "a folder that cannot be read: ",
             path);
        return;
    }
    const size_t count = list_folder(folder, &names);
    for (size_t i = 0; i < count; ++i) {
        char *below =
            text_must(malloc(strlen(path) + strlen(names[i]) + 2));
        sprintf(below, "%s/%s", path, names[i]);
        const mode_t mode = mode_of(folder, names[i]);
        if (!S_ISDIR(mode) || ends(names[i], c_endings))
            take(s, usual, below, names[i], mode, depth);
        else if (!is_kit(folder, names[i]))
            walk(s, usual, folder, names[i], below, depth + 1);
        free(below);
    }
    free_names(names, count);
    close(folder);
}

/* Returns the submission of a student, after adding it if it is new. There
   is one student for each folder, and one for each owner named in a file
   name. If there are only files without an owner, they all belong to one
   student. */
static struct submission *student(struct submissions *all,
                                  const char *entry, const char *name)
{
    for (size_t i = 0; i < all->count; ++i)
        if (strcmp(all->list[i].entry, entry) == 0)
            return &all->list[i];
    all->list =
        text_must(realloc(all->list, (all->count + 1) * sizeof *all->list));
    all->list[all->count] = (struct submission){.entry = strdup(entry),
                                                .name = compose("%s", name),
                                                .notes = compose("")};
    return &all->list[all->count++];
}

static bool is_loose(const char *name)
{
    const char *ex = find_exercise(name);
    return ex && (ends(name, c_endings) || is_page(ex));
}

static void take_entry(struct submissions *all, const char *const usual[],
                       int top, const char *name, size_t *loose)
{
    struct owner owner;
    struct stat about;
    const char *rest = part_name(name, &owner);
    const mode_t mode = mode_of(top, name);
    const bool link = S_ISLNK(mode) && fstatat(top, name, &about, 0) == 0 &&
                      S_ISDIR(about.st_mode);
    if (S_ISDIR(mode) || link) {
        const bool known =
            strstr(name, "_assignsubmission_") || owner.attempt;
        const char *whose = known ? owner.name : name;
        struct submission *s = student(all, whose, whose);
        s->attempt = owner.attempt;
        s->canvas = false;
        if (link)
            note(s, "a link, which is not followed: ", name);
        else
            walk(s, usual, top, name, name, 0);
    } else if (rest) {
        struct submission *s = student(all, owner.name, owner.name);
        s->attempt = owner.attempt;
        s->canvas = owner.canvas;
        if (owner.late)
            note(s, "handed in late, as its name says: ", name);
        if (owner.guessed && s->others == 0)
            note(s, "whose it is was guessed from its name: ", name);
        take(s, usual, name, rest, mode, 0);
    } else if (is_loose(name)) {
        ++*loose;
    } else if (*name != '.') {
        note(&all->nobody,
             ends(name, archives) ? "an archive that is not unpacked: "
                                  : "of no student: ",
             name);
    }
}

static void tell_empty(struct submission *s)
{
    bool any = s->noted > 0;
    char others[40] = "";
    if (s->others > 0)
        snprintf(others, sizeof others, "; other files: %zu", s->others);
    for (size_t i = 0; i < s->count; ++i)
        any |= s->answers[i].rank < MISNAMED;
    if (!any)
        note(s, "no file of an exercise", others);
}

static int compare_entries(const void *a, const void *b)
{
    const struct submission *one = a, *other = b;
    return strcmp(one->entry, other->entry);
}

/* Returns whether a name begins with `start` or with LATE_, which Canvas
   may put before any student's name. */
static bool is_wanted(const char *name, const char *start)
{
    return text_after(name, start) || text_after(name, "LATE_");
}

struct submissions submissions_find(const char *folder,
                                    const char *const usual[],
                                    const char *start)
{
    const int top = open_folder(AT_FDCWD, folder);
    struct submissions all = {.nobody = {.notes = compose("")}};
    size_t loose = 0;
    char **names;
    if (top < 0)
        text_fail("cannot read the folder '%s': %s", folder,
                  strerror(errno));
    const size_t entries = list_folder(top, &names);
    for (size_t i = 0; i < entries; ++i)
        if (is_wanted(names[i], start))
            take_entry(&all, usual, top, names[i], &loose);
    const char *slash = strrchr(folder, '/');
    struct submission *own = &all.nobody;
    if (all.count == 0 && loose > 0)
        own = student(&all, ".", slash && slash[1] ? slash + 1 : folder);
    for (size_t i = 0; loose > 0 && i < entries; ++i) {
        struct owner owner;
        if (!S_ISDIR(mode_of(top, names[i])) && is_loose(names[i]) &&
            !part_name(names[i], &owner)) {
            if (own == &all.nobody)
                note(own, "of no student: ", names[i]);
            else
                take(own, usual, names[i], names[i], mode_of(top, names[i]),
                     0);
        }
    }
    free_names(names, entries);
    close(top);
    if (all.count == 0 && !*start)
        text_fail("'%s' has neither folders of students nor files of "
                  "exercises (01a-....c)",
                  folder);
    qsort(all.list, all.count, sizeof *all.list, compare_entries);
    for (size_t i = 0; i < all.count; ++i)
        tell_empty(&all.list[i]);
    return all;
}

/* Returns a positive number if the answer `one` is better, a negative
   number if `other` is better, and 0 if they are equal. A file that can be
   graded is better than one that cannot. Then the later attempt is better,
   and then the lower rank. */
static int prefer(const struct answer *one, const struct answer *other)
{
    const bool graded = one->rank < MISNAMED;
    if (graded != (other->rank < MISNAMED))
        return graded ? 1 : -1;
    if (one->attempt != other->attempt)
        return one->attempt > other->attempt ? 1 : -1;
    return (one->rank < other->rank) - (one->rank > other->rank);
}

/* Returns whether both paths begin with the same folder. Notes then leave
   that folder out. */
static bool together(const char *one, const char *other)
{
    const size_t length = strcspn(one, "/");
    return one[length] && strncmp(one, other, length + 1) == 0;
}

/* Returns the best answer to an exercise, or NULL if there is none, if it
   cannot be graded, or if two are equally good. Sets *note to a remark on
   the choice. */
static const struct answer *choose(const struct submission *s,
                                   const char *usual, char **note)
{
    const struct answer *best = NULL, *second = NULL;
    int count = 0;
    for (size_t i = 0; i < s->count; ++i) {
        const struct answer *a = &s->answers[i];
        if (strncmp(a->exercise, usual, 3) != 0)
            continue;
        count += a->rank < MISNAMED;
        if (!best || prefer(a, best) > 0) {
            second = best;
            best = a;
        } else if (!second || prefer(a, second) > 0) {
            second = a;
        }
    }
    if (!best) {
        *note = compose("");
        return NULL;
    }
    const bool tie = count > 1 && prefer(best, second) == 0;
    const char *slash = strrchr(best->path, '/');
    const char *name = slash ? slash + 1 : best->path;
    const char *its = find_exercise(name);
    const bool odd = !ends(name, c_endings) ||
                     (slash ? strncmp(name, usual, 3) != 0
                            : its && strncmp(its, usual, 3) != 0) ||
                     strcmp(name + strlen(name) - 2, ".c") != 0;
    const bool whole = second && !together(best->path, second->path);
    const char *its_path = whole ? best->path : below(best->path);
    const char *other = !second ? ""
                        : whole ? second->path
                                : below(second->path);
    if (best->rank >= MISNAMED)
        *note = compose("not graded, since its name does not end in .c: %s",
                        its_path);
    else if (tie)
        *note =
            compose("%d files could be it: %s, %s", count, its_path, other);
    else if (count > 1 && best->attempt != second->attempt)
        *note = compose("of %d attempts the last was taken: %s, not %s",
                        count, its_path, other);
    else if (count > 1)
        *note = compose("of %d files was taken %s, not %s", count, its_path,
                        other);
    else if (odd)
        *note = compose("taken in spite of its name: %s", its_path);
    else
        *note = compose("");
    return best->rank >= MISNAMED || tie ? NULL : best;
}

/* Opens the file `path` below a folder. Opens the folders of the path one
   by one, because none of the names may be a link. */
static int open_below(const char *folder, const char *path)
{
    int at = open_folder(AT_FDCWD, folder);
    while (at >= 0) {
        const size_t length = strcspn(path, "/");
        char *name = strndup(path, length);
        const bool last = !path[length];
        const int next =
            !name  ? -1
            : last ? openat(at, name,
                            O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)
                   : open_folder(at, name);
        const int why = errno;
        free(name);
        close(at);
        errno = why;
        if (last)
            return next;
        at = next;
        path += length + 1;
    }
    return -1;
}

/* Returns the bytes of a file, or NULL if it is too large. Tries to read
   one byte more than is allowed, in order to notice a file that is
   growing. */
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

/* Returns the bytes of a regular file. On failure returns NULL and sets
   *refusal to the reason. The file was opened with O_NONBLOCK, so that a
   named pipe can be recognised. */
static char *read_regular(int file, const char *name, size_t *length,
                          char **refusal)
{
    struct stat about;
    char *bytes = NULL;
    if (file < 0 && errno != ELOOP)
        *refusal = compose("cannot be read: %s", strerror(errno));
    else if (file < 0 || fstat(file, &about) != 0 ||
             !S_ISREG(about.st_mode))
        *refusal =
            compose("refused, since it is no regular file: %s", name);
    else if (!(bytes = read_all(file, length)))
        *refusal =
            compose("refused, since it is larger than 1 MiB: %s", name);
    if (file >= 0)
        close(file);
    return bytes;
}

char *submissions_read(const char *folder, const struct submission *s,
                       const char *usual, size_t *length, char **file,
                       char **note)
{
    const struct answer *best = choose(s, usual, note);
    char *bytes = NULL;
    *length = 0;
    *file = NULL;
    if (best) {
        const char *slash = strrchr(best->path, '/');
        const char *name = slash ? slash + 1 : best->path;
        const int opened = open_below(folder, best->path);
        char *refusal = NULL;
        bytes = read_regular(opened, name, length, &refusal);
        if (bytes) {
            *file = compose("%.200s", name);
        } else {
            free(*note);
            *note = refusal;
        }
    }
    if (!*file)
        *file = compose("no file");
    return bytes;
}
char *submissions_page(const char *folder, const struct submission *s,
                       const char *name, size_t *length, char **refusal)
{
    const struct answer *best = NULL;
    *length = 0;
    *refusal = NULL;
    for (size_t i = 0; i < s->count; ++i)
        if (strncmp(s->answers[i].exercise, page_key(name), 3) == 0 &&
            (!best || prefer(&s->answers[i], best) > 0))
            best = &s->answers[i];
    return best ? read_regular(open_below(folder, best->path), name, length,
                               refusal)
                : NULL;
}
