/* Refuses calls back, for exercises that hand over no function. */
#include "examiner/remote.h"
#include "examiner/transport.h"

/* Does nothing. An exercise that hands no function to the student is linked
   with this. It is alone in its file, so that the linker takes it only
   where nobody else has defined the name. */
void remote_serve_callback(int which)
{
    (void)which;
    transport_lost();
}
