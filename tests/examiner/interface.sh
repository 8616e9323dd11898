#!/bin/sh
# What examine says on its screen, and with which status it ends.
. tests/examiner/kit

run() { # status, arguments: keeps the output in out
    wanted=$1
    shift
    build/check/examine --seconds 1 "$@" >out 2>&1
    status=$?
    [ "$status" -eq "$wanted" ] && { [ "$wanted" -eq 2 ] || narrow; }
}
lines() { [ "$(wc -l <out)" -eq "$1" ]; }
both() { # status, pattern, arguments
    pattern=$2 status_wanted=$1
    shift 2
    run "$status_wanted" "$@" && says "$pattern"
}
traps=$here/traps

verdict 'a fresh copy is not begun, and that is no error' \
    both 0 '^99a  Twice  *not begun  *0 of  3 points  5 min$'
verdict 'a fresh copy is told where to start' \
    says '^Next: open exercises/99a-twice.c, then: make check EX=99a$'
verdict 'a fresh copy is told kindly' says 'Nothing is begun yet'

cp "$traps/wrong.c" exercises/99a-twice.c
cksum exercises/* >before
verdict 'a wrong answer ends with status 1' both 1 ' failed  *0 of  3 points  5 min$'
verdict 'a wrong answer is what comes next' \
    says '^Next: mend exercises/99a-twice.c, then: make check EX=99a$'
verdict 'an equation without a number keeps its label' says 'eq:twice'
echo 'eq:twice 1.7' >tests/equations.txt
verdict 'an equation has its number in the book' \
    both 1 'book       equation (1.7)$' 99a
verdict 'an exercise not named is not checked' \
    eval "run 0 99b && ! says '^99a'"
cksum exercises/* >after
verdict 'the files of the student are as before' cmp -s before after

sed 's|3 [*] x|x < 0 ? 2 * x : x|' "$traps/wrong.c" >exercises/99a-twice.c
verdict 'an idle test alone earns nothing' both 1 ' failed  *0 of  3 points'
sed 's|3 [*] x|x > 1 ? x : 2 * x|' "$traps/wrong.c" >exercises/99a-twice.c
verdict 'beside another it earns its points' both 1 ' failed  *2 of  3 points'

cp "$traps/right.c" exercises/99a-twice.c
verdict 'a right answer ends with status 0' both 0 ' passed  *3 of  3 points  5 min$'
verdict 'after a right answer the next exercise is named' \
    says '^Next: open exercises/99b-twice.c'
verdict 'a chapter stands for its exercises' both 0 '^99b' 99
cp "$traps/right.c" exercises/99b-twice.c
verdict 'a test that checks nothing does not pass' both 1 'checked nothing' 99b

cp "$traps/warned.c" exercises/99b-twice.c
verdict 'a warning alone does not stop the build' both 1 ' failed ' 99b
verdict 'with --strict a warning is an error' \
    both 1 ' does not build  *0 of' --strict 99b

verdict 'an unknown exercise is refused with the names of the known' \
    both 2 "^examine: there is no exercise '98z'; there are 99a 99b$" 98z
verdict 'the names of exercises are parted by commas and blanks alike' \
    both 2 "^examine: there is no exercise '98z'; there are" '99a, 99b,98z'
verdict 'an unknown option is refused' both 2 'examine --help' --frobnicate
verdict '--as needs --file' both 2 'go together' --as 99a
verdict '--seconds wants a number' both 2 'whole number' --seconds ten
verdict 'a file that is not there is refused' \
    both 2 "cannot read 'none.c': No such file" --as 99a --file none.c
verdict '--help says how it is used' both 0 '^Usage: examine' --help
verdict '--list names title, time, points and file' \
    both 0 '99a  Twice  *5 min  *3 points  exercises/99a-twice.c' --list

cp "$traps/right.c" 'exercises/99a-my own copy.c'
verdict 'two files of one exercise are refused' both 2 'are the same exercise'
rm exercises/99a-twice.c
verdict 'a name with blanks is as good as any' both 0 'passed' 99a
rm exercises/99a-*
verdict 'a file that is gone can be fetched again' \
    both 0 'file is missing. Fetch it: make reset EX=99a' 99a
cp tests/exercises/99b/stub.c exercises/99b-twice.c
verdict 'a full round says that a file is missing' both 0 'file is missing'
verdict 'a missing file is fetched, not opened' \
    eval "says '^Next: fetch .*: make reset EX=99a' && ! says 'open tests'"
cp "$traps/right.c" exercises/99a_twice.c
verdict 'a misnamed file is named' \
    both 0 'is it exercises/99a_twice.c? .* exercises/99a-twice.c$'
rm exercises/99a_twice.c
mkfifo exercises/99a-twice.c
timeout 10 build/check/examine >out 2>&1
verdict 'a pipe among the exercises is refused, not waited for' \
    eval "[ $? -eq 2 ] && says 'not a plain file'"
rm exercises/99a-twice.c

cp "$traps/partial.c" exercises/99a-twice.c
verdict 'a gap in begun work is counted' both 0 ' not begun  *2 of  3 points'
verdict 'a gap in begun work is said to be at its line' \
    says '^99a is under way; its gap is at line 8.$'
verdict 'a fresh exercise does not deny begun work' \
    eval "run 0 99b && ! says 'Nothing is begun'"

cp "$traps/right.c" exercises/99a-twice.c
(exec 5>held 6>held && build/check/examine --as 99a --file "$traps/verdict.c") \
    >out 2>&1
verdict 'what the examiner has open stays closed to the student' \
    [ ! -s held ]

cp "$traps/sleep.c" exercises/99a-twice.c
build/check/examine --seconds 30 99a >out 2>&1 &
pid=$!
for try in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    sleep 0.2
    ls build/check/work.*/report >/dev/null 2>&1 && break
done
kill -TERM $pid
wait $pid
verdict 'a signal ends a round with status 2' [ $? -eq 2 ]
verdict 'a round cut short leaves no folder' \
    [ -z "$(ls -d build/check/work.* 2>/dev/null)" ]

cp "$traps/right.c" exercises/99a-twice.c
verdict 'sanitizers that are there are not missed' \
    eval "run 0 99a && { ! grep -q =address build/check/flags ||
        ! says 'no sanitizers'; }"
plain_objects='check.o no_hidden.o random.o'
plain=$(echo "$cc" | sed 's/ -f[a-z-]*saniti[^ ]*//g')
rm build/check/flags
printf '#!/bin/sh\necho "$TMPDIR" >tmpdir\nexec "$@"\n' >said
chmod +x said
printf '%s\n%s\n' "./said $plain" "$plain_objects ${libraries#* }" \
    >build/check/flags
# shellcheck disable=SC2086
$plain -Isrc -c src/examiner/check.c src/examiner/no_hidden.c \
    src/toolbox/random.c &&
    $plain -Isrc -c "$here/suite.c" -o build/check/99a.suite.o
verdict 'a compiler without sanitizers is named as such' \
    both 0 'no sanitizers: errors of memory may pass unseen' 99a
verdict 'and this is said once' [ "$(grep -c sanitizers out)" -eq 1 ]
verdict 'a compiler has its temporary files in the working folder' \
    grep -q '^build/check/work' tmpdir

rm build/check/flags
cp "$traps/right.c" exercises/99a-twice.c
verdict 'without its flags the kit says what to do' both 2 'make check$' 99a
rm build/check/*.list
verdict 'without any suite the kit says what to do' both 2 'make check$'
echo 1..44
