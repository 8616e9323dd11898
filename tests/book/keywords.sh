#!/bin/sh
# The filter that sets keywords apart reads C: strings, comments, characters,
# preprocessor lines, and comments that run over lines and chunks.
. tests/programs/common
lib=
for place in /usr/lib/noweb /usr/local/lib/noweb /usr/lib64/noweb \
    /usr/local/noweb/lib /opt/homebrew/lib/noweb; do
    [ -z "$lib" ] && [ -x "$place/finduses" ] && lib=$place
done
[ -n "$lib" ] || { echo 'not ok keywords - noweb is not installed'; exit 1; }

# Marks K<keyword>, C<comment>, S<string> and I<identifier with a link>.
marked() {
    printf '%s\n' "$1" >"$work/x.nw"
    "$lib/markup" "$work/x.nw" | "$lib/finduses" | chapters/press/keywords |
        awk '
        /^@begin code/ { code = 1 }
        /^@end code/ { code = 0 }
        !code { next }
        /^@literal {/ {
            open = /keyword/ ? "K<" : /comment/ ? "C<" : "S<"
            printf "%s", open
        }
        /^@literal }/ { printf ">" }
        /^@index use / { use = 1; next }
        /^@text / {
            printf "%s", use ? "I<" substr($0, 7) ">" : substr($0, 7)
            use = 0
        }
        /^@use / { printf "[%s]", substr($0, 6) }
        /^@nl$/ { if (begun) print ""; begun = 1 }
        /^@end code/ { begun = 0 }' | sed '/^$/d; s/>S<//g; s/>C<//g'
}
reads() { # name expected C-text
    is "$1" "$2" "$(marked "<<x.c>>=
$3
@ %def collide table")"
}

reads 'a keyword' 'K<for> (;;) K<return> x;' 'for (;;) return x;'
reads 'a keyword within an identifier' 'format = xfor + for_x + 0xfor;' \
    'format = xfor + for_x + 0xfor;'
reads 'a keyword in a string' 's = S<"wait for it">; K<if>' 's = "wait for it"; if'
reads 'an escaped quote in a string' 's = S<"a \" for"> + y' 's = "a \" for" + y'
reads 'a backslash that ends a string' 's = S<"\\">; K<if>' 's = "\\"; if'
reads 'a comment in a string' 's = S<"/* no"> K<if>' 's = "/* no" if'
reads 'a comment with quotes' 'C</* it'"'"'s "for" you */> K<if>' \
    '/* it'"'"'s "for" you */ if'
reads 'a // comment with a quote' 'x C<// isn'"'"'t "for>
K<if>' 'x // isn'"'"'t "for
if'
reads "the character '\"'" "c = S<'\"'>; K<if> (S<'\\''>)" "c = '\"'; if ('\\'')"
reads 'a comment over lines' 'C</* one>
C<   for */> K<if>' '/* one
   for */ if'
reads 'a division' 'x = a / b * c; K<if>' 'x = a / b * c; if'
reads 'an include' 'K<#include> S<<for.h>>
K<#  define> X 1 < 2' '#include <for.h>
#  define X 1 < 2'
reads 'an identifier with a link' 'I<collide>(1, S<"collide">) C</* collide */>' \
    'collide(1, "collide") /* collide */'
reads 'a comment over another chunk' 'C</* for>
C<   >[Other]
C<   if */> K<if>' '/* for
   <<Other>>
   if */ if'

is 'a comment over a continued chunk' 'a C</* for>
C<if */> K<while>' "$(marked '<<x.c>>=
a /* for
@ Some words, and it goes on.
<<x.c>>=
if */ while
@')"
echo 1..15
