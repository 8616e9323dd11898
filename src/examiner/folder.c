/* Removes folders that contain trees of any depth. */
#include "examiner/folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LOOK_IN = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC };

/* Opens a folder in order to empty it. First restores the owner's
   permissions, which a program may have taken away. */
static int open_folder(int above, const char *name)
{
    struct stat about;
    if (fstatat(above, name, &about, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISDIR(about.st_mode) && (about.st_mode & 0700) != 0700)
        fchmodat(above, name, 0700, 0);
    return openat(above, name, LOOK_IN);
}

static bool is_own_name(const char *name)
{
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

/* Removes an entry of a folder. If the entry is a folder that is not empty,
   moves it into the folder `top`, with a number as its name, to be removed
   later. So a tree of any depth needs only two open folders, and no path
   becomes too long. */
static bool remove_entry(int folder, const char *name, int top,
                         unsigned long *number)
{
    char fresh[32];
    if (unlinkat(folder, name, 0) == 0 ||
        unlinkat(folder, name, AT_REMOVEDIR) == 0)
        return true;
    if (errno != ENOTEMPTY && errno != EEXIST)
        return false;
    const int inner = open_folder(folder, name);
    if (inner >= 0)
        close(inner);
    do {
        snprintf(fresh, sizeof fresh, "%lu", ++*number);
        if (renameat(folder, name, top, fresh) == 0)
            return true;
    } while (errno == ENOTEMPTY || errno == EEXIST || errno == ENOTDIR);
    return false;
}

static bool remove_inner(int top, const char *name, unsigned long *number)
{
    if (unlinkat(top, name, 0) == 0 ||
        unlinkat(top, name, AT_REMOVEDIR) == 0)
        return true;
    const int inner = open_folder(top, name);
    DIR *list = inner >= 0 ? fdopendir(inner) : NULL;
    if (!list)
        return false;
    for (struct dirent *entry; (entry = readdir(list));)
        if (!is_own_name(entry->d_name))
            remove_entry(inner, entry->d_name, top, number);
    closedir(list);
    return unlinkat(top, name, AT_REMOVEDIR) == 0;
}

bool folder_remove(const char *path)
{
    unsigned long number = 0, removed, kept;
    int why = 0;
    const int top = open_folder(AT_FDCWD, path);
    DIR *list = top >= 0 ? fdopendir(top) : NULL;
    if (!list)
        return false;
    /* Entries moved to `top` may not appear until the next pass. */
    do {
        removed = kept = 0;
        rewinddir(list);
        for (struct dirent *entry; (entry = readdir(list));)
            if (is_own_name(entry->d_name)) {
                continue;
            } else if (remove_inner(top, entry->d_name, &number)) {
                ++removed;
            } else {
                ++kept;
                why = errno;
            }
    } while (removed > 0);
    closedir(list);
    errno = why;
    return kept == 0 && rmdir(path) == 0;
}
