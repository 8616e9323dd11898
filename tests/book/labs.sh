#!/bin/sh
# Each lab sheet has its page for the instructor: what is usually predicted,
# what comes out, an answer to each open question, ten points. And students do
# not get it.
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
echo 1..38
