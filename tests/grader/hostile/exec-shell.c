/* failed: it becomes a shell that answers */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    execl("/bin/sh", "sh", "-c",
          "printf 'r%017d' 0 >&4; cat <&3 >/dev/null", (char *)0);
}
