#!/bin/sh
# The book and its instructor's edition build, with every figure; nothing
# sticks out; the equations have the numbers that the examiner knows.
. tests/programs/common
# Two recipes side by side: each of them with one thread.
OMP_NUM_THREADS=1 ${MAKE:-make} -j2 book-parts >"$work/parts" 2>&1
holds 'figures and runs are made' \
    sh -c "[ $? -eq 0 ] || { tail -5 $work/parts; false; }"
# The others begin with the numbers of the book. TeX works alone, so pages are
# made beside it.
${MAKE:-make} -j2 book site >"$work/book" 2>&1
holds 'the book builds, and the pages of the reader' \
    sh -c "[ $? -eq 0 ] || { tail -5 $work/book; false; }"
${MAKE:-make} -j2 build/bonkers-instructor.pdf build/site-instructor/made \
    >"$work/lecturers" 2>&1
holds 'and what lecturers get' \
    sh -c "[ $? -eq 0 ] || { tail -5 $work/lecturers; false; }"
${MAKE:-make} book site EDITION=instructor >"$work/instructor" 2>&1
holds 'the instructor'"'"'s edition is all of that' \
    sh -c "[ $? -eq 0 ] || { tail -5 $work/instructor; false; }"
holds 'and make names them' \
    grep -qx 'The pages: open build/site-instructor/index.html' "$work/instructor"
holds 'and the PDF' \
    grep -qx 'The book: build/bonkers.pdf' "$work/book"
for volume in bonkers bonkers-instructor; do
    holds "build/$volume.pdf is there" test -s "build/$volume.pdf"
done
holds 'the equations have the numbers of tests/equations.txt' \
    chapters/press/equations --check
for script in plots/[0-9]*.gp; do
    figure=build/figures/$(basename "$script" .gp)
    holds "$figure is drawn for the book and the page" \
        test -s "$figure.pdf" -a -s "$figure.svg"
    holds "$figure.svg says what it shows" grep -q '<desc>' "$figure.svg"
done
cksum build/*.pdf >"$work/before"
${MAKE:-make} book >"$work/again" 2>&1
holds 'made again, nothing runs' \
    sh -c "! grep -e 'build/bin/' -e ' cc ' -e gnuplot $work/again"
cksum build/*.pdf >"$work/after"
holds 'and the PDFs stay' cmp "$work/before" "$work/after"
set -- plots/[0-9]*.gp
echo "1..$((11 + 2 * $#))"
