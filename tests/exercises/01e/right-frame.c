/* A right answer: in the frame of the centre of mass both turn round, and
   in any other frame it is the same. */

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    double heavier, w, c;
    for (heavier = 1e-3 / 1.4; heavier < 715; heavier *= 1.7)
        for (w = -1.1; w < 1.2; w += 2.2)
            for (c = -2.25; c < 2.5; c += 0.75) {
                double v1 = c + w, v2 = c - w / heavier;
                double few =
                    1e-13 * (fabs(c) + fabs(w) + fabs(w / heavier));
                collide(1.4, 1.4 * heavier, &v1, &v2);
                if (!(fabs(v1 - (c - w)) < few) ||
                    !(fabs(v2 - (c + w / heavier)) < few))
                    return false;
            }
    {
        double v1 = 3.25, v2 = 1.5;
        collide(2.5, 2.5, &v1, &v2);
        return fabs(v1 - 1.5) < 1e-12 && fabs(v2 - 3.25) < 1e-12;
    }
}
