/* Saves a file under a dated name, then puts the stub in its place. */
#include "examiner/reset.h"
#include "examiner/hint.h"
#include "examiner/sum.h"
#include "examiner/text.h"
#include "toolbox/replace.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* Copies a file to the open descriptor `out` and closes `out`. */
static bool copy(const char *from, int out)
{
    char block[1 << 12];
    const int in = open(from, O_RDONLY);
    bool fine = in >= 0 && out >= 0;
    for (ssize_t length; fine && (length = read(in, block, sizeof block));)
        fine = length > 0 && write(out, block, (size_t)length) == length;
    fine = out >= 0 && fsync(out) == 0 && fine;
    if (in >= 0)
        close(in);
    return out >= 0 && close(out) == 0 && fine;
}

/* Copies a file to a new name, for file systems without links, such as
   those of memory sticks. */
static bool copy_to(const char *from, const char *to)
{
    const int out = open(to, O_WRONLY | O_CREAT | O_EXCL, 0666);
    const bool fine = copy(from, out);
    if (out >= 0 && !fine)
        unlink(to);
    return fine;
}

enum { KEPT = COURSE_PATH + 64 };

/* Gives the student's file a second name that ends with the date. (A name
   that ends in .c would be taken for an answer.) A link is made in a single
   step, and fails if the name is taken. Only then does the stub replace the
   file under its first name, so nothing is ever lost. */
static bool save(const char *file, char kept[KEPT])
{
    char date[32];
    const time_t now = time(NULL);
    strftime(date, sizeof date, "%Y-%m-%dT%H%M%S", localtime(&now));
    snprintf(kept, KEPT, "%s.%s", file, date);
    for (int i = 2; i < 100; ++i) {
        if (link(file, kept) == 0)
            return true;
        if (errno != EEXIST)
            return copy_to(file, kept);
        snprintf(kept, KEPT, "%s.%s-%d", file, date, i);
    }
    return false;
}

/* Replaces the student's file with the stub. The new file keeps the
   permissions of the old one, which a lecturer may have set for a group. */
static bool replace(const char *file, const char *stub)
{
    struct stat about;
    char *temporary;
    const mode_t mode =
        stat(file, &about) == 0 ? about.st_mode & 0777 : REPLACE_USUAL;
    if (copy(stub, replace_begin(file, mode, &temporary)))
        return replace_finish(temporary, file, false);
    replace_cancel(temporary);
    return false;
}

_Noreturn static void give_up(const char *file, const char *kept)
{
    const int why = errno;
    if (*kept)
        unlink(kept);
    text_fail("cannot reset '%s', which is as it was: %s", file,
              strerror(why));
}

/* Resets an exercise and the number of hints given for it. No other command
   changes anything in exercises/. */
void reset_exercise(struct exercise *e)
{
    char kept[KEPT] = "";
    const bool there = *e->file;
    if (there && sum_file(0, e->file) == sum_file(0, e->stub)) {
        printf("%s is as it came; there is nothing to reset.\n", e->file);
        return;
    }
    if (!there)
        snprintf(e->file, sizeof e->file, "exercises/%s", e->usual);
    if (there && !save(e->file, kept))
        give_up(e->file, "");
    if (!replace(e->file, e->stub))
        give_up(e->file, kept);
    hint_forget(e);
    if (there)
        printf("What you had is kept in %s\n", kept);
    printf("%s is as it came. Next: make check EX=%s\n", e->file, e->name);
}
