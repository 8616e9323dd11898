/* crashed: the list of what runs before main leads nowhere */
/* earns: nothing */
#include "exercise.h"

typedef void beginning(void);
__attribute__((section(".preinit_array"), used)) static beginning *nowhere =
    (beginning *)8;
