#!/bin/sh
# A name in the code is a link only where it means what %def names: where the
# file includes the module, and never as a member, a label, a parameter or a
# variable of the function; a tag behind struct, and only there. Each line of
# the chapters below is the only one that has its number, in a comment; the
# names linked in it stand before that.
set -u
here=$(pwd)
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
lib=${NOWEB_LIBRARY-}
for place in /usr/lib/noweb /usr/local/lib/noweb /usr/lib64/noweb \
    /usr/local/noweb/lib /opt/homebrew/lib/noweb; do
    [ -z "$lib" ] && [ -x "$place/finduses" ] && lib=$place
done
mkdir "$scratch/works"
cat >"$scratch/01-far.nw" <<'END'
\chapter{Far} No file here includes [[light]], nor [[lonely]], but [[unique]] is one thing.
<<far/far.c>>=
struct light { int x; };         /* none 1 */
int start(int light)             /* none 2 */
{
    return light + start(2);     /* none 3 */
}
@
END
cat >"$scratch/02-near.nw" <<'END'
\chapter{Near}
<<near/near.h>>=
struct light {                   /* light 10 */
    int light, lonely;           /* none 11 */
};
int shine(struct light *light);  /* shine light 12 */
int start(int);                  /* start 13 */
enum { BRIGHT = 1, DIM };        /* BRIGHT 14 */
#define LAMP(x) (BRIGHT + x)     /* LAMP BRIGHT 15 */
typedef struct light lamp_type;  /* light lamp_type 16 */
@ %def light shine start BRIGHT LAMP lamp_type
<<near/near.c>>=
#include "near/near.h"
<<Shine>>
<<Shine>>=
int shine(struct light *light)   /* shine light 20 */
{
    <<Say how bright>>
    return start(light->light);  /* start 21 */
}
<<Say how bright>>=
light->light = BRIGHT;           /* BRIGHT 22 */
@
<<between.h>>=
#include "near/near.h"
int far_only(void), unique(void), lonely(void);
@ %def far_only unique lonely
END
cat >"$scratch/03-use.nw" <<'END'
\chapter{Use}
[[struct light]], but neither [[light]], [[shine]] nor [[a.start]], and
[[start(2)]] though a variable has its name.
<<use/use.c>>=
#include "between.h"
<<The functions>>
@
<<The functions>>=
static int own(int start, lamp_type *a) /* lamp_type 30 */
{
    struct light light = {.light = 3};  /* light 31 */
    int n = start, shine = 2;           /* none 32 */
    a->light = light.light + shine;     /* none 33 */
    for (int BRIGHT = 0; BRIGHT < n; ++BRIGHT) /* none 34 */
        n += LAMP(2);                   /* LAMP 35 */
    {
        double lamp_type = 2, *LAMP;    /* none 36 */
        n += lamp_type + *LAMP;         /* none 37 */
    }
    goto start;                         /* none 38 */
start:                                  /* none 39 */
    return n;
}
int other(int n)
{
    <<Prepare>>
    lamp_type a = {n};                  /* lamp_type 40 */
    n = (&a)->start + a.start;          /* none 43 */
    goto shine;                         /* none 44 */
shine:                                  /* none 45 */
    n += light(2);                      /* none 46 */
    if (n)
        return shine(&a) * start(3);    /* shine start 41 */
    <<Go on, in Works>>
}
<<Prepare>>=
const size_t BRIGHT = 3;                /* none 42 */
@
END
cat >"$scratch/works/03-use.nw" <<'END'
<<Go on, in Works>>=
n = BRIGHT;                             /* none 50 */
return start(far_only());               /* start far_only 51 */
<<use/other.c>>=
int two(struct light *l, int far_only)  /* none 60 */
{
    return BRIGHT + far_only;           /* none 61 */
}
@
END
cat >"$scratch/04-twice.nw" <<'END'
<<twice/a.h>>=
int same(void);                         /* same@@twice-a 70 */
@ %def same
<<twice/b.h>>=
int same(int);                          /* same@@twice-b 71 */
@ %def same
<<twice/use.c>>=
#include "b.h"
int f(void)
{
    return same(1);                     /* same@@twice-b 72 */
}
@
END
for file in 01-far 02-near 03-use 04-twice works/03-use; do
    "$lib/markup" "$scratch/$file.nw" |
        sed "/^@defn /s/\$/@@${file##*/}/; /^@use /s/\$/@@${file##*/}/"
done | "$lib/finduses" | "$here/chapters/press/keywords" |
    "$here/chapters/press/names" >"$scratch/out"
# Each line, and the names that are links in it.
awk '
/^@index use / { names = names " " substr($0, 12); next }
/^@text / { text = text substr($0, 7) }
/^@nl/ {
    if (match(text, /[/][*] [^*]* [0-9]+ [*][/]/)) {
        asked = substr(text, RSTART + 3, RLENGTH - 6)
        number = asked
        sub(/.* /, "", number)
        sub(/ [0-9]+$/, "", asked)
        got = names == "" ? "none" : substr(names, 2)
        print (got == asked ? "ok" : "not ok") " names: line " number ", " asked \
            (got == asked ? "" : " - got " got)
    } else if (text ~ /\[\[|chapter|though|neither/)
        docs = docs names
    text = names = ""
}
END {
    asked = " unique light start"
    print (docs == asked ? "ok" : "not ok") " names: quoted in the text," asked \
        (docs == asked ? "" : " - got" docs)
}' "$scratch/out"
echo 1..38
