#!/bin/sh
# Weaving: links across chapters, chunk names kept apart, mistakes refused.
set -u
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/chapters/press" "$scratch/tests/exercises/01a" "$scratch/solutions"
cp chapters/press/weave chapters/press/keywords chapters/press/volumes \
    chapters/press/across chapters/press/names chapters/press/lines chapters/press/quote \
    "$scratch/chapters/press/"
cd "$scratch" || exit 1
has() { # name needle file
    if grep -qF -- "$2" "$3"; then
        echo "ok weave: $1"
    else
        printf '%s\n' "not ok weave: $1 - no '$2' in $3"
    fi
}
refused() { # name message
    said=$(chapters/press/weave 2>&1)
    status=$?
    if [ "$status" -eq 1 ] && [ "$said" = "$2" ]; then
        printf '%s\n' "ok weave: $1"
    else
        printf '%s\n' "not ok weave: $1 - status $status and '$said'"
    fi
}
one='\chapter{One}
\section{What [[hit_it]] does}
<<one.h>>=
<<Includes>>
int hit_it(void);

@ %def hit_it
<<Includes>>=
#include <math.h>
@'
two='\chapter{Two}
<<two.c>>=
#include "one.h"
<<Includes>>
<<Call [[hit_it]] once>>
<<Includes>>=
#include <time.h>
<<Call [[hit_it]] once>>=
return hit_it(); /* hit_it */
@'
printf '%s\n' "$one" >chapters/01-one.nw
printf '%s\n' "$two" >chapters/02-two.nw
lines() { awk -v n="$1" 'BEGIN { for (i = 1; i <= n; ++i)
    print n < 14 || i != 5 && i != 9 ? "x = " i ";" : i == 5 ? "" : "do {" }'; }
{
    printf '%s\n' '\chapter{Three}' '<<ten.c>>='
    lines 10
    echo '<<more.c>>='
    lines 14
    echo '@'
} >chapters/03-three.nw
printf 'int main(void)\n{\n    return 0; /* for */\n}\n' >solutions/01a-x.c
chapters/press/weave || echo 'not ok weave: two chapters - status 1'
label=$(sed -n 's/.*sublabel{\(NW[^}]*\)}.*one\.h.*/\1/p' build/book/01-one.tex)
has 'an identifier is linked to another chapter' \
    "\\nwlinkedidentc{hit_it}{$label}" build/book/02-two.tex
grep -c 'linkedidentc' build/book/02-two.tex | grep -qx 1 &&
    echo 'ok weave: but not in a comment' ||
    echo 'not ok weave: but not in a comment - more than one link'
grep -c '^\\nwixlogsorted{c}{{Includes}' build/works/indexes.tex |
    grep -qx 2 && echo 'ok weave: chunks of two chapters stay apart' ||
    echo 'not ok weave: chunks of two chapters stay apart - merged'
has 'code in a chunk name is safe in the index' \
    '{{Call {\Tt{}hit{\_}it\nwendquote} once}' build/works/indexes.tex
has 'the lines of a chunk are counted, a blank end left out' \
    '\nwcodelines{2}{}\nwbegincode{1}' build/book/01-one.tex
has 'a page ends in a long chunk best at a blank line' \
    '\nwcodelines{14}{-----082264---}\nwbegincode{2}' build/book/03-three.tex
has 'and never in one of ten lines' \
    '\nwcodelines{10}{}\nwbegincode{1}' build/book/03-three.tex
[ ! -e build/book/solutions-01.tex ] && [ ! -s build/book/edition.tex ] &&
    echo 'ok weave: no solutions for students' ||
    echo 'not ok weave: no solutions for students - there they are'
has 'the instructor has another edition' '\instructortrue' \
    build/book-instructor/edition.tex
has 'solutions for instructors' '{\nwkeyword{}return} 0; {\nwcomment{}/* for */}' \
    build/book-instructor/solutions-01.tex

printf '%s\n' "$one" | sed 's/^@ %def.*/@ %def hit_it strike_it/' \
    >chapters/01-one.nw
refused 'a %def of what is not there' \
    'weave: chapters/01-one.nw: %def names strike_it, which is not in the chunk above it'
printf '%s\n' "$one" >chapters/01-one.nw
printf '%s\n' "$two" | sed 's/^<<Includes>>$/<<Inclusions>>/' \
    >chapters/02-two.nw
refused 'a chunk without a definition' \
    'weave: chapters/02-two.nw: no chunk is named <<Inclusions>>'
printf '%s\n' "$two" >chapters/02-two.nw

# Two volumes: a chapter and its part in Works have one set of chunk names.
mkdir chapters/works
works='\chapter{Two}
\section{The \prog{two} of [[hit_it]]}
\label{works:two}
As in \inbook{sec:one}, by~\eqref{eq:one}.
<<Includes>>=
#include <stdio.h>
<<alone.c>>=
<<Call [[hit_it]] once>>
@'
printf '%s\n' "$works" >chapters/works/02-two.nw
printf '%s\n' "$one" '\section{More}\label{sec:one}' '\begin{equation}\label{eq:one}' \
    '\end{equation}' '\inworks{how \prog{two} is' 'made}{works:two}{src/alone.c}' \
    '[[\ref{works:two}]] is no reference, % nor is \ref{works:two}' >chapters/01-one.nw
chapters/press/weave || echo 'not ok weave: two volumes - status 1'
has 'Works are woven beside the book' '\label{works:two}' build/works/02-two.tex
has 'the book knows the titles of Works' \
    '\workstitle{works:two}{The \prog{two} of \texttt{hit\_it}}' build/book/titles.tex
label=$(sed -n 's/.*sublabel{\(NW[^}]*\)}.*{Includes.*/\1/p' build/works/02-two.tex)
has 'a chunk of the book goes on in Works' "{$label}" build/book/02-two.tex
has 'and the book knows that it stands there' "\\nwelsewhere{$label}" \
    build/book/elsewhere.tex
has 'a heading of Works is a place' '\label{works:two}\worksanchor{works:two}' \
    build/works/02-two.tex
label=$(sed -n 's/.*sublabel{\(NW[^}]*\)}.*one\.h.*/\1/p' build/book/01-one.tex)
grep -qF "\\nwelsewhere{$label}" build/works/elsewhere.tex &&
    grep -qF "\\nwixadd{\\nwixd}{hit:unit}{$label}" build/works/elsewhere.tex &&
    echo 'ok weave: and so Works of what the book defines' ||
    echo 'not ok weave: and so Works of what the book defines - it does not'
# Includes: defined twice and used twice in the book, defined once in Works.
grep '{c}{{Includes}.*nwixu.*nwixd.*nwixd' build/works/indexes.tex |
    grep -v 'nwixu.*nwixu' | grep -vq 'nwixd.*nwixd.*nwixd' &&
    echo 'ok weave: the index has one place of a kind in the book' ||
    echo 'not ok weave: the index has one place of a kind in the book - others'
# A second file of Works goes with the same chapter.
printf '%s\n' '\chapter{More}' '<<more.c>>=' '<<Call [[hit_it]] once>>' '@' \
    >chapters/works/02-two-more.nw
chapters/press/weave &&
    echo 'ok weave: a chapter may have two files of Works' ||
    echo 'not ok weave: a chapter may have two files of Works - refused'
rm chapters/works/02-two-more.nw
# What noweb made of the code is kept while only words change, between chunks
# and beside what they quote.
as_from_nothing() { # name
    chapters/press/weave
    cp -R build "$scratch/soon" && rm -rf build && chapters/press/weave &&
        diff -r "$scratch/soon/book" build/book && diff -r "$scratch/soon/works" build/works &&
        echo "ok weave: $1" || echo "not ok weave: $1 - other files than from nothing"
    rm -rf "$scratch/soon"
}
sed 's/^As in/More\n\nwords than/; s/ by~/ not [[hit_it]] by~/' chapters/works/02-two.nw \
    >"$scratch/quoted"
sed 's/^As in/More\n\nwords than/' chapters/works/02-two.nw >"$scratch/worded"
chapters/press/weave
cp "$scratch/worded" chapters/works/02-two.nw
as_from_nothing 'other words are woven as from nothing'
has 'and stand there' 'words than' build/works/02-two.tex
echo '@text what is kept' >>build/tagged/plain
printf '%s\n' "$works" >chapters/works/02-two.nw
chapters/press/weave
has 'noweb is not asked for that' 'what is kept' build/tagged/plain
rm -rf build/tagged && chapters/press/weave
cp "$scratch/quoted" chapters/works/02-two.nw
as_from_nothing 'and so is what they quote'
sed 's/stdio/stdlib/' "$scratch/worded" >chapters/works/02-two.nw
as_from_nothing 'and other code'
has 'which stands there' 'stdlib.h' build/works/02-two.tex
printf '%s\n' "$works" >chapters/works/02-two.nw
# said FILE LINE MESSAGE: with this line at its end the file is refused.
said() {
    cp "$1" "$scratch/kept"
    printf '%s\n' "$2" >>"$1"
    refused "$2" "weave: $1:$(wc -l <"$1"): $3"
    cp "$scratch/kept" "$1"
}
said chapters/01-one.nw '\inworks{x}{works:three}{src/alone.c}' \
    'no heading in chapters/works has \label{works:three}'
said chapters/01-one.nw '\inworks{x}{works:two}{src/other.c}' \
    'no chapter writes src/other.c'
said chapters/01-one.nw '\inworks{x}{works:two}' \
    '\inworks wants {what}{works:label}{src/file.c}'
said chapters/01-one.nw 'See \ref{works:two}.' \
    '\ref{works:two} leads to Works (chapters/works/02-two.nw:3); write \inworks'
said chapters/works/02-two.nw 'On page~\pageref{sec:one}.' \
    '\pageref{sec:one} leads to the book, whose pages Works does not know; write \inbook or \ref'
said chapters/01-one.nw 'See \ref{sec:lost}.' 'no chapter has \label{sec:lost}'
said chapters/works/02-two.nw '\inbook{sec:two}' \
    'no chapter of the book has \label{sec:two}'
said chapters/01-one.nw '\label{sec:one}' \
    '\label{sec:one} stands already in chapters/01-one.nw:11'
said chapters/works/02-two.nw '\label{sec:one}' \
    '\label{sec:one} stands in the book, too: chapters/01-one.nw:11'
cp chapters/01-one.nw "$scratch/kept"
sed '2s/$/\r/' "$scratch/kept" >chapters/01-one.nw
refused 'a Windows line end' "weave: chapters/01-one.nw: Windows line ends (a carriage\
 return before the line feed) in 1 of its $(wc -l <"$scratch/kept") lines; save it with\
 Unix line ends, or: sed -i 's/\\r\$//' chapters/01-one.nw"
echo 1..36
