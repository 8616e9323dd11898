#!/bin/sh
# No exercise asks for code that the book prints: no function of a solution
# or of a right answer shares a long run of tokens with a function in src/,
# whatever the names in it. Only 01a stands before its chunk and is left out.
# And no exercise may be linked with the physics that solves it.
#
# How long is long? A loop over an array, `for (size_t i = 0; i < n; ++i) {`,
# has 14 tokens, and so had the longest run found by chance when this was
# written; a formula of the book, such as the line of collide.c that
# takes the restitution into account, has more than 20.
set -u
tokens=build/tests/tokens
limit=20
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM

[ -x "$tokens" ] || {
    echo "not ok exercises - $tokens is missing: make test"
    exit 1
}
book=$(find src -name '*.c')

# compare FILE...: 0 when nothing long is shared, 1 when something is.
compare() {
    # shellcheck disable=SC2086
    "$tokens" --shared "$limit" "$@" -- $book >"$out/shared" 2>&1
}

for folder in tests/exercises/[0-9P]*/; do
    ex=$(basename "$folder")
    tests/exercises/answers "$ex" "$out/answers/$ex" || echo "not ok exercises - $ex"
done

# All of them at once, so that src/ is read once.
set --
for file in solutions/*.c "$out"/answers/*/right-*.c; do
    case $file in
    solutions/01a-* | */answers/01a/*) ;;
    *) set -- "$@" "$file" ;;
    esac
done
compare "$@"
status=$?
if [ $status -gt 1 ] || ! grep -q '^longest [0-9]' "$out/shared"; then
    echo "not ok exercises: the answers are compared with src/ -" \
        "$(head -n 1 "$out/shared")"
fi
cp "$out/shared" "$out/all"
told=0
for file; do
    name=$(echo "$file" | sed "s,^$out/answers,tests/exercises,")
    if grep "^$file:" "$out/all" >"$out/its"; then
        told=$((told + 1))
        echo "not ok exercises: $name - $(head -n 1 "$out/its")"
    else
        echo "ok exercises: $name owes nothing to src/"
    fi
done
[ $((status == 0)) -eq $((told == 0)) ] ||
    echo "not ok exercises - $tokens ends with $status, $told answers named"

# The rule must be able to fail: a copy of the book's code with every name
# changed, spaced and commented in another way, is found out, and so is a
# few statements of it in a function of one's own.
sed -e 's/im1/weight/g; s/im2/other/g; s/v1/left/g; s/v2/right/g' \
    -e 's/restitution/bounce/g; s/split/mine/g; s/const //' \
    -e 's/;/; \/\* mine \*\//' src/line/collide.c >"$out/copy.c"
if compare "$out/copy.c"; then
    echo "not ok exercises: a renamed copy of collide.c is found out - it" \
        "was not"
else
    echo "ok exercises: a renamed copy of collide.c is found out"
fi
statement=$(grep -m 1 -A 2 'split((1 + restitution) \* (\*v1' src/line/collide.c)
[ -n "$statement" ] || echo "not ok exercises - collide.c has lost the" \
    "statement that this test looks for: choose another"
printf 'double f(double a)\n{\n    a = 1;\n%s\n    return a;\n}\n' \
    "$statement" | sed 's/restitution/e/g; s/v1/p/g; s/v2/q/g' \
    >"$out/line.c"
if compare "$out/line.c"; then
    echo "not ok exercises: three statements of the book are found out - they were" \
        "not"
else
    echo "ok exercises: three statements of the book are found out"
fi

# Only the C library, the exercise's own header and the random numbers, which
# are all that a runner is linked with.
for what in stub solution right wrong; do
    case $what in
    stub) set -- tests/exercises/*/stub.c ;;
    solution) set -- solutions/*.c ;;
    right) set -- "$out"/answers/*/right*.c "$out"/answers/*/plain.c ;;
    wrong) set -- "$out"/answers/*/wrong*.c ;;
    esac
    if grep -n '^ *# *include *"' "$@" |
        grep -v '"exercise\.h"\|"collide\.h"\|"force\.h"\|"toolbox/random\.h"' >"$out/includes"; then
        echo "not ok exercises: $what includes no physics -" \
            "$(head -n 1 "$out/includes")"
    else
        echo "ok exercises: $what includes no physics"
    fi
done
# One for each answer but 01a's, and six.
echo "1..$(($(ls solutions/*.c "$out"/answers/*/right-*.c |
    grep -c -v '/01a[-/]') + 6))"
