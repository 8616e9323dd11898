/* A right answer: the touches of a disk with all images of the others. */

static double touch(double dx, double dy, double sigma)
{
    double q = sigma * sigma - dy * dy;
    if (q <= 0 || dx <= 0)
        return INFINITY;
    return dx > sqrt(q) ? dx - sqrt(q) : 0;
}

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first, double length)
{
    size_t moves = first, next, j, touches = 0;
    do {
        double way = length, t;
        int p, q;
        next = moves;
        for (j = 0; j < n; j++)
            for (p = 0; p < 2; p++)
                for (q = -1; q < 2; q++) {
                    t = touch(x[j] + p * width - x[moves],
                              y[j] + q * height - y[moves], sigma);
                    if (j != moves && t < way) {
                        way = t;
                        next = j;
                    }
                }
        x[moves] += way;
        x[moves] -= width * floor(x[moves] / width);
        length -= way;
        if (next == moves)
            return touches;
        moves = next;
        touches++;
    } while (1);
}
