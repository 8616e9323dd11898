/* Refuses callbacks, where a student gets no function to call. */
#include "examiner/remote.h"
#include "examiner/transport.h"

/* Ends the program: no callback was expected. It has a file of its own, so
   that the linker takes it from the library only for an exercise that does
   not define this function. */
void remote_serve_callback(int which)
{
    (void)which;
    transport_lost();
}
