/* Makes a temporary folder and removes it at the end of the program. */
#include "examiner/work.h"
#include "examiner/folder.h"
#include "examiner/text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char folder[] = "build/check/work.XXXXXX";

static void remove_folder(void)
{
    if (!folder_remove(folder))
        fprintf(stderr, "examine: cannot remove '%s': %s\n", folder,
                strerror(errno));
}

/* The folder is in build/, since some machines do not execute programs in
   /tmp. Its name is new each time, so that two examiners running at once do
   not share it. */
const char *work_folder(void)
{
    static bool made;
    if (!made && !mkdtemp(folder))
        text_fail("cannot make a folder in build/check: %s",
                  strerror(errno));
    if (!made)
        atexit(remove_folder);
    made = true;
    return folder;
}
