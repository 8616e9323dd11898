/* A right answer: sit on the second body, which is then at rest before. */

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    double in = u1 - u2, back = v1 - u2, hit = v2 - u2;
    if (in == 0)
        return false;
    if (in == back) {
        *mass_ratio = INFINITY;
        *restitution = (hit - back) / in;
        return hit != 0;
    }
    *mass_ratio = hit / (in - back);
    if (*mass_ratio == 0)
        *mass_ratio = 0; /* no minus sign before a zero */
    *restitution = (hit - back) / in;
    return *mass_ratio >= 0;
}
