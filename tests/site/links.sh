#!/bin/sh
# The pages, without a browser: each link of each edition leads to a place, what
# is read lies beside them, nothing of TeX is left, the numbers are those of the
# PDF, and what the PDF says stands in them.
. tests/programs/common
LC_ALL=C
export LC_ALL
for edition in '' -instructor; do
    awk -f tests/site/links.awk build/site$edition/*.html build/site$edition/src/*.html \
        >"$work/all"
    sed '$d' "$work/all" >"$work/wrong"
    holds "nothing is wrong in build/site$edition" \
        sh -c "sed 5q '$work/wrong'; [ ! -s '$work/wrong' ]"
    holds 'and there are many links' \
        [ "$(sed -n '$s/ links$//p' "$work/all")" -gt 5000 ]
done

# What is wrong is seen: two pages alone, before and after.
mkdir "$work/site"
for file in figures live src page.css page.js; do
    ln -s "$PWD/build/site/$file" "$work/site"
done
cp build/site/05-disks.html "$work/site"
wrong() {
    sed "s|^<main.*|&$1|" build/site/03-equilibrium.html \
        >"$work/site/03-equilibrium.html"
    awk -f tests/site/links.awk "$work"/site/*.html | sed '$d' | sort
}
wrong '' >"$work/before"
planted() { # NAME WHAT-IT-SAYS HTML
    wrong "$3" | comm -13 "$work/before" - >"$work/wrong"
    holds "seen: $1" sh -c \
        "cat '$work/wrong'; [ \"\$(cat '$work/wrong')\" = '$2' ]"
}
planted 'a link to no page' '03-equilibrium.html: nowhere.html is not there' \
    '<a href="nowhere.html">x</a>'
planted 'a link to no place' \
    '03-equilibrium.html: no place sec:none in 05-disks.html' \
    '<a href="05-disks.html#sec:none">x</a>'
planted 'a place that is there twice' \
    '03-equilibrium.html: two places are called sec:ten' \
    '<i id="sec:ten"></i>'
planted 'a link to no name of src' '03-equilibrium.html: src/none.html is not there' \
    '<a href="src/none.html#x">x</a>'
planted 'a picture that is not there' \
    '03-equilibrium.html: figures/none.svg is not there' \
    '<img src="figures/none.svg">'
planted 'a macro that nobody has read' \
    '03-equilibrium.html: TeX is left: \unread{x}' '<p>\\\\unread{x}</p>'
planted 'a placeholder' '03-equilibrium.html: something is left: QB12BQ' \
    '<p>QB12BQ</p>'

# A macro that is new to the pages ends their making, with its name.
printf '%s\n' '\chapter{Ten}\label{ch:equilibrium}' '' 'A \unread{word}.' \
    >"$work/chapter.tex"
awk -v page=03-equilibrium -v pieces="$work/pieces" \
    -v uses="$work/uses" -v heads=build/pages/heads -v edition= \
    -f chapters/press/site/text.awk -f chapters/press/site/read.awk \
    build/pages/places build/book/results.tex build/book/files.tex \
    build/book/terms.tex chapters/D-glossary.nw "$work/chapter.tex" >"$work/out" 2>&1
holds 'a macro that is new is named' \
    sh -c "[ $? -eq 1 ] && grep -q 'what is .unread?' '$work/out'"

# The numbers, as TeX has counted them: of each label that it has written down.
sed -n '/{[a-z]*[*]\.[0-9]*}{}}$/d
    s/^\\newlabel{\([a-z]*:[^}]*\)}{{\([^}]*\)}.*/\1 \2/p' \
    build/book/book.aux | grep -v '^fail:' | sort >"$work/tex"
awk -F '\t' '$3 ~ /^(chapter|appendix|section|equation|figure|table|exercise)$/ {
    print $1 " " $4 }' build/pages/places | sort >"$work/pages"
sort "$work/tex" | sed 's/{}//g' | join -a 1 - "$work/pages" |
    awk '$2 != $3 { print; bad = 1 } END { exit bad }' >"$work/other" 2>&1
holds 'the numbers are those of the PDF' \
    sh -c "sed 5q '$work/other'; [ ! -s '$work/other' ]"
holds 'of some 600 labels' test "$(wc -l <"$work/tex")" -gt 600
sed -n 's/^\\bibcite{\(.*\)}{\([0-9]*\)}/cite.\1 \2/p' build/book/book.aux |
    sort >"$work/tex"
awk -F '\t' '$3 == "cite" { print $1 " " $4 }' build/pages/places | sort |
    cmp - "$work/tex" >"$work/other" 2>&1
holds 'and so are those of the citations' test $? -eq 0 -a -s "$work/tex"

# What the woven chapters have the pages have.
counted() { grep -o -e "$1" $2 | wc -l; }
chapters=$(awk -F '\t' '$5 != "" { n = split($5, f, " ")
    for (i = 1; i <= n; ++i) print "build/" f[i] ".tex" }' build/pages/pages)
# Two tables are written by runs.
chapters="$chapters $(sed -n '/runs.*\.tex$/p' build/pages/*.uses | sort -u)"
pages=$(awk -F '\t' '$5 != "" { print "build/site/" $1 ".html" }' build/pages/pages)
for pair in '\\nwbegincode{|<div class="chunk"' '\\begin{equation}|class="formula" id=' \
    '^\(\\nw.*\)\{0,1\}\\plotfigure|<img src="figures' \
    '\\begin{exercise}|<section class="exercise"' '\\begin{question}|<div class="question"' \
    '\\begin{labsheet}|<div class="labsheet"' '^\\transcript{\|^\\begin{verbatim}|<pre class="run"' \
    '\\begin{tabular}\|\\begin{longtable}|<table' '^\\term[[{]|<dt id="gloss'
do
    holds "as many as in the chapters: ${pair##*|}" \
        [ "$(counted "${pair%|*}" "$chapters")" -eq "$(counted "${pair##*|}" "$pages")" ]
done

holds 'what is searched has at most 2 MB' \
    [ "$(wc -c <build/site/search-data.js)" -le 2000000 ]
holds 'nothing is fetched from elsewhere' sh -c \
    '! grep -hE "(src|srcset)=\"(https?:)?//|url\(.?(https?:)?//|<link [^>]*https?:" \
        build/site/*.html build/site/*.css'

# Nothing has changed: no page is made anew.
touch "$work/now"
chapters/press/site/make >"$work/out" 2>&1
holds 'made again, nothing is written' \
    sh -c "[ $? -eq 0 ] && [ -z \"\$(find build/site -name '*.html' -newer '$work/now')\" ]"
echo 1..27
