/* failed: what it prints cannot move the cursor or set a colour */
/* says: | .x1b.31mred */
#include <stdio.h>

double twice(double x)
{
    puts("\033[31mred\033[0m \a\b");
    return x;
}
