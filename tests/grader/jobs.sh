#!/bin/sh
# A batch as a list of jobs: in any order, twice at a time and with one killed,
# its reports are those of one machine; and a job whose file, kit or sandbox is not
# what it was grades nothing.
topic='jobs'
. tests/grader/hostile/kit

kit
honest "$scratch/class"
for n in 1 2 3 4; do # one of them with a name that no shell should read
    mkdir -p "$scratch/class/it's \$n$n" &&
        { cat "$scratch/class/honest/01a-collide.c" && echo "/* $n */"; } \
            >"$scratch/class/it's \$n$n/01a-collide.c"
done
mkdir "$scratch/class/idle" "$scratch/class/late" "$scratch/class/.git"
# Late by the clock on the wall, as on a machine with other work.
sed -e '1i #include <unistd.h>' -e 's/^{$/{ for (volatile int i = 0; i == 0;) pause();/' \
    tests/exercises/01a/right-frame.c >"$scratch/class/late/01a-collide.c"
mv "$scratch/class/it's \$n4" "$scratch/class/Åsa"
cp "$scratch/class/Åsa/01a-collide.c" "$scratch/class/eva_LATE_123_456_01a-collide.c"

list() { # FILE: the jobs that are listed now
    (cd "$scratch/kit" && exec build/grade/grade --list --exercises 01a \
        --hidden "$seed" --seconds 1 --output "$scratch/out" \
        "$scratch/class") >"$1" 2>"$scratch/said"
    status=$?
}
listed() { # NUMBER
    list "$scratch/list"
    ended 0 || return 1
    [ "$(wc -l <"$scratch/list")" -eq "$1" ] || why "$(cat "$scratch/list")"
}
run() { # LIST [SAID]: one job after the other
    while IFS= read -r job; do
        (cd "$scratch/kit" && exec sh -c "$job") </dev/null || return 1
    done <"$1" >"$scratch/${2:-said}" 2>&1
}
results() { find "$scratch/out/marks" -name '01a.json' | wc -l; }
# Two at a time, one from behind; the late one, which takes its time, once.
twice() {
    sed -e '1!G;h;$!d' "$scratch/list" | grep -v 'job late' >"$scratch/behind"
    run "$scratch/list" &
    run "$scratch/behind" other
    wait
}
whole() { [ "$(results)" -eq "$1" ] || why "$(results) results"; }

# One machine's reports, without the times.
reports() { # FOLDER
    for file in "$1/grades.csv" "$1"/gradescope/*.json "$1/table"; do
        echo "${file#"$1"}"
        sed -e 's/20..-..-..T..:..:..Z//' \
            -e 's/"execution_time": *[0-9.e+-]*//' \
            -e "s|$1|OUT|" "$file" 2>/dev/null
    done
}
grade "$scratch/class" "$scratch/alone" --seconds 1 --report gradescope
verdict 'one machine grades all' ended 0
cp "$scratch/said" "$scratch/alone/table"

verdict 'of eight students with a file there are eight jobs' listed 8
verdict 'and who has none is booked at once' whole 1
head -n 1 "$scratch/list" >"$scratch/first"
{ (cd "$scratch/kit" && exec timeout -s KILL 0.1 sh -c "$(cat "$scratch/first")"); } \
    >/dev/null 2>&1
verdict 'a job that is killed has no result' whole 1
sed '1!G;h;$!d' "$scratch/list" >"$scratch/behind"
twice
verdict 'run twice at a time, all have one' whole 9
verdict 'what was late is listed once more, alone' listed 1
verdict 'it is that one' grep -q -e '--job late/01a/' "$scratch/list"
run "$scratch/list"
verdict 'and then nothing is' listed 0
ls -i "$scratch"/out/marks/*/01a.json >"$scratch/before"
grade "$scratch/class" "$scratch/out" --seconds 1 --report gradescope
verdict 'make grade collects them' ended 0
ls -i "$scratch"/out/marks/*/01a.json >"$scratch/after"
verdict 'and grades nothing again' cmp -s "$scratch/before" "$scratch/after"
cp "$scratch/said" "$scratch/out/table"
reports "$scratch/alone" >"$scratch/one"
reports "$scratch/out" >"$scratch/two"
same() {
    cmp -s "$scratch/one" "$scratch/two" ||
        why "$(diff "$scratch/one" "$scratch/two")"
}
verdict 'its reports are those of one machine' same
verdict 'and are there' test "$(grep -c '"score"' "$scratch/two")" -gt 20

# A line is of one file, one kit and one sandbox.
echo '/* more */' >>"$scratch/class/honest/01a-collide.c"
verdict 'a file that is new is listed' listed 1
cp "$scratch/list" "$scratch/first"
echo '/* and more */' >>"$scratch/class/honest/01a-collide.c"
refused() { # WORDS
    ! run "$scratch/first" && grep -q -e "$1" "$scratch/said" ||
        why "$(cat "$scratch/said")"
}
verdict 'what has changed since is not graded' refused 'is not what it was'
verdict 'nor is anything written' \
    test "$(ls -i "$scratch"/out/marks/*/01a.json)" = "$(cat "$scratch/before")"
list "$scratch/first"
mkdir "$scratch/bare"
for tool in env sh setpriv rm prlimit; do
    ln -s "$(command -v $tool)" "$scratch/bare/$tool"
done
sed -i "s|^|PATH=$scratch/bare |" "$scratch/first"
verdict 'where there is no sandbox a job says so' refused 'CANNOT BE ISOLATED'
sed -i 's/--job/--unsafe --job/' "$scratch/first"
verdict 'and is no job of a list that has sandboxes' refused 'sandbox (NONE'
verdict 'and grades nothing' \
    test "$(ls -i "$scratch"/out/marks/*/01a.json)" = "$(cat "$scratch/before")"
sed -i 's|--job [^/]*|--job berta|' "$scratch/first"
verdict 'nor for who is no student' refused "no student 'berta'"

# A machine that has another compiler, by its own words.
list "$scratch/first"
printf '#!/bin/sh\necho cc 99\n' >"$scratch/cc"
chmod 755 "$scratch/cc"
cc=$(sed -n '1s/ .*//p' build/grade/flags)
elsewhere() {
    [ "$(id -u)" -eq 0 ] && unshare --mount true 2>/dev/null || {
        echo '# note: only root can put another compiler in its place here'
        return
    }
    sed "s|^|exec unshare --mount sh -c 'mount --bind \$0 /usr/bin/$cc \&\& exec \"\$@\"' \
        $scratch/cc |" "$scratch/first" | tr -d '\n' >"$scratch/there"
    echo >>"$scratch/there"
    (cd "$scratch/kit" && sh "$scratch/there") >"$scratch/said" 2>&1
    grep -q 'the compiler or the sandbox' "$scratch/said" ||
        why "$(cat "$scratch/said")"
}
verdict 'where the compiler is another one a job is not done' elsewhere
done_here() { [ -s "$scratch/first" ] && run "$scratch/first"; }
verdict 'it is done where it was listed' done_here
echo 1..21
