#!/bin/sh
# A part of `make memcheck': the runs of all programs that summary.sh has, and
# six unit tests, under the sanitizers: that of the page's player, which else
# runs in a browser, and five that the commit draws, so that in two dozen
# commits most have had their turn. Those are left out that take a
# second and more of such a run; make memcheck has them all.
. tests/programs/common
root=$PWD
ASAN_OPTIONS=allocator_may_return_null=1 # it is asked for too much
export ASAN_OPTIONS

others='player adaptive averages bites bonkers cells choose disks gravity_tree impact
laws models sampling springs statistics toolbox_digits toolbox_random'
seed=$(git rev-parse HEAD 2>"$work/said" || cksum CHANGELOG.md)
drawn="player $(for file in tests/library/*.c; do
    name=$(basename "$file" .c)
    case " $(echo $others) " in *" $name "*) continue ;; esac
    echo "$(echo "$seed $name" | cksum | cut -d ' ' -f 1) $name"
done | sort -n | sed 's/.* //; 5q')"
programs=$(ls build/bin)

# shellcheck disable=SC2046,SC2086
holds 'the sanitized programs and tests are built' ${MAKE:-make} -s \
    $(printf 'build/sanitized/bin/%s ' $programs) \
    $(printf 'build/memcheck/library/%s ' $drawn)

# They complain on standard error and end with a status of their own.
sanitized() { # NAME COMMAND...
    what=$1
    shift
    if ! "$@" >"$work/ran" 2>&1 </dev/null; then
        not_ok "$what" "it fails: $(tail -n 3 "$work/ran" | tr '\n' ' ')"
    elif grep -q -e '^not ok' -e 'runtime error' -e 'ERROR: .*Sanitizer' "$work/ran"; then
        not_ok "$what" "$(grep -m 1 -e '^not ok' -e 'runtime error' \
            -e 'ERROR: .*Sanitizer' "$work/ran")"
    else
        ok "$what"
    fi
}
sanitized 'runs of all programs' \
    env BIN=build/sanitized/bin tests/programs/summary.sh

# In a folder of their own, for the same tests may run beside these and write
# to the same files.
mkdir -p "$work/here/build/tests"
ln -s "$root/tests" "$work/here/tests"
for name in $drawn; do
    cd "$work/here" || exit 1
    sanitized "the tests of $name" "$root/build/memcheck/library/$name"
    cd "$root" || exit 1
done

# What is wrong is seen: a byte behind the room, and a step too far down.
cat >"$work/wrong.c" <<'END'
#include <stdio.h>
#include <stdlib.h>
int main(int argc, char *argv[])
{
    int most = 2147483647, *room = malloc(argc * sizeof *room);
    puts("ok");
    if (argv[argc - 1][0] == 'o')
        printf("%d\n", most + argc);
    else
        room[argc] = 1;
    free(room);
    return 0;
}
END
san=$(sed -n '/^sanitizers/,/[^\\]$/p' src/examiner/check.mk |
    sed 's/^sanitizers =//; s/\\$//')
# shellcheck disable=SC2086
${CC:-cc} -w $san -o "$work/wrong" "$work/wrong.c"
for wrong in overflow behind; do
    sanitized "$wrong" "$work/wrong" "$wrong" >"$work/verdict"
    holds "seen: $wrong" grep -q '^not ok' "$work/verdict"
done
echo 1..10
