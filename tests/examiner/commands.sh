#!/bin/sh
# What a student asks for besides a check: what is remembered, hints, the
# progress, a way back, the solution, and the watch.
. tests/examiner/kit
traps=$here/traps
mine=exercises/99a-twice.c

# A compiler that counts how often it is called.
rm -f build/check/flags
printf '#!/bin/sh\necho once >>compiled\nexec "$@"\n' >counted
chmod +x counted
printf '%s\n%s\n' "./counted $cc" "$libraries" >build/check/flags
: >compiled

ask() { # arguments: the output in out, the status in $status
    build/check/examine --seconds 1 "$@" >out 2>&1
    status=$?
}
# runs TIMES STATUS ARGUMENT...: so often is the compiler called.
runs() {
    before=$(wc -l <compiled) times=$1 want=$2
    shift 2
    ask "$@"
    [ "$status" -eq "$want" ] &&
        [ $(($(wc -l <compiled) - before)) -eq "$times" ]
}
gives() { # STATUS PATTERN ARGUMENT...
    want=$1 pattern=$2
    shift 2
    ask "$@"
    [ "$status" -eq "$want" ] && says "$pattern"
}

# ---- What is remembered.
verdict 'a fresh copy is not compiled at all' runs 0 0
cp "$traps/wrong.c" $mine
verdict 'what was edited is compiled once' runs 1 1
cp out first
verdict 'what is known is not compiled again' runs 0 1
verdict 'and told in the same words' cmp -s first out
verdict 'nor when it is named' runs 0 1 99a
cp "$traps/right.c" exercises/99b-twice.c
verdict 'after an edit of one file only that one is compiled' runs 1 1
cp "$traps/right.c" $mine
verdict 'each content has its own verdict' runs 1 1 99a 99b
cp "$traps/wrong.c" $mine
touch -t 200001010000 $mine
verdict 'an older file with other contents is looked at again' \
    eval "runs 1 1 99a && says '^99a.* failed '"
touch $mine
verdict 'a date alone is no reason to compile' runs 0 1 99a
verdict 'another limit on time is' runs 1 1 --seconds 2 99a
verdict 'and again for the first one' runs 1 1 99a
echo >>build/check/99a.suite.o
verdict 'another suite is' runs 1 1 99a
echo 'note x' >>build/check/99a.list
verdict 'another list of tests is' runs 1 1 99a
mkdir -p tests
echo 'eq:twice 1.7' >tests/equations.txt
verdict 'other numbers of equations are' runs 1 1 99a
cp "$traps/no-build.c" $mine
verdict 'a file that does not build is compiled once' \
    eval 'runs 1 1 99a && runs 0 1 99a'
for damage in 's/\(.\)$/x/' '1s/^...../00000/' '2s/2/5/' '4,$d' d; do
    cp "$traps/wrong.c" $mine
    ask 99a
    cp out first
    sed "$damage" build/check/99a.verdict >damaged
    cp damaged build/check/99a.verdict
    verdict "a verdict damaged by $damage is ignored" \
        eval 'runs 1 1 99a && cmp -s first out'
done
head -c 5000 /dev/urandom >build/check/99a.verdict
verdict 'a verdict of random bytes is ignored' runs 1 1 99a
cp "$traps/sleep.c" $mine
verdict 'a test that timed out is tried again' \
    eval 'runs 1 1 99a && runs 1 1 99a'
cp "$traps/abort.c" $mine
verdict 'a test that crashed is tried again' \
    eval 'runs 1 1 99a && runs 1 1 99a'
echo 'static double two(void) { return 2; }' >exercises/own.h
printf '#include "own.h"\ndouble twice(double x);\n%s\n' \
    'double twice(double x) { return two() * x; }' >$mine
verdict 'a file with a header of its own is looked at every time' \
    eval 'runs 1 0 99a && runs 1 0 99a'
cp "$traps/right.c" $mine
: >compiled
cp exercises/99a-twice.c right
verdict 'another file in its place is not remembered' \
    eval 'ask 99a; build/check/examine --as 99a --file "$traps/wrong.c" \
        >out 2>&1; runs 0 0 99a && says passed'

# ---- Hints.
printf 'Look at x.\nWhat is it?\n--\nAdd it.\n--\nSee "Twice".\n' \
    >tests/exercises/99a/hints.txt
printf 'Only one.\n' >tests/exercises/99b/hints.txt
verdict 'the first hint comes first' \
    gives 0 '^99a, Twice: hint 1 of 3$' --hint 99a
verdict 'with all of its lines' \
    eval "says '^Look at x' && says '^What is it' && ! says 'Add it'"
verdict 'the second is the next' gives 0 'hint 2 of 3$' --hint 99a
verdict 'of another exercise it is the first' \
    gives 0 '^99b, Nothing: hint 1 of 1$' --hint 99b
verdict 'then the last' gives 0 'hint 3 of 3$' --hint 99a
verdict 'after the last it is said that there are no more' \
    gives 0 'hint 3 of 3, the last one again; there are no more' --hint 99a
verdict 'and the last is shown again' says '^See "Twice".$'
verdict 'what was given stands at the top' grep -qx '99a 3' .progress
echo 'rubbish 99a x' >.progress
verdict 'a damaged memory of hints begins at the first' \
    gives 0 'hint 1 of 3$' --hint 99a
head -c 3000 /dev/urandom >.progress
verdict 'and so does one of random bytes' gives 0 'hint 1 of 3$' --hint 99a
rm .progress
cp "$traps/wrong.c" exercises/99b-twice.c
verdict 'without a name it is for what comes next' \
    gives 0 '^99b, ' --hint
verdict 'a chapter has no hint' gives 2 "'99' is a chapter" --hint 99
verdict 'two exercises are one too many' \
    gives 2 "one exercise at a time, and not '99b'" --hint 99a 99b
verdict 'an unknown exercise has none' \
    gives 2 "there is no exercise '98a'; there are 99a 99b$" --hint 98a
mv tests/exercises/99a/hints.txt away
verdict 'without hints it is said what is missing' \
    gives 2 "cannot read 'tests/exercises/99a/hints.txt'" --hint 99a
mv away tests/exercises/99a/hints.txt

# ---- The progress.
cp tests/exercises/99b/stub.c exercises/99b-twice.c
verdict 'the progress has a bar for a chapter' gives 0 \
    '^chapter 99  ##############\.\{10\}    3 of   5 points,  1 of  2 exercises$' \
    --progress
verdict 'and one for all' says '^all  *#*\.*    3 of   5 points'
verdict 'and what comes next' says '^Next: open exercises/99b-twice.c'
verdict 'it compiles nothing that is known' runs 0 0 --progress
cp "$traps/wrong.c" $mine
verdict 'it looks first at what has changed' \
    eval "runs 1 0 --progress && says '^all  *\.*    0 of   5 points'"
verdict 'two commands at once are refused' \
    gives 2 'one thing at a time' --progress --hint

# ---- A way back.
cp "$traps/wrong.c" $mine
printf 'no newline, \303\244 and \001' >>$mine
cp $mine old
ask --hint 99a
verdict 'a reset says what it has kept' \
    gives 0 '^What you had is kept in exercises/99a-twice.c.20' --reset 99a
verdict 'the stub is back' cmp -s $mine tests/exercises/99a/stub.c
verdict 'what there was is kept, to the byte' cmp -s old $mine.20*
verdict 'the hints begin again' gives 0 'hint 1 of 3' --hint 99a
verdict 'what is kept is not taken for the exercise' \
    gives 0 '^99a .* not begun ' 99a
verdict 'a second reset has nothing to do' \
    gives 0 'nothing to reset' --reset 99a
rm -f $mine.20*
for i in 1 2 3 4 5; do
    echo "$i" >$mine
    ask --reset 99a
done
verdict 'resets in one second keep every file' \
    [ "$(cat $mine.20* | grep -cx '[1-5]')" -eq 5 ]
rm $mine
verdict 'a missing file is fetched' gives 0 'is as it came' --reset 99a
verdict 'and is there' cmp -s $mine tests/exercises/99a/stub.c
verdict 'a reset wants a name' gives 2 'which exercise' --reset
verdict 'a chapter is not reset' gives 2 'is a chapter' --reset 99
rm -f $mine.20*
long=exercises/99a-$(printf '%0240d' 0).c
mv $mine "$long"
cp "$traps/wrong.c" "$long"
verdict 'what cannot be kept is not reset' \
    gives 2 'cannot reset .* as it was: File name too long' --reset 99a
verdict 'and stays as it was' cmp -s "$long" "$traps/wrong.c"
verdict 'alone' [ "$(ls exercises/99a* | wc -l)" -eq 1 ]
rm "$long"
cp "$traps/wrong.c" $mine
mv tests/exercises/99a/stub.c stub
mkdir tests/exercises/99a/stub.c
verdict 'without a stub nothing is reset' gives 2 'not a plain' --reset 99a
rmdir tests/exercises/99a/stub.c
verdict 'nor is anything else told' \
    gives 2 '^examine: exercise 99a has no tests/exercises/99a/stub.c$' --progress
mv stub tests/exercises/99a/stub.c
verdict 'and the file is as it was' cmp -s $mine "$traps/wrong.c"

# A kill at any moment leaves a file that is the old one or the stub, and
# the old one is never lost.
lost=
for pause in 0 0.001 0.002 0.003 0.004 0.005 0.006 0.008; do
    rm -f $mine.20*
    cp "$traps/wrong.c" $mine
    build/check/examine --reset 99a >out 2>&1 &
    sleep $pause
    kill -KILL $! 2>/dev/null
    wait $! 2>/dev/null
    cmp -s $mine "$traps/wrong.c" ||
        { cmp -s $mine tests/exercises/99a/stub.c &&
            cmp -s $mine.20* "$traps/wrong.c"; } || lost="$lost $pause"
done
verdict 'a reset that is killed loses nothing' [ -z "$lost" ]
rm -rf $mine.20* build/check/work.*
cp "$traps/right.c" $mine
cksum exercises/* >before.sum
for pause in 0.01 0.05 0.1 0.15 0.2 0.3; do
    rm -f build/check/99a.verdict
    build/check/examine 99a >out 2>&1 &
    sleep $pause
    kill -KILL $! 2>/dev/null
    wait $! 2>/dev/null
done
cksum exercises/* >after.sum
verdict 'a check that is killed touches nothing' cmp -s before.sum after.sum
verdict 'and the next one is right' gives 0 ' passed ' 99a
rm -rf build/check/work.*

# ---- The worked solution.
mkdir solutions
echo '/* Worked. */' >solutions/99a-twice.c
cp "$traps/wrong.c" $mine
verdict 'before it passes there is no solution' \
    gives 0 'can be read once 99a passes' --solution 99a
verdict 'but the state' eval "says '^99a .* failed ' && ! says Worked"
cp tests/exercises/99a/stub.c $mine
verdict 'nor before it is begun' \
    gives 0 'can be read once 99a passes' --solution 99a
cp "$traps/right.c" $mine
verdict 'a pass offers the solution' \
    gives 0 'The worked solution: make solution EX=99a' 99a
verdict 'the solution is shown once it passes' \
    gives 0 '^/. Worked. ./$' --solution 99a
mv solutions "no solutions"
verdict 'without solutions the lecturer has them' \
    gives 0 'your lecturer keeps them' --solution 99a
mv "no solutions" solutions
verdict 'a solution wants a name' gives 2 'which exercise' --solution
verdict 'only a check takes another file' gives 2 'for checking alone' \
    --solution --as 99a --file right

# ---- The watch. wait_for PATTERN: until the watch says so, at most 10 s.
wait_for() {
    try=0
    while [ $((try += 1)) -le 100 ]; do
        grep -q -e "$1" out && return 0
        sleep 0.1
    done
    return 1
}
for ex in 99a 99b; do
    cp tests/exercises/$ex/stub.c exercises/$ex-twice.c
done
build/check/examine --watch >out 2>&1 </dev/null &
watch=$!
verdict 'the watch begins with what comes next' \
    wait_for '^Next: open exercises/99a-twice.c'
sleep 0.3
cat "$traps/wrong.c" >$mine
verdict 'it notices a file that is written' wait_for '^99a .* failed '
verdict 'and tells its story' wait_for 'How much is one and one'
cp "$traps/no-build.c" fresh
mv fresh $mine
verdict 'it notices a file that is put in its place' \
    wait_for '^99a .* does not build '
sleep 0.3
mv $mine gone
sleep 0.3
cp "$traps/right.c" $mine
verdict 'and one that was gone for a moment' wait_for '^99a .* passed '
sleep 0.3
cp "$traps/half-done.c" exercises/99b-twice.c
verdict 'and the others' wait_for '^99b '
sleep 0.3
rm $mine
cp "$traps/half-done.c" exercises/99a-again.c
verdict 'and one that comes back under another name' \
    wait_for 'exercises/99a-again.c does not pass'
mv exercises/99a-again.c gone
cp "$traps/right.c" $mine
verdict 'a file gets no codes for the screen' \
    eval '! grep -q "$(printf "\033")" out'
kill -INT $watch
wait $watch
verdict 'Ctrl-C ends the watch with status 0' [ $? -eq 0 ]
verdict 'and no folder of it is left' \
    [ -z "$(ls -d build/check/work.* 2>/dev/null)" ]
mv build/check/99b.* .
build/check/examine --watch >out 2>&1 </dev/null &
watch=$!
verdict 'when all passes the watch says so' wait_for '^Everything here passes'
kill -TERM $watch
wait $watch
mv 99b.* build/check/
fewer=0
if command -v script >/dev/null 2>&1 && script -qec true out >/dev/null 2>&1
then
    cp "$traps/wrong.c" $mine
    : >out
    (wait_for 'Keys: h'; printf 'h\n'; wait_for 'hint 1 of 3'
        printf '\003'; wait_for '^ended') |
        script -qec 'sh -c "build/check/examine --watch 99a; \
            echo ended \$?"' script.out >out 2>&1
    verdict 'a terminal is cleared' grep -q "$(printf '\033\[2J')" out
    verdict 'the key h gives a hint' says 'hint 1 of 3'
    verdict 'Ctrl-C reaches the watch and nobody else' says '^ended 0'
    cp "$traps/right.c" $mine
    verdict 'on a terminal a solution goes through the pager' eval \
        "PAGER='sed s/W/PW/' script -qec \
        'build/check/examine --solution 99a' script.out >out 2>&1 </dev/null
        says PWorked"
else
    fewer=4
fi

# ---- The front door.
for goal in watch hint progress reset solution; do
    ${MAKE:-make} -s -n -C "$root" $goal EX=01a >out 2>&1
    verdict "make $goal asks for it" says "examine --$goal [$]EX"
done
echo "1..$((94 - fewer))"
