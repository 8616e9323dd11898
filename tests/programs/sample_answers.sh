#!/bin/sh
# What sample and sample-studies say, against closed forms and reference
# runs computed for this book by programs of its own. Tolerances are four
# standard errors of the run, as it tells them, and of the reference.
. tests/programs/common
s=build/bin/sample
t=build/bin/sample-studies

# near NAME KEY EXPECTED REFERENCE-ERROR: what the last summary says.
near() {
    holds "$1" awk -v key="$2" -v want="$3" -v error="$4" '
        $1 == key { got = $2; found = 1 }
        $1 == key "_error" { own = $2 }
        END { d = got - want; if (d < 0) d = -d
            print key, got, "+-", own, "not", want
            exit !(found && own > 0 && d <= 4 * sqrt(own^2 + error^2)) }' \
        "$work/s"
}

# profile NAME TABLE: the table's densities of x and of y against the
# reference, by chi-square of 70 bins whose errors come from 64 blocks or
# more; 1.5 a bin allows for that and for neighbours that know each other.
profile() {
    holds "$1" awk '/^#/ { next }
        FILENAME == ARGV[1] { p[int($1 * 100 + 0.5)] = $2; next }
        (i = int($1 * 100 + 0.5)) in p {
            n++; x += (($2 - p[i]) / $3) ^ 2; y += (($4 - p[i]) / $5) ^ 2 }
        END { print n, x, y; exit !(n == 70 && x > 20 && x < 105 &&
            y > 20 && y < 105) }' plots/data/06-reference.dat "$2"
}

# Two disks: (6.2, eq:two-disks) and what follows from it.
for method in direct markov; do
    step='--step 0.4'
    [ $method = markov ] || step=
    # shellcheck disable=SC2086
    $s --method $method --disks 2 --samples 3e5 $step -o /dev/null \
        --summary "$work/s"
    [ $method = direct ] &&
        near "two disks: acceptance" acceptance 0.616017342677 0
    near "two disks, $method: wall" Z_wall_x 1.771667475064 0
    near "two disks, $method: other wall" Z_wall_y 1.771667475064 0
    near "two disks, $method: contact" f_contact 3.202196 1e-6
    near "two disks, $method: the middle by symmetry" mean_x1 0.5 0
done

# Four disks: 5e9 throws; density at the wall 2.698893 +- 0.00031.
for method in direct markov; do
    $s --method $method --samples 5e5 -o "$work/$method" --summary "$work/s"
    [ $method = direct ] &&
        near 'four disks: acceptance' acceptance 0.0365551596 2.5e-6
    near "four disks, $method: wall" Z_wall_x 2.698893 0.00031
    near "four disks, $method: other wall" Z_wall_y 2.698893 0.00031
    near "four disks, $method: contact" f_contact 3.952373 0.00059
    near "four disks, $method: virial" Z_virial 1.88928 0.00013
    profile "four disks, $method: the density" "$work/$method"
done
# All densities are normalised; a box of unequal sides, in space.
$s --box 1.3,0.9,1.1 --radius 0.2 --samples 2e4 --bins 40 -o "$work/table" \
    --summary "$work/s"
holds 'densities of x, y and z have the sum one' awk '!/^#/ {
        x += $2 * 1.3 / 40; y += $4 * 0.9 / 40; z += $6 * 1.1 / 40; n++ }
    END { print n, x, y, z; exit !(n == 40 && (x - 1) ^ 2 < 1e-20 &&
        (y - 1) ^ 2 < 1e-20 && (z - 1) ^ 2 < 1e-20) }' "$work/table"
holds 'walls and virial agree in a box of unequal sides' awk '
    { v[$1] = $2 }
    END { w = (v["Z_wall_x"] * 0.9 / 1.3 + v["Z_wall_y"] * 0.5 / 0.9 + \
            v["Z_wall_z"] * 0.7 / 1.1) / 3
        e = sqrt((v["Z_wall_x_error"] * 0.9 / 1.3) ^ 2 + \
            (v["Z_wall_y_error"] * 0.5 / 0.9) ^ 2 + \
            (v["Z_wall_z_error"] * 0.7 / 1.1) ^ 2) / 3
        d = w - v["Z_virial"]; print w, v["Z_virial"], e
        exit !(d * d < 16 * (e ^ 2 + v["Z_virial_error"] ^ 2)) }' "$work/s"

# The seed decides, and nothing else.
for seed in 1 1 2; do
    $s --samples 50 --seed $seed --measure states | grep -v '^#' | cksum
done >"$work/seeds"
holds 'equal seeds give equal states, others do not' awk '
    { c[NR] = $1 } END { exit !(c[1] == c[2] && c[1] != c[3]) }' \
    "$work/seeds"

# In a periodic box every place is as good as any other; 1.5 a bin as above.
$s --boundary periodic --samples 2e5 --bins 50 -o "$work/table" \
    --summary "$work/s"
holds 'a periodic box has an even density' awk '!/^#/ {
        n++; x += (($2 - 1) / $3) ^ 2; y += (($4 - 1) / $5) ^ 2 }
    END { print x, y; exit !(n == 50 && x > 12 && x < 75 && y < 75) }' \
    "$work/table"
# Eight disks, packing 0.39: chain and direct sampling agree, and so do event
# chains.
for method in direct markov chains; do
    $s --method $method --disks 8 --box 2,2 --boundary periodic \
        --radius 0.25 --samples 10000 -o /dev/null --summary "$work/$method"
done
holds 'both methods find one pressure in a periodic box' awk '
    $1 ~ /^Z_virial/ { v[FILENAME, $1] = $2 }
    END { a = ARGV[1]; b = ARGV[2]
        d = v[a, "Z_virial"] - v[b, "Z_virial"]
        print v[a, "Z_virial"], v[b, "Z_virial"]
        exit !(d * d < 16 * (v[a, "Z_virial_error"] ^ 2 + \
            v[b, "Z_virial_error"] ^ 2)) }' "$work/direct" "$work/markov"
holds 'chains find it twice, by slides and as they go' awk '
    { v[FILENAME, $1] = $2 }
    END { a = ARGV[1]; b = ARGV[2]; z = v[b, "Z_chain"]
        e = v[a, "Z_virial_error"] ^ 2; f = v[b, "Z_virial_error"] ^ 2
        g = v[b, "Z_chain_error"] ^ 2
        print z, v[a, "Z_virial"], v[b, "Z_virial"]
        exit !((z - v[a, "Z_virial"]) ^ 2 < 16 * (e + g) &&
            (z - v[b, "Z_virial"]) ^ 2 < 16 * (f + g) && g < f) }' \
    "$work/direct" "$work/chains"
# A thin gas of 64, packing 0.1, has Henderson's equation, but that a disk
# sees 63 others.
gas='--boundary periodic --box 22.42,22.42 --radius 0.5'
# shellcheck disable=SC2086
$s --method chains --disks 64 $gas --samples 40000 --bins 10 \
    -o "$work/table" --summary "$work/s"
holds 'chains know the pressure of a thin gas' awk '{ v[$1] = $2 }
    END { p = 0.1; z = (1 + p * p / 8) / (1 - p) ^ 2
        print v["Z_chain"], v["Z_chain_error"], z
        d = v["Z_chain"] - 1 - (z - 1) * (1 - 1 / 64)
        e = v["Z_chain_error"]
        exit !(e < 0.005 && d * d < 16 * e * e) }' "$work/s"

# Both methods take the small ones seriously.
for method in direct markov; do
    $s --method $method --disks 2 --small 0.05,8 --samples 60000 \
        -o /dev/null --summary "$work/$method"
done
holds 'both methods agree about small ones' awk '
    $1 ~ /^(Z_wall_x|f_contact)/ { v[FILENAME, $1] = $2 }
    END { a = ARGV[1]; b = ARGV[2]
        d = v[a, "Z_wall_x"] - v[b, "Z_wall_x"]
        f = v[a, "f_contact"] - v[b, "f_contact"]
        print v[a, "Z_wall_x"], v[b, "Z_wall_x"], v[a, "f_contact"], f
        exit !(v[a, "Z_wall_x"] > 2 && d * d < 16 * \
            (v[a, "Z_wall_x_error"] ^ 2 + v[b, "Z_wall_x_error"] ^ 2) &&
            f * f < 16 * (v[a, "f_contact_error"] ^ 2 + \
            v[b, "f_contact_error"] ^ 2)) }' "$work/direct" "$work/markov"

# States: rows of places that fit, and that go on from each other.
$s --method markov --step 0.05 --samples 500 --measure states \
    -o "$work/states"
holds 'no two disks of a state overlap, and a sweep is a small step' awk '
    /^#/ { next }
    { n++
        for (i = 2; i < 10; i += 2) {
            bad += $i < 0.15 || $i > 0.85
            for (j = 2; j < i; j += 2)
                bad += ($i - $j) ^ 2 + ($(i + 1) - $(j + 1)) ^ 2 < 0.09
            if (n > 1 && ($i - x[i]) ^ 2 > 0.1) bad++
            x[i] = $i } }
    END { print n, bad; exit !(n == 500 && !bad && NF == 9) }' \
    "$work/states"

# The two mistakes: 5e9 throws have 2.3788 and 1.0683; a chain of 1e7
# sweeps without its rejections 2.293(6) and 0.958(3).
$t --study mistakes --samples 300000 -o "$work/mistakes" --summary "$work/s"
holds 'what is wrong is wrong, what is right is right' awk '
    function off(got, error, want) { return ((got - want) / error) ^ 2 > 16 }
    !/^#/ { n++
        if (n == 1) bad = off($2, $3, 2.3788) + off($6, $7, 2.3788) + \
            off($8, sqrt($9 ^ 2 + 4e-5), 2.293) + ($4 > 2.2)
        if (n == 7) bad += off($2, $3, 1.0683) + off($6, $7, 1.0683) + \
            off($8, sqrt($9 ^ 2 + 1e-5), 0.958) }
    END { print n, bad; exit !(n == 14 && !bad) }' "$work/mistakes"

# A signal: the table stays, with what there is; no summary.
$s --samples 1e12 -o "$work/table.cut" --summary "$work/none" \
    2>"$work/err" &
pid=$!
sleep 1
kill -TERM $pid
wait $pid
status=$?
holds 'a run that is cut short has a table' \
    test "$(grep -c '^[0-9]' "$work/table.cut")" -eq 100
holds 'but no summary, and fails' \
    test "$status" -eq 1 -a ! -e "$work/none"
echo 1..32
