/* How the function of exercise 05d is called: see tests/remote.awk. With
 * the list comes what stands behind it: the suite has put something there.
 */
/* output: wall_z z 2 */

enum wall { LEFT, RIGHT, BOTTOM, TOP };

struct wall_hit {
    double t;
    enum wall wall;
    double mass, v;
};

void wall_z(size_t n, const struct wall_hit hits[n + 1],
            const double size[2], size_t disks, double energy, double from,
            double until, double z[2]);
