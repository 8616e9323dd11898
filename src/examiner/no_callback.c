/* Refuses callbacks in exercises that do not use any. */
#include "examiner/remote.h"
#include "examiner/transport.h"

/* Ends the program, since no callback was expected. This is a file of its
   own, so that the linker takes it from the library only for an exercise
   that does not define this function. */
void remote_serve_callback(int which)
{
    (void)which;
    transport_lost();
}
