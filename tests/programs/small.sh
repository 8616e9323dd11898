#!/bin/sh
# The small programs, which the book prints whole: each compiles as it stands,
# and its numbers are those of the large program.
. tests/programs/common

# alone NAME [MODULE.c...]: compiles with these, without a warning.
alone() {
    name=$1
    shift
    holds "$name compiles as it stands" "${CC:-cc}" -std=c11 -Wall -Wextra -pedantic \
        -Werror -Isrc -o "$work/$name" "src/programs/$name.c" "$@" -lm
}

# nearly ROWS: as many rows in "$work/small" and "$work/large", and the numbers are
# equal but for the digits printed.
nearly() {
    awk -v rows="$1" 'FNR == NR { for (i = 1; i <= NF; ++i) a[FNR, i] = $i; next }
        { if (FNR == 1) wrong = 0
          for (i = 1; i <= NF; ++i) {
              d = a[FNR, i] - $i
              wrong += d > 1e-8 || d < -1e-8 || a[FNR, i] == ""
          } }
        END { exit FNR != rows || NR != 2 * rows || wrong > 0 }' "$work/small" "$work/large"
}

# ---- galperin0 and the study that counts

alone galperin0 src/line/collide.c
for k in 0 1 2 3 4 5; do
    "$work/galperin0" "1e$((2 * k))" | sed -n 's/^# collisions//p'
done >"$work/small"
build/bin/collide-forms --study galperin --digits 5 | grep -v '^#' >"$work/large"
holds 'galperin0 counts as the study does' awk '
    FNR == NR { count[FNR] = $1; next }
    $1 != FNR - 1 || $2 != count[FNR] || $7 != count[FNR] { far = 1 }
    END { exit far || FNR != 6 || count[6] != 314159 }' "$work/small" "$work/large"
# In the wedge the way is a straight line that has been folded: its distance from
# the corner is that of a line 0.42 beside it.
holds 'its path is a line, folded' sh -c '"$1" 9 | awk '\''
    /^#/ { next }
    NR > 1 { dx = $1 - x; dy = $2 - y; off = (x * dy - y * dx) / sqrt(dx * dx + dy * dy)
             far += off * off - 0.1764 > 1e-8 || off * off - 0.1764 < -1e-8 }
    { x = $1; y = $2 }
    END { exit NR != 12 || far }'\' sh "$work/galperin0"
refuses 2 expected "$work/galperin0"
refuses 2 expected "$work/galperin0" 0

# ---- bonkers0 with other beads, histogram0 behind it, and the large programs

alone bonkers0 src/line/collide.c
build/bin/bonkers --preset thermal --every 0.24 --samples 400 >"$work/table"
awk -f plots/beads.awk "$work/table" >"$work/beads"
"$work/bonkers0" 0.24 400 - <"$work/beads" >"$work/small"
grep -v '^#' "$work/table" | cut -d ' ' -f 1,2,5-24 >"$work/large"
holds 'bonkers0 takes other beads where bonkers does' awk '
    FNR == NR { if (!/^#/) row[FNR] = $0; next }
    { split(row[FNR], x)
      for (i = 1; i <= 22; ++i)
          far += x[i] - $i > 1e-8 || x[i] - $i < -1e-8 }
    END { exit FNR != 401 || far > 0 }' "$work/small" "$work/large"
refuses 2 'line 1: expected' "$work/bonkers0" 0.24 400 -

alone histogram0 src/line/statistics.c
sed 1d "$work/small" | "$work/histogram0" 16 10 -3.2 3.2 20 -1.5 1.5 |
    grep -v '^#' >"$work/own"
for k in 4,3.2 9,1.5; do
    build/bin/histogram --skip 1 --block --column "v${k%,*}" --range="-${k#*,},${k#*,}" \
        --bins 16 "$work/table" 2>"$work/told" | sed '/^#/d' | awk 'NF'
    printf '\n\n'
done >"$work/large"
# bonkers0 prints ten digits.
holds 'histogram0 has the bins and errors of histogram' awk '
    FNR == NR { x[FNR] = $1; p[FNR] = $2; s[FNR] = $3; next }
    { dx = x[FNR] - $1; dp = p[FNR] - $3; ds = s[FNR] - $4
      far += dx * dx + dp * dp + ds * ds > 1e-14 }
    END { exit FNR != 36 || far > 0 }' "$work/own" "$work/large"
refuses 2 expected "$work/histogram0" 16 10 -3.2 </dev/null
refuses 2 expected "$work/histogram0" 0 10 -3.2 3.2 </dev/null

# ---- piston0 and piston

alone piston0 src/line/piston.c
for mass in 0 6.6666666666666667; do
    "$work/piston0" 0.1 $mass 200 >"$work/small"
    build/bin/piston --velocity 0.1 --gas-masses $mass,$mass --until 100 --every 0.5 |
        grep -v '^#' >"$work/large"
    holds "piston0 swings as piston does, gases of $mass kg" awk '
        FNR == NR { x[FNR] = $2; v[FNR] = $3; next }
        { dx = x[FNR] - $2; dv = v[FNR] - $3; far += dx * dx + dv * dv > 1e-16 }
        END { exit FNR != 201 || far > 0 }' "$work/small" "$work/large"
done
refuses 2 expected "$work/piston0" 0.1 0
refuses 2 expected "$work/piston0" 0.1 -1 200
# ---- pendulum0 and the study of the same four methods

alone pendulum0
for method in euler symplectic-euler leapfrog rk4; do
    time=200
    [ $method != euler ] || time=7
    for angle in 0.6 1.2 1.8 2.4; do
        "$work/pendulum0" $method 0.5 $time $angle
    done
done >"$work/small"
build/bin/step-studies --study portrait | grep -v '^#' | awk NF >"$work/large"
# Nine digits are printed.
holds 'pendulum0 swings as stepping does' awk '
    FNR == NR { x[FNR] = $2; v[FNR] = $3; next }
    { dx = x[FNR] - $1; dv = v[FNR] - $2
      far += dx * dx + dv * dv > 1e-16 * (1 + $1 * $1 + $2 * $2) }
    END { exit FNR != 4872 || NR != 2 * FNR || far > 0 }' "$work/small" "$work/large"
refuses 2 expected "$work/pendulum0" verlet 0.5 7 0.6
refuses 2 expected "$work/pendulum0" euler 0 7 0.6

# ---- orbit0 and step

alone orbit0
cat >"$work/year" <<'END'
pos 0  0 0 0  1 0 0.1
pos 1  1 0 0  0 0 0.1
vel 1  0 6.2831853071795862 0
vfix 0  0 0 0
k2 39.478417604357434
dt 0.01
END
for method in euler symplectic-euler leapfrog; do
    "$work/orbit0" $method 0.01 3 >"$work/small"
    build/bin/step "$work/year" --method $method --until 3 --every 0.01 --bound 1e9 \
        --observe x:1,y:1 2>"$work/told" | grep -v '^#' >"$work/large"
    holds "orbit0 and step go the same way, $method" awk '
        FNR == NR { t[FNR] = $1; x[FNR] = $2; y[FNR] = $3; next }
        { dx = x[FNR] - $2; dy = y[FNR] - $3; dt = t[FNR] - $1
          far += dx * dx + dy * dy + dt * dt > 1e-16 }
        END { exit FNR != 301 || far > 0 }' "$work/small" "$work/large"
done
refuses 2 expected "$work/orbit0" verlet 0.01 3
refuses 2 expected "$work/orbit0" euler 0 3

# ---- springs0 and step: all bodies at four times

alone springs0
for rest in 0.8 1; do
    "$work/springs0" $rest | awk NF >"$work/small"
    build/bin/scene membrane --damping 0 --rest $rest -o "$work/membrane"
    build/bin/step "$work/membrane" --dt 0.01 --until 24 --every 8 | grep -v '^#' |
        awk '{ for (i = 2; i < NF; i += 6) print $i, $(i + 1), $(i + 2) }' >"$work/large"
    holds "springs0 swings as step does, rest length $rest" nearly 256
done
refuses 2 expected "$work/springs0"
refuses 2 expected "$work/springs0" -1

# ---- spheres0 and step: all balls after the break, and no other order

alone spheres0
build/bin/scene break -o "$work/break"
broken() { # ORDER
    build/bin/step "$work/break" --until 0.5 --every 0.5 --shift back \
        --rule approaching --order "$1" | awk '$1 == 0.5 {
            for (i = 2; i < NF; i += 6)
                print $i, $(i + 1), $(i + 3), $(i + 4) }' >"$work/large"
}
for order in ascending descending; do
    "$work/spheres0" $order >"$work/small"
    broken $order
    holds "spheres0 breaks as step does, $order" nearly 16
done
broken ascending
nearly 16 && not_ok 'and the other order is seen' 'it was not' ||
    ok 'and the other order is seen'
refuses 2 expected "$work/spheres0"
refuses 2 expected "$work/spheres0" deepest

# ---- bonk0 and bonk, when the same two models are all that it may take

alone bonk0 -D_POSIX_C_SOURCE=200809L src/forces/jacobi.c src/forces/kepler.c \
    src/toolbox/aligned.c
cat >"$work/planets" <<'END'
pos 0  0 0 0     1 0 0
pos 1  5.2 0 0   0.0009551098376313276 0 0
pos 2  0 9.58 0  0.0002858776443682104 0 0
vel 1  0 2.755 0
vel 2  -2.03 0 0
k2 39.478417604357434
END
# Steps and prices are the same, errors but for what the references differ by,
# a twentieth of the tolerance each.
for pair in 0.05:kepler,no-light 0.005:leapfrog 0.001:leapfrog; do
    e=${pair%:*} model=${pair#*:}
    "$work/bonk0" "$e" | grep holds | tail -n 1 >"$work/small"
    build/bin/bonk "$work/planets" --until 120 --tolerance "$e" --model "$model" \
        --summary - -o "$work/rows" >"$work/large"
    holds "bonk0 takes what bonk takes of ${model%,*}, $e" awk '
        FNR == NR { name = $2; sub(/ellipses:0/, "kepler,no-light", name)
                    e = $1; error = $3; cost = $4; next }
        { v[$1] = $2 }
        END { far = v["error_found"] - error
              exit !(v["model"] == name && far * far < (e / 10) ^ 2 &&
                  sprintf("%.1f", 1e9 * v["cost"]) == cost) }' \
        "$work/small" "$work/large"
done
refuses 2 expected "$work/bonk0" 0
refuses 2 expected "$work/bonk0"
# ---- throw0 and sample: the same throws

alone throw0 src/toolbox/random.c
"$work/throw0" 20000 | cut -d' ' -f1,2 >"$work/small"
build/bin/sample --samples 20000 | grep -v '^#' | cut -d' ' -f1,2 >"$work/large"
holds 'throw0 has the density of sample' nearly 100

# ---- markov0 and sample: the same chain, whose distances are counted here

alone markov0 src/toolbox/random.c
for box in 2:2000:72:100:5,5 3:300:400:75:5,5,5; do
    IFS=: read -r axes sweeps small bins sides <<END
$box
END
    [ "$axes" -eq 3 ] && space=3 || space=
    # shellcheck disable=SC2086
    "$work/markov0" "$sweeps" $space | awk -v columns=1 -v bins="$bins" -v high=2.5 \
        -v block=$((sweeps / 10)) -f plots/density.awk | cut -d' ' -f1,2 >"$work/small"
    build/bin/sample --method markov --disks 2 --radius 1 --box "$sides" \
        --boundary periodic --small "0.2,$small" --measure distances --bins "$bins" \
        --step 0.3 --samples "$sweeps" | grep -v '^#' | cut -d' ' -f1,2 |
        awk '{ printf "%.6g %.9g\n", $1, $2 }' >"$work/large"
    holds "markov0 has the distances of sample, $axes axes" nearly "$bins"
done

# ---- gas0 and disks: the same gas

alone gas0 src/box/collapse.c src/box/disks.c src/box/falling.c src/box/heat.c \
    src/box/meet.c src/box/meetings.c src/box/speeds.c src/box/starts.c src/box/walls.c \
    src/line/collide.c src/line/fall.c src/line/statistics.c src/toolbox/random.c
"$work/gas0" 250 200 | awk '{ printf "%s %s %s %s\n", $1, $2, $4, $5 }' >"$work/small"
build/bin/disks --disks 250 --radius 0.1 --box 7.5,5 --measure speeds --every 0.4 \
    --samples 199 | grep -v '^#' |
    awk '{ printf "%.5f %s %s %s\n", $1, $2, $4, $5 }' >"$work/large"
holds 'gas0 has the speeds of disks' nearly 42
echo 1..51
