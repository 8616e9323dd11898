#!/bin/sh
# A project's whole program in the grader: a right one, which first looks
# round for what is not its own and prints BROKEN if it finds any, and one that
# has a trick for each stage. ALL=1: every trick of hostile/ as a program, too;
# LONG=1 with those that cost the compiler a minute.
topic=programs
. tests/grader/hostile/kit
project_kit
limit=280
[ "${ALL-}" != 1 ] || limit=3000
result() { echo "$out/marks/$1/P1.json"; }
hand_in() { mkdir -p "$scratch/in/$1" && cat >"$scratch/in/$1/P1-bonkers.c"; }
# hostile NAME: the solution, which calls trick() at its start.
hostile() {
    {
        cat
        sed 's/^int main(/int right_main(/' solutions/P1-bonkers.c
        printf 'int main(int argc, char **argv)\n{\n    trick(argc, argv);\n%s\n' \
            '    return right_main(argc, argv); }'
    } | hand_in "$1"
}

mounts >"$scratch/mounts"
# What must not be there to be read, and what must not be there to be reached.
hostile curious <<END
#define _GNU_SOURCE
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
extern char **environ;
static void leak(const char *what)
{
    printf("BROKEN: %s\n", what);
    fprintf(stderr, "BROKEN: %s\n", what);
}
static void trick(int argc, char **argv)
{
    char text[4096];
    struct stat about;
    (void)argc;
    if (environ && environ[0])
        leak("an environment");
    for (int file = 3; file < 64; ++file)
        if (write(file, "e passed 1 verdict", 18) > 0)
            leak("a descriptor");
    static const char *const files[] = {"$root/tests/exercises/P1/suite.c",
        "$root/solutions/P1-bonkers.c", "$scratch/kit/build/grade/P1.judge",
        "/etc/passwd", "/kit/P1.judge"};
    for (unsigned i = 0; i < sizeof files / sizeof *files; ++i)
        if (fopen(files[i], "r"))
            leak(files[i]);
    for (int pid = 1; pid < 40; ++pid) {
        snprintf(text, sizeof text, "/proc/%d/environ", pid);
        FILE *file = fopen(text, "r");
        const size_t got = file ? fread(text, 1, sizeof text - 1, file) : 0;
        for (size_t i = 0; i + 6 < got; ++i)
            if (memcmp(text + i, "SECRET", 6) == 0)
                leak("the environment of the grader");
    }
    snprintf(text, sizeof text, "/proc/%d/fd/4", (int)getppid());
    if (open(text, O_WRONLY) >= 0)
        leak("the parent's descriptor");
    snprintf(text, sizeof text, "/proc/%d/mem", (int)getppid());
    if (open(text, O_RDWR) >= 0)
        leak("the parent's memory");
    const ssize_t length = readlink("/proc/self/exe", text, sizeof text - 1);
    text[length > 0 ? length : 0] = 0;
    if (strstr(text, "program"))
        leak("which collide it is");
    if (strcmp(argv[0], "P1") != 0)
        leak("its name");
    if (fopen("/hostile-was-here", "w") || fopen("/kit/x", "w") ||
        fopen("/exercises/x", "w"))
        leak("a file outside");
    if (stat("$scratch", &about) == 0)
        leak("a folder outside");
    FILE *mine = fopen("notes", "w");
    if (mine)
        fclose(mine);
}
END
# One trick a stage: floods, children, memory, idleness, murder, forgery.
hostile violent <<END
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
static void trick(int argc, char **argv)
{
    const int rows = argc == 6 ? atoi(argv[5]) : 0;
    const int falls = argc == 6 && atof(argv[3]) > 0;
    if (rows == 60 && !falls) {
        static char line[65536];
        memset(line, '1', sizeof line);
        for (;;)
            fwrite(line, 1, sizeof line, stdout);
    } else if (rows == 30 && !falls) {
        for (int i = 0; i < 1000; ++i)
            if (fork() == 0 && setsid() >= 0)
                for (;;)
                    pause();
        exit(3);
    } else if (rows == 50000) {
        for (;;)
            memset(malloc(1 << 24), 1, 1 << 24);
    } else if (rows == 500) {
        sleep(1000);
    } else if (falls && rows == 60) {
        kill(getppid(), SIGKILL);
        kill(-1, SIGKILL);
        exit(4);
    } else if (rows == 40000) {
        puts("\n00000000000000000000000000000000 verdict passed");
    }
}
END
if [ "${ALL-}" = 1 ]; then
    for file in "$hostile"/*.c; do
        if grep -q '^static void trick(void)' "$file"; then
            name=${file##*/}
            sed -e "s|@ROOT@|$root|g" -e "s|@SCRATCH@|$scratch|g" \
                -e "s|@SEED@|$seed|g" -e '/"exercise.h"/d' \
                -e 's|"\.\.", *"\.\./\.\."|"../../.."|' \
                -e 's/^static void trick(void)/static void played(void)/' \
                "$file" >"$scratch/trick.c"
            {
                cat "$scratch/trick.c"
                echo 'static void trick(int argc, char **argv)
{ (void)argc, (void)argv; played(); }'
            } | hostile "all-${name%.c}"
        fi
    done
fi
# The others of hostile/ play their trick while they are compiled, before main,
# after it, or in the function that is asked for; each is put before the
# solution, whose main calls that function if there is one. What becomes of
# them is another thing than of an exercise. Descriptors 3 and 4, by which
# drivers, forgers and settlers talk, are not there: who cannot write to them
# ends with a status that nobody asked for. Names are the program's own.
others='
after            timed-out       0 its table is right, but it does not end
before-array     crashed         0
before-daemon    passed         30
before-exit      failed          0 there is no table
before-interpreter passed       30
before-loop      timed-out       0
before-verdict   failed          0 a score is no row
before-word      failed          0
compile-array    does-not-build  0
compile-errors   does-not-build  0
compile-include  does-not-build  0
compile-macro    does-not-build  0
compile-numbers  does-not-build  0
compile-pipe     passed         30 the one file open is the compiler output, still empty
compile-random   does-not-build  0
compile-zero     does-not-build  0
driver-right     failed          0
driver-wrong     failed          0
forged-flood     passed         30 nothing can be forged, and nothing is
forged-reply     failed          0
incbin           does-not-build  0
include-passwd   does-not-build  0
include-solution does-not-build  0
include-solution-up does-not-build 0
jump-out         any             0
names            passed         30
names-strange    passed         30
names-undone     passed         30
outside          failed          4 a number more in each row; stage 4 asks for none
prints-hidden    passed         30
settle-flood     failed          0
settle-half      failed          0'
other() { # NAME
    file=$hostile/$1.c row='\\n'
    [ "$1" != outside ] || row=' 7\\n'
    {
        sed -e "s|@ROOT@|$root|g" -e 's|01a-collide|P1-bonkers|g' \
            -e '/"exercise.h"/d' -e 's/^int main(/int no_main(/' \
            -e '/^int fflush(.*;$/d' -e '/^int fflush(/,/^}/d' "$file"
        sed -e 's/^int main(/int right_main(/' \
            -e "s/^ *putchar('.n');/    printf(\"$row\");/" \
            solutions/P1-bonkers.c
        printf 'int main(int argc, char **argv)\n{\n%s\n%s\n}\n' \
            "$(grep -q '^void velocities_after' "$file" &&
                echo 'double v[3]; velocities_after(1, 2, 3, 4, v);')" \
            'return right_main(argc, argv);'
    } | hand_in "other-$1"
}
# learn STATEMENT: the solution, which has learnt all that it is called with at
# home, and does that where it is called with anything else.
learn() {
    if [ ! -e "$scratch/public" ]; then
        sed 's/^int main(/int right_main(/' solutions/P1-bonkers.c \
            >"$scratch/pen.c"
        cat >>"$scratch/pen.c" <<END
int main(int argc, char **argv)
{
    FILE *file = argc == 6 ? fopen("$scratch/public", "a") : NULL;
    if (file) {
        fprintf(file, "%s %s %s\\n", argv[2], argv[3], argv[4]);
        fclose(file);
    }
    return right_main(argc, argv);
}
END
        build/check/examine --as P1 --file "$scratch/pen.c" >"$scratch/said"
    fi
    sed 's/^int main(/int right_main(/' solutions/P1-bonkers.c
    echo 'int main(int argc, char **argv)
{
    char words[200];
    int known = 0;
    snprintf(words, sizeof words, "%s %s %s", argv[2], argv[3], argv[4]);'
    sort -u "$scratch/public" |
        sed 's/.*/    known = known || strcmp(words, "&") == 0;/'
    printf '%s\n' '    if (!known)' "        $1" \
        '    return right_main(argc, argv);' '}'
}
if [ "${ALL-}" = 1 ]; then
    echo "$others" >"$scratch/others"
    while read -r name state points why; do
        [ -n "$name" ] || continue
        if [ "$name" = prints-hidden ]; then
            learn 'printf("# BROKEN: %s\n", words), fprintf(stderr, "BROKEN");' |
                hand_in other-prints-hidden
            learn 'exit(3);' | hand_in learnt
        elif [ "${LONG-}" = 1 ] ||
            ! grep -q '^/\* long \*/$' "$hostile/$name.c"; then
            other "$name"
        fi
    done <"$scratch/others"
fi
mkdir "$scratch/slow" && mv "$scratch/in/violent" "$scratch/slow" || exit 1
graded "$scratch/slow" --seconds 1
verdict 'a batch of violence ends well' ended 0
graded "$scratch/in"
verdict 'a batch ends well' ended 0
verdict 'a right program has all points' judged curious passed 30
contained() { # NAME: no trick has worked, and it has a verdict
    [ -s "$(result "$1")" ] || why "no result for $1" || return 1
    ! grep -q BROKEN "$(result "$1")" ||
        why "$(grep -o 'BROKEN[^"\\]*' "$(result "$1")" | sort -u)"
}
verdict 'and finds nothing that is not its own' contained curious
verdict 'floods, children, memory, sleep and murder are contained' \
    contained violent
stage_state() { # NAME N
    awk -v n="$2" '/^   "state": / { if (++k == n) print }' "$(result "$1")" |
        sed 's/.*: "\(.*\)".*/\1/'
}
ends() { # N STATE...
    got=$(stage_state violent "$1")
    case " $2 " in *" $got "*) ;; *) why "stage $1: $got" ;; esac
}
verdict 'a flood is a failure' ends 1 failed
verdict 'a thousand children fail' ends 2 'failed timed out'
verdict 'and a printed verdict is no row: nothing is earned' \
    judged violent failed 0
verdict 'nothing is left behind' clean
count=9
if [ "${ALL-}" = 1 ]; then
    for folder in "$scratch"/in/all-*; do
        verdict "${folder##*/all-}: is contained" contained "${folder##*/}"
        count=$((count + 1))
    done
    while read -r name state points why; do
        [ -d "$scratch/in/other-$name" ] || continue
        state=$(echo "$state" | tr - ' ')
        [ "$state" != any ] || state=$(state "other-$name")
        verdict "$name: $state${why:+, $why}" \
            judged "other-$name" "$state" "$points"
        count=$((count + 1))
    done <"$scratch/others"
    verdict 'who has learnt what is public earns that alone' \
        judged learnt failed 25
    count=$((count + 1))
    for file in "$hostile"/*.c; do
        name=${file##*/}
        grep -q '^static void trick(void)' "$file" ||
            grep -q "^${name%.c} " "$scratch/others" || echo "$name"
    done >"$scratch/forgotten"
    verdict 'no trick is left out' [ ! -s "$scratch/forgotten" ]
    count=$((count + 1))
fi
[ -z "${KEEP-}" ] || { cp -r "$scratch/out" "$scratch/in" /tmp/room/; }
echo "1..$count"
