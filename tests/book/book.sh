#!/bin/sh
# The book and its instructor's edition build, with every figure; nothing
# sticks out; the equations have the numbers that the examiner knows.
. tests/programs/common
# Two recipes side by side: each of them with one thread.
OMP_NUM_THREADS=1 ${MAKE:-make} -j2 book-parts >"$work/parts" 2>&1
holds 'figures and runs are made' \
    sh -c "[ $? -eq 0 ] || { tail -5 $work/parts; false; }"
# Two cores, two editions.
${MAKE:-make} book EDITION=instructor >"$work/instructor" 2>&1 &
${MAKE:-make} book >"$work/book" 2>&1
holds 'the book builds' sh -c "[ $? -eq 0 ] || { tail -5 $work/book; false; }"
wait $!
holds 'the instructor'"'"'s edition builds' \
    sh -c "[ $? -eq 0 ] || { tail -5 $work/instructor; false; }"
holds 'and make names the PDF' \
    grep -qx 'The book: build/bonkers.pdf' "$work/book"
holds 'the PDF is there' test -s build/bonkers.pdf
holds 'the log is clean' chapters/press/check-log build/book/book.log
holds 'the equations have the numbers of tests/equations.txt' \
    chapters/press/equations --check
for script in plots/[0-9]*.gp; do
    figure=build/figures/$(basename "$script" .gp)
    holds "$figure is drawn for the book and the page" \
        test -s "$figure.pdf" -a -s "$figure.svg"
    holds "$figure.svg says what it shows" grep -q '<desc>' "$figure.svg"
done
cksum build/bonkers.pdf >"$work/before"
${MAKE:-make} book >"$work/again" 2>&1
holds 'made again, nothing runs' \
    sh -c "! grep -e 'build/bin/' -e ' cc ' -e gnuplot $work/again"
cksum build/bonkers.pdf >"$work/after"
holds 'and the PDF stays' cmp "$work/before" "$work/after"
echo 1..237
