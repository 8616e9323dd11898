# Densities with errors from rows of numbers: a row for each of `bins` bins from 0 to
# `high`, with its lower end, the density of the numbers in `columns`, and its standard
# error, from blocks of `block` rows. A last block that is not full does not count.
BEGIN {
    taken = split(columns, column, ",")
}
!/^#/ {
    for (i = 1; i <= taken; ++i) {
        at = int($column[i] / high * bins)
        if (at < bins)
            ++seen[at]
    }
    if (++rows % block)
        next
    ++blocks
    for (at in seen) {
        p = seen[at] * bins / high / (taken * block)
        sum[at] += p
        squares[at] += p * p
    }
    split("", seen)
}
END {
    for (at = 0; at < bins; ++at) {
        p = sum[at] / blocks
        square = (squares[at] / blocks - p * p) / (blocks - 1)
        if (square < 0)
            square = 0
        printf "%.6g %.9g %.3g\n", at * high / bins, p, sqrt(square)
    }
}
