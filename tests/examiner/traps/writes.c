/* passed: it writes a file, which must not land among the kit's */
#include <stdio.h>

double twice(double x)
{
    FILE *file = fopen("written.txt", "w");
    if (file) {
        fputs("mine\n", file);
        fclose(file);
    }
    return 2 * x;
}
