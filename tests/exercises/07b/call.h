/* How the function of exercise 07b is called: see tests/remote.awk. With
 * the list comes what stands behind it: the suite has put something there.
 */
/* output: compressibility pressure 1 */

struct collision {
    double mass[2];
    double apart[3];
    double first[3];
    double second[3];
};

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[count + 1],
                       double *pressure);
