#!/bin/sh
# Every limit that the text of an exercise names is visited by its suite, from
# both sides. The list of limits is made from the texts, of the stub and of the
# chapter; where a suite visits one, a comment says so:
#   /* limit: 1e-9 m/s (what is meant, if that is not plain) */
# and a limit without such a comment is an error, so that nobody can write one
# into a text and forget the test. Whether a test does visit both sides is for
# the wrong answers beside it to show.
#   tests/exercises/limits.sh [EXERCISE]...    all, or 01a
set -u
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM

# limits_of TEXT: the numbers in it that are limits, one a line: all that are
# written with an exponent; what follows `at least` and its like, or goes
# before `or more`; both ends of a range; epsilons, and digits that are to be
# right. TeX's 10^{-9} is 1e-9 here. Not a limit of the answer is what the
# check provides, where zero is one end, and the number of a century.
limits_of() {
    tr '\n~' '  ' <"$1" | sed -e 's/[$]//g; s/\\,//g' \
        -e 's/\\le\([ 0-9]\)/ at most \1/g; s/\\ge\([ 0-9]\)/ at least \1/g' \
        -e 's/10^{\(-[0-9]*\)}/1e\1/g; s/2^{\(-[0-9]*\)}/1p\1/g' \
        -e 's/  */ /g; s/\([0-9]\), or /\1 or /g' \
        -e 's/provides: a number from 0 to below 1//g' \
        -e 's/\bone epsilon/1 epsilon/g; s/\btwo epsilon/2 epsilon/g' \
        -e 's/\bfour epsilon/4 epsilon/g; s/\bten epsilon/10 epsilon/g' \
        -e 's/twelve digits/12 digits/g' >"$out/flat"
    number='[0-9]+(\.[0-9]+)?'
    {
        grep -oE "(^|[^a-z0-9.^{])$number[ep]-?[0-9]+" "$out/flat"
        grep -oE "(at least|at most|up to|less than|more than|larger than|smaller than|below) $number( |,|;|:|\.)" \
            "$out/flat"
        grep -oE "(^|[^0-9.^])$number ([a-z]+ )?(or more|or less|or fewer|and more|at most)" \
            "$out/flat"
        grep -oE "(^|[^0-9.e-])$number to (below )?$number" "$out/flat" |
            sed 's/ to / /; s/below //' | tr ' ' '\n'
        grep -oE "$number (DBL_EPSILON|epsilon)" "$out/flat"
        grep -oE "$number digits" "$out/flat" | sed 's/\([0-9]*\).*/1e-\1/'
    } | grep -oE "$number([ep]-?[0-9]+)?" | grep -vx 0 | sort -u
}

# texts_of EXERCISE: what its stub and its chapter say; of a project, the
# contract, without the header that is printed in it.
texts_of() {
    case $1 in
    P*)
        sed -n "/^.texttt{$1 [A-Za-z]/,/^.subsection{The stages}/p" \
            $(grep -l "^.texttt{$1 [A-Za-z]" chapters/[0-9]*.nw) |
            sed '/^<<.*>>=$/,/^@$/d'
        ;;
    *)
        sed '/^   Check your answer/,$d' "tests/exercises/$1/stub.c"
        sed -n "/^.begin{exercise}{$1}/,/^.end{exercise}/p" \
            chapters/"${1%?}"-*.nw | sed 1d
        ;;
    esac
}

# unvisited LIMITS SUITE...: those that no comment of a suite names.
unvisited() {
    limits=$1
    shift
    sed -n 's,^.*/\* limit: \([^ ]*\).*$,\1,p' "$@" | sort -u >"$out/visited"
    grep -vxFf "$out/visited" "$limits"
}

[ $# -gt 0 ] || set -- $(ls tests/exercises | grep '^[0-9P].*[0-9a-z]$')
for ex; do
    texts_of "$ex" >"$out/text"
    limits_of "$out/text" >"$out/limits"
    if forgotten=$(unvisited "$out/limits" "tests/exercises/$ex/suite.c" \
        $(ls "tests/exercises/$ex/hidden.c" 2>/dev/null)); then
        echo "not ok limits: $ex visits what its text names -" \
            "no /* limit: ... */ in its suite for" $forgotten
    else
        echo "ok limits: $ex visits what its text names"
    fi
done

# It can fail: a limit that a text names and a suite does not is seen, and so
# are all the ways in which texts name one.
cat >"$out/text" <<'TEXT'
   a speed, zero, or 1e-9 m/s and more; at least 3 of them, 7 or more; from 2
   to 100, wrong by ten epsilons (DBL_EPSILON), or $10^{-13}$ of the larger;
   gaps down to $2^{-26}$; a number below~5, to twelve digits
TEXT
limits_of "$out/text" >"$out/limits"
if [ "$(tr '\n' ' ' <"$out/limits")" = \
    '10 100 1e-12 1e-13 1e-9 1p-26 2 3 5 7 ' ]; then
    echo 'ok limits: all ways of naming one are read'
else
    echo 'not ok limits: all ways of naming one are read - only' \
        $(cat "$out/limits")
fi
printf '%s\n' 10 1e-12 1e-13 1p-26 100 2 3 5 7 | sed 's,.*,/* limit: & */,' \
    >"$out/suite"
if [ "$(unvisited "$out/limits" "$out/suite")" = 1e-9 ]; then
    echo 'ok limits: one that no suite visits is seen'
else
    echo 'not ok limits: one that no suite visits is seen - it was not'
fi
echo "1..$(($# + 2))"
