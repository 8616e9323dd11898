# Particles between a wall at 0 and a piston at 1 + a sin(2 pi t), one h and one
# swing being the units: in blocks, for each of four starts at the wall, its
# number, the time and the speed after each hit, for 60 swings; then two paths for
# two swings, time and place. For plots/04-forget.gp.
function wall(t) { return 1 + a * sin(omega * t) }
function push(t) { return a * omega * cos(omega * t) }
# One step. Says what was hit: 1 the wall, 2 the piston, 0 neither.
function step(dt,    hit) {
    x = x + v * dt
    t = t + dt
    if (x < 0) {
        x = -x
        v = -v
        hit = 1
    }
    if (v > push(t) && x > wall(t)) {
        v = 2 * push(t) - v
        x = 2 * wall(t) - x
        hit = 2
    }
    return hit
}
function place(x) { printf "%.15g %.15g\n", t, x }
BEGIN {
    a = 0.25
    omega = 2 * atan2(0, -1)
    border = 2 * sqrt(a) * omega
    dt = 0.002
    print "# the number of the start; t (swings); speed (v_*)"
    for (n = split("0.2 0.33 0.62 2.0", start, " "); k++ < n; printf "\n\n") {
        t = x = 0
        v = start[k] * border
        while (t < 60)
            if (step(v > border ? dt / 3 : dt) == 2)
                printf "%d %.15g %.15g\n", k, t, (v < 0 ? -v : v) / border
    }
    print "# t (swings); x (h)"
    for (k = 1; k <= 2; ++k) {
        t = 0
        x = k == 1 ? 0.3 : 0.1
        v = (k == 1 ? 2 : 0.3) * border
        for (place(x); t < 2;)
            if (hit = step(dt))
                place(hit == 1 ? 0 : wall(t))
        place(x)
        printf "\n\n"
    }
}
