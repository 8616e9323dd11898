#!/bin/sh
# The shape of the kit: what stands at the top, which module may include
# which, one layout for all C, no warnings from two compilers, and a README
# whose commands are those that are tested.
. tests/programs/common

allowed='Makefile README.md LICENSE CHANGELOG.md CONTRIBUTING.md SECURITY.md CITATION.cff
chapters src exercises
solutions tests plots build compile_commands.json'
# The reader's own files are the reader's: with git, only what is committed
# counts; an archive is not judged.
kept() { # PATTERN...
    if [ -e .git ]; then git ls-files -- "$@"; else ls -d "$@"; fi
}
strangers=
[ -e .git ] && for name in $(kept | sed 's/\/.*//' | grep -v '^\.' | sort -u); do
    case " $(echo $allowed) " in
    *" $name "*) ;;
    *) strangers="$strangers $name" ;;
    esac
done
holds 'all that belongs at the top is there' \
    ls Makefile README.md LICENSE CHANGELOG.md CONTRIBUTING.md SECURITY.md CITATION.cff \
    chapters src exercises \
    solutions tests plots .clang-format .editorconfig .gitignore .ci/run
holds 'nothing else at the top' \
    sh -c "echo '$strangers'; test -z '$strangers'"

# Who comes in by the front door can read it.
holds 'the Makefile is two pages' sh -c '[ "$(wc -l <Makefile)" -le 132 ]'

# The exercises as they are committed are the stubs as they came, under the
# names that the suites give.
blobs() { git ls-files -s -- "$@" | cut -d ' ' -f 2; }
names() {
    for suite in tests/exercises/*/suite.c; do
        ex=$(basename "$(dirname "$suite")")
        sed -n "s/^ *\.file = \"\($ex-[a-z-]*\.c\)\",\$/\1/p" "$suite"
    done
}
[ -e .git ] && holds 'the exercises are the stubs' \
    [ "$(blobs exercises)" = "$(blobs 'tests/exercises/*/stub.c')" ]
[ -e .git ] && for folder in exercises solutions; do
    holds "$folder/ has the files that the suites name" \
        [ "$(kept $folder | sed -n 's/.*\///; /\.c$/p')" = "$(names)" ]
done

# The rooms of src/: a file includes its own room or one before it; programs
# and studies are two roofs, which nothing includes, and so is the page, what
# runs in a browser; the examiner has a house of its own and takes nothing but
# tools. And no literate module includes a literate one of a later chapter: the book
# is read in the order of its chapters.
rooms='toolbox line box scenes forces choosing programs studies'
# included: every `FILE INCLUDED` of src/, with their chapters or 0.
included() {
    (cd src && awk '
        FNR == 1 && /^\/\* From chapters\// { own[FILENAME] = substr($3, 10) + 0 }
        /^#include "/ { split($0, part, "\""); from[++n] = FILENAME
            to[n] = part[2] }
        END { for (i = 1; i <= n; ++i) print from[i], to[i],
            own[from[i]] + 0, own[to[i]] + 0 }' */*.[ch])
}
# misplaced: which of these may not be, and why.
misplaced() {
    awk -v rooms="$rooms" 'BEGIN {
            for (n = split(rooms, room); n; --n) place[room[n]] = n }
        function may(own, its) {
            if (its == "programs" || its == "studies") return 0
            if (its == "examiner" || its == "page") return own == its
            return its == "toolbox" || its == own || its in place &&
                own != "examiner" &&
                (!(own in place) || place[its] < place[own])
        }
        $3 && $4 > $3 { print "src/" $1 ": " $2 " of chapter " $4 }
        { own = $1; its = index($2, "/") ? $2 : $1
            sub("/.*", "", own); sub("/.*", "", its) }
        !may(own, its) { print "src/" $1 ": " $2 " stands in a room that " \
            own " may not look into" }'
}
wrong=$(for room in src/*/; do
    case " $rooms examiner page " in
    *" $(basename "$room") "*) ;;
    *) echo "$room is no room of the house" ;;
    esac
done; included | misplaced)
holds 'no module includes one of a later chapter or of a later room' \
    sh -c "echo '$wrong'; test -z '$wrong'"
seen=$(misplaced <<'END'
toolbox/table.c line/collide.h
box/disks.c forces/stepping.h
examiner/check.c line/collide.h
line/start.c examiner/text.h
programs/disks.c studies/x.h
studies/x.c studies/y.h
box/disks.c page/page.h
programs/disks.c page/page.h
box/disks.c box/calendar.h 5 7
END
)
none=$(printf '%s\n' 'forces/hard.c box/disks.h' 'page/page.c forces/hard.h' \
    'box/calendar.c box/disks.h 7 5' | misplaced)
holds 'and one that does is seen' test -z "$none" \
    -a "$(echo "$seen" | wc -l)" = 9 -a "$(included | wc -l)" -gt 300

# Right answers as they are tried: the files need not be whole.
for folder in tests/exercises/[0-9P]*/; do
    ex=$(basename "$folder")
    tests/exercises/answers "$ex" "$work/answers/$ex" || echo "not ok layout: answers $ex"
done
rights=$(ls "$work"/answers/*/right-*.c "$work"/answers/*/plain.c)
c_files="$(ls src/*/*.c tests/library/*.c tests/stability/*.c \
    tests/tools/*.c tests/fuzz/*.c tests/mutants/*.c solutions/*.c \
    tests/exercises/*/[hs]*.c tests/exercises/*/remote.c tests/grader/*.c) $rights"
xml="-I/usr/include/libxml2 $(pkg-config --cflags libxml-2.0 2>/dev/null)"
# How a file is laid out depends on the version; these agree about all of ours.
version=$(clang-format --version | sed -n 's/.*version \([0-9]*\).*/\1/p')
all_in='the layout of every C file is .clang-format'
case $version in
1[4-9])
    holds "$all_in" clang-format --dry-run -Werror src/*/*.[ch] tests/*.h \
        tests/library/*.[ch] tests/stability/*.c tests/tools/*.[ch] tests/fuzz/*.c \
        tests/mutants/*.c tests/exercises/*/*.[ch] tests/grader/*.c \
        tests/examiner/*.c solutions/*.c ;;
*) echo "skipped layout: $all_in - clang-format $version may have another opinion;" \
    'versions 14 to 19 agree' ;;
esac
# Its versions do not agree about a macro whose body is a list in braces.
braces() { # FILE...: macros of this kind that clang-format lays out
    awk '/clang-format off/ { off = 1 } /clang-format on/ { off = 0 }
        macro && !off && /^ *\{/ { print FILENAME ":" FNR }
        { macro = /^#define .*\\$/ || /^ *[(].*[]][)] *\\$/ }' "$@"
}
holds 'no macro is a list in braces, but for those laid out by hand' \
    test -z "$(braces src/*/*.[ch] tests/*.h tests/*/*.[ch] tests/*/*/*.[ch])"
printf '#define LIST(x) \\\n    {x}\n' >"$work/braces.c"
holds 'and one that is is seen' test "$(braces "$work/braces.c")" = "$work/braces.c:2"
# Both compilers read all files. What clang would start anew for each of them,
# which takes longer than to read it, is told all in one.
warnings='-Wall -Wextra -pedantic -Werror -O2 -fsyntax-only'
quiet() { # COMPILER FLAGS FILE...: it says nothing
    cc=$1 flags=$2
    shift 2
    case $cc in
    clang)
        # shellcheck disable=SC2086
        "$cc" $flags $warnings -### "$1" 2>&1 |
            sed -n '$s/"-disable-free"//; $s/"[^"]*"$/"$@"/p' >"$work/reads"
        grep -q -e '-cc1' "$work/reads" && . "$work/reads" ;;
    # shellcheck disable=SC2086
    *) "$cc" $flags $warnings "$@" ;;
    esac
}
printf 'int sound(void);\n' >"$work/sound.c"
printf 'void sound(void) { int unused; }\n' >"$work/unsound.c"
unseen=
# The remote calls that are made from a call.h are read as well.
for file in tests/exercises/*/call.h; do
    ex=$(basename "$(dirname "$file")")
    awk -f tests/remote.awk "$file" >"$work/remote-$ex.c"
done
remotes=$(ls tests/exercises/*/remote.c "$work"/remote-*.c)
c_files="$c_files $(ls "$work"/remote-*.c)"
# Stubs and right answers tests/exercises/all.sh has compiled, with the same
# warnings for errors, by the compiler of the exercises: where that is gcc, gcc
# does not read them twice.
read -r checks _ <build/check/flags
known() { "$1" -dM -E -x c /dev/null 2>&1; }
if [ "$(known "$checks")" = "$(known gcc)" ]; then
    twice=$(ls solutions/[0-9]*.c tests/exercises/[0-9]*/stub.c &&
        printf '%s\n' $rights | grep -v '/P[0-9]/')
else
    twice=
fi
printf '%s\n' $c_files | grep -vxF -e "${twice:-none}" >"$work/gcc"
printf '%s\n' $c_files >"$work/clang"
for cc in gcc clang; do
    # shellcheck disable=SC2046,SC2086
    holds "no warning from $cc" quiet $cc "-std=c11 -D_POSIX_C_SOURCE=200809L \
        -Isrc -Isrc/examiner -Itests $xml" $(cat "$work/$cc")
    # shellcheck disable=SC2086
    holds "no warning from $cc in the sandbox's half of the remote calls" \
        quiet $cc '-std=c11 -Isrc -DREMOTE_SERVER' $remotes
    quiet $cc -std=c11 "$work/sound.c" "$work/sound.c" >"$work/said" 2>&1 &&
        ! quiet $cc -std=c11 "$work/sound.c" "$work/unsound.c" \
            "$work/sound.c" >"$work/said" 2>&1 &&
        grep -q 'unsound.c:1.*unused' "$work/said" || unseen="$unseen $cc"
done
holds 'and one in a file among others is seen' test -z "$unseen"

# Lines of the chapters are as long as an editor shows; a %run line goes on in
# the next one behind a backslash.
in_width() {
    LC_ALL=C.UTF-8 awk 'length > 100 { print FILENAME ":" FNR ": " length
        bad = 1 } END { exit bad }' "$@"
}
# shellcheck disable=SC2046
holds 'no line of a chapter has more than 100 columns' \
    in_width $(find chapters -name '*.nw')
printf '%0100d\n%0101d\n' 0 0 >"$work/wide"
holds 'and one of 101 is seen' \
    test "$(in_width "$work/wide")" = "$work/wide:2: 101"

# Modules have names of their own: who puts all objects into one folder, as
# tests/programs/bytes.sh does, would lose one of two.
twice=$(for room in ${rooms%programs*}; do ls src/"$room"/*.c; done |
    sed 's/.*\///' | sort | uniq -d | tr '\n' ' ')
holds 'no two modules have one name' sh -c "echo '$twice'; test -z '$twice'"

# Who opens a file reads first what it is: on line 1, or below the two lines of one
# that is tangled.
silent() { # FILE...: those that do not say
    awk 'FNR == 1 { if (NR > 1 && !said) print file; said = 0; file = FILENAME
            at = /^\/\* From chapters\// ? 3 : 1 }
        FNR == at { said = /^\/\* [A-Za-z].*[A-Za-z0-9)][.] \*\/$/ }
        END { if (!said) print file }' "$@"
}
holds 'each file of src/ says first what it is' \
    sh -c "echo '$(silent src/*/*.[ch])'; test -z '$(silent src/*/*.[ch])'"
printf '%s\n' 'int x;' '/* What it is. */' >"$work/silent.c"
printf '%s\n' '/* What it is. */' 'int x;' >"$work/plain.c"
printf '%s\n' '/* From chapters/a.nw. */' '/* checksum 1. */' 'int x;' >"$work/tangled.c"
holds 'and one that does not is seen' test "$(silent "$work/silent.c" "$work/plain.c" \
    "$work/tangled.c" | tr '\n' ' ')" = "$work/silent.c $work/tangled.c "

# A literate file is printed whole, and nobody reads more than six pages of code.
long_ones() { awk '/^\/\* From chapters\// && FNR == 1 { its[FILENAME] }
    FNR > 350 && FILENAME in its { long[FILENAME] } END { for (file in long) print file }' "$@"; }
holds 'no literate file has more than 350 lines' test -z "$(long_ones src/*/*.[ch])"
{ cat "$work/tangled.c" && yes 'int x;' | head -n 350; } >"$work/long.c"
holds 'and one that has is seen' test "$(long_ones "$work/long.c")" = "$work/long.c"

# The numbers of equations in comments are those of the book.
grep -ho '([0-9A-C]*\.[0-9]*, eq:[a-z-]*)' -r src tests/exercises chapters |
    sort -u | sed 's/[(),]//g' >"$work/pairs"
while read -r number label; do
    grep -qx "$label $number" tests/equations.txt ||
        not_ok 'equation numbers in comments' \
            "($number, $label); tests/equations.txt has $(grep "^$label " \
                tests/equations.txt)"
done <"$work/pairs"
holds 'equation numbers in comments are the book'"'"'s' test -s "$work/pairs"

grep '^sh .ci/install' README.md >"$work/commands"
holds 'the README has two commands' \
    test "$(wc -l <"$work/commands")" -eq 2
holds 'the gate runs the second' \
    grep -qxF "$(sed -n 2p "$work/commands")" .ci/run
holds 'make help names every target a reader may want' sh -c '
    ${MAKE:-make} -s help >'"$work"'/help
    for goal in check watch hint progress solution reset book site handout grade grade-bench figures figure contact movie \
        movies inspect chart test programs bench memcheck \
        mutants fuzz hunt jobs debug tangle check-tangle format compile_commands.json clean; do
        grep -q "^make $goal " '"$work"'/help || { echo "$goal"; exit 1; }
    done'

# The file for editors is JSON with one entry a source file.
${MAKE:-make} -s compile_commands.json
holds 'compile_commands.json has every source' \
    test "$(grep -c '"file":' compile_commands.json)" -eq \
    "$(ls src/*/*.c | wc -l)"
echo 1..28
