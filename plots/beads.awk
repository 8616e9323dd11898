# The beads of a table of bonkers, as bonkers0 reads them: mass, place and velocity
# of each in the first row, and the right stop.
/^# masses:/ {
    movers = split($0, mass) - 2
}
!/^#/ && !rows++ {
    for (i = 1; i <= movers; ++i)
        print mass[i + 2], $(3 + 2 * i), $(4 + 2 * i)
    print "inf", $(5 + 2 * movers), 0
}
