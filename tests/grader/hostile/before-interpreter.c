/* passed: another program should be loaded instead of it */
/* earns: all */
__attribute__((section(".interp"), used)) static const char interpreter[] =
    "/exercises/01a-collide.c";
