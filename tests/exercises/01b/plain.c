/* A right answer in plain C, with which wrong.diff begins. */

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    if (u1 == u2 || (u1 == v1 && u2 == v2) || (u1 - v1) * (v2 - u2) < 0)
        return false;
    *mass_ratio = fabs((v2 - u2) / (u1 - v1));
    *restitution = (v2 - v1) / (u1 - u2);
    return true;
}
