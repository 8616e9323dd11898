#!/bin/sh
# The tool that breaks solutions on purpose does what it says, operator by
# operator, and the run that counts survivors refuses a wrong list of those
# that are equal in effect.
. tests/programs/common
mutate=build/tests/mutate

cat >"$work/small.c" <<'END'
#include <math.h>
#define TWICE(x) (2 * (x)) /* no mutants in here: 1 + 1 */
static const double outside = 3.0 + 4.0;

bool kind(const double *p)
{
    return !isnan(*p) && *p != -2.0;
}

/* Nor in comments, "1 + 1". */
double work(int n, double a, double b)
{
    double sum = (double)n * a - b / 2.5;
    if (n < 3 || a >= b)
        return 0.0;
    for (int i = 0; i <= n; ++i)
        sum += pow(a, b);
    puts("1 + 1");
    return sum > 0.0 ? sum : -sum;
}
END
$mutate --list "$work/small.c" >"$work/list"

# makes OPERATOR BEFORE AFTER: there is just this mutant of it.
makes() {
    holds "$1: $3" test "$(cut -d' ' -f5- "$work/list" |
        grep -cxF "$1 :: $2 :: $3")" -eq 1
}
# never TEXT: no mutant changes a line like this.
never() {
    holds "nothing touches $1" test "$(grep -cF ":: $1" "$work/list")" -eq 0
}

sum='double sum = (double)n * a - b / 2.5;'
loop='for (int i = 0; i <= n; ++i)'
last='return sum > 0.0 ? sum : -sum;'
test='if (n < 3 || a >= b)'
makes plus-minus "$sum" 'double sum = (double)n * a + b / 2.5;'
makes times-divide "$sum" 'double sum = (double)n / a - b / 2.5;'
makes times-divide "$sum" 'double sum = (double)n * a - b * 2.5;'
makes drop-term "$sum" 'double sum = (double)n * a;'
makes drop-term "$sum" 'double sum = - b / 2.5;'
makes drop-term "$sum" 'double sum = a - b / 2.5;'
makes drop-term "$sum" 'double sum = (double)n - b / 2.5;'
makes drop-term "$sum" 'double sum = (double)n * a - 1.0 / 2.5;'
makes drop-term "$test" 'if (a >= b)'
makes constant "$sum" 'double sum = (double)n * a - b / 3.5;'
makes constant "$sum" 'double sum = (double)n * a - b / 0.5;'
makes constant "$loop" 'for (int i = (-1); i <= n; ++i)'
makes constant "$loop" 'for (int i = 2; i <= n; ++i)'
makes boundary "$loop" 'for (int i = 0; i < n; ++i)'
makes boundary "$test" 'if (n < 3 || a > b)'
makes boundary "$test" 'if (n <= 3 || a >= b)'
makes boundary "$last" 'return sum >= 0.0 ? sum : -sum;'
makes equal 'return !isnan(*p) && *p != -2.0;' 'return !isnan(*p) && *p == -2.0;'
makes and-or "$test" 'if (n < 3 && a >= b)'
makes and-or 'return !isnan(*p) && *p != -2.0;' 'return !isnan(*p) || *p != -2.0;'
makes drop-sign "$last" 'return sum > 0.0 ? sum : sum;'
makes drop-sign 'return !isnan(*p) && *p != -2.0;' 'return !isnan(*p) && *p != 2.0;'
makes negate 'return !isnan(*p) && *p != -2.0;' 'return isnan(*p) && *p != -2.0;'
makes negate "$test" 'if (!(n < 3 || a >= b))'
makes negate "$loop" 'for (int i = 0; !(i <= n); ++i)'
makes negate "$last" 'return !(sum > 0.0) ? sum : -sum;'
makes step "$loop" 'for (int i = 0; i <= n; -- i)'
makes assign 'sum += pow(a, b);' 'sum -= pow(a, b);'
makes assign 'sum += pow(a, b);' 'sum = pow(a, b);'
makes swap-arguments 'sum += pow(a, b);' 'sum += pow(b, a);'
makes drop-statement 'sum += pow(a, b);' ';'
makes drop-statement "$test return 0.0;" ';'
makes drop-statement "$loop" 'for (int i = 0; i <= n; )'
makes return-early 'sum += pow(a, b);' 'return 0;'
makes return-early 'puts("1 + 1");' 'return 0; puts("1 + 1");'
makes return-early 'return !isnan(*p) && *p != -2.0;' \
    'return true; return !isnan(*p) && *p != -2.0;'
never 'static const double outside = 3.0 + 4.0;'
never '#define TWICE(x) (2 * (x))'
holds 'a call that returns 0 already is no early return' \
    test "$(grep -c 'return-early :: return 0.0;' "$work/list")" -eq 0

count=$(wc -l <"$work/list")
refuses 2 "not a whole number from 1 to $count" $mutate $((count + 1)) "$work/small.c"
number=$(sed -n '/ :: boundary :: for /s/ .*//p' "$work/list")
$mutate "$number" "$work/small.c" >"$work/one.c"
holds 'a mutant differs in one line' \
    test "$(diff "$work/small.c" "$work/one.c" | grep -c '^>')" -eq 1
i=0
while [ $i -lt "$count" ]; do
    i=$((i + 1))
    $mutate $i "$work/small.c" | tr -s ' \n' '  ' | cksum
done >"$work/sums"
holds 'all mutants are different' test "$(sort -u "$work/sums" | wc -l)" -eq "$count"
refuses 2 'not a whole number from 1' $mutate 0 "$work/small.c"
refuses 2 "cannot read '$work/none'" $mutate --list "$work/none"
echo 'int f(void) { return (1; }' >"$work/torn.c"
refuses 2 'torn.c:1: this bracket' $mutate --list "$work/torn.c"

# More of them for the library, where names say which is which.
cat >"$work/more.c" <<'END'
static const double table[] = {0.5, 3.0};
double most(double a, double b)
{
    double *x = malloc(sizeof *x * 2 + 7), room[3], seen[5];
    use(room, seen, sizeof seen);
    return fmax(a, b) + 0.25;
}
END
$mutate --more --list "$work/more.c" >"$work/list"
makes scale 'static const double table[] = {0.5, 3.0};' \
    'static const double table[] = {0.59999999999999998, 3.0};'
makes constant 'static const double table[] = {0.5, 3.0};' \
    'static const double table[] = {0.5, 2.0};'
makes least-most 'return fmax(a, b) + 0.25;' 'return fmin (a, b) + 0.25;'
x='double *x = malloc(sizeof *x * 2 + 7), room[3], seen[5];'
makes constant "$x" 'double *x = malloc(sizeof *x * 2 + 6), room[3], seen[5];'
makes constant "$x" 'double *x = malloc(sizeof *x * 2 + 7), room[2], seen[5];'
makes constant "$x" 'double *x = malloc(sizeof *x * 2 + 7), room[3], seen[6];'
never 'double *x = malloc(sizeof *x * 2 + 8), room[3], seen[5];'
never 'return fmax(b, a) + 0.25;'

# The draw knows no paths and no lines, but the seed and the function.
ranks() { $mutate --more --rank "$1" "$2" | awk -F ' :: ' '{ print $1, $4, $7 }'; }
ranks seven "$work/more.c" >"$work/ranks"
mkdir "$work/moved"
{ echo && cat "$work/more.c"; } >"$work/moved/more.c"
ranks seven "$work/moved/more.c" >"$work/moved/ranks"
holds 'a file that has moved has the same ranks' \
    cmp "$work/ranks" "$work/moved/ranks"
ranks eight "$work/more.c" >"$work/moved/ranks"
holds 'another seed gives others' \
    test "$(sort -u "$work/ranks" "$work/moved/ranks" | wc -l)" -eq \
    $((2 * $(sort -u "$work/ranks" | wc -l)))
holds 'ranks lie between 0 and 1, and are all over' \
    awk '$1 <= 0 || $1 >= 1 { bad = 1 } $1 < 0.5 { ++low }
    END { exit bad || low < NR / 4 || low > 3 * NR / 4 }' "$work/ranks"
holds 'the function is named' grep -q ' most return fmin' "$work/ranks"

# Ten small mistakes in the library, of a fixed seed, in files whose tests take
# no time: all are seen.
export EQUAL=tests/mutants/equal-in-library.txt
holds 'the list of the equal ones is in order' env CHECK=1 tests/mutants/library
for wrong in 'record :: f :: constant :: a :: b :: no such mutant' 'record :: f'
do
    echo "$wrong" >"$work/equal.txt"
    EQUAL=$work/equal.txt CHECK=1 tests/mutants/library >"$work/out" 2>"$work/err"
    holds "an entry is refused: $wrong" test $? -eq 2
done
quick=
for name in checkpoint closed record blocks schedule jacobi piston; do
    quick="$quick $(sed -n 8p build/tests/mutants/library-flags |
        tr ' ' '\n' | grep "/$name\.c\$")"
done
# shellcheck disable=SC2086
COUNT=10 UNITS=1 JOBS=1 SEED=d LEAST=100 tests/mutants/library $quick >"$work/ten"
holds 'ten mutants of the library are killed' sh -c "
    sed -n '/^Survivors/,\$p' $work/ten; grep -q '^10 of 10 killed' $work/ten"

# A list of mutants that are equal in effect must name mutants that there are
# and that survive.
wrong_list() { # ENTRY PATTERN
    echo "$1" >"$work/equal.txt"
    EQUIVALENT=$work/equal.txt tests/mutants/run 01a >"$work/out" 2>"$work/err"
    status=$?
    holds "an entry is refused: $2" sh -c "
        cat $work/err; [ $status -eq 2 ] &&
        grep -q 'mutants: $work/equal.txt:1: $2' $work/err"
}
line='v[0] = 2.0 * centre - u1;'
wrong_list "01a :: constant :: $line :: v[0] = 7.0 * centre - u1; :: why not" \
    'there is no such mutant of 01a'
wrong_list "01a :: constant :: $line :: v[0] = 3.0 * centre - u1;" \
    'want EXERCISE'
wrong_list "01a :: constant :: $line :: v[0] = 3.0 * centre - u1; :: why not" \
    'this mutant is not equal in effect: failed'
holds 'the table has a row and a total' sh -c \
    "grep -q '^01a  *[0-9]' $work/out && grep -q '^total ' $work/out"
echo 1..65
