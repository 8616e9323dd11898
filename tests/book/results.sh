#!/bin/sh
# A number in the prose that leaves its range, or is not there, ends the build
# with the file, the line, what was found and the range.
. tests/programs/common
mkdir -p "$work/chapters/press" "$work/build/runs" "$work/plots/data"
cp chapters/press/results "$work/chapters/press/"
cd "$work" || exit 1
cat >build/runs/drift.summary <<'END'
energy_error -5.1234e-13
count 31415926
wrong 3.2e-9
big 1234567.5
small 0.0123456789
one 1e-16
form smaller
huge 12345678901234567891
END
printf '# form time cost\nsmaller 1.5 3.25\n' >plots/data/01-timing.dat

tex() { # the TeX that one \result gives
    printf '%s\n' "$1" >chapters/01-x.nw
    chapters/press/results out.tex 2>&1 && sed 's/^\\setresult{[^}]*}{\(.*\)}$/\1/' out.tex
}
refused() { # name text message
    printf 'one\ntwo\n%s\n' "$2" >chapters/01-x.nw
    rm -f out.tex
    said=$(chapters/press/results out.tex 2>&1)
    is "$1" "1 $3" "$? $said"
    [ ! -e out.tex ] || not_ok "$1" 'wrote out.tex all the same'
}

is 'two digits, unless told' '-5.1\times 10^{-13}' \
    "$(tex '\result[-6e-13 to -4e-13]{drift}{energy_error}')"
is 'a modulus with one digit' '5\times 10^{-13}' \
    "$(tex '\result[abs 4e-13 to 6e-13, 1 digit]{drift}{energy_error}')"
is 'an exact count in groups of three' '31\,415\,926' \
    "$(tex '\result[=31415926]{drift}{count}')"
is 'a count beyond 2^53 is compared digit by digit' \
    "chapters/01-x.nw:1: \\result{drift}{huge} is 12345678901234567891, not 12345678901234567890" \
    "$(tex '\result[=12345678901234567890]{drift}{huge}')"
is 'more digits than a power of ten needs' '1\,234\,568' \
    "$(tex '\result[1e6 to 2e6, 7 digits]{drift}{big}')"
is 'a plain decimal' '0.0123' \
    "$(tex '\result[0 to 1, 3 digits]{drift}{small}')"
is 'a range over two lines' '0.012' "$(tex '\result[0
  to 1]{drift}{small}')"
is 'a word' '\text{smaller}' "$(tex '\result[=smaller]{drift}{form}')"
is 'a committed table' '3.2' \
    "$(tex '\datum[1 to 5]{plots/data/01-timing.dat}{smaller}{3}')"
printf '# machine: one\n# a\n1 2\n3 4\n\n# b\n1 5\n' >plots/data/02-two.dat
is 'a row under a heading' '4' \
    "$(tex '\datum[=4]{plots/data/02-two.dat}{a:2}{2}')"
is 'the same number in the other one' '5' \
    "$(tex '\datum[=5]{plots/data/02-two.dat}{b:1}{2}')"
refused 'a row too far under a heading' \
    '\datum[=5]{plots/data/02-two.dat}{b:2}{2}' \
    'chapters/01-x.nw:3: \datum{plots/data/02-two.dat}{b:2}{2}: plots/data/02-two.dat has no "b:2"'
is 'code, comments and quotes are not read' '' "$(tex '<<x.c>>=
\result{a}{b}
@
% \result{a}{b}
50 \% [[\result{a}{b}]]')"

refused 'out of range' '\result[4e-13 to 9e-13]{drift}{wrong}' \
    'chapters/01-x.nw:3: \result{drift}{wrong} is 3.2e-9, not in 4e-13 to 9e-13'
refused 'the sign counts' '\result[4e-13 to 9e-13]{drift}{energy_error}' \
    'chapters/01-x.nw:3: \result{drift}{energy_error} is -5.1234e-13, not in 4e-13 to 9e-13'
refused 'no range' '\result{drift}{wrong}' \
    'chapters/01-x.nw:3: \result{drift}{wrong}: states no range, such as [4e-13 to 9e-13]'
refused 'no such key' '\result[0 to 1]{drift}{lost}' \
    'chapters/01-x.nw:3: \result{drift}{lost}: build/runs/drift.summary has no "lost"'
refused 'no such run' '\result[0 to 1]{lost}{lost}' \
    'chapters/01-x.nw:3: \result{lost}{lost}: cannot read build/runs/lost.summary'
refused 'another count' '\result[=31428489]{drift}{count}' \
    'chapters/01-x.nw:3: \result{drift}{count} is 31415926, not 31428489'
refused 'another word' '\result[0 to 1]{drift}{form}' \
    'chapters/01-x.nw:3: \result{drift}{form} is smaller, which is no number'
echo 1..20
