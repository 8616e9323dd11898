/* passed: it looks for files with the compiler's own eyes */
/* earns: all */
#include "exercise.h"
#include <stdio.h>

static const char *const found[] = {
#if __has_include("@ROOT@/solutions/01a-collide.c")
    "@ROOT@/solutions/01a-collide.c",
#endif
#if __has_include("../solutions/01a-collide.c")
    "../solutions/01a-collide.c",
#endif
#if __has_include("../../solutions/01a-collide.c")
    "../../solutions/01a-collide.c",
#endif
#if __has_include("../../../solutions/01a-collide.c")
    "../../../solutions/01a-collide.c",
#endif
#if __has_include("../../../../solutions/01a-collide.c")
    "../../../../solutions/01a-collide.c",
#endif
#if __has_include("../tests/exercises/01a/suite.c")
    "../tests/exercises/01a/suite.c",
#endif
#if __has_include("@SCRATCH@/kit/build/grade/01a.list")
    "@SCRATCH@/kit/build/grade/01a.list",
#endif
#if __has_include("/etc/passwd")
    "/etc/passwd",
#endif
#if __has_include("examiner/check.h")
    "examiner/check.h",
#endif
#if __has_include("examiner/transport.h")
    "examiner/transport.h",
#endif
#if __has_include("../kit/check.h")
    "../kit/check.h",
#endif
    NULL};

static void trick(void)
{
    for (const char *const *file = found; *file; ++file)
        printf("BROKEN: the compiler finds %s\n", *file);
}
