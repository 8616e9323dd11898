#!/bin/sh
# Both editions of the book as they were last made: outlines for every font, a quiet log;
# the equation numbers that the examiner quotes. And each check sees its mistake.
set -u
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
no_bitmaps() { awk '$0 ~ / Type 3 / { bad = 1 } END { exit bad || NR < 3 }'; }
# The files of fonts that TeX lists at the end of its log are outlines, all of
# them. (To ask pdffonts about a book of a thousand pages takes five seconds;
# it is asked about the figures, which bring their own.)
outlines() {
    awk '/^Here is how much/ { end = 1 } end { all = all $0 }
        END {
            n = split(all, file, "<")
            for (i = 2; i <= n; ++i)
                if (file[i] !~ /^[^>]*\.(pfb|otf|ttf)>/) bad = 1
            exit bad || n < 4
        }' "$1"
}
if [ -e build/bonkers.pdf ]; then
    for volume in bonkers=book/book bonkers-instructor=book-instructor/book; do
        pdf=build/${volume%=*}.pdf
        if outlines "build/${volume#*=}.log"; then
            echo "ok pdf: no bitmap fonts in $pdf"
        else
            echo "not ok pdf: no bitmap fonts in $pdf - a pk file, or none"
        fi
        if chapters/press/check-log "build/${volume#*=}.log"; then
            echo "ok pdf: the log of $pdf is quiet"
        else
            echo "not ok pdf: the log of $pdf is quiet - see above"
        fi
    done
    for figure in build/figures/*.pdf; do
        pdffonts "$figure"
    done >"$scratch/fonts"
    if no_bitmaps <"$scratch/fonts"; then
        echo 'ok pdf: no bitmap fonts in the figures'
    else
        echo 'not ok pdf: no bitmap fonts in the figures - Type 3, or nothing'
    fi
    if chapters/press/equations --check; then
        echo 'ok pdf: equation numbers'
    else
        echo 'not ok pdf: equation numbers - see above'
    fi
    tr -s ' \f' '\n' <"$(tests/text-of build/bonkers.pdf)" >"$scratch/words"
    missing=$(ls plots/[0-9]*.gp | sed 's/.*\///; s/\.gp$//' | grep -vxF -f "$scratch/words")
    if [ -z "$missing" ]; then
        echo 'ok pdf: each figure has its name beside it'
    else
        echo 'not ok pdf: each figure has its name beside it - not' $missing
    fi
fi

printf 'name type\n---- ----\nXYZ+SFRM1000 Type 3   Custom yes\n' | no_bitmaps &&
    echo 'not ok pdf: a bitmap font is seen - it was not' ||
    echo 'ok pdf: a bitmap font is seen'
printf '%s\n' 'Here is how much of TeX' '{lm-ec.enc}</lm/lmr9.pfb></lm/lmr' \
    '10.pfb></ec/tcrm1000.600pk></lm/lmr8.pfb>' >"$scratch/book.log"
outlines "$scratch/book.log" &&
    echo 'not ok pdf: and so is a file of one - it was not' ||
    echo 'ok pdf: and so is a file of one'
seen() { # name log-line status
    printf '%s\n' 'This is pdfTeX' "$2" '[]text' >"$scratch/book.log"
    chapters/press/check-log "$scratch/book.log" 2>/dev/null
    status=$?
    [ "$status" -eq "$3" ] && echo "ok pdf: $1" ||
        echo "not ok pdf: $1 - status $status for '$2'"
}
seen 'an overfull box' 'Overfull \hbox (1.2pt too wide) in paragraph at lines 1--2' 1
seen 'a hair over is let pass' 'Overfull \hbox (0.9pt too wide) in paragraph at lines 1--2' 0
seen 'an overfull page' 'Overfull \vbox (12.0pt too high) has occurred while \output is active' 1
seen 'an undefined reference' "LaTeX Warning: Reference \`eq:x' on page 3 undefined on input line 4." 1
seen 'an undefined citation' "LaTeX Warning: Citation \`x' on page 3 undefined on input line 4." 1
seen 'a label given twice' "LaTeX Warning: Label \`eq:x' multiply defined." 1
seen 'a missing character' 'Missing character: There is no x in font y!' 1
seen 'a run too few' 'LaTeX Warning: Label(s) may have changed. Rerun to get cross-references right.' 1
seen 'a quiet log' 'Underfull \hbox (badness 1000) in paragraph at lines 1--2' 0

mkdir -p "$scratch/chapters/press" "$scratch/build/book" "$scratch/tests"
cp chapters/press/equations "$scratch/chapters/press/"
cd "$scratch" || exit 1
printf '%s\n' '\newlabel{eq:b}{{1.2}{3}{Two}{equation.1.2}{}}' \
    '\newlabel{sec:x}{{1}{3}{}{}{}}' \
    '\newlabel{eq:a}{{1.1}{3}{One}{equation.1.1}{}}' >build/book/book.aux
chapters/press/equations && [ "$(cat tests/equations.txt)" = 'eq:a 1.1
eq:b 1.2' ] && chapters/press/equations --check &&
    echo 'ok pdf: equation numbers are listed' ||
    echo 'not ok pdf: equation numbers are listed - they are not'
echo 'eq:a 1.3' >tests/equations.txt
chapters/press/equations --check 2>/dev/null &&
    echo 'not ok pdf: another number is seen - it was not' ||
    echo 'ok pdf: another number is seen'
echo 1..20
