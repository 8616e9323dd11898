#!/bin/sh
# The recipe of the book's appendix for lecturers, run as it is printed, in a copy of
# the kit: a chapter is changed, an exercise added, the course handed out and
# a submission graded.
. tests/programs/common
LC_ALL=C
export LC_ALL
unset EX HIDDEN SUBMISSIONS REPORT RESULTS SECONDS UNSAFE WITH_CHAPTERS
root=$(pwd)
kit=$work/kit
mkdir "$kit"

# What is built is taken along, so that only what changes is built again; the
# book and the pages are taken for new, since their text is another test's
# business.
tar cf - --exclude=./.git --exclude=./build . | (cd "$kit" && tar xf -)
mkdir "$kit/build"
cp -Rp build/compiler.mk build/compiler build/made build/obj build/check build/bonkers.pdf \
    build/recipes "$kit/build/" 2>/dev/null
mkdir "$kit/build/site"
cp build/site/index.html "$kit/build/site/"
[ -d build/grade ] && cp -Rp build/grade "$kit/build/"
rm -rf "$kit"/build/grade/results "$kit"/build/grade/work.*
cd "$kit" || exit 1
# A header changes, and everything is built again: a course with the exercises
# of chapter 1 is enough to add one to.
rm -rf tests/exercises/0[2-9]? tests/exercises/1?? tests/exercises/P?
find solutions exercises build/check build/grade -name '[0-9P]*' ! -name '01*' \
    ! -type d -exec rm -f {} + 2>/dev/null
git init -q . && git add -A >/dev/null 2>&1 &&
    git -c user.name=kit -c user.email=kit@localhost commit -qm kit ||
    not_ok 'the copy is put under git' 'git failed'

{
    # shellcheck disable=SC2016
    echo 'make() { command ${MAKE:-make} -o build/bonkers.pdf -o build/site/made "$@"; }'
    cat tests/kit/recipe/steps
} >"$work/steps"
sh -eu "$work/steps" >"$work/out" 2>&1
holds 'the recipe runs to its end' sh -c "[ $? -eq 0 ] ||
    { tail -5 '$work/out'; false; }"
holds 'the change of the chapter is in src/' \
    grep -q 'whether the result of this' src/line/collide.c
holds 'and the text of the exercise in the chapter' sh -c '
    grep -A 6 "^.begin{exercise}{01f}" chapters/01-collide.nw |
        grep -q "^.solutions{01}"'
holds 'its stub is not begun' \
    grep -q '^01f  What a collision can cost.* not begun' "$work/out"
holds 'its three right answers pass' \
    test "$(grep -c '^01f  What a .* passed ' "$work/out")" -eq 3
for mistake in all-of-it half-forgotten sum-of-velocities; do
    holds "its wrong answer is told [$mistake]" \
        grep -q -F "[$mistake]" "$work/out"
done
tar tzf build/bonkers-course.tar.gz >"$work/list" 2>/dev/null
for file in exercises/01f-stake.c tests/exercises/01f/suite.c \
    tests/exercises/01f/stub.c tests/exercises/01f/call.h \
    tests/exercises/01f/hints.txt; do
    holds "the archive has $file" grep -q -x "bonkers-course/$file" \
        "$work/list"
done
holds 'the archive has no solution' \
    sh -c "! grep -E 'solutions/|tests/.*/(right|wrong|plain|remote|hidden)' \
        '$work/list'"
holds 'Ada has all ten points' \
    grep -q '^"ada",10,10,10' build/grade/results/grades.csv
# The same files, looked at as the kit's own tests do.
{ cat tests/exercises/01f/stub.c && echo '/* my first line */'; } >touched.c
build/check/examine --strict --as 01f --file touched.c >"$work/strict" 2>&1
holds 'its stub stands a strict compiler' \
    sh -c "sed 1q '$work/strict' | grep -q ' not begun'"
# A method, by its own recipe.
{ sed 1q "$work/steps" && cat tests/kit/recipe/method; } >"$work/method"
sh -u "$work/method" >"$work/out" 2>&1
holds 'a method is added' sh -c "[ $? -eq 0 ] || { tail -5 '$work/out'; false; }"
holds 'help lists it' grep -q '^ *ruth3[, ]' "$work/out"
holds 'its limit is said, and then holds' test "$(sed -n \
    's/ stepping_limits: every method has the limit.*//p' "$work/out" | tr '\n' ' ')" = 'not ok ok '
cd "$root" || exit 1
for file in tests/kit/recipe/*.[ch]; do
    holds "$file keeps .clang-format" \
        clang-format --dry-run -Werror "$file"
done
echo 1..29
