/* Halving, until there is no number between. */

double eccentric_anomaly(double e, double mean)
{
    double low = mean - e, high = mean + e, middle;
    while (middle = low + (high - low) / 2, middle > low && middle < high) {
        if (middle - mean < e * sin(middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}
