/* Refuses callbacks in exercises that do not use any. */
#include "examiner/remote.h"
#include "examiner/transport.h"

/* Ends the program, because this exercise has no callbacks. The function
   has a file of its own: the linker takes it from the library only for an
   exercise that does not define it. */
void remote_serve_callback(int which)
{
    (void)which;
    transport_lost();
}
