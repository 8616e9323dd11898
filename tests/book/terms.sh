#!/bin/sh
# Bibliography, glossary and table of symbols: what is cited is there and what
# is there is cited; each word that a chapter introduces in bold is explained,
# and each explained word is used; each name of a symbol is one of the code.
# And each check sees its mistake.
set -u
LC_ALL=C
export LC_ALL
here=$(pwd)
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM

# Bold that introduces no word: answers of the check, headings, one sentence.
cat >"$scratch/no-terms" <<'END'
crashed
does not build
failed
not begun
passed
the positions
the pressure
the velocities
throw all if any two overlap throw all again
timed out
END

cited() {
    find chapters -name '*.nw' -exec cat {} + | tr '\n' ' ' |
        grep -o '\\cite\(\[[^]]*\]\)\{0,1\}{[^}]*}' |
        sed 's/.*{//; s/}//' | tr -d ' ' | tr ',' '\n' | sort -u
}
entries() { sed -n 's/^@[a-z]*{\([^,]*\),.*/\1/p' chapters/press/references.bib; }
keys() { # those that are only in one of the two, or twice
    cited >"$scratch/cited"
    entries | sort >"$scratch/entries"
    comm -3 "$scratch/cited" "$scratch/entries"
    uniq -d "$scratch/entries"
}
unexplained() {
    chapters/press/terms --check >"$scratch/words"
    sed -n 's/^.*|\(.*\)|no$/\1/p' "$scratch/words" | sort -u >"$scratch/bold"
    comm -3 "$scratch/bold" "$scratch/no-terms"
}
unused() { sed -n 's/^.*|\(.*\)|unused$/\1/p' "$scratch/words"; }
names() { sed -n 's/^\\term\(\[[^]]*\]\)\{0,1\}{\([^}]*\)}.*/\2/p' chapters/D-glossary.nw; }
unsorted() {
    names | sed "s/'s//g; s/--/ /g; s/-/ /g" | tr 'A-Z' 'a-z' >"$scratch/names"
    sort -u -c "$scratch/names" 2>&1
}
strangers() { # names in the table of symbols that the code does not have
    sed -n '/begin{longtable}/,/end{longtable}/p' chapters/C-symbols.nw |
        grep -o '\[\[[^]]*\]\]' | tr -c 'A-Za-z0-9_' '\n' | sed '/^$/d' |
        sort -u >"$scratch/wanted"
    cat src/*/*.[ch] | tr -c 'A-Za-z0-9_' '\n' | sort -u |
        comm -23 "$scratch/wanted" -
}
none() { # name what-there-is
    if [ -z "$2" ]; then
        echo "ok terms: $1"
    else
        printf 'not ok terms: %s - %s\n' "$1" \
            "$(printf '%s' "$2" | tr '\n' ' ' | cut -c1-200)"
    fi
}
some() { # name what-there-is expected
    if [ "$2" = "$3" ]; then
        echo "ok terms: $1"
    else
        printf "not ok terms: %s - it was '%s'\n" "$1" \
            "$(printf '%s' "$2" | tr '\n' ' ')"
    fi
}

[ "$(entries | wc -l)" -ge 60 ] && [ "$(names | wc -l)" -ge 60 ] &&
    echo 'ok terms: sixty entries, sixty words' ||
    echo 'not ok terms: sixty entries, sixty words - fewer'
none 'cited is what chapters/press/references.bib has' "$(keys)"
none 'words in bold are in chapters/D-glossary.nw, or in the list above' "$(unexplained)"
none 'words of chapters/D-glossary.nw are used' "$(unused)"
none 'the glossary is sorted' "$(unsorted)"
none 'names of symbols are in src/' "$(strangers)"
[ "$(wc -l <"$scratch/wanted")" -ge 60 ] &&
    echo 'ok terms: sixty names of symbols' ||
    echo 'not ok terms: sixty names of symbols - fewer'

# The book as it was last made: every mark that the index asks for is there.
if [ -s build/book/terms.tex ] && [ -s build/book/book.aux ]; then
    grep -o '\\term[du][es][fe]{[0-9]*}' build/book/terms.tex |
        sed 's/.*{//; s/}//' | sort >"$scratch/asked"
    sed -n 's/^\\newlabel{t\.\([0-9]*\)}.*/\1/p' build/book/book.aux | sort |
        comm -3 "$scratch/asked" - >"$scratch/lost"
    none 'marks of the index are in the book' "$(cat "$scratch/lost")"
    grep -c . "$scratch/asked" | awk '{ exit $1 < 300 }' &&
        echo 'ok terms: three hundred of them' ||
        echo 'not ok terms: three hundred of them - fewer'
fi

# Each mistake is seen.
mkdir -p "$scratch/kit/chapters/press" "$scratch/kit/src/toolbox"
cp chapters/press/terms "$scratch/kit/chapters/press/"
cd "$scratch/kit" || exit 1
printf '%s\n' '\bookchapter{01-x}' >chapters/press/book.tex
printf '%s\n' '@book{one1999,' '}' '@article{two2000,' '}' >chapters/press/references.bib
printf '%s\n' 'A \textbf{heap}, a \textbf{slow' '  leash} \cite{one1999,' \
    'three2001}. Heaps are old.' '<<x.c>>=' 'virial' '@' >chapters/01-x.nw
printf '%s\n' '\term[heaps]{heap}{A tree.}' '\term{virial}{A sum.}' \
    '\term{anchor}{A place.}' >chapters/D-glossary.nw
printf '%s\n' '\begin{longtable}' '[[disk]]\allowbreak[[.radius]] [[mass]]' \
    '\end{longtable}' >chapters/C-symbols.nw
echo 'struct disk { double radius; };' >src/toolbox/x.h
: >"$scratch/no-terms"
some 'a key that is missing, an entry that is not cited' "$(keys)" "three2001
$(printf '\t')two2000"
some 'a word that is not explained' "$(unexplained)" 'slow leash'
some 'words that are not used, but in code' "$(unused)" 'virial
anchor'
some 'a name that the code does not have' "$(strangers)" mass
[ -n "$(unsorted)" ] && echo 'ok terms: disorder' ||
    echo 'not ok terms: disorder - it was not seen'
mkdir tex
printf '%s\n' '\section{One}' 'A \textbf{heap} stands' 'here in a row.' '' \
    'In $a' '+b$ heaps' 'grow, and so' 'does a heap.' >tex/01-x.tex
chapters/press/terms tex
some 'a mark stands at the end of a plain line' "$(sed -n 2p tex/01-x.tex)" \
    'A \textbf{heap} stands\termmark{1}'
some 'and the list names it' "$(grep '^.termline' tex/terms.tex)" \
    '\termline{heap}{\termdef{1}}'
cd "$here" || exit 1
echo 1..16
