#!/bin/sh
# Where the figures come from: script -> command -> program -> linked objects. A figure
# that a program of the kit computes links a literate file of its own chapter or of an
# earlier one; the programs behind the figures of a chapter link at least one literate
# file of that chapter; and each small program draws a figure.
. tests/programs/common
${MAKE:-make} -s programs >"$work/made" 2>&1 ||
    not_ok 'the programs are made' "$(tail -3 "$work/made" | tr '\n' ' ')"

# A literate file and the number of its chapter.
for file in src/*/*.[ch]; do
    sed -n "1s|^/\* From chapters/\([0-9][0-9]\)-.*|${file#src/} \1|p" "$file"
done >"$work/literate"
# Which literate files an object holds: its own source, and private headers.
# Objects of a source that is gone may lie in build/, too.
objects=
for source in src/*/*.c; do
    name=${source#src/} name=${name%.c}
    [ -e "build/obj/$name.o" ] || continue
    objects="$objects build/obj/$name.o"
    echo "$name $(tr ' ' '\n' <"build/made/obj/$name.o.d" |
        sed -n 's|^src/\(.*\.[ch]\)$|\1|p' | sort -u | tr '\n' ' ')"
done >"$work/sources"
# shellcheck disable=SC2086
nm -A -P $objects | sed 's|^build/obj/\([^:]*\)\.o: |\1 |' >"$work/symbols"
for script in plots/[0-9]*.gp; do
    figure=${script##*/} figure=${figure%.gp}
    sed -n '/^#/!q; s/^# command: //p' "$script" | tr -s '|;& ' '\n' |
        sed -n "s|^build/bin/\([a-z0-9-]*\)$|$figure \1|p" | sort -u
done >"$work/draws"

origins() { # LITERATE DRAWS: what is wrong
    awk -v literate="$1" -v draws="$2" '
    FILENAME == literate { chapter[$1] = $2 + 0; next }
    FILENAME ~ /sources$/ {
        for (i = 2; i <= NF; ++i)
            # A header counts where it is included, a source in its own object.
            if ($i in chapter)
                holds[$1] = holds[$1] " " chapter[$i]
        next
    }
    FILENAME ~ /symbols$/ {
        if ($3 == "U")
            wants[$1] = wants[$1] " " $2
        else if ($3 ~ /^[TDBRCVW]$/ && $1 !~ /^(programs|studies)\//)
            home[$2] = $1
        if ($1 ~ /^(programs|studies)\//) {
            name = $1
            sub(/.*\//, "", name)
            main[name] = $1
        }
        next
    }
    # The objects that a program links, as the linker takes them out of the archive.
    function chapters_of(program,    object, n, i, part, queue, head, tail, symbol, seen) {
        if (program in linked)
            return linked[program]
        queue[head = tail = 1] = main[program]
        seen[main[program]] = 1
        while (head <= tail) {
            object = queue[head++]
            linked[program] = linked[program] holds[object]
            n = split(wants[object], symbol, " ")
            for (i = 1; i <= n; ++i)
                if ((symbol[i] in home) && !(home[symbol[i]] in seen)) {
                    seen[home[symbol[i]]] = 1
                    queue[++tail] = home[symbol[i]]
                }
        }
        return linked[program]
    }
    {
        own = substr($1, 1, 2)
        of_chapter[own] = of_chapter[own] chapters_of($2)
        of_figure[$1] = of_figure[$1] " " chapters_of($2)
        drawn_by[$2] = drawn_by[$2] " " own
    }
    END {
        for (figure in of_figure) {
            own = substr(figure, 1, 2) + 0
            good = own == 0 # an appendix
            n = split(of_figure[figure], part, " ")
            for (i = 1; i <= n; ++i)
                good = good || part[i] <= own
            if (!good)
                print "figure " figure ": no literate file of its chapter or before"
        }
        for (own in of_chapter)
            if (own + 0 && index(of_chapter[own] " ", " " (own + 0) " ") == 0)
                print "chapter " own ": its figures link none of its literate files"
        for (name in main)
            if (name ~ /0$/ && !(name in drawn_by))
                print "small program " name ": draws no figure"
    }' "$1" "$work/sources" "$work/symbols" "$2" | sort
}
origins "$work/literate" "$work/draws" >"$work/wrong"
holds 'figures come from what the book prints' \
    sh -c "cat '$work/wrong'; [ ! -s '$work/wrong' ]"
holds 'of a hundred figures' test "$(cut -d ' ' -f 1 "$work/draws" | sort -u | wc -l)" -gt 100

# And what is wrong is seen.
grep -v '^line/collide' "$work/literate" | sed 's/ 0[1-5]$/ 12/' >"$work/other"
origins "$work/other" "$work/draws" >"$work/wrong"
holds 'a chapter without its literate files is seen' \
    grep -q '^chapter 02: ' "$work/wrong"
holds 'and a figure' grep -q '^figure 01-' "$work/wrong"
grep -v ' orbit0$' "$work/draws" >"$work/fewer"
origins "$work/literate" "$work/fewer" >"$work/wrong"
holds 'and a small program that draws nothing' \
    grep -q '^small program orbit0: ' "$work/wrong"
echo 1..5
