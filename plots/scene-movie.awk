# A run of a scene, or of disks, made into pictures for scene-movie.gp:
#   awk -v ask=1 -f plots/scene-movie.awk SCENE TABLE
# says in one line whether the two go together, how many rows there are, the
# time between two and what is to be seen; with ask=0 and what it has said,
# it writes the commands that draw each row. For disks, SCENE is the table.
#   view   xy, xz or tilted; if none is given, what the motion wants
BEGIN {
    bodies = springs = shown = seen = row = picture = 0
    pi = atan2(0, -1)
    side = sin(pi / 6)
    front = cos(pi / 6)
    up = cos(pi / 7)
    flat = sin(pi / 7)
    split("0072b2 d55e00 009e73 e69f00 aa4499 56b4e9 999933 333333", hue, " ")
}
FNR == 1 { ++file }
file == 1 { read_scene() }
file == 2 { read_table() }
END {
    if (disks && row)
        finish()
    if (ask)
        answer()
}

# ---- the scene ------------------------------------------------------------

function read_scene() {
    if ($1 == "pos") {
        i = $2
        there[i] = ++bodies
        mass[i] = $6
        radius[i] = $8
        colour[i] = NF >= 11 && $9 + $10 + $11 > 0 ? \
            mixed(255 * $9, 255 * $10, 255 * $11) : -1
    } else if ($1 == "vel")
        moving[$2] = $3 != 0 || $4 != 0 || $5 != 0
    else if ($1 == "vfix")
        fixed[$2] = !($3 + $4 + $5)
    else if ($1 == "s")
        kind[$2] = mixed(255 * $5, 255 * $6, 255 * $7)
    else if ($1 == "sl") {
        from[springs] = $2
        to[springs] = $3
        of[springs++] = $4
    } else if ($1 == "contact")
        contact = 1
    else if ($1 == "box")
        for (k = 0; k < 3; ++k) {
            start[k] = $(2 + 2 * k)
            stop[k] = $(3 + 2 * k)
        }
    else if ($1 == "walls")
        for (k = 0; k < 3; ++k)
            wall[k] = $(2 + k) != "open"
    else if ($1 == "#" && $2 == "box") {  # a table of disks
        disks = contact = 1
        for (k = 0; k < 2; ++k) {
            stop[k] = $(3 + k)
            wall[k] = 1
        }
    } else if (disks && !/^#/) {
        if (NF < 11 || bodies && $1 != begun)
            return
        begun = $1
        i = $2
        there[i] = ++bodies
        mass[i] = $3
        radius[i] = $4
        colour[i] = -1
        moving[i] = 1
    }
}
function mixed(r, g, b) {
    return 65536 * int(r + 0.5) + 256 * int(g + 0.5) + int(b + 0.5)
}
function number(text,    n, k) {
    for (k = 1; k <= length(text); ++k)
        n = 16 * n + index("123456789abcdef", substr(text, k, 1))
    return n
}

# ---- the table ------------------------------------------------------------

# Which columns have the places of which body; then row after row.
function read_table() {
    if ($1 == "#" && $3 ~ /^x:[0-9]+$/ && $5 == "place") {
        at[shown] = $2
        id[shown++] = substr($3, 3)
    } else if (/^#/)
        ;
    else if (disks && NF) {
        if (row && $1 != time)
            finish()
        if (!row || $1 != time)
            ++row
        time = $1
        take($2, $5, $6, 0)
    } else if (NF && shown) {
        ++row
        time = $1
        for (s = 0; s < shown; ++s)
            take(id[s], $(at[s]), $(at[s] + 1), $(at[s] + 2))
        finish()
    }
}
function take(i, a, b, c) {
    if (!(i in known)) {
        known[i] = 1
        order[seen++] = i
    }
    x[i] = a
    y[i] = b
    z[i] = c
}
function finish() {
    if (ask)
        measure()
    else
        draw()
}

# ---- what is to be seen ---------------------------------------------------

# The least and the greatest of each coordinate. What flies off leaves the
# picture at four times the size that the scene had, of many bodies at 1.5.
function measure(    s, i, k, half) {
    if (first == "")
        first = time
    if (row == 2)
        step = time - first
    if (row == 1) {
        for (s = 0; s < seen; ++s) {
            i = order[s]
            p[0] = x[i]; p[1] = y[i]; p[2] = z[i]
            for (k = 0; k < 3; ++k) {
                if (!s || p[k] < low[k]) low[k] = p[k]
                if (!s || p[k] > high[k]) high[k] = p[k]
            }
            if (radius[i] > largest)
                largest = radius[i]
        }
        for (k = 0; k < 3; ++k) {
            middle[k] = (low[k] + high[k]) / 2
            if (high[k] - low[k] > 2 * half)
                half = (high[k] - low[k]) / 2
        }
        reach = half > 0 ? (seen > 30 ? 1.5 : 4) * half : 1e300
        for (k = 0; k < 6; ++k) {
            low[k] = 1e300
            high[k] = -1e300
        }
    }
    for (s = 0; s < seen; ++s) {
        i = order[s]
        p[0] = held(x[i], 0)
        p[1] = held(y[i], 1)
        p[2] = held(z[i], 2)
        project("tilted", p[0], p[1], p[2])
        p[3] = u
        p[4] = v
        p[5] = v + 2 * up * p[2]
        for (k = 0; k < 6; ++k) {
            if (p[k] < low[k]) low[k] = p[k]
            if (p[k] > high[k]) high[k] = p[k]
        }
    }
}
function held(c, k) {
    return c < middle[k] - reach ? middle[k] - reach : \
        c > middle[k] + reach ? middle[k] + reach : c
}
function project(view, a, b, c) {
    u = a
    v = b
    depth = c
    if (view == "xz") {
        v = c
        depth = -b
    } else if (view == "tilted") {
        u = front * a - side * b
        depth = -(side * a + front * b)
        v = up * c * (tall > 1 ? tall : 1) - flat * depth
    }
}

# One line: how many rows, the time between two, whether it is on a line, the
# view, how much higher heights are drawn there, left, right, bottom, top.
function answer(    a, b, k, most, height, deep, line, tall) {
    if (!bodies || !seen) {
        print "no table of the states of the scene's bodies"
        return
    }
    if (row < 2) {
        print "a table of " row " rows, expected two at least"
        return
    }
    for (k in known)
        if (!(k in there)) {
            print "a table with a body " k ", which the scene has not"
            return
        }
    for (k = 0; k < 3; ++k) {
        if (wall[k]) {
            low[k] = start[k] + 0
            high[k] = stop[k] + 0
        }
        if (high[k] - low[k] > most)
            most = high[k] - low[k]
    }
    height = high[1] - low[1]
    deep = high[2] - low[2]
    if (view == "")
        view = deep <= 0.04 * most ? "xy" : height <= 0.04 * most ? "xz" : \
            "tilted"
    tall = view == "tilted" && deep < 0.15 * most ? 3 : 1
    a = view == "tilted" ? 3 : 0
    b = tall > 1 ? 5 : view == "tilted" ? 4 : view == "xz" ? 2 : 1
    line = view != "tilted" && !(high[b] - low[b] > 1e-9 * most)
    for (k = 0; k < 6; ++k) {
        low[k] -= wall[k] ? 0 : largest
        high[k] += wall[k] ? 0 : largest
    }
    print "rows", row, step, line, view, tall, low[a], high[a], low[b], high[b]
}

# ---- a picture of each row --------------------------------------------------

# The first row settles how large and in which colour a body is: what the
# scene says, but no smaller than can be seen; of many bodies without a colour
# the heavy ones are red, or the only one that moves, or else the first.
function dress(    s, i, least, most, mark, movers) {
    least = 1e300
    for (s = 0; s < seen; ++s) {
        i = order[s]
        if (fixed[i])
            continue
        if (mass[i] < least) least = mass[i]
        if (mass[i] > most) most = mass[i]
        if (moving[i]) {
            ++movers
            mark = i
        }
    }
    if (movers != 1 || springs)
        mark = springs ? "" : order[0]
    smallest = (top - bottom) * (seen > 300 ? 0.002 : seen > 30 ? 0.005 : 0.008)
    tail = 3 * fps * (line ? 2 : 1)
    for (s = 0; s < seen; ++s) {
        i = order[s]
        heavy[i] = most > 1.5 * least && mass[i] >= sqrt(least * most)
        size[i] = contact && radius[i] > 0 || radius[i] > smallest ? radius[i] \
            : smallest
        if (colour[i] < 0)
            colour[i] = fixed[i] ? number("777777") : \
                seen - springs <= 8 && springs < 5 ? \
                number(hue[s % 8 + 1]) : \
                heavy[i] || most <= 1.5 * least && i == mark ? \
                number("d55e00") : number(springs ? "0072b2" : "56b4e9")
        traced[i] = !fixed[i] && (line || seen <= 16 && springs < 5)
    }
    lone = line || springs || seen <= 16 || mark == "" ? "" : mark
    for (s = 0; s < seen; ++s)
        if (lone != "" && most > 1.5 * least && heavy[order[s]])
            lone = order[s]
}

# A colour paler by the share f.
function pale(c, f,    r, g) {
    r = int(c / 65536)
    g = int(c / 256) % 256
    return mixed(r + f * (255 - r), g + f * (255 - g), \
        c % 256 + f * (255 - c % 256))
}

function draw(    s, i, j, k, n, f, d, last) {
    if (row == 1)
        dress()
    n = picture++
    print "$bodies << end"
    for (s = 0; s < seen; ++s) {
        i = order[s]
        project(view, x[i], y[i], z[i])
        pu[i] = wayu[i, n % (tail + 1)] = u
        pv[i] = wayv[i, n % (tail + 1)] = v
        sorted[s] = depth
        key[s] = s
    }
    if (view == "tilted")
        sort(seen)
    for (s = 0; s < seen; ++s) {
        i = order[key[s]]
        print pu[i], pv[i], size[i], colour[i]
    }
    print "end\n$springs << end\n0 0 0\n"
    for (s = 0; s < springs; ++s)
        if (from[s] in pu && to[s] in pu)
            spring(from[s], to[s], kind[of[s]])
    print "end\n$ways << end\n0 0 0\n"
    for (s = 0; s < seen; ++s) {
        i = order[s]
        if (!traced[i])
            continue
        k = n > tail ? n - tail : 0
        last = wayu[i, k % (tail + 1)]
        for (; k <= n; ++k) {
            j = k % (tail + 1)
            f = (n - k) / tail
            d = wayu[i, j] - last
            if (d * d > (right - left) * (right - left) / 4)
                print ""
            last = wayu[i, j]
            print wayu[i, j], wayv[i, j] - (line ? f * fall : 0), \
                pale(colour[i], 0.25 + 0.75 * f)
        }
        print ""
    }
    print "end"
    if (lone != "")
        trace = trace pu[lone] " " pv[lone] "\n"
    print "$lone << end\n" (lone == "" ? "0 0\n" : trace) "end"
    print "f = " n "; t = " time "; eval picture"
}

# From the farthest to the nearest.
function sort(n,    gap, a, b, d, k) {
    for (gap = int(n / 2); gap > 0; gap = int(gap / 2))
        for (a = gap; a < n; ++a) {
            d = sorted[a]
            k = key[a]
            for (b = a; b >= gap && sorted[b - gap] > d; b -= gap) {
                sorted[b] = sorted[b - gap]
                key[b] = key[b - gap]
            }
            sorted[b] = d
            key[b] = k
        }
}

# A spring is a line; of a few, one with windings.
function spring(a, b, c,    du, dv, d, k, w) {
    c = c ? c : number("777777")
    du = pu[b] - pu[a]
    dv = pv[b] - pv[a]
    d = sqrt(du * du + dv * dv)
    print pu[a], pv[a], c
    w = springs > 4 || d == 0 ? 0 : 0.018 * (top - bottom) / d
    if (w)
        for (k = 0; k <= 17; ++k)
            print pu[a] + du * (0.12 + 0.76 * k / 17) - dv * w * zig(k), \
                pv[a] + dv * (0.12 + 0.76 * k / 17) + du * w * zig(k), c
    print pu[b], pv[b], c
    print ""
}
function zig(k) {
    return k == 0 || k == 17 ? 0 : k % 2 ? 1 : -1
}
