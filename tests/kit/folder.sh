#!/bin/sh
# The kit in a folder whose name has what TeX, make and a shell take for their
# own, unpacked from an archive (there is no git) by somebody whose files are
# private: the book is set, an exercise checked, a submission graded, and what was
# made on the way removed.
. tests/programs/common
here=$(pwd)
umask 077
kit="$work/Kurs, 50% ~1 (O'Brien)"
mkdir -p "$kit/chapters" "$kit/plots" "$kit/solutions" "$kit/exercises" \
    "$kit/src/toolbox" "$kit/src/examiner" "$kit/tests/exercises/01a" \
    "$kit/build/check" "$kit/build/grade"
cp -R chapters/press "$kit/chapters"
cp plots/style.gp "$kit/plots"
cp src/toolbox/version.h "$kit/src/toolbox"
cp src/examiner/*.h "$kit/src/examiner"
cp solutions/01a-collide.c "$kit/solutions"
cp solutions/01a-collide.c "$kit/exercises"
cp tests/exercises/01a/* "$kit/tests/exercises/01a"
for name in build/check/examine build/check/flags build/check/libcheck.a build/check/01a.* \
    build/grade/grade build/grade/flags build/grade/01a.*; do
    cp "$name" "$kit/$name" || exit 1
done
cd "$kit" || exit 1

# A book of one page, with a figure and a reference.
printf '%s\n' '\chapter{Two bodies}\label{ch:two}' '\plotfigure[A line]{01-line}{A line.}' \
    '\begin{equation}\label{eq:one} a = b \end{equation}' \
    'Figure~\ref{fig:01-line} is in \cite{tonks1936}.' '<<one.h>>=' 'int one;' \
    '@ %def one' >chapters/01-collide.nw
printf '%s\n' '# alt: A line.' 'width = 14' 'height = 4' "load 'plots/style.gp'" \
    'plot [0:1] x' >plots/01-line.gp
echo 'eq:one 1.1' >tests/equations.txt
holds 'a figure is drawn' sh -c 'chapters/press/recipes &&
    chapters/press/recipes --figure pdf build/figures/01-line.pdf plots/01-line.gp &&
    chapters/press/recipes --alt build/figures/01-line.alt.tex plots/01-line.gp'
holds 'chapters are woven' chapters/press/make-book woven
holds 'what both editions begin with is kept as a format' test -s build/volume.fmt
for volume in bonkers bonkers-instructor; do
    holds "$volume is set" sh -c "chapters/press/make-book $volume &&
        test -s build/$volume.pdf"
done
# What is wrong in a chapter is said at its line there, by TeX and by a compiler.
cp chapters/01-collide.nw good.nw
printf '%s\n' '' '<<one.c>>=' '#include "one.h"' '@' 'More of it.' '' 'It is \unheard{of}.' \
    >>chapters/01-collide.nw
line=$(wc -l <chapters/01-collide.nw)
chapters/press/make-book woven && chapters/press/make-book bonkers >said 2>&1
holds 'an error of TeX has the line of the chapter' \
    grep -q "^chapters/01-collide.nw:$line: .*Undefined control sequence" said
cp good.nw chapters/01-collide.nw
holds 'and tangled' sh -c 'rm -r src/examiner src/toolbox && chapters/press/tangle &&
    cat src/one.h'
cp -R "$here/src/examiner" src

rm tests/equations.txt && cp "$here/tests/equations.txt" tests
holds 'an exercise is checked' build/check/examine 01a
holds 'and nothing is left behind' test -z "$(ls -d build/check/work.* 2>/dev/null)"
mkdir -p "$work/they're 100%/Anna ~O'Brien"
cp solutions/01a-collide.c "$work/they're 100%/Anna ~O'Brien"
build/grade/grade --unsafe --exercises 01a "$work/they're 100%" >said 2>&1
holds 'a submission is graded' awk '{ print } /^ *possible / { most = $NF }
    /Anna ~O/ { got = $NF } END { exit got == "" || got != most }' said
holds 'and nothing is left behind either' test -z "$(ls -d build/grade/work.* 2>/dev/null)"
holds 'nor anything beside the kit' \
    test "$(ls "$work" | grep -vx 'err\|out\|why\|said')" = "$(printf '%s\n' \
        "Kurs, 50% ~1 (O'Brien)" "they're 100%")"

# What JSON takes for its own in a folder's name is written so that it is none.
odd="$work/a \"quoted\" \\name"
mkdir -p "$odd/src" "$odd/tests" "$odd/plots" "$odd/build"
cp "$here/Makefile" "$odd"
cp -R "$here/src/." "$odd/src"
cp "$here"/tests/*.mk "$odd/tests"
cp "$here"/plots/*.mk "$odd/plots"
cp -R "$here/build/compiler" "$here/build/compiler.mk" "$odd/build"
cd "$odd" || exit 1
${MAKE:-make} -s compile_commands.json >said 2>&1
holds 'the file for editors is JSON and tells the folder' node -e '
    const rows = JSON.parse(require("fs").readFileSync("compile_commands.json"))
    if (!rows.length || rows.some((row) => row.directory !== process.cwd()))
        throw new Error(rows[0].directory)'
echo 1..13
