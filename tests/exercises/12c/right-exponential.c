/* exp(x) - 1 and 1 - exp(-x): their product is twice what is needed. */

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    double grown = 0, left;
    if (push * time > 0) {
        if (stretch * time == 0)
            grown = time * time;
        else
            grown = expm1(stretch * time) / stretch *
                    (-expm1(-stretch * time) / stretch);
    }
    *bound = grown / 2 * push;
    left = *budget - *bound;
    if (left < 0)
        return false;
    *budget = left;
    return true;
}
