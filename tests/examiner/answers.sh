#!/bin/sh
# The checks of the book's exercises are checked themselves: every stub is not
# begun, every solution and every other right answer passes with warnings as
# errors, every wrong answer is refused with the hint of its own mistake.
set -u
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

of() { name=${1##*/}; echo "${name%%-*}"; }
judge() { # condition: one line of result
    if "$@"; then echo "ok $name"; else
        echo "not ok $name - it said: $(head -c 600 "$work/out" | tr '\n' '~')"
    fi
}
examine() { build/check/examine "$@" >"$work/out" 2>&1; }
state() { sed -n '1s/^.* min  \([a-z ]*[a-z]\).*/\1/p' "$work/out"; }

stub_is_open() { # the file as it came, and changed by a blank
    examine --strict --as "$ex" --file "$1" && [ "$(state)" = 'not begun' ] &&
        { cat "$1"; echo; } >"$work/${1##*/}" &&
        examine --strict --as "$ex" --file "$work/${1##*/}" &&
        [ "$(state)" = 'not begun' ]
}
passes() {
    examine --strict --as "$ex" --file "$1" && [ "$(state)" = passed ]
}
is_refused() {
    mistake=$(sed -n '1s/^\/\* mistake: \([^ ]*\) \*\/$/\1/p' "$1")
    ! examine --as "$ex" --file "$1" && [ "$(state)" = failed ] &&
        [ -n "$mistake" ] && tr -s ' \n' ' ' <"$work/out" |
        grep -q -F "[$mistake]"
}

for file in tests/stubs/*.c; do
    ex=$(of "$file")
    name="$file is not begun"
    judge stub_is_open "$file"
    for solution in solutions/"$ex"-*.c tests/right/"$ex"-*.c; do
        name="$solution passes"
        judge passes "$solution"
    done
    for wrong in tests/wrong/"$ex"-*.c; do
        name="$wrong is refused with its own hint"
        judge is_refused "$wrong"
    done
    rights=$(ls tests/right/"$ex"-*.c 2>/dev/null | wc -l)
    wrongs=$(ls tests/wrong/"$ex"-*.c 2>/dev/null | wc -l)
    name="exercise $ex has two other right answers and three wrong ones"
    judge eval '[ "$rights" -ge 2 ] && [ "$wrongs" -ge 3 ]'
done
