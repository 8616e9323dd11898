/* A right answer in plain C, with which wrong.diff begins. */

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    bool may;
    double u = stretch * time / 2;
    *bound = push == 0 ? 0
             : u > 0   ? push * time * time / 2 * pow(sinh(u) / u, 2)
                       : push * time * time / 2;
    may = *bound <= *budget;
    if (may)
        *budget -= *bound;
    return may;
}
