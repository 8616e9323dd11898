/* does not build: the assembler should put a secret file into it */
#include "exercise.h"

__asm__(".data\nsecret: .incbin \"@ROOT@/solutions/01a-collide.c\"\n.text");
