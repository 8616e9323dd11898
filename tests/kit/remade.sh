#!/bin/sh
# What is made again, and what is not: a header reaches what includes it and
# nothing else, what comes out as it was reaches nothing, and what is gone is
# no obstacle. In a copy of the kit that has been built.
. tests/programs/common
make=${MAKE:-make}
unset CPPFLAGS CFLAGS LDFLAGS MAKEFLAGS MFLAGS V
$make -s -j2 programs build/tests/tokens >/dev/null 2>&1
kit=$work/kit
mkdir -p "$kit/build/tests"
for file in Makefile src chapters plots tests exercises; do
    cp -Rp $file "$kit"
done
for file in compiler compiler.mk made obj bin tests/tokens; do
    cp -Rp build/$file "$kit/build/$file"
done
cd "$kit" || exit 1

# made GOAL...: makes it and prints what was compiled and linked, "" if
# nothing.
made() { echo $($make "$@" 2>&1 | sed -n 's/^  \(cc\|link\) //p'); }
# Another time than before, and no other byte.
later() { sleep 0.01; touch "$@"; }

is 'what is made is not made twice' '' "$(made programs)"
holds 'and make -q says so' $make -q programs

# A header reaches the files that include it, directly or not.
# A line for each: its object, itself, and what it reads.
cc -MM -D_POSIX_C_SOURCE=200809L -Isrc src/*/*.c 2>/dev/null |
    sed -e ':more' -e '/\\$/{N;s/\\\n//;b more' -e '}' >"$work/reads"
for header in box/cells line/collide scenes/pair; do
    expected=$(echo $(awk -v header="src/$header.h" '
        $2 !~ /examiner|page/ && index($0 " ", " " header " ") { print $2 }' \
        "$work/reads" | sort))
    later src/$header.h
    is "$header.h reaches what includes it, and no program" "$expected" \
        "$(echo $(made programs | tr ' ' '\n' | sort))"
done
is 'once' '' "$(made programs)"
holds 'and make -q says so, too' $make -q programs
later src/examiner/*.h
is 'the examiner reaches no physics' '' "$(made programs)"

# What comes out as it was keeps its time.
cp -Rp build/bin build/obj "$work"
sed 's/^#include "line\/collide.h"/&\n\/* A word. *\//' src/line/collide.c \
    >"$work/other.c" && mv "$work/other.c" src/line/collide.c
is 'a comment compiles one file and links nothing' src/line/collide.c \
    "$(made programs)"
is 'no program is newer' '' "$(find build/bin -type f -newer src/line/collide.c)"
is 'nor is it another' '' "$(diff -r build/bin "$work/bin")"
is 'nor is there another object' '' "$(diff -r build/obj "$work/obj")"
sed '/ATTRIBUTE/d; s/1 + restitution/2 + restitution/' src/line/collide.c \
    >"$work/other.c" && mv "$work/other.c" src/line/collide.c
is 'another formula links all' "$((1 + $(ls build/bin | wc -l)))" \
    "$(made programs | wc -w | tr -d ' ')"
is 'and makes other programs of those that use it' 'bonkers collide' \
    "$(cd build/bin && echo $(for p in bonkers collide histogram orbit; do
        cmp -s "$p" "$work/bin/$p" || echo "$p"; done))"
holds 'nothing is left of the making' \
    sh -c "! find build -name '*.new*' | grep ."

# So are things of one file, with what they are linked with.
outlive=build/tests/mutants/outlive
is 'a tool is compiled' tests/mutants/outlive.c \
    "$(made $outlive | tr ' ' '\n' | grep -v src/examiner)"
is 'once' '' "$(made $outlive)"
later tests/mutants/outlive.c
is 'and again with its headers known' tests/mutants/outlive.c "$(made $outlive)"

# What is lost is made again, and what is gone is not asked for.
rm build/bin/orbit build/obj/line/collide.o
is 'what is lost is made again' 'src/line/collide.c build/bin/orbit' \
    "$(made programs)"
holds 'all of it' test -x build/bin/orbit -a -f build/obj/line/collide.o
printf '#include "line/gone.h"\n' >src/line/more.h
printf 'enum { GONE = 1 };\n' >src/line/gone.h
printf '#include "line/more.h"\n' >>src/line/piston.c
made programs >/dev/null
rm src/line/gone.h
: >src/line/more.h
is 'a header that is gone' src/line/piston.c "$(made programs)"
sed '$d' src/line/piston.c >"$work/other.c" && mv "$work/other.c" src/line/piston.c
rm src/line/more.h
is 'and one more' src/line/piston.c "$(made programs)"
is 'nor is anything waited for that a rule reads' '' "$(find build/made -name \
    '*.d' -exec awk '{ gsub(/\\/, "") } NF == 1 && /:$/ { alone[FILENAME $1] }
    NF > 1 { for (i = 1; i <= NF; ++i) if ($i !~ /:$/) needed[FILENAME $i ":"] }
    END { for (name in needed) if (!(name in alone)) print name }' {} + |
    head -n 1)"
printf 'int line_more(void);\nint line_more(void) { return 1; }\n' >src/line/more.c
made programs >/dev/null
rm src/line/more.c
made programs >/dev/null
holds 'a module that is gone is in no archive' \
    sh -c "! ar t build/obj/libbonkers.a | grep more"

# Flags, wherever they are given, reach every object.
sed 's/^PORTABLE = -O2/PORTABLE = -O1/' Makefile >"$work/other" &&
    mv "$work/other" Makefile
is 'other flags in the Makefile compile anew' src/line/collide.c \
    "$(made build/obj/line/collide.o)"
printf '# A word.\n' >>Makefile
is 'a word in it does not' '' "$(made build/obj/line/collide.o)"
echo 1..26
