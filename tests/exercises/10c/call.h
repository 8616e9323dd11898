/* How the function of exercise 10c is called: see tests/remote.awk. With
 * the places for the frequencies comes one behind them: the suite looks
 * there. */
/* output: membrane_modes omega (g->nx-2)*(g->ny-2) suite */

struct grid {
    int nx, ny;
    double mass;
    double stiffness;
    double dx, dy;
    double restx, resty;
};

double membrane_modes(
    const struct grid *g,
    double omega[(size_t)(g->nx - 2) * (size_t)(g->ny - 2) + 1]);
