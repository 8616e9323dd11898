#!/bin/sh
# Every way in which a student's file can end, one file each in traps/. Its
# first line says the state it should be given, and its `says:` lines what
# should be said; nothing else than a right answer may pass.
. tests/examiner/kit

judged() { # file state
    [ "$(sed -n '1s/^99a  Twice  *\([a-z ]*[a-z]\)  .*/\1/p' out)" = "$2" ] &&
        narrow || return 1
    case "$2" in
    passed | 'not begun') [ "$status" -eq 0 ] || return 1 ;;
    *) [ "$status" -eq 1 ] || return 1 ;;
    esac
    sed -n 's/^ *\/\* says: \(.*\) \*\/$/\1/p' "$1" >wanted
    while IFS= read -r words; do
        says "$words" || return 1
    done <wanted
}

fewer=0
for file in "$here"/traps/*.c; do
    name=${file##*/}
    if grep -q "needs: sanitizers" "$file" &&
        ! grep -q fsanitize=address build/check/flags; then
        fewer=$((fewer + 1))
        continue
    fi
    state=$(sed -n '1s/^\/\* \(.*\): .* \*\/$/\1/p' "$file")
    cp "$file" "$name"
    seconds=$(sed -n "s/^.. seconds: \([0-9]*\) .*/\1/p" "$file")
    build/check/examine --seconds "${seconds:-1}" --as 99a --file "$name" \
        >out 2>&1 </dev/zero
    status=$?
    verdict "$name is judged: $state" judged "$name" "$state"
    if says DEADLYSIGNAL; then
        echo "not ok examiner: $name - a sanitizer's cry was shown as output"
    fi
    cmp -s "$file" "$name" ||
        echo "not ok examiner: $name was changed - it is the student's"
done

[ -s lingers.pid ] && ! kill -0 "$(cat lingers.pid)" 2>/dev/null
verdict 'a process left behind is killed' [ $? -eq 0 ]
verdict 'no working folder is left' [ -z "$(ls -d build/check/work.* 2>/dev/null)" ]
verdict 'what a student writes does not land in the kit' [ ! -e written.txt ]
if [ -d /proc/self/task ]; then
    alive=
    while read -r pid; do
        kill -0 "$pid" 2>/dev/null && alive="$alive $pid"
    done <strays.pid
    verdict 'on Linux a process that left the group is killed' \
        eval '[ -s strays.pid ] && [ -z "$alive" ]'
fi
echo "1..$((52 - fewer))"
