#!/bin/sh
# What a compiler says and what it means: one file for each mistake in
# messages/, with the state in its first line and what must be said below,
# tried with gcc and with clang; and crashes, with the sanitizers and without.
. tests/examiner/kit

errors=$(echo "$cc" | grep -o -e '-Werror=[a-z-]*' | tr '\n' ' ')

# use COMPILER FLAG...: a kit made by another compiler.
use() {
    compiler=$*
    rm -f build/check/flags build/check/libcheck.a build/check/*.suite.o
    mkdir -p objects
    base="$* -std=c11 -D_XOPEN_SOURCE=700 -ffp-contract=off -g -O1 $errors"
    for file in src/examiner/check.c src/examiner/no_hidden.c \
        src/toolbox/random.c; do
        # shellcheck disable=SC2086
        $base -Isrc -c "$file" -o "objects/$(basename "$file" .c).o" ||
            return 1
    done
    rm -f build/check/libcheck.a
    ar rcs build/check/libcheck.a objects/*.o
    # shellcheck disable=SC2086
    $base -Isrc -c "$here/suite.c" -o build/check/99a.suite.o || return 1
    printf '%s\n%s\n' "$base" "$libraries" >build/check/flags
}
judged() { # file state
    grep -q "^99a  Twice  *$2  " out && narrow || return 1
    sed -n 's/^\/\* says: \(.*\) \*\/$/\1/p' "$1" >wanted
    [ -s wanted ] || return 1
    while IFS= read -r words; do
        says "$words" || return 1
    done <wanted
}
try() { # file
    name=${1##*/}
    state=$(sed -n '1s/^\/\* \([a-z ]*\): .* \*\/$/\1/p' "$1")
    cp "$1" "$name"
    build/check/examine --seconds 1 --as 99a --file "$name" >out 2>&1
    verdict "$compiler, $name: $state" judged "$1" "$state"
}

# crash TRAP PATTERN...: the trap crashes, and each pattern is said.
crash() {
    trap=$1
    cp "$here/traps/$trap.c" "my-$trap.c"
    build/check/examine --seconds 2 --as 99a --file "my-$trap.c" >out 2>&1
    shift
    for words; do
        verdict "$compiler, $trap.c crashes: $words" \
            eval 'grep -q "^99a  Twice  *crashed " out && says "$words"'
    done
}

sanitizers='-fsanitize=address,undefined -fno-sanitize=object-size
-fno-sanitize-recover=undefined'
echo 'int main(void) { return 0; }' >main.c
fewer=0
for cc in gcc clang; do
    use $cc || echo "not ok examiner: $cc - it builds no kit"
    for file in "$here"/messages/*.c; do
        try "$file"
    done
    nowhere='^  where  *Only a compiler with sanitizers could tell the line'
    crash null '^  what  *SIGSEGV: it used a pointer' "$nowhere"
    crash divide '^  what  *SIGFPE: .*divided by zero' "$nowhere"
    crash abort '^  what  *SIGABRT: it called abort' "$nowhere"
    crash stack '^  what  *SIGSEGV: .*$' "$nowhere"
    # shellcheck disable=SC2086
    if $cc $sanitizers -o main main.c 2>said && ./main; then
        use $cc $sanitizers
        compiler="$cc with sanitizers"
        crash null 'null pointer' '^  where  *my-null.c:7' '  |.*nowhere + x'
        crash divide 'division by zero' '^  where  *my-divide.c:7'
        crash abort 'SIGABRT: ' '^  where  *my-abort.c:7, in the function twice'
        # The page that is not there is met first by whatever writes to it:
        # mostly the function's beginning, but once in a hundred the call.
        crash stack 'the stack is full' '^  where  *my-stack.c:[678], .* twice'
    else
        fewer=$((fewer + 9)) # such a compiler
    fi
done
echo "1..$((94 - fewer))"
