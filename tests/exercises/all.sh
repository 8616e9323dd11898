#!/bin/sh
# What every exercise must have, and what the examiner must say about it:
# a pristine stub that is not begun, a solution and other right answers that
# pass, wrong answers that are recognised, hints, and equations that the book
# has. Nothing here reads exercises/: those files are the student's own.
#   tests/exercises/all.sh [EXERCISE]...      all, or 01a
set -u
examine=build/check/examine
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM

# verdict NAME WHY COMMAND...: one line of result.
verdict() {
    name=$1 why=$2
    shift 2
    if "$@"; then
        echo "ok exercises: $name"
    else
        echo "not ok exercises: $name - $why"
    fi
}

# says STATUS STATE: what the examiner is asked about $file must end with
# that status and have that state in its first line.
says() {
    want=$1 state=$2
    shift 2
    "$examine" "$@" --as "$ex" --file "$file" >"$out/said" 2>&1
    [ $? -eq "$want" ] && read -r first <"$out/said" && case "$first " in
    *" $state "*) ;;
    *) false ;;
    esac
}

# mistake_of FILE: what its first line names, in $mistake; "" if nothing.
mistake_of() {
    read -r first <"$1"
    mistake=
    case $first in
    '/* mistake: '*' */') mistake=${first#*: } mistake=${mistake% *} ;;
    esac
    case $mistake in *[!a-z0-9-]*) mistake= ;; esac
}

# Its author is told of this mistake, and of no other.
recognised() { # MISTAKE
    says 1 failed --strict && [ "$(grep -c '^  hint ' "$out/said")" -eq 1 ] &&
        [ "$(sed -n '/^  hint /,$p' "$out/said" |
            grep -o '\[[a-z][a-z0-9-]\{2,\}\]$')" = "[$1]" ]
}

# A wrong answer whose value several mistakes share, or that none explains:
# it is refused, and its author is accused of nothing.
unnamed() {
    says 1 failed --strict && ! grep -q '^  hint ' "$out/said"
}

# A wrong answer makes $mistake, as they are listed in $made.
is_made() {
    case $made in
    *"[$mistake]"*) ;;
    *) false ;;
    esac
}

# An answer under the name by which it is known, wherever it was written.
its_name() { echo "$file" | sed 's/^build.tests.answers/tests\/exercises/'; }

count() { # FILE...: how many there are; a pattern that matched none is not
    n=0
    for f; do
        [ -f "$f" ] && n=$((n + 1))
    done
    echo "$n"
}

# The hints of a file, each on one line.
hints() {
    awk '/^--$/ { print text; text = ""; next }
         { text = text (text == "" ? "" : " ") $0 } END { print text }' "$1"
}

wordy() { # every hint has 30 to 60 words and asks something
    hints "$1" | awk 'NF < 30 || NF > 60 || !/[?]/ { bad = 1 }
                      END { exit bad || NR < 3 }'
}

# The last hint names sections of the chapter, in double quotes.
sections_named() {
    hints "$1" | tail -n 1 | grep -o '"[^"]*"' | tr -d '"' >"$out/named"
    [ -s "$out/named" ] || return 1
    while IFS= read -r title; do
        grep -q -F "\\section{$title}" chapters/"${ex%?}"-*.nw || return 1
    done <"$out/named"
}

# A stub that somebody has touched without filling its gap.
touched_stub() {
    file=$out/${stub##*/}
    { cat "$stub" && echo '/* my first line */'; } >"$file"
    says 0 'not begun' --strict
}

has_one_gap() {
    [ "$(grep -c 'TODO:' "$1")" -eq 1 ] && grep -q 'NOT_DONE_YET(' "$1"
}

[ -x "$examine" ] || {
    echo "not ok exercises - $examine is missing: make check"
    exit 1
}

. tests/exercises/linker
[ -z "$linker" ] || export COMPILER_PATH="$linker"

[ $# -gt 0 ] || set -- $(ls solutions | grep '^[0-9]' | cut -c 1-3)
for ex; do
    folder=tests/exercises/$ex answers=build/tests/answers/$ex
    tests/exercises/answers "$ex" "$answers" ||
        echo "not ok exercises: $ex: its answers - tests/exercises/answers fails"
    suite=$folder/suite.c stub=$folder/stub.c
    called=$(sed -n 's/^ *\.file = "\(.*\)",$/\1/p' "$suite")

    file=$stub
    verdict "$ex: the pristine stub is not begun" \
        "see $examine --as $ex --file $file" says 0 'not begun' --strict
    verdict "$ex: a stub with its gap is not begun" \
        'its NOT_DONE_YET is not reached, or it does not build' touched_stub
    verdict "$ex: the stub has one gap" \
        'it wants one TODO: and a NOT_DONE_YET' has_one_gap "$stub"

    for file in "solutions/$called" "$answers"/right-*.c "$answers"/plain.c; do
        [ -e "$file" ] || continue
        verdict "$(its_name) passes" "see $examine --strict --as $ex --file $file" \
            says 0 passed --strict
    done
    verdict "$ex: two right answers or more" "fewer in $folder" \
        [ "$(count "$answers"/right-*.c)" -ge 2 ]

    made=
    for file in "$answers"/wrong-*.c; do
        mistake_of "$file"
        if [ "$mistake" = none ]; then
            verdict "$(its_name) is refused, and no mistake is named" \
                "see $examine --strict --as $ex --file $file" unnamed
            made=$made[$(sed -n '2s,^/\* unnamed: \([a-z0-9-]*\) \*/$,\1,p' \
                "$file")]
            continue
        fi
        made="$made[$mistake]"
        verdict "$(its_name) is refused as [$mistake]" \
            "see $examine --strict --as $ex --file $file" \
            recognised "${mistake:-without a name in line 1}"
    done
    verdict "$ex: three wrong answers or more" "fewer in $folder" \
        [ "$(count "$answers"/wrong-*.c)" -ge 3 ]
    # Names in the suite's lists of mistakes, with no space in them.
    tr '\n' ' ' <"$suite" | grep -o '{ *"[a-z0-9-]*",' | tr -d '{", ' | sort -u |
        while IFS= read -r mistake; do
            verdict "$ex: [$mistake] has a wrong answer" \
                "none in $folder makes this mistake" is_made
        done

    verdict "$ex: three hints or more, of 30 to 60 words, that ask" \
        "see $folder/hints.txt" wordy "$folder/hints.txt"
    verdict "$ex: the last hint names a section" \
        'no "Section" in it that the chapter has' \
        sections_named "$folder/hints.txt"

    grep -o '"eq:[a-z0-9-]*"' "$suite" | tr -d '"' | sort -u >"$out/labels"
    verdict "$ex: the suite names an equation" 'none found' \
        [ -s "$out/labels" ]
    while IFS= read -r label; do
        verdict "$ex: the book has $label" 'not in tests/equations.txt' \
            grep -q "^$label " tests/equations.txt
    done <"$out/labels"
done
# Of each exercise nine checks, one for each answer but the solution, and one
# for each mistake and each equation that its suite names.
planned=0
named() {
    tr '\n' ' ' <"tests/exercises/$ex/suite.c" | grep -o "$1" | tr -d ' ' | sort -u | wc -l
}
for ex; do
    planned=$((planned + 9 + $(ls build/tests/answers/"$ex" | wc -l) + $(named '{ *"[a-z0-9-]*",') +
        $(named '"eq:[a-z0-9-]*"')))
done
echo "1..$planned"
