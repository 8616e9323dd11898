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
echo 1..10
