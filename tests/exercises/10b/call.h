/* How the function of exercise 10b is called: see tests/remote.awk. */
/* output: oscillate velocity 1 */

struct oscillator {
    double mass;
    double damping;
    double stiffness;
    double x;
    double v;
};

double oscillate(const struct oscillator *o, double t, double *velocity);
