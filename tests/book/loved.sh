#!/bin/sh
# What is loved stays word for word: every paragraph of loved.txt, beside this
# file, stands in the chapters, however its lines are broken.
. tests/programs/common
list=tests/book/loved.txt

# Prints the first words of the paragraphs of FILE that the chapters on
# standard input do not have.
lost() { # FILE
    awk -v list="$1" '
    function flat(s) {
        gsub(/[ \t\n]+/, " ", s)
        sub(/^ /, "", s)
        sub(/ $/, "", s)
        return s
    }
    # Prose only, with a sign where it is interrupted.
    /^<<.*>>=/ { code = 1; text = text " \001 "; next }
    /^@( |$)/ { code = 0; sub(/^@ ?/, "") }
    code || /^%/ { next }
    { text = text $0 "\n" }
    END {
        text = flat(text)
        while ((got = getline line < list) > 0 || part != "") {
            if (got > 0 && line !~ /^(#|==)/ && line ~ /[^ ]/) {
                part = part line "\n"
                continue
            }
            part = flat(part)
            if (part != "" && !index(text, part))
                print substr(part, 1, 70)
            if (part != "")
                ++parts
            part = ""
            if (got <= 0)
                break
        }
        if (!parts)
            print "no passages in " list
    }'
}
cat chapters/*.nw | lost "$list" >"$work/lost"
holds 'what is loved stands as it was' test ! -s "$work/lost"
sed 's/^/  lost: /' "$work/lost"
holds 'forty passages' test "$(grep -c '^== ' "$list")" -ge 40

# It sees a word that is changed, a passage that is gone, and reads on where
# only lines are broken anew.
printf '%s\n' '== One' 'Two bodies meet,' 'and part.' '' '# A reason.' \
    'They fly on.' '' '== Two' 'Nobody looks.' >"$work/list"
sees() { # NAME EXPECTED, a chapter on standard input
    got=$(lost "$work/list" | tr '\n' '|')
    holds "$1" test "$got" = "$2"
}
sees 'lines broken anew are the same' '' <<'END'
Then two: Two bodies meet, and
part. They fly on. Nobody
looks.
END
sees 'a word that is changed is seen' 'Two bodies meet, and part.|' <<'END'
Two bodies met, and part. They fly on. Nobody looks.
END
sees 'and a paragraph that is gone, or is code' 'They fly on.|Nobody looks.|' <<'END'
Two bodies meet, and part.
<<Chunk>>=
They fly on.
@
% Nobody looks.
END
echo 1..5
