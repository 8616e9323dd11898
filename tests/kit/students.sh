#!/bin/sh
# No target writes a student's file, and a kit without the big tools still
# builds and checks: only cc, make and CUnit.
. tests/programs/common
kit=$work/kit
mkdir "$kit"
tar cf - --exclude=./build --exclude=./.git . | (cd "$kit" && tar xf -)
chmod -R u+w "$kit"
# Programs and what checks are made here; of the objects, which are compiled by
# one rule, a few: handout.sh compiles all of them, in a course from its archive.
mkdir "$kit/build"
for file in compiler compiler.mk made obj; do
    cp -Rp build/$file "$kit/build" || exit 1
done
cd "$kit" || exit 1
rm -rf build/made/check build/made/grade build/made/tests \
    build/obj/toolbox/options.o build/obj/line/collide.o \
    build/obj/programs/step.o build/obj/examiner/examine.o
# The names are those of the solutions, file for file.
for name in solutions/*.c; do
    name=${name#*/}
    cp "tests/exercises/${name%%-*}/stub.c" "exercises/$name"
done

# A PATH with little more than cc and make.
mkdir "$work/bin"
for tool in sh as ld make ar cat cp mv rm mkdir rmdir sed \
    grep awk mawk gawk printf echo test tr cut head tail sort uniq wc ls \
    dirname basename cksum cmp diff mktemp find touch date expr true false \
    chmod sleep timeout env uname; do
    for folder in /usr/local/bin /usr/bin /bin; do
        [ -x $folder/$tool ] && ln -sf $folder/$tool "$work/bin/$tool"
    done
done
# A compiler looks for its parts where it is called: no link, but a call.
printf '#!/bin/sh\nexec %s "$@"\n' "$(command -v cc)" >"$work/bin/cc"
chmod +x "$work/bin/cc"
PATH=$work/bin
export PATH
make >"$work/out" 2>&1
holds 'bare make needs only cc and make' grep -q '^Next: ' "$work/out"
holds 'and shows a collision' grep -q 'velocity 1 -> -0.6' "$work/out"
make -s check >"$work/out" 2>&1
holds 'make check in a fresh kit exits 0' test $? -eq 0
holds 'and says that nothing is begun' grep -q 'Nothing is begun' "$work/out"
holds 'and names the first exercise' grep -q '01a-' "$work/out"
for goal in tangle check-tangle format book; do
    make -s $goal >"$work/out" 2>&1
    status=$?
    holds "make $goal asks for what it lacks" \
        sh -c "tail -3 $work/out; [ $status -ne 0 ] && grep -q 'apt-get install' $work/out"
done

# A begun exercise: kept as it is by every target, and make check exits 1.
mine=exercises/01a-collide.c
sed 's/NOT_DONE_YET(u1)/u2/; s/NOT_DONE_YET(u2)/u1/' tests/exercises/01a/stub.c \
    >$mine
cksum $mine >"$work/before"
make -s check >"$work/out" 2>&1
holds 'make check exits 1 when something begun fails' test $? -ne 0
holds 'and says failed' grep -q '^01a .*failed' "$work/out"
cp solutions/01[ab]-*.c exercises/
make -s check >"$work/out" 2>&1
holds 'two begun exercises that are right pass together' \
    sh -c "[ $? -eq 0 ] && [ \$(grep -c ' passed' $work/out) -eq 2 ]"
cksum $mine >"$work/before"
make -s all check tangle test-parts clean >/dev/null 2>&1
cksum $mine >"$work/after"
holds 'no target writes a student'"'"'s file' cmp "$work/before" "$work/after"
echo 1..13
