#!/bin/sh
# Each lab sheet has its page for the instructor: what is usually predicted,
# what comes out, an answer to each open question, ten points. Each project has a
# rubric of five points. And students get neither, on paper, as pages or with the chapters.
. tests/programs/common
for number in 01 02 03 04 05 06 07 08 09 10 11 12; do
    page=solutions/lab-$number.tex
    holds "lab sheet $number: predicted, and what comes out" sh -c "
        grep -q 'What is usually predicted' $page &&
        grep -q 'What comes out' $page"
    asked=$(cat chapters/$number-*.nw | grep -c '^\\begin{question}')
    holds "lab sheet $number: its $asked open questions are answered" \
        test "$asked" -gt 0 -a "$(grep -c '^\\answer{' $page)" -eq "$asked"
    holds "lab sheet $number: ten points" test 10 = \
        "$(sed -n 's/^\\item\[\([0-9]*\)\].*/\1/p' $page | awk '{ n += $1 } END { print n }')"
done
said() { grep -c 'To the lab sheet' "$(tests/text-of "build/$1.pdf")"; }
holds 'they stand in the instructor'"'"'s edition' test "$(said bonkers-instructor)" -eq 12
holds 'and not in the students'"'"'' test "$(said bonkers)" -eq 0
for project in P1 P2 P3 P4; do
    page=solutions/rubric-$project.tex
    holds "project $project: five points, for people to give" \
        test 5 = "$(sed -n '/^A point each:$/,/^.end{enumerate}/s/^\\item .*/x/p' $page | wc -l)"
    holds "project $project: its rubric has a place" \
        grep -q "^.projectrubric{$project}{" chapters/B-lecturers.nw
done
# rubrics FILE...: how many rubrics of projects stand in the files; nothing, and so no
# test passes, where a file is missing.
rubrics() { cat "$@" >"$work/read" && grep -c "A point each" "$work/read"; }
printed() { rubrics "$(tests/text-of "build/$1.pdf")"; }
holds 'four rubrics in the instructor'"'"'s edition' test "$(printed bonkers-instructor)" -eq 4
holds 'and none in the students'"'"'' test "$(printed bonkers)" -eq 0
holds 'four on the instructor'"'"'s pages' test "$(rubrics build/site-instructor/*.html)" -eq 4
holds 'and none on the students'"'"' pages' \
    test "$(rubrics build/site/*.html)" -eq 0
holds 'and none in the chapters, which may be handed out' test "$(rubrics chapters/*.nw)" -eq 0
echo 1..51
