#!/bin/sh
# What chapters/press/tangle promises, tried on a copy of the kit.
. tests/programs/common
holds 'src/ is what the chapters tangle to' chapters/press/tangle --check

mkdir "$work/kit"
cp -R chapters src "$work/kit"
chmod -R u+w "$work/kit"
cd "$work/kit" || exit 1
# A book of two chapters: what is refused in it is refused in all.
find chapters -name '*.nw' ! -name '01-*' ! -name 'A-*' -exec rm -f {} +
find src -type f | while read -r file; do
    head -n 1 "$file" | grep -q 'From chapters/\(01\|A\)-' || rm -f "$file"
done
fails() { # NAME PATTERN: tangling must fail and say so, src/ stay as it was
    find src -type f -exec cksum {} + | sort >"$work/before"
    chapters/press/tangle >"$work/out" 2>&1
    status=$?
    find src -type f -exec cksum {} + | sort >"$work/after"
    if [ $status -ne 1 ] || ! grep -q -e "$2" "$work/out"; then
        not_ok "$1" "status $status: $(head -c 300 "$work/out")"
    elif ! cmp -s "$work/before" "$work/after"; then
        not_ok "$1" 'src/ was changed'
    else
        ok "$1"
    fi
}
chapter=chapters/01-collide.nw
cp $chapter "$work/good.nw"

printf '\n<<line/collide.h>>=\n<<Never defined>>\n@\n' >>$chapter
fails 'an undefined chunk is refused' 'Never defined'
cp "$work/good.nw" $chapter
printf '\n<<Never used>>=\nint x;\n@\n' >>$chapter
fails 'a chunk that nothing uses is refused' 'Never used.*never used'
cp "$work/good.nw" $chapter
printf '\n<<toolbox/random.h>>=\nint x;\n@\n' >>$chapter
fails 'a file of two chapters is refused' 'two chapters'
cp "$work/good.nw" $chapter

echo 'int edited;' >>src/line/collide.c
fails 'an edit in src/ is recognised and shown' '^+int edited;'
chapters/press/tangle --check >"$work/out" 2>&1
holds 'and so does --check' grep -q '^+int edited;' "$work/out"
cp "$OLDPWD/src/line/collide.c" src/line/
echo 'int stray;' >src/line/stray.c
fails 'a file that no chapter writes is refused' 'no chapter writes it'
rm src/line/stray.c

printf '\n<<line/collide.h>>=\n/* more */\n@\n' >>$chapter
chapters/press/tangle --check >"$work/out" 2>&1
holds 'a chapter ahead of src/ is seen' grep -q 'run make tangle' "$work/out"
touch -t 200001010000 src/line/collide.c
chapters/press/tangle >"$work/out" 2>&1
holds 'tangle writes the file that changed' grep -q 'more' src/line/collide.h
holds 'and names it' grep -qx 'src/line/collide.h' "$work/out"
holds 'and leaves the others alone' test -z "$(find src/line/collide.c -newer src/line/collide.h)"
chapters/press/tangle -L "$work/lines" >"$work/out" 2>&1
holds '-L names the chapter and its line' \
    grep -q '#line [0-9]* "chapters/01-collide.nw"' "$work/lines/line/collide.c"
echo 1..12
