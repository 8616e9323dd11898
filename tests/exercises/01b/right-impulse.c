/* A right answer: each inverse mass in units of the impulse. */

static bool is_a_mass(double inverse)
{
    return inverse >= 0.0;
}

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    double im1 = v1 - u1, im2 = u2 - v2;
    if (im1 < 0.0 || im2 < 0.0) { /* the impulse pushed the other way */
        im1 = -im1;
        im2 = -im2;
    }
    if (u1 == u2 || !is_a_mass(im1) || !is_a_mass(im2) || im1 + im2 == 0.0)
        return false;
    *restitution = fabs(u1 - u2);
    *restitution = (u1 > u2 ? v2 - v1 : v1 - v2) / *restitution;
    *mass_ratio = im1 > 0.0 ? im2 / im1 : INFINITY;
    return true;
}
