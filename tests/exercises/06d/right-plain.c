/* A right answer: with comparisons instead of remainders. */

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first, double length)
{
    size_t i = first, j, k, count = 0;
    double left = length, w, c, a;
    for (;;) {
        w = left;
        k = n;
        for (j = 0; j < n; j++) {
            c = fabs(y[i] - y[j]);
            if (c > height / 2)
                c = height - c;
            a = x[j] - x[i];
            if (a < 0)
                a += width;
            if (j == i || c >= sigma || a < 0)
                continue;
            a -= sqrt(sigma * sigma - c * c);
            if (a < 0)
                a = 0;
            if (a < w) {
                w = a;
                k = j;
            }
        }
        x[i] += w;
        while (x[i] >= width)
            x[i] -= width;
        if (k == n)
            return count;
        left -= w;
        count++;
        i = k;
    }
}
