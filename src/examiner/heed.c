/* From chapters/works/B-grader.nw: edit there, then run make tangle. */
/* checksum 1127352648 of the lines below */
#include "examiner/border.h"
#include "examiner/wire.h"

void border_heed(int which)
{
    (void)which;
    wire_lost();
}
