#!/bin/sh
# What chapters/press/tangle promises, tried on a copy of the kit.
. tests/programs/common
holds 'src/ is what the chapters tangle to' chapters/press/tangle --check

here=$(pwd)
mkdir "$work/kit"
cp -R chapters src "$work/kit"
chmod -R u+w "$work/kit"
cd "$work/kit" || exit 1
# A book of two chapters: what is refused in it is refused in all.
find chapters -name '*.nw' ! -name '01-*' -exec rm -f {} +
# shellcheck disable=SC2046
rm -f $(awk 'FNR == 1 && !/From chapters\/01-/ {
    print FILENAME }' $(find src -type f))
printf '<<programs/two.c>>=\n/* Of the second. */\nint two;\n@\n' >chapters/02-two.nw
chapters/press/tangle >"$work/out" 2>&1
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

printf '\n<<line/collide.c>>=\n<<Never defined>>\n@\n' >>$chapter
fails 'an undefined chunk is refused, at its line' \
    "$chapter:$(($(wc -l <$chapter) - 1)): .*Never defined"
cp "$work/good.nw" $chapter
printf '\n<<Never used>>=\nint x;\n@\n' >>$chapter
fails 'a chunk that nothing uses is refused' 'Never used.*never used'
cp "$work/good.nw" $chapter
printf '\n<<programs/two.c>>=\nint x;\n@\n' >>$chapter
fails 'a file of two chapters is refused' 'two chapters'
cp "$work/good.nw" $chapter

# What an editor on Windows leaves behind.
sed 's/$/\r/' "$work/good.nw" >$chapter
fails 'Windows line ends are refused' "$chapter: Windows line ends.* in"
sed '5s/$/\r/' "$work/good.nw" >$chapter
fails 'and one among others' "$chapter: Windows line ends.* in 1 of its"
{ printf '\357\273\277' && cat "$work/good.nw"; } >$chapter
fails 'a byte-order mark is refused' "$chapter: begins with a byte-order mark"
sed '5s/./\r&/' "$work/good.nw" >$chapter
fails 'a carriage return within a line, too' "$chapter:5: has a carriage return"
cp "$work/good.nw" $chapter
printf '\377\376a\000\n\000' >chapters/03-wide.nw
fails 'and UTF-16' 'chapters/03-wide.nw: is UTF-16'
rm chapters/03-wide.nw

echo 'int edited;' >>src/line/collide.c
fails 'an edit in src/ is recognised and shown' '^+int edited;'
chapters/press/tangle --check >"$work/out" 2>&1
holds 'and so does --check' grep -q '^+int edited;' "$work/out"
cp "$OLDPWD/src/line/collide.c" src/line/
# Plain files: theirs is src/, and a tangled one cannot become one by accident.
printf '%s\n' '/* A plain file. */' 'int plain;' >src/line/plain.c
echo 'What is here.' >src/line/README.md
cp src/line/plain.c "$work/plain.c"
holds 'plain files stand beside tangled ones' chapters/press/tangle
holds 'and are left alone' cmp "$work/plain.c" src/line/plain.c
holds '--check does not mind them' chapters/press/tangle --check
printf '\n<<line/plain.c>>=\nint tangled;\n@\n' >>$chapter
printf '\n<<line/new.c>>=\nint new;\n@\n' >>$chapter
fails 'a chapter that would write over a plain file is refused, the chapter named' \
    "src/line/plain.c: is plain.*$chapter writes it"
cp "$work/good.nw" $chapter
head -n 2 src/line/collide.c | cat - src/line/plain.c >src/line/stale.c
fails 'a tangled file that no chapter writes any more is refused' \
    'src/line/stale.c: was tangled, and no chapter writes it'
sed 1d src/line/stale.c >"$work/stale.c" && cp "$work/stale.c" src/line/stale.c
fails 'and one that has kept one of its two lines' 'src/line/stale.c: was tangled'
rm src/line/stale.c

printf '\n<<line/collide.c>>=\n/* more */\n@\n' >>$chapter
chapters/press/tangle --check >"$work/out" 2>&1
holds 'a chapter ahead of src/ is seen' grep -q 'run make tangle' "$work/out"
touch -t 200001010000 src/programs/check-collide.c
chapters/press/tangle >"$work/out" 2>&1
holds 'tangle writes the file that changed' grep -q 'more' src/line/collide.c
holds 'and names it' grep -qx 'src/line/collide.c' "$work/out"
holds 'and leaves the others alone' \
    test -z "$(find src/programs/check-collide.c -newer src/line/collide.c)"
chapters/press/tangle -L "$work/lines" >"$work/out" 2>&1
echo 'int wrong = ;' >"$work/wrong"
sed '/^#include "line\/collide.h"/r '"$work/wrong" $chapter >"$work/wrong.nw"
cp $chapter "$work/better.nw" && cp "$work/wrong.nw" $chapter
line=$(grep -nxF 'int wrong = ;' $chapter | cut -d : -f 1)

chapters/press/tangle -L "$work/lines" >"$work/out" 2>&1
${CC:-cc} -I"$work/lines" -I"$here/src" -c -o "$work/collide.o" "$work/lines/line/collide.c" >"$work/out" 2>&1
holds 'a compiler then says where in the chapter' \
    grep -q "^$chapter:$line:.* error" "$work/out"
cp "$work/better.nw" $chapter
chapters/press/tangle -L "$work/lines" >"$work/out" 2>&1
holds '-L names the chapter and its line' \
    grep -q '#line [0-9]* "chapters/01-collide.nw"' "$work/lines/line/collide.c"

echo 1..23
