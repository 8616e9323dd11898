#!/bin/sh
# What the book quotes from plain files of src/: the right lines, links and keywords
# as in a chunk, and a refusal at the chapter's line where that cannot be.
. tests/programs/common
quote=chapters/press/quote

# Every function of src/ is found from its first to its last line: the layout, in which
# the brace of a function alone begins a line, says where they are. What cannot be
# followed is called doubtful, never something else.
$quote --items src/*/*.[ch] >"$work/items"
awk 'FILENAME ~ /items$/ {
        if ($4 == "function")
            is[$1, $3] = $2
        else if ($4 == "doubtful")
            doubtful[$1, $3] = ++doubts
        next
    }
    FNR == 1 { open = 0 }
    /^[{]$/ { open = FNR }
    /^[}]$/ && open {
        ++all
        if (is[FILENAME, FNR] && is[FILENAME, FNR] < open)
            ++found
        else if (!((FILENAME, FNR) in doubtful))
            print FILENAME ":" open ": not found"
        open = 0
    }
    END { print all - found, all > "/dev/stderr" }' "$work/items" src/*/*.[ch] \
    >"$work/missed" 2>"$work/counts"
read -r refused all <"$work/counts"
echo "# of $all functions of src/ $refused cannot be quoted"
holds 'all functions of src/ are found, or refused' test ! -s "$work/missed" -a \
    "$all" -gt 2000 -a "$refused" -le 5

mkdir -p "$work/kit/chapters/press" "$work/kit/src/room"
cp chapters/press/quote chapters/press/weave chapters/press/keywords \
    chapters/press/lines chapters/press/measure chapters/press/recipes "$work/kit/chapters/press"
cd "$work/kit" || exit 1
cat >src/room/plain.h <<'END'
/* What may be quoted from a header. */
#ifndef PLAIN_H
#define PLAIN_H

/* A struct and a function have one name. */
struct bead {
    double x; /* m */
    struct {
        int n;
    } inner;
};

enum { BEADS_MOST = 1 << 20, /* a power of two */
       BEADS_FEW = 3 };

struct other;

/* Returns the bead that is
   next, { or (. */
struct bead *bead(const struct other *other, int (*choose)(int, int),
                  enum kind kind);
typedef double (*law)(double x);
double mass, charge;
#endif
END
cat >src/room/plain.c <<'END'
/* What may be quoted from a program. */
#include "room/plain.h"
#include "line/one.h"

#define TWICE(x) \
    (2 * (x))

static int helper(int a);
static const char *const names[] = {
    "a } in a string \" and on", "b", /* a } in a comment */
}; /* a comment that begins behind it
      and goes on
      to here */
static int (*const calls[2])(int) = {helper, 0};
static const double first = 1, second = 2;

/* Not above anything. */

/* Says twice what it is given; an apostrophe's no character. */
static int helper(int a)
{
    if (a == '}' || a == '\'' || a == '"') {
        hit_it(); /* hit_it */
        return a << 1;
    }
    return a;
}
#ifdef _OPENMP
static int split(int a)
{
#ifdef MORE
    if (a) {
        return 0;
    }
#else
    if (!a)
        return 1;
#endif
    return a;
}
#else
static int split(int a)
{
    return 0;
}
#endif
MARKED
static int odd(void)
{
    return 1;
}

int helped(int a)
{
    return helper(a) + BEADS_MOST;
}
END
{
    printf '/* Too long. */\nint longer(void)\n{\n'
    yes '    f(1);' | head -n 27
    printf '}\n\nint longest(void)\n{\n'
    yes '    f(2);' | head -n 27
    printf '}\n'
} >src/room/long.c
cat >src/room/unsure.c <<'END'
/* Of g alone the first and last line are certain. */
#ifdef A
int f(int a)
{
#else
int f(long a)
#endif
    return 1;
}
int g(void)
{
    return 2;
}
int h(int a)
{
#ifdef A
    if (a) {
#else
    if (!a) {
#endif
        return 1;
    }
    return 0;
}
END
printf '%s\n' '/* From chapters/01-one.nw: edit there, then run make tangle. */' \
    '/* checksum 1 of the lines below */' 'int tangled;' >src/room/tangled.c

# quoted FILE NAME FIRST LAST: those lines, and nothing else.
quoted() {
    printf '%s\n' 'Text.' "\\quotecode{src/room/$1}{$2}" 'More.' >chapters/02-two.nw
    {
        echo 'Text.'
        echo "<<room/$1:$3>>="
        sed -n "$3,$4{s/<</@<</g;p;}" "src/room/$1"
    } >"$work/expected"
    $quote chapters/02-two.nw >"$work/got" 2>"$work/said"
    sed '/^@ %def /,$d' "$work/got" >"$work/code"
    if cmp -s "$work/expected" "$work/code" && [ "$(tail -n 1 "$work/got")" = More. ]; then
        ok "$2 of $1"
    else
        not_ok "$2 of $1" "$(cat "$work/said"; diff "$work/expected" "$work/code")"
    fi
}
quoted plain.c helper 19 27
quoted plain.c helped 53 56
quoted plain.c names 9 13
quoted plain.c calls 14 14
quoted plain.c second 15 15
quoted plain.c TWICE 5 6
quoted plain.h 'struct bead' 5 11
quoted plain.h 'bead()' 18 21
quoted plain.h BEADS_FEW 13 14
quoted plain.h law 22 22
quoted plain.h charge 23 23
quoted long.c longest 33 62
quoted unsure.c g 10 13
# refused LINES MESSAGE: those lines of a chapter, which have the mistake in line 3.
refused() {
    printf '%s\n' 'Text.' '' "$1" >chapters/02-two.nw
    said=$($quote chapters/02-two.nw 2>&1 >/dev/null)
    is "$1" "1 quote: chapters/02-two.nw:3: $2" "$? $said"
}
q() { echo "\\quotecode{src/room/$1}{$2}"; }
refused "$(q plain.c gone)" 'src/room/plain.c has no gone'
refused "$(q plain.c a)" 'src/room/plain.c has no a'
refused "$(q plain.h other)" 'src/room/plain.h has no other'
refused "$(q none.c x)" 'there is no file src/room/none.c'
refused "$(q long.c longer)" \
    'src/room/long.c: longer has 31 lines; at most 30 can be quoted'
refused "$(q tangled.c tangled)" \
    'src/room/tangled.c is tangled from chapters/01-one.nw, which prints it'
refused "$(q plain.h bead)" "src/room/plain.h has bead twice, in lines 5 and 18; \
\"struct bead\" or \"bead()\" says which if one is a type and one a function"
refused "$(q plain.c odd)" "src/room/plain.c: where odd begins and ends is not certain: \
line 48 looks as if something else began there"
refused "$(q unsure.c f)" "src/room/unsure.c: where f begins and ends is not certain: \
an #if begins or ends within it"
refused "$(q unsure.c h)" "src/room/unsure.c: where h begins and ends is not certain: \
line 24 looks as if it ended there"
refused "See $(q plain.c helper)" \
    '\quotecode{src/room/file.c}{name} stands on a line of its own'

# Woven: a chunk among others. What it uses is linked to where the book defines it,
# through what the plain files include; what it defines is linked from elsewhere.
cat >chapters/01-one.nw <<'END'
\chapter{One}
<<line/one.h>>=
int hit_it(void);
@ %def hit_it
<<line/one.c>>=
#include "room/plain.h"
int use(void)
{
    return helped(BEADS_MOST) + hit_it();
}
@
END
cat >chapters/02-two.nw <<'END'
\chapter{Two}
As [[helper]] says:
\quotecode{src/room/plain.c}{helper}
And
\quotecode{src/room/plain.h}{BEADS_MOST}
\quotecode{src/room/plain.h}{helped}
END
echo 'int helped(int a);' >>src/room/plain.h
echo 'int hit_it(void);' >src/room/one.h
holds 'a chapter with quotes is woven' chapters/press/weave
woven=build/book/02-two.tex
has() { # NAME STRING FILE
    holds "$1" grep -qF -e "$2" "$3"
}
label() { sed -n "s/.*sublabel{\(NW[^}]*\)}.*$1.*/\1/p" "$2" | head -n 1; }
has 'the file and line stand above it' \
    '\moddef{{\Tt{}src/room/plain.c:19\nwendquote}~' $woven
has 'as no definition' '\endquotedef' $woven
has 'keywords are set apart' '{\nwkeyword{}static} {\nwkeyword{}int} ' $woven
has 'and so are comments' '{\nwcomment{}/* ' $woven
has 'a shift is no chunk' 'return} a << 1;' $woven
has 'what it uses is linked to its definition' \
    "\\nwlinkedidentc{hit_it}{$(label one.h build/book/01-one.tex)}" $woven
has 'words about it are linked to it' \
    "\\nwlinkedidentq{helper}{$(label plain.c:19 $woven)}" $woven
has 'and so is a chunk that uses it, through the headers of plain files' \
    "\\nwlinkedidentc{BEADS_MOST}{$(label plain.h:13 $woven)}" build/book/01-one.tex
holds 'no foot repeats its name' sh -c "! grep -q 'nwnotused{room' $woven"
sed 's/after/behind/; s/an apostrophe/and an apostrophe/' src/room/plain.c >"$work/plain.c"
cp "$work/plain.c" src/room/plain.c
chapters/press/weave
has 'it is read anew when the file has changed' 'and an apostrophe' $woven
holds 'its lines count as code, and none of it as words' \
    test "$($quote chapters/02-two.nw | chapters/press/measure --words)" = '4 12'
chapters/press/recipes
holds 'make knows which files are quoted' test "$(sed -n '/^QUOTED/,$p' \
    build/recipes/rules.mk | tr -d ' \t\\\n')" = \
    'QUOTED:=src/room/plain.csrc/room/plain.h'
echo '\quotecode{src/room/plain.c}{gone}' >>chapters/02-two.nw
said=$(chapters/press/weave 2>&1)
holds 'weave refuses what quote refuses' \
    test $? -eq 1 -a "$said" = 'quote: chapters/02-two.nw:7: src/room/plain.c has no gone'
echo 1..39
