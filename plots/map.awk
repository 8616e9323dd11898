# What is drawn of one scene of the atlas (plots/map.gp). -v scene=NAME and
# want=curve -v way=WAY   its points, error and cost; NaN if there is none
# want=ends -v ways=...   where the names of curves stand, and their ends:
#                         x y, x y of the name, the name as method,cut
# want=air -v ways=...    the ends of those that come less deep, and their names
# want=like -v plan=RE    cost and error of all points whose plan is like that
# want=front              those that are on the front
# want=picks              what holds each tolerance: cost, error, plan, 1e-k
# A way is a plan without its steps: "leapfrog,rods" for "leapfrog:10,rods".
# The names below stand on their heads, at least -v apart=DECADES apart.
function way_of(plan) {
    sub(/:[^,]*/, "", plan)
    return plan
}
want == "picks" && $1 ~ ("^" scene "-[369]$") {
    tolerance = substr($1, length($1))
    if ($2 != "-") {
        print $4, $3, $2, "1e-" tolerance
        ++found
    }
}
$1 != scene || NF != 5 { next }
want == "curve" && way_of($3) == way && $4 < 10 {
    print $5, $4
    ++found
}
(want == "like" && $3 ~ plan) || (want == "front" && $2) {
    print $5, $4
    ++found
}
want == "ends" || want == "air" {
    w = way_of($3)
    if ($4 < 10) {
        x[w] = $5
        y[w] = $4
    }
}
END {
    if (want ~ /curve|like|front|picks/ && !found)
        print "NaN NaN - 1e-3"
    if (want != "ends" && want != "air")
        exit
    n = split(ways, name, " ")
    for (k = 1; k <= n && want == "air"; ++k)
        if (y[name[k]] > deep) {
            print x[name[k]], y[name[k]], name[k]
            ++found
        }
    if (want == "air") {
        if (!found)
            print "NaN NaN -"
        exit
    }
    for (k = 1; k <= n; ++k)
        if (name[k] in x)
            place(name[k])
    spread()
    for (k = 1; k <= ends; ++k)
        print x[end[k]], y[end[k]], 10 ^ at[k], band, end[k]
    if (!ends)
        print "NaN NaN NaN NaN -"
}
# Those that have come far enough down have their names below, from the left
# to the right.
function place(w,    k) {
    if (y[w] > deep)
        return
    for (k = ends++; k > 0 && x[end[k]] > x[w]; --k)
        end[k + 1] = end[k]
    end[k + 1] = w
}
function spread(    k, moved, gap, round) {
    for (k = 1; k <= ends; ++k)
        at[k] = log(x[end[k]]) / log(10)
    for (round = 0; round < 400; ++round)
        for (k = 2; k <= ends; ++k) {
            gap = apart - (at[k] - at[k - 1])
            if (gap > 1e-9) {
                at[k - 1] -= gap / 2
                at[k] += gap / 2
            }
        }
}
