/* A right answer: the blow carried out, and bisection to take aim. */

static double turn(double phi, double ratio)
{
    return atan2(sin(2 * phi), ratio - cos(2 * phi));
}

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    double ratio = im2 / im1;
    double hard = ratio > 1 ? acos(1 / ratio) / 2 : 0;
    double soft = acos(0.0);
    int steps;
    if (ratio > 1 && turn(hard, ratio) < deflection)
        return -1;
    if (ratio == 1 && deflection > soft)
        return -1;
    for (steps = 0; steps < 60; steps++) {
        double middle = (hard + soft) / 2;
        if (turn(middle, ratio) > deflection)
            hard = middle;
        else
            soft = middle;
    }
    return (r1 + r2) * sin((hard + soft) / 2);
}
