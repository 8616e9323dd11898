#!/bin/sh
# make slides: all figures of a chapter stand in them with their titles, in the
# order of the book, one a page.
. tests/programs/common
slides=chapters/press/slides
for number in 01 02 03 04 05 06 07 08 09 10 11 12; do
    $slides --list $number >"$work/list"
    cut -f 1 "$work/list" | sort >"$work/shown"
    ls plots/$number-*.gp | sed 's/.*\///; s/\.gp$//' | sort >"$work/drawn"
    holds "chapter $number: every figure, once" cmp "$work/shown" "$work/drawn"
    holds "chapter $number: each has a title" \
        awk -F '\t' '$2 == "" { exit 1 }' "$work/list"
done
mkdir -p "$work/kit/chapters/press" "$work/kit/build/lecture" "$work/kit/plots"
cp chapters/press/slides chapters/press/recipes chapters/press/lines "$work/kit/chapters/press"
printf '%s\n' '\chapter{Ways}\label{ch:ways}' \
    '\plotfigure[A way down]{09-down}{Text.}' '\plotfigure[A way up,' \
    'by steps]{09-up}{Text.}' >"$work/kit/chapters/09-ways.nw"
for name in down up; do
    printf '%s\n' '# alt: A line.' "set title '$name'" 'plot x' \
        >"$work/kit/plots/09-$name.gp"
    gnuplot -e "set terminal pdfcairo size 32cm,18cm; set output \
        '$work/kit/build/lecture/09-$name.pdf'; plot x" >"$work/drawing" 2>&1
done
holds 'two are set' sh "$work/kit/chapters/press/slides" 09
pdftotext -layout "$work/kit/build/slides-09.pdf" "$work/text"
holds 'on a page of their own behind the title' \
    sh -c "tr '\f\n' '|;' <'$work/text' | tr -s ' ;' ' ' |
        grep -q 'Chapter 9.*Ways.*|.*A way down.*|.*A way up, by steps'"
for chapter in 77 x '1 2'; do
    ${MAKE:-make} -s slides CHAPTER="$chapter" >"$work/words" 2>&1
    holds "chapter '$chapter' is refused" \
        grep -q "slides: CHAPTER: '$chapter' is no chapter" "$work/words"
done
echo 1..29
