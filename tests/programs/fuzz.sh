#!/bin/sh
# Some hundred commands that are wrong, of all programs, under the sanitizers;
# and the judge of them, who has to notice programs that misbehave.
. tests/programs/common

holds 'wrong commands are refused, and leave nothing' \
    ${MAKE:-make} -s fuzz-commands COMMANDS=100 SEED=1

# planted NAME WHY BODY: a program that goes wrong in this way is caught.
mkdir -p "$work/bin" "$work/folder"
planted() {
    cat >"$work/bin/$1" <<END
#!/bin/sh
if [ "\$1" = --help ]; then
    echo '  -o, --output FILE  for the table'
    exit
fi
$3
END
    chmod +x "$work/bin/$1"
    echo "$1 -o new.dat" >"$work/commands"
    build/fuzz/commands "$work/bin" "$work/folder" "$work/commands" 1 0 \
        "${4-20}" 1 >"$work/caught" 2>&1
    status=$?
    if [ -n "$2" ]; then
        holds "caught: $2" grep -q "^[0-9]*: $2 (" "$work/caught"
    else
        holds 'one that behaves is left alone' test $status -eq 0
    fi
}
planted good '' 'echo "good: no" >&2; exit 2'
planted crashes 'it crashes' 'kill -ABRT $$'
planted strange 'it crashes' 'echo "strange: no" >&2; exit 3'
planted dirty 'a sanitizer complains' 'echo "x.c:1: runtime error: y" >&2'
planted silent 'it does not say why' 'exit 1'
planted nameless 'it does not say why' 'echo no >&2; exit 1'
planted wordy 'it says too much' \
    'for i in 1 2 3 4 5 6 7 8 9; do echo "wordy: $i" >&2; done; exit 2'
planted leaves 'it leaves a temporary file' 'touch bonkers.a1b2c3'
planted strays 'it writes to a file that was not asked for' 'echo 1 >other'
planted hasty 'refused, and it wrote a file' \
    'echo 1 >new.dat; echo "hasty: no" >&2; exit 2'
planted halves 'it leaves half a line' 'printf 1 >new.dat'
planted takes 'it takes a file away' 'rm -f old.dat'
planted endless 'it takes for ever' 'while :; do :; done' 1
echo 1..14
