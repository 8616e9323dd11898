#!/bin/sh
# Where the samplers fail. Each case must go on failing as chapter 6 says.
. tests/programs/common
s=build/bin/sample
t=build/bin/sample-studies

# says NAME AWK: a condition on the keys of the last summary, in v.
says() {
    holds "$1" awk "{ v[\$1] = \$2 } END { print v[\"mean_x1\"],
        v[\"mean_x1_error\"], v[\"acceptance\"]; exit !($2) }" "$work/s"
}

# Direct sampling dies: at packing 0.2 (r = (0.2/(pi N))^(1/2)) its
# acceptance falls faster than a power of the number of disks.
for n in 4,0.12615663 8,0.08920621 16,0.06307831; do
    $t --study acceptance --disks "${n%,*}" --radii "${n#*,}" \
        --samples 400 | awk '!/^#/ { print $3 }'
done >"$work/falls"
holds 'acceptance falls exponentially with the number of disks' awk '
    { a[NR] = -log($1) }
    END { print a[1], a[2], a[3]
        exit !(a[1] > 1.3 && a[2] > 2 * a[1] && a[3] > 2 * a[2] && a[3] < 12) }' \
    "$work/falls"
# And faster than if pairs were independent: 0.6160 to the sixth is 0.0546.
$s --samples 20000 -o /dev/null --summary "$work/s"
says 'pairs are not independent' 'v["acceptance"] < 0.75 * 0.0546'

# Four disks that cannot change places: (2^(1/2) - 1)/2 = 0.2071. The chain
# says that all is well; its mean is wrong by a hundred errors.
for radius in 0.2 0.21; do
    $s --method markov --radius $radius --samples 3e5 -o /dev/null \
        --summary "$work/s"
    says "radius $radius: the chain is stuck" \
        '(v["mean_x1"] - 0.5) ^ 2 > (100 * v["mean_x1_error"]) ^ 2 &&
        v["acceptance"] > 0.05'
done
# The pressure is right all the same, since all pieces look alike: direct
# sampling has 4.998(166) and 5.006(114), and its mean is right, too.
$s --method markov --radius 0.2 --samples 3e5 -o /dev/null \
    --summary "$work/chain"
$s --radius 0.2 --samples 1000 -o /dev/null --summary "$work/s"
says 'direct sampling is not stuck' \
    '(v["mean_x1"] - 0.5) ^ 2 < (4 * v["mean_x1_error"]) ^ 2'
holds 'and has the same pressure' awk '
    $1 ~ /^Z_virial/ { v[FILENAME, $1] = $2 }
    END { a = ARGV[1]; b = ARGV[2]
        d = v[a, "Z_virial"] - v[b, "Z_virial"]
        print v[a, "Z_virial"], v[b, "Z_virial"]
        exit !(d * d < 16 * (v[a, "Z_virial_error"] ^ 2 + \
            v[b, "Z_virial_error"] ^ 2)) }' "$work/chain" "$work/s"
# The inefficiency of x_1 grows, and then seems small.
$t --study memory --radii 0.12,0.16,0.18,0.2 --step 0.15 --samples 500000 \
    --summary "$work/s" -o /dev/null
says 'memory grows, until the run cannot see it' \
    'v["g_x_2"] > 3 * v["g_x_1"] && v["g_x_3"] > 5 * v["g_x_2"] &&
    v["g_x_4"] < 100'

# Many disks in cages: less than a diameter within 5000 sweeps.
$s --method markov --disks 48 --radius 0.5 --box 6.866,6.866 --boundary \
    periodic --step 0.15 --samples 5000 -o /dev/null --summary "$work/s"
says 'a crowd rattles' 'v["moved"] < 0.5'
$s --method markov --disks 48 --radius 0.5 --box 7.927,7.927 --boundary \
    periodic --step 0.15 --samples 5000 -o /dev/null --summary "$work/s"
says 'a less dense one flows' 'v["moved"] > 1.5'

# A mean without a spread: one narrow line in 20000.
$s --radius 0.18 --samples 20000 -o /dev/null --summary "$work/s"
says 'one sample shakes an error' \
    'v["Z_wall_x_error"] > 5 * v["Z_wall_y_error"]'

# Both sides of (6.5, eq:two-sides) for four ways, in standard errors.
$t --study mistakes --samples 300000 -o /dev/null --summary "$work/s"
holds 'the virial catches what fitted being kept' awk '{ v[$1] = $2 }
    END { d = v["kept_walls"] - v["kept_pairs"]
        print d; exit !(d * d > 16 * (v["kept_walls_error"] ^ 2 + \
            v["kept_pairs_error"] ^ 2)) }' "$work/s"
holds 'but hardly a chain without rejections, which is 5 per cent off' awk '
    { v[$1] = $2 }
    END { d = v["moved_walls"] - v["moved_pairs"]
        print d; exit !(d * d < 0.03 ^ 2 && v["moved_walls"] < 1.83 &&
            v["moved_pairs"] < 1.83) }' "$work/s"
# Event chains along one axis: wrong by a thousand errors.
$t --study one-way --samples 20000 -o /dev/null --summary "$work/s"
says 'chains along one axis keep their rows' \
    'v["Z_both"] > 8.3 && v["Z_both"] < 8.5 &&
    v["Z_x"] < v["Z_both"] - 1000 * v["Z_x_error"]'
echo 1..13
