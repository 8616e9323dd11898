/* A right answer: half a chord, less the way along it made already. */

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    double speed = hypot(v[0], v[1]), s = box - radius;
    double along, across, half, way;
    if (speed == 0)
        return INFINITY;
    along = (r[1] * v[1] + r[0] * v[0]) / speed;
    across = fabs(r[0] * v[1] - r[1] * v[0]) / speed;
    half = across < s ? sqrt((s - across) * (s + across)) : 0;
    way = half - along;
    return way > 0 ? way / speed : 0;
}
