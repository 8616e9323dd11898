#!/bin/sh
# A beginner waits for nothing that is not needed: what is compiled for the
# first answer from a kit that has just been unpacked, and for the next.
. tests/programs/common
export LC_ALL=C
unset CPPFLAGS CFLAGS LDFLAGS EX V MAKEFLAGS MFLAGS
make=${MAKE:-make}
copy_kit Makefile src tests exercises solutions plots chapters/press

# made GOAL...: makes it, its words in said, and prints what was compiled.
made() {
    $make "$@" >"$work/told" 2>&1
    echo $(sed -n 's/^  cc //p' "$work/told" | sort)
}
says() { grep -q -e "$1" "$work/told"; }
suite() { echo tests/exercises/$1/suite.c; }

# What the examiner consists of: its files in src that examine includes.
first=$(made hint EX=01a)
is 'a hint needs the examiner alone, and two files of the toolbox' '' "$(echo "$first" | tr ' ' '\n' |
    grep -v -e '^src/examiner/[a-z_]*\.c$' \
        -e '^src/toolbox/\(options\|replace\)\.c$')"
holds 'and not the grader' sh -c "! echo '$first' | grep 'grad\|judge\|publish'"
holds 'and is given' says 'hint 1 of'
is 'the next one needs nothing' '' "$(made hint EX=01a)"
holds 'and is the next' says 'hint 2 of'
is 'nor does one for the exercise to do next' '' "$(made hint)"
is 'nor what was done so far' '' "$(made progress)"
holds 'which is nothing of everything' says 'all .* 0 of [4-9][0-9][0-9] points'
is 'nor a file as it came' '' "$(rm exercises/03a-*; made reset EX=03a)"
holds 'which is there again' test -f exercises/03a-bins.c

is 'one exercise needs its suite, and what all suites need' \
    "$(echo $(printf 'build/check/obj/%s.o\n' examiner/check examiner/guards \
        examiner/local examiner/no_callback examiner/no_hidden examiner/project \
        examiner/remote examiner/run examiner/run_server toolbox/random) "$(suite 01a)")" "$(made check EX=01a)"
holds 'and is not begun' says '^01a .* not begun '
is 'once' '' "$(made check EX=01a)"
is 'the others need none as long as they are not begun' '' "$(made check)"
is 'and there are 47' 47 "$(grep -c 'not begun' "$work/told")"
for exercise in 01a 02a 02b; do cp solutions/$exercise* exercises; done
is 'an edit needs no suite' '' "$(made check EX=01a)"
holds 'and passes' says '^01a .* passed '
is 'who asks for a solution needs its suite' "$(suite 02b)" \
    "$(made solution EX=02b)"
holds 'and passes, too' says '^02b .* passed '
is 'who asks how things stand, those of what is begun' "$(suite 02a)" \
    "$(made progress)"
holds 'and is told' says 'chapter 2 .* 2 of  3 exercises'
is 'a whole chapter needs its suites' "$(suite 01b) $(suite 01c) $(suite 01d) $(suite 01e)" \
    "$(made check EX=01)"
echo '/* A word. */' >>"$(suite 01b)"
echo '/* A word. */' >>"$(suite 02b)"
is 'a suite is built anew when it is asked for' "$(suite 01b)" \
    "$(made check EX=01a,01b)"
is 'or begun' "$(suite 02b)" "$(made hint)"

# What somebody begins during the watch is built then.
is 'a watch needs what is begun' 0 "$($make -n watch 2>&1 | grep -c 'suite\.c')"
build/check/examine --watch >"$work/watched" 2>&1 </dev/null &
watch=$!
waits() { # PATTERN: until the watch says it
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do
        grep -q "$1" "$work/watched" && return
        sleep 1
    done
    return 1
}
holds 'the watch begins' waits '^Watching'
holds 'and has built no other suite' test ! -e build/check/04a.suite.o
cp solutions/04a* exercises
holds 'what is begun meanwhile is built' waits "cc $(suite 04a)"
holds 'and checked' waits '^04a .* passed '
kill -TERM $watch
wait $watch
holds 'and is remembered' sh -c "$make -s progress | grep 'chapter 4 .* 1 of  2'"
rm build/check/04a.suite.o
mv Makefile away
build/check/examine --as 04a --file exercises/04a-air.c >"$work/told" 2>&1
holds 'a suite that cannot be built is named' \
    says 'the tests of 04a cannot be built; try: make build/check/04a.suite.o'
mv away Makefile

# A suite in which something else stands than can be read.
sed 's/^    .minutes = .*/    .minutes = 5 * 2,/' "$(suite 01a)" >"$work/other" &&
    mv "$work/other" "$(suite 01a)"
made check >/dev/null
holds 'a suite that does not say its minutes is refused' says \
    '^lists: tests/exercises/01a/suite.c: check_suite: .* expected, and not'
cd "$OLDPWD" || exit 1

# The lists are what the judges say.
for list in build/grade/*.list; do
    grep -v '^hidden ' "$list" | cmp -s - "build/check/${list##*/}" &&
        echo same
done >"$work/same"
is 'a suite says the same as its text' \
    "$(ls -d tests/exercises/*/ | wc -l)" "$(grep -c same "$work/same")"
echo 1..33
