#!/bin/sh
# Weaving: links across chapters, chunk names kept apart, mistakes refused.
. tests/programs/common
mkdir -p "$work/chapters/press" "$work/src/unit" "$work/tests/exercises/01a" "$work/solutions"
cp chapters/press/weave chapters/press/keywords \
    chapters/press/lines chapters/press/quote "$work/chapters/press/"
cd "$work" || exit 1
has() { # name needle file
    holds "$1" grep -qF -- "$2" "$3"
}
refused() { # name message
    said=$(chapters/press/weave 2>&1)
    is "$1" "1 $2" "$? $said"
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
echo 'int hit_it(void);' >src/unit/one.h
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
is 'but not in a comment' 1 "$(grep -c 'linkedidentc' build/book/02-two.tex)"
has 'chunks of two chapters stay apart' 'Includes~{' build/book/02-two.tex
has 'the lines of a chunk are counted, a blank end left out' \
    '\nwcodelines{2}{}\nwbegincode{1}' build/book/01-one.tex
has 'a page ends in a long chunk best at a blank line' \
    '\nwcodelines{14}{-----082264---}\nwbegincode{2}' build/book/03-three.tex
has 'and never in one of ten lines' \
    '\nwcodelines{10}{}\nwbegincode{1}' build/book/03-three.tex
holds 'no solutions for students' \
    test ! -e build/book/solutions-01.tex -a ! -s build/book/edition.tex
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
    'weave: chapters/02-two.nw:4: no chunk is named <<Inclusions>>'
printf '%s\n' "$two" >chapters/02-two.nw

# Uses of a name: not a member; a struct behind that word alone; a function, in code,
# only where it is called; of what no header declares only in the chapter that defines it.
printf '%s\n' 'struct lamp { int bright; };' 'int shine(int n);' >src/unit/lamp.h
lamp='\chapter{Lamp}
<<lamp.c>>=
/* A lamp is bright. */
struct lamp {
    int bright;
};
int shine(int n)
{
    return dim(n);
}
static int dim(int n)
{
    return n;
}
@ %def lamp shine dim
<<again.c>>=
struct lamp lamp = {.shine = dim(1)};
lamp.shine = shine(2);
@
<<also.c>>=
static int shine = 1;
dim = shine * 2 + lamp;
@
Of [[shine]].'
printf '%s\n' "$lamp" >chapters/04-lamp.nw
printf '%s\n' "$lamp" | sed '1s/.*/\\chapter{Other}/; /^<<lamp.c/,/^@ %def/d
    s/again.c/other.c/' >chapters/05-other.nw
chapters/press/weave || echo 'not ok weave: lamps - status 1'
linked() { # CHAPTER: the names that are links in its last chunks, a q behind one in prose
    sed -n '/again.c\|other.c/,$p' "build/book/$1.tex" |
        grep -o 'linkedident[cq]{[a-z]*}' | sed 's/.*ident\(.\){\(.*\)}/\2\1/; s/c$//' |
        tr '\n' ' '
}
for pair in '04-lamp=lamp dim shine shineq ' '05-other=lamp shine shineq '; do
    is "the uses in ${pair%%=*}" "${pair#*=}" "$(linked "${pair%%=*}")"
done
rm chapters/04-lamp.nw chapters/05-other.nw

printf '%s\n' '\bookchapter{01-one}' >chapters/press/book.tex
refused 'a chapter that the book leaves out' \
    'weave: chapters/02-two.nw: chapters/press/book.tex does not name it
weave: chapters/03-three.nw: chapters/press/book.tex does not name it'
rm chapters/press/book.tex
cp chapters/01-one.nw "$work/kept"
sed '2s/$/\r/' "$work/kept" >chapters/01-one.nw
refused 'a Windows line end' "weave: chapters/01-one.nw: Windows line ends (a carriage\
 return before the line feed) in 1 of its $(wc -l <"$work/kept") lines; save it with\
 Unix line ends, or: sed -i 's/\\r\$//' chapters/01-one.nw"
echo 1..15
