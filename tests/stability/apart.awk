# The largest difference of a place in any row of two tables of states, as
# step and bonk write them: the time, then for each body three numbers of its
# place and three of its velocity. Divided by `scale`, if one is given;
# "rows" when they have none, or not the same number of them.
#
#   awk [-v scale=SIZE] -f tests/stability/apart.awk TABLE TABLE
BEGIN { scale = scale ? scale : 1 }
/^#/ { next }
FNR == NR { for (i = 2; i <= NF; ++i) first[rows + 0, i] = $i; ++rows; next }
{
    for (i = 2; i <= NF; ++i)
        if ((i - 2) % 6 < 3) {
            d = first[n + 0, i] - $i
            if (d < 0) d = -d
            if (d > most) most = d
        }
    ++n
}
END { print n && n == rows ? most / scale : "rows" }
