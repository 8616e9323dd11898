#!/bin/sh
# The book is carried about and read: so many pages, so much prose to its code,
# counted by chapters/press/measure; on the paper, in the type and on the text
# block that the numbers were set for. And what counts does count.
. tests/programs/common
measure=chapters/press/measure

# What is a word, what a line of code.
counts() { # NAME WORDS LINES, a chapter on standard input
    got=$($measure --words)
    holds "$1" test "$got" = "$2 $3" || echo "found $got, expected $2 $3"
}
counts 'plain words' 6 0 <<'END'
Two beads meet, and don't part.
END
counts 'a chunk is code; what stands between chunks is not' 3 2 <<'END'
One word
<<Say it>>=
x = 1; /* not a word */

y = 2;
@ more.
END
counts 'what is set verbatim is code' 1 2 <<'END'
Look:
\begin{verbatim}
while true
    step
\end{verbatim}
END
counts 'mathematics is no word' 4 0 <<'END'
Let $x$ be \[ a + b \] the place
\begin{equation}
  x = \text{never}
\end{equation}
\eqref{eq:flight}.
END
counts 'quoted code, commands and names of files are none' 4 0 <<'END'
Call [[collide]] from \prog{bonkers --help} in \cfile{a/file}; \textbf{now}
\cite{knuth}.
END
counts 'tables and captions are none' 2 0 <<'END'
Before \begin{tabular}{ll} not & this \\ \end{tabular}
\plotfigure[Short]{01-drift}{A long caption with a \result{a}{b} in it.} after
END
counts 'recipes and remarks are none' 1 0 <<'END'
%run first: build/bin/collide --velocities 1,0 \
%   --inverse-masses 1,0.25
\transcript{first} word % a remark
END
printf '%s\n' 'a = b + 1;' 'go(on);' '}' >"$work/code"
{
    printf '2 Head\n'
    for i in 1 2 3 4; do printf '   a = b + 1;\n'; done
    printf 'Prose.\n 43\n\f2 Head\n'
    for i in 1 2 3 4 5; do printf '   go(on);\n   }\n'; done
    printf 'Prose.\n 44\n\f2 Head\nProse.\nMore prose.\n45\n'
} >"$work/text"
holds 'a page with five lines of six is almost all code, one with four is not' \
    test "$($measure --pages "$work/code" <"$work/text" | tr '\n' ' ')" = '0 1 0 '

# The measure itself.
$measure >"$work/table"
cat "$work/table" | sed 's/^/# /'
all() { awk -v column="$1" '$1 == "all" { print $column + 0 }' "$work/table"; }
is() { awk "BEGIN { exit !($1) }"; }
holds 'every chapter is in the table' \
    test "$(awk '$1 ~ /^[0-9]+$/ && $2 > 0 && $3 > 0' "$work/table" | wc -l)" -eq 12
holds 'at most 500 pages' is "$(all 2) <= 500"
# The longest: the chooser's core is printed whole, and every failure has its picture.
holds 'chapter 12 has at most 60' \
    is "$(awk '$1 == 12 { print $2 }' "$work/table") <= 60"
holds 'ten words or more to a printed line of code' is "$(all 5) >= 10"
awk '$1 ~ /^[0-9]+$/ && !($5 >= 6) { print "chapter", $1, "has", $5 }' \
    "$work/table" >"$work/low"
holds 'no chapter has less than six' test ! -s "$work/low"
cat "$work/low"
holds 'of a hundred pages at most twelve are almost all code' is "$(all 6) <= 12"
holds '40 to 46 exercises' is "$(all 7) >= 40 && $(all 7) <= 46"
preface=$(sed -n 's/.*nonumberline Preface}{\([0-9]*\)}.*/\1/p' build/book/book.toc)
holds 'the first sentence stands on page five or before' \
    is "${preface:-99} <= 5"

# What it is measured on: A4, eleven points, a block of 418 by 676 points in
# one column, code in lines of 76, figures not below 7 points (figures.sh).
holds 'on A4' sh -c "pdfinfo build/bonkers.pdf |
    awk '/^Page size:/ { exit !(\$3 > 595 && \$3 < 596 && \$5 > 841 && \$5 < 843) }'"
holds 'in eleven points' grep -q '^\\documentclass\[fontsize=11pt,paper=a4' \
    chapters/press/volume.tex
block() { sed -n "s/^measure: $1=//p" build/book/book.log; }
holds 'in one column of 418 points by 676' \
    test "$(block textwidth) $(block columnwidth) $(block textheight)" = \
    '418.0pt 418.0pt 676.0pt'
holds 'prose in 10.95 points on lines of 14.1, code in 10' \
    test "$(block prose) $(block code)" = '10.95/14.1439pt 10'
holds 'code has 76 columns' grep -q '^ColumnLimit: *76' .clang-format
echo 1..21
