#!/bin/sh
# Bad commands and bad tables: one clear line with file and line, status 2,
# nothing half-written.
. tests/programs/common
h=build/bin/histogram
good=$work/good.dat
bad=$work/bad.dat
printf '# 1 t [s] time\n# 2 v1 [m/s] velocity\n0 1.5\n1 2.5\n2 -1\n' >"$good"

refuses 2 'a FILE is needed' $h
refuses 2 "'b': there is a file already, 'a'" $h a b
refuses 2 "bins: '0' is not a whole number" $h --bins 0 "$good"
refuses 2 "bins: 'ten'" $h --bins ten "$good"
refuses 2 "range: '1' is not two numbers" $h --range 1 "$good"
refuses 2 "range: '2,1' is not two numbers, the smaller one first" \
    $h --range 2,1 "$good"
refuses 2 "range: '1,1'" $h --range 1,1 "$good"
refuses 2 "range:.* has more than 2 numbers" $h --range 1,2,3 "$good"
refuses 2 "fit: 'bell' is not gaussian" $h --fit bell "$good"
refuses 2 "law: 'gauss' is not normal, microcanonical:n, beta:k,n or" \
    $h --law gauss "$good"
refuses 2 "law: 'beta:4,3' is not beta:k,n" $h --law beta:4,3 "$good"
refuses 2 "law: 'microcanonical:1' is not microcanonical:n" \
    $h --law microcanonical:1 "$good"
refuses 2 "law: 'maxwell:-1' is not maxwell:kT" $h --law maxwell:-1 "$good"
refuses 2 "table: 'all' is not histogram, columns, blocks" \
    $h --table all "$good"
refuses 2 "skip: '-1'" $h --skip -1 "$good"
refuses 2 "would both go" $h --summary - "$good"
refuses 2 "$work/none.dat: No such file" $h "$work/none.dat"
refuses 2 "$good:3: no column 'v2' is named" $h --column v2 "$good"
refuses 2 "$good:3: no column 3: the row has 2" $h --column 3 "$good"
refuses 2 "$good:3: no column 0" $h --column 0 "$good"
refuses 2 "$good:3: no column ''" $h --column ,v1 "$good"
refuses 2 "$good:3: no column 'v9'" $h --column v1 --against v9 "$good"
printf '1 2\n1 3\n1 4\n' >"$work/still"
refuses 2 'c1 is the same in all rows' $h --column 1 --against 2 "$work/still"
refuses 2 'c1 is the same in all rows' $h --column 2 --against 1 "$work/still"
refuses 2 "$good:3: 2 laws for 1 columns" \
    $h --column v1 --law normal --law normal "$good"
refuses 2 "$good:3: 2 ranges for 1 columns" \
    $h --column v1 --range 0,1 --range 0,2 "$good"
refuses 2 "$good: 1 rows of numbers, where 2 are the least" \
    $h --skip 2 "$good"
refuses 2 "/dev/null: 0 rows" $h /dev/null

# Found by a trial of the second edition: an assertion, and inf with status 0.
printf '%s\n' 1e308 -1e308 1e308 >"$work/wide"
for table in histogram columns blocks correlation; do
    refuses 2 'wide: c1 reaches from -1e+308 to 1e+308, expected a range' \
        $h --table $table "$work/wide"
done
awk 'BEGIN { for (i = 0; i < 1000; ++i) printf "%de-170\n", i * i % 997 }' \
    >"$work/small"
refuses 2 'small: c1 has a standard deviation of 2.9.*e-168' \
    $h --table blocks "$work/small"
sed 's/170/312/' "$work/small" >"$work/least"
refuses 2 'least: c1 would have 10 bins .*so narrow' $h "$work/least"
sed 's/e.*/ 1/' "$work/small" >"$work/constant"
refuses 2 'constant: c2: no law has its standard deviation, 0' \
    $h --law normal "$work/constant"

refuses_row() { # PATTERN ROW
    printf '1 2\n3 4\n%s\n5 6\n' "$2" >"$bad"
    rm -f "$work/new"
    refuses 2 "$bad:3: $1" $h -o "$work/new" --summary "$work/sum" "$bad"
    holds "nothing is written for '$2'" \
        sh -c "test ! -e '$work/new' && test ! -e '$work/sum'"
}
refuses_row "column 2 (c2) is 'nan', not a finite number" '1 nan'
refuses_row "column 1 (c1) is '-inf', not a finite number" '-inf 2'
refuses_row "column 2 (c2) is '1e999', not a finite number" '1 1e999'
refuses_row "column 2 (c2) is '4,5', not a number" '3 4,5'
refuses_row "column 1 (c1) is 'abc', not a number" 'abc 1'
refuses_row '1 columns, where column 2 is wanted' '3'
printf '1\n2\nx\n' >"$bad"
if $h - <"$bad" 2>"$work/err"; then not_ok 'bad standard input' 'accepted'
elif grep -q 'histogram: -:3: column 1' "$work/err"; then ok 'bad standard input'
else not_ok 'bad standard input' "$(cat "$work/err")"; fi

# A folder that is not there, a full disk.
refuses 1 'cannot write' $h -o "$work/none/x" "$good"
if [ -c /dev/full ]; then
    refuses 1 'cannot write' $h -o /dev/full "$good"
fi
echo 1..50
