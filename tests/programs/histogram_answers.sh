#!/bin/sh
# What histogram says, against numbers worked out by hand.
. tests/programs/common
h=build/bin/histogram

# Ten samples of 4.5 on average; the sum of the squares of the deviations is
# 82.5. A title, blank lines and a column of words do no harm.
cat >"$work/ten" <<'END'
# anything (Bonkers) 0.1
# command: anything --seed 7
# seed: 7
# 1 name [1] a word
# 2 v1 [m/s] velocity
# 3 x1 [m] position

a 0 1
b 1 1
c 2 1

d 3 1
e 4 1
f 5 1
g 6 1
h 7 1
i 8 1
j 9 1
END
$h --column v1 --bins 3 --range 0,9 --summary "$work/s" -o "$work/t" \
    "$work/ten" || not_ok 'histogram runs' "status $?"

says() { # KEY VALUE TOLERANCE
    awk -v key="$1" -v want="$2" -v tolerance="$3" '
        $1 == key { found = 1; value = $2; d = value - want }
        END {
            if (found && d <= tolerance && -d <= tolerance)
                print "ok histogram_answers: " key
            else
                print "not ok histogram_answers: " key " - " value \
                    ", not " want " to within " tolerance
        }' "$work/s"
}
row() { # LINE COLUMN VALUE TOLERANCE: of the rows of numbers
    awk -v line="$1" -v column="$2" -v want="$3" -v tolerance="$4" '
        !/^#/ && NF { if (++n == line) value = $column }
        END { d = value - want
            what = "row " line ", column " column
            if (value != "" && d <= tolerance && -d <= tolerance)
                print "ok histogram_answers: " what
            else
                print "not ok histogram_answers: " what " - " value \
                    ", not " want }' "$work/t"
}
says samples 10 0
says mean_v1 4.5 1e-12
says sd_v1 3.0276503540974917 1e-12         # sqrt(82.5 / 9)
says mean_error_v1 0.9574271077563381 1e-12 # over sqrt(10)
says least_v1 0 0
says greatest_v1 9 0
says inefficiency_v1 1 0
says outside_v1 0 0
# 0 1 2 | 3 4 5 | 6 7 8 9: the upper end is in the last bin.
row 1 1 1.5 1e-9
row 1 2 3 0
row 3 2 4 0
row 3 3 0.133333333 1e-8  # 4 / (10 * 3)
row 3 4 0.0516397779 1e-9 # sqrt(0.4 * 0.6 / 10) / 3

has() { # NAME FILE PATTERN
    if grep -q -e "$3" "$2"; then ok "$1"; else
        not_ok "$1" "no '$3' in: $(tr '\n' ' ' <"$2")"; fi
}
has 'the head names the command' "$work/t" \
    '^# command: histogram --column v1 --bins 3 --range 0,9 '
has 'the head keeps the seed' "$work/t" '^# seed: 7$'
has 'the head says where the data are from' "$work/t" \
    '^# data: anything --seed 7$'
has 'the unit of a density' "$work/t" '\[1/(m/s)\]'
has 'mean and spread for the reader' "$work/t" \
    '^# v1 \[m/s\]: mean 4.5 +- 0.96, sd 3.028 +- '

# Half of it outside: counts, and rows skipped from the front.
$h -c v1 -B 2 -r 2,5 --skip 1 --summary "$work/s" -o "$work/t" "$work/ten"
says samples 9 0
says outside_v1 5 0
row 2 2 2 0
row 2 3 0.148148148 1e-8 # 2 / (9 * 1.5)

# By number, a table without a head, from standard input.
printf '1 10\n2 20\n4 60\n' | $h -c 2 -S "$work/s" -o "$work/t" -
says mean_c2 30 1e-12
# All columns, one of which never changes.
printf '1 7\n2 7\n6 7\n' | $h --block --table columns \
    -S "$work/s" -o "$work/t" - 2>"$work/err"
says mean_c1 3 1e-12
says sd_c2 0 0
says mean_error_c2 0 0
row 1 1 1 0
row 2 1 2 0
# Lines that end as in Windows, tabs, and no newline at the end.
printf '1\t10\r\n2\t20\r\n4\t60' | $h -c 2 -S "$work/s" -o "$work/t" -
says mean_c2 30 1e-12

# A law: 0.051, 0.151, ... of a flat one. The distance is 0.051, and of the
# twenty bins every second holds one: 20 * 0.25 / 0.5 = 10.
awk 'BEGIN { for (i = 0; i < 10; ++i) print i / 10 + 0.051 }' |
    $h --law beta:1,1 -B 2 -r 0,1 -S "$work/s" -o "$work/t" -
says law_distance_c1 0.051 1e-12
says law_chi2_c1 10 1e-9
says law_degrees_c1 19 0
says law_mean_c1 0.5 1e-12
row 1 5 1 1e-9
# Two laws and two ranges serve two columns in turn.
awk 'BEGIN { for (i = 0; i < 10; ++i) print i / 10 + 0.051, i + 0.51 }' |
    $h --law beta:1,1 --law beta:1,1,0,10 --range 0,1 --range 0,10 -B 2 \
        -S "$work/s" -o "$work/t" -
says law_distance_c1 0.051 1e-12
says law_distance_c2 0.051 1e-12
row 3 1 2.5 1e-9
# The arcsine law is infinite at its end, its mean in a bin is not: the last
# of four bins has 1/3 of the probability, from cos(60) to cos(0).
awk 'BEGIN { for (i = 0; i < 9; ++i) print i / 4 - 1 }' |
    $h --law microcanonical:2,0.5,1 -B 4 -r -1,1 -S "$work/s" -o "$work/t" -
row 4 5 0.666666667 1e-8

# Plus and minus one: all squares are alike, and correlate with nothing.
awk 'BEGIN { for (i = 0; i < 100; ++i) print "1\n-1" }' >"$work/signs"
$h --table correlation --column 1 -o "$work/t" "$work/signs"
holds 'squares that are alike have no correlation' awk '!/^#/ {
    ++n; bad += $4 != "nan" || $3 != $3 + 0 } END { exit !n || bad }' "$work/t"

# A series and its square: no correlation, no independence.
awk 'BEGIN { for (i = 0; i < 1001; ++i) print i - 500, (i - 500)^2 }' |
    $h -c 1 --against 2 --table columns -S "$work/s" -o "$work/t" - 2>"$work/err"
says correlation_c1 0 1e-12
says against_degrees_c1 16 0
says against_probability_c1 0 1e-12

# The same bytes twice, and with either of the ways to name a column.
$h -c v1 --block -o "$work/a" "$work/ten" 2>"$work/err"
$h -c 2 --block "$work/ten" >"$work/b" 2>"$work/err"
holds 'a column by name or by number' \
    sh -c "grep -v command '$work/a' >'$work/c' &&
        grep -v command '$work/b' | cmp - '$work/c'"
has 'too few samples are said to be' "$work/err" \
    'histogram: note: v1: 10 samples are too few'

# A column that never changes has bins, however large it is.
printf '1e17\n1e17\n' | $h -S "$work/s" - >"$work/t"
says sd_c1 0 0
says outside_c1 0 0
echo 1..46
