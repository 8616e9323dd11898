#!/bin/sh
# Compiles a student's file in the sandbox, hides its symbols, links it, and becomes
# the program. sandbox.c gives this text to the shell inside, with these arguments;
# src/examiner/sandbox.h says what each of them means.
#
# The limits are hard limits, different for the compiler and the program.
# shellcheck disable=SC2046,SC2086,SC3045
root=$1 name=$2 compiler=$3 keep=$4 seconds=$5 memory=$6 terse=$7
lean=$8 linker=$9 declared=${10} types='' cpu=20
# If memory runs out, the kernel kills this process first.
echo 1000 >/proc/self/oom_score_adj
export PATH=/usr/bin:/bin LC_ALL=C HOME=$root/work TMPDIR=$root/work
common=exitcode=86:color=never
export UBSAN_OPTIONS=$common
export ASAN_OPTIONS=$common:handle_abort=1:hard_rss_limit_mb=512:leak_check_at_exit=0
processes() { ulimit -p $1 2>/dev/null || ulimit -u $1; }
ulimit -c 0 && ulimit -f 65536 && processes 64 || exit

# The pipes are closed while the compiler runs, so that a file that includes
# /proc/self/fd/3 gets nothing.
build() (
    ulimit -t $cpu && ulimit -v 2097152 && exec "$@" 3<&- 4>&-
)
compile() {
    build $compiler -I$root/kit -DEXAMINER_GIVES $types "$@" -c -o work/answer.o $name
}
cd $root/ || exit
[ ! "$declared" ] || {
    types='-include work/types.h'
    printf '%s\n' "$declared" >work/types.h
}
# gcc took 28 s to print twenty thousand warnings with their source lines. So the
# compiler first runs without source lines. Only if it fails does it run again with
# them, or without warnings if there were many.
compile $lean $terse >work/said 2>&1 || {
    cpu=5
    if [ "$(wc -c <work/said)" -lt 9999 ]; then
        compile
    else
        compile -w && grep error: work/said | head -n 20
    fi
    exit
}
# BUILD_MEMBERS of build.h defines the function members.
eval "${11}" && members work/types.h $name build $compiler -I$root/kit || exit
cd work || exit
kit=../kit/sandbox.suite.o program=./program of=
bound() {
    ulimit -S -t $seconds && ulimit -H -t $((seconds + 1)) && ulimit -n 64 &&
        ulimit -f $1 && processes 16 &&
        { [ $memory = unlimited ] || ulimit -v $memory; }
}
# objcopy makes all of the student's symbols local, except the functions of the
# exercise. A student's malloc, write or main then cannot replace the driver's.
# objcopy also removes a section .interp: programs linked by gold would contain it,
# and Linux would start the interpreter that it names.
link() { build objcopy -R .interp $keep answer.o && build "$@"; }
by_compiler="$compiler -o program answer.o $kit -lm"
case $keep in
figure | program) of=$(nm $kit | sed -n 's/.* T \([a-z]*\)_0$/\1/p') ;;
esac
given() { [ ! "$of" ] || echo -Wl,-u,${of}_$1,--defsym=$of=${of}_$1; }
if [ "$keep" = figure ]; then
    project=${name#*/} && project=${project%%-*} && mkdir desk &&
        build objcopy --keep-global-symbol=main answer.o &&
        build $compiler -o desk/$project answer.o $kit -lm \
            $(given 0) || exit
    cd desk && cat <&3 >$project.gp || exit
    command -v gnuplot >/dev/null || { printf g >&4; exit; }
    printf b >&4
    (bound 31250 && exec gnuplot $project.gp </dev/null 3<&- 4>&-)
    [ ! -L $project.png ] && [ -f $project.png ] &&
        head -c 4194305 $project.png >&4
    exit
fi
# A project keeps its main. The driver is a program without any code of the student's,
# and the student's program is linked once for each version of the function that it
# calls. With sanitizers it is linked only for the first version.
if [ "$keep" = program ]; then
    build objcopy --keep-global-symbol=main answer.o || exit
    laws=0 && [ ! "$of" ] ||
        laws=$(nm $kit | sed -n "s/.* T ${of}_//p")
    for law in $laws; do
        [ $memory = unlimited ] && ln program0 program$law \
            2>/dev/null && continue
        build $compiler -o program$law answer.o $kit -lm \
            $(given $law) || exit
    done
    build $compiler -o sandbox $kit -lm \
        -Wl,-u,sandbox_main,--defsym=main=sandbox_main || exit
    mkdir desk && cd desk && program=../sandbox || exit
else
    # Symbols and line numbers are left out, except with sanitizers. If the linker
    # fails, the file is compiled again with them, for its message. gold takes a
    # third of the usual linker's time with sanitizers, and three quarters without.
    set -- $linker
    [ $# -gt 0 ] || set -- $by_compiler
    link "$@" >said 2>&1 || {
        cd .. && compile $terse >work/said 2>&1 && cd work && link $by_compiler
    } || exit
fi
printf b >&4
bound 2048 && exec $program
