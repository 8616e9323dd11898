/* A right answer: from where the path is nearest to the centre of the box
   the distance only grows, so halving finds where it is reached. */

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    double speed = hypot(v[0], v[1]), early, late;
    int i;
    if (speed == 0)
        return INFINITY;
    early = -(r[1] * v[1] + r[0] * v[0]) / speed / speed;
    if (early < 0)
        early = 0;
    late = early + 2 * box / speed;
    for (i = 0; i < 200; i++) {
        double t = early + (late - early) / 2;
        if (hypot(r[0] + v[0] * t, r[1] + v[1] * t) < box - radius)
            early = t;
        else
            late = t;
    }
    return early;
}
