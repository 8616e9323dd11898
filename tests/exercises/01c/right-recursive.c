/* A right answer: a stack is a ball thrown at a smaller stack. */

static double climb(size_t left, const double *ball, double speed, double e,
                    double up)
{
    double ratio, jump;
    if (left == 1)
        return up;
    ratio = ball[1] / ball[0];
    jump = (speed + up) * (1 + e) / (1 + ratio);
    return climb(left - 1, ball + 1, speed, e, jump - speed);
}

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    return climb(n, masses, speed, restitution, restitution * speed);
}
