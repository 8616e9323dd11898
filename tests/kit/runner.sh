#!/bin/sh
# tests/run: what a script leaves out is a failure.
. tests/programs/common
root=$PWD
cd "$work" || exit 1

# says STATUS LAST LINE...: of a script of these lines.
says() {
    want=$1 last=$2
    shift 2
    printf '%s\n' '#!/bin/sh' "$@" >script && chmod +x script
    "$root/tests/run" ./script >out 2>&1
    got=$?
    holds "a script of: $*" sh -c "[ $got -eq $want ] || cat out; [ $got -eq $want ] &&
        tail -n 1 out | grep -qx '$last'"
}
says 0 '2 passed, 0 failed' 'echo ok a' 'echo ok b' 'echo 1..2'
says 1 '1 passed, 1 failed' 'echo ok a' 'exit 0' 'echo ok b' 'echo 1..2'
says 1 '1 passed, 1 failed' 'echo ok a' 'for f in nothing/*.c; do [ -e $f ] &&
    echo ok $f; done' 'echo 1..2'
says 1 '3 passed, 1 failed' 'echo ok a' 'echo ok b' 'echo ok c' 'echo 1..2'
says 1 '0 passed, 1 failed' 'echo 1..0'
says 1 '1 passed, 1 failed' 'echo ok a' 'echo 1..1' 'exit 3'
says 1 '1 passed, 1 failed' 'echo ok a' 'echo not ok b - why' 'echo 1..2'
says 0 '1 passed, 0 failed' 'echo "# note: no card here"' 'echo ok a' \
    'echo "# a remark"' 'echo 1..1'
holds 'what could not be tested is said aloud, and no other remark' \
    test "$(grep '^#' out)" = '# note: no card here'
says 0 '1 passed, 0 failed, 1 skipped' 'echo ok a' 'echo skipped b - no b here' \
    'echo 1..2'
holds 'what is skipped is said aloud, and named before the end' \
    test "$(grep -c '^skipped b - no b here$\|^  b - no b here$' out)" -eq 2
says 1 '0 passed, 0 failed, 1 skipped' 'echo skipped b - no b here' 'echo 1..1'
says 1 '1 passed, 1 failed, 1 skipped' 'echo ok a' 'echo skipped b - why' 'echo 1..3'
# What stands behind -- waits for the first.
printf '%s\n' '#!/bin/sh' 'sleep 1' ': >made' 'echo ok a' 'echo 1..1' >first
printf '%s\n' '#!/bin/sh' '[ ! -e made ] && echo ok b' 'echo 1..1' >beside
printf '%s\n' '#!/bin/sh' '[ -e made ] && echo ok c' 'echo 1..1' >behind
chmod +x first beside behind
"$root/tests/run" -j 3 ./first ./beside -- ./behind >out 2>&1
holds 'behind -- the first is waited for, and not before' \
    grep -qx '3 passed, 0 failed' out
# And from then on four run where two did: each waits for the other three.
for name in a b c d; do
    printf '%s\n' '#!/bin/sh' ": >started.$name" 'for i in 1 2 3 4 5 6 7 8 9; do' \
        '    set -- started.*; [ $# -lt 4 ] || break; sleep 1' 'done' \
        "[ \$# -eq 4 ] && echo ok $name" 'echo 1..1' >"$name" && chmod +x "$name"
done
rm made
"$root/tests/run" -j 2 ./first ./beside -- ./a ./b ./c ./d >out 2>&1
holds 'then two more run beside them' grep -qx '6 passed, 0 failed' out

# What tries both commands in bare roots refuses what it cannot do.
printf '%s\n' '#!/bin/sh' 'if [ "$1" = -u ]; then echo 1000; else echo anna; fi' >id
chmod +x id
refuses_systems() { # WORDS NAME...
    words=$1
    shift
    PATH="$work:$PATH" "$root/tests/systems/run" "$@" >out 2>&1
    [ $? -eq 2 ] && [ "$(wc -l <out)" -eq 1 ] && grep -q "^systems: $words" out || {
        cat out
        return 1
    }
}
holds 'roots of a system that is none' refuses_systems "'woody' is neither" woody
holds 'roots made by somebody else than root' refuses_systems '.*this is anna' trixie
echo 1..17
