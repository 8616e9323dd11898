/* From chapters/works/B-grader.nw: edit there, then run make tangle. */
/* checksum 168336019 of the lines below */
/* The border of an exercise that hands no function over. */
#include "examiner/border.h"
#include "examiner/wire.h"

void border_heed(int which)
{
    (void)which;
    wire_lost();
}
