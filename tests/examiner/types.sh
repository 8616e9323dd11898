#!/bin/sh
# A function with other types than the exercise gave does not build, whichever
# type it is, at home and in the grader: the message names the function, gives
# its types and points to the line of the student's file. Nor does a structure
# with other members. Every exercise's functions are tried with each of their
# types changed, and its structures with each member changed; and files that are
# right are not refused.
. tests/programs/common
out=$work/out
mkdir "$out"
root=$(pwd)
here=tests/examiner/types

# ---- each type of each function, by the compiler alone ----

# variants HEADER: a file in which each function that the header gives is
# declared in a block of its own: first as given, in lines that end with
# "right"; then with one change in each, in lines that end with "wrong".
variants() {
    awk '
    function declare(text, how) {
        print "void f" ++blocks "(void) { " text "; } /* " how " */"
    }
    # Each place where a word stands, in turn, with another word there.
    function change(text, word, by,    from, before, after) {
        for (from = 1; match(substr(text, from), word); from += RSTART) {
            before = from + RSTART == 2 ? " " : substr(text, from + RSTART - 2, 1)
            after = substr(text, from + RSTART + RLENGTH - 1, 1)
            if ((before after) !~ /[A-Za-z_0-9]/)
                declare(substr(text, 1, from + RSTART - 2) by \
                    substr(text, from + RSTART + RLENGTH - 1), "wrong")
        }
    }
    /^(struct|enum) / { tags = tags $0 "\n" }
    /^\/\* given: [^{]*$/ {
        sub(/^\/\* given: /, "")
        sub(/ \*\/$/, "")
        while (match($0, /struct [a-z_0-9]+ [a-z_0-9]+\[\]/)) {
            at = substr($0, RSTART, RLENGTH - 2)
            sub(/ [a-z_0-9]+$/, " *&", at)
            sub(/\* /, "*", at)
            $0 = substr($0, 1, RSTART - 1) at substr($0, RSTART + RLENGTH)
        }
        declare($0, "right")
        change($0, "double", "float")
        change($0, "double", "long double")
        change($0, "size_t", "int")
        change($0, "size_t", "unsigned")
        change($0, "int", "unsigned")
        change($0, "int", "long")
        change($0, "unsigned", "int")
        change($0, "bool", "int")
        change($0, "const", "")
        if (/^void/)
            declare("int" substr($0, 5), "wrong")
        if (/^enum/)
            declare("int" substr($0, index($0, " measure_order")), "wrong")
        if (/\(void\)$/)
            declare(substr($0, 1, length($0) - 6) "(int more)", "wrong")
        else
            declare(substr($0, 1, length($0) - 1) ", int more)", "wrong")
        if (match($0, /, [^,()]*\)$/))
            declare(substr($0, 1, RSTART - 1) ")", "wrong")
    }
    BEGIN { print "#include <stdbool.h>\n#include <stddef.h>" }' "$1"
}
all_noticed() { # COMPILER HEADER
    variants "$2" >"$out/variants.c"
    grep -n 'wrong \*/$' "$out/variants.c" | cut -d : -f 1 >"$out/wrong"
    # shellcheck disable=SC2086
    LC_ALL=C $1 -std=c11 -fsyntax-only -include "$2" "$out/variants.c" \
        >"$out/said" 2>&1
    sed -n "s,^$out/variants.c:\([0-9]*\):.* error: .*,\1,p" "$out/said" |
        uniq >"$out/noticed"
    [ -s "$out/wrong" ] && cmp -s "$out/wrong" "$out/noticed" && return
    sed -n "$(diff "$out/wrong" "$out/noticed" |
        sed -n 's/^[<>] //p' | head -n 1)p" "$out/variants.c"
    return 1
}
count=0 tried=0
for compiler in 'gcc -fmax-errors=0' 'clang -ferror-limit=0'; do
    for header in build/check/[0-9]*.types.h; do
        ex=${header##*/} ex=${ex%%.*}
        holds "$ex: each changed type is an error with ${compiler%% *}" \
            all_noticed "$compiler" "$header"
        count=$((count + 1)) tried=$((tried + $(wc -l <"$out/wrong")))
    done
done
holds "every exercise has such a header, and most functions many types" \
    [ "$count" -eq $((2 * $(ls -d tests/exercises/[0-9]* | grep -c '[a-z]$'))) \
    -a "$tried" -gt 800 ]

# ---- each member of each structure ----

# member_variants HEADER STUB: a file in which each structure that the stub
# defines is defined in a block of its own, with what the header asserts behind
# it, in one line: as given, and with one member renamed, in lines that end with
# "right"; with one member changed, in lines that end with "wrong". Where a
# member is gone, either that is noticed or the name is.
member_variants() {
    awk '
    function block(how,    i, list, end) {
        end = kind == "enum" ? "," : ";"
        for (i = 1; i <= n; ++i)
            list = list " " part[i] end
        print "void f" ++blocks "(void) { " kind " " tag " {" list " }; " asserts[tag] \
            "} /* " how " */"
    }
    function with(i, text, how,    kept) {
        kept = part[i]
        part[i] = text
        block(how)
        part[i] = kept
    }
    function retyped(i, from, to,    text) {
        text = part[i]
        if (sub("^" from " ", to " ", text))
            with(i, text, "wrong")
    }
    function swapped(i,    kept) {
        kept = part[i]
        part[i] = part[i + 1]
        part[i + 1] = kept
    }
    function vary(    i, text) {
        block("right")
        for (i = 1; i <= n; ++i) {
            if (kind == "enum") {
                with(i, "OWN, " part[i], "wrong")
            } else {
                text = part[i]
                sub(/[a-z_0-9]+(\[[0-9]*\])*$/, "own_&", text)
                with(i, text, "right")
                with(i, "double own; " part[i], "wrong")
                with(i, part[i] "; double own", "wrong")
                with(i, n > 1 ? "" : "double own", "gone")
                retyped(i, "double", "float")
                retyped(i, "double", "long double")
                retyped(i, "size_t", "int")
                retyped(i, "unsigned", "long")
                retyped(i, "unsigned", "int")
                retyped(i, "int", "unsigned")
                text = part[i]
                if (sub(/\[3\]/, "[2]", text))
                    with(i, text, "wrong")
            }
            if (i < n) {
                swapped(i)
                block("wrong")
                swapped(i)
            }
        }
    }
    BEGIN { print "#include <stdbool.h>\n#include <stddef.h>" }
    FNR == NR && /^struct given_/ {
        tag = substr($2, 7)
        given[tag] = $0 " "
    }
    FNR == NR && /^_Static_assert/ {
        split($0, word, "\"")
        tag = word[2]
        asserts[tag] = (asserts[tag] ? asserts[tag] : given[tag]) $0 " "
    }
    FNR == NR { next }
    /^(struct|enum) [a-z_]+ \{/ { kind = $1; tag = $2; body = ""; inside = 1 }
    inside { body = body " " $0 }
    inside && kind == "enum" && /\};$/ { whole = body }
    inside && /\};$/ {
        inside = n = 0
        while (match(body, /\/\*[^*]*\*\//))
            body = substr(body, 1, RSTART - 1) substr(body, RSTART + RLENGTH)
        sub(/^[^{]*\{ */, "", body)
        sub(/ *\}.*/, "", body)
        gsub(/ +/, " ", body)
        count = split(body, line, kind == "enum" ? " *, *" : " *; *")
        for (k = 1; k <= count; ++k) {
            if (line[k] == "")
                continue
            more = split(line[k], word, / *, */)
            type = word[1]
            sub(/ [^ ]*$/, "", type)
            for (m = 1; m <= more; ++m)
                part[++n] = m == 1 ? word[m] : type " " word[m]
        }
        vary()
        if (kind == "enum")
            print whole
    }' "$2" "$1"
}
members_noticed() { # COMPILER HEADER
    member_variants "tests/exercises/$ex/stub.c" "$2" >"$out/variants.c"
    grep -n 'wrong \*/$' "$out/variants.c" | cut -d : -f 1 >"$out/wrong"
    # shellcheck disable=SC2086
    LC_ALL=C $1 -std=c11 -w -fsyntax-only "$out/variants.c" >"$out/said" 2>&1
    sed -n "s,^$out/variants.c:\([0-9]*\):.* error: static.assert.*,\1,p" "$out/said" |
        uniq >"$out/noticed"
    grep -n 'gone \*/$' "$out/variants.c" | cut -d : -f 1 >"$out/gone"
    sed -n "s,^$out/variants.c:\([0-9]*\):.* error: .*,\1,p" "$out/said" |
        sort -u >"$out/any"
    grep -v -x -F -f "$out/gone" "$out/noticed" >"$out/exact"
    [ -s "$out/wrong" ] && cmp -s "$out/wrong" "$out/exact" &&
        [ -z "$(sort "$out/gone" | comm -23 - "$out/any")" ] && return
    diff "$out/wrong" "$out/exact"
    sed -n "$(diff "$out/wrong" "$out/exact" |
        sed -n 's/^[<>] //p' | head -n 1)p" "$out/variants.c"
    return 1
}
structures=0 changed=0
for compiler in 'gcc -fmax-errors=0' 'clang -ferror-limit=0'; do
    for ex in $(grep -l '^\(struct\|enum\) [a-z_]* {' tests/exercises/*/stub.c |
        cut -d / -f 3); do
        holds "$ex: each changed member is an error with ${compiler%% *}" \
            members_noticed "$compiler" build/check/"$ex".types.h
        structures=$((structures + 1)) changed=$((changed + $(wc -l <"$out/wrong")))
    done
done
holds 'fifteen exercises give structures, and most of them many members' \
    [ "$structures" -eq 30 -a "$changed" -gt 500 ]

# ---- files, at home and in the grader ----

# The first line of a file says of which exercise it is and how it ends,
#   /* 02a does not build: ... */
# and `says:` what is told.
narrow() { tr -s ' \n' ' ' | sed 's/ | / /g'; }
told() { # FILE TEXT-FILE
    sed -n 's/^\/\* says: \(.*\) \*\/$/\1/p' "$1" >"$out/wanted"
    while IFS= read -r words; do
        narrow <"$2" | grep -q -F -e "$words" ||
            { echo "$words?" && cat "$2"; return 1; }
    done <"$out/wanted"
}
at_home() { # FILE
    cp "$1" "$out/own.c"
    build/check/examine --as "$ex" --file "$out/own.c" >"$out/said" 2>&1
    grep -q "^$ex .* $state " "$out/said" && told "$1" "$out/said" ||
        { cat "$out/said" && false; }
}
in_the_grader() { # FILE
    result=$out/graded/marks/$(basename "$1" .c)/$ex.json
    grep -q "^ \"state\": \"$state\"" "$result" &&
        sed -n 's/^ "story": "\(.*\)",$/\1/p' "$result" |
        sed 's/\\n/ /g' >"$out/story" && told "$1" "$out/story" ||
        { cat "$result" "$out/story" && false; }
}
head_of() { sed -n "1s/^\/\* \([0-9][0-9][a-z]\) \([a-z ]*\): .*/$1/p" "$file"; }
for file in "$here"/*.c; do
    ex=$(head_of '\1')
    mkdir -p "$out/in/$(basename "$file" .c)"
    cp "$file" "$out/in/$(basename "$file" .c)/$(ls solutions | grep "^$ex")"
done
build/grade/grade --hidden 1 --output "$out/graded" "$out/in" >"$out/grading" 2>&1
for file in "$here"/*.c; do
    ex=$(head_of '\1') state=$(head_of '\2') name=$(basename "$file" .c)
    holds "$name $state at home" at_home "$file"
    holds "$name $state in the grader" in_the_grader "$file"
done
echo "1..$((2 * $(ls -d tests/exercises/[0-9]* | grep -c '[a-z]$') + 1 + 31 + \
    2 * $(ls "$here"/*.c | wc -l)))"
