#!/bin/sh
# The course as students get it: the archive is the same whoever makes it and
# whatever lies about, builds and checks on its own, and says in one line what
# it cannot do. And nothing in it gives an answer away.
. tests/programs/common
LC_ALL=C
export LC_ALL
unset EDITION WITH_CHAPTERS SOURCE_DATE_EPOCH EX HIDDEN PRESET SCENE LIVE V
make=${MAKE:-make}
root=$(pwd)
tokens=build/tests/tokens
course=bonkers-course
archive=build/$course.tar.gz
[ -x "$tokens" ] || {
    echo "not ok $suite - $tokens is missing: make test"
    exit 1
}

# equal NAME EXPECTED GOT
equal() {
    if [ "$2" = "$3" ]; then ok "$1"; else
        not_ok "$1" "expected '$2', got '$(echo "$3" | head -c 300)'"; fi
}

# ---- the archive ----------------------------------------------------------

rm -f "$archive"
$make -s handout >"$work/out" 2>&1
holds 'make handout makes it' \
    sh -c "[ $? -eq 0 ] || { tail -3 '$work/out'; false; }"
holds 'and says where it is' grep -q "^The course: $archive, " "$work/out"
[ -s "$archive" ] || exit 0
holds 'and only one file of it' test ! -e "$archive.part"

# In a folder whose name has a space.
mkdir "$work/a place" "$work/all"
cp "$archive" "$work/made.tar.gz"
tar xzf "$archive" -C "$work/a place"
place="$work/a place/$course"
equal 'all in one folder' "$course" "$(ls -A "$work/a place")"

# Kinds of files, and no other; nothing but the recipes of chapters/.
strangers=$(cd "$place" && find . ! -type d ! \( -type f \( \
    -path './src/*.[ch]' -o -path './exercises/*.c' -o \
    -path './tests/exercises/[0-9][0-9][a-z]/suite.c' -o \
    -path './tests/exercises/P[0-9]/suite.c' -o \
    -path './tests/exercises/[0-9][0-9][a-z]/stub.c' -o \
    -path './tests/exercises/P[0-9]/stub.c' -o \
    -path './tests/exercises/[0-9][0-9][a-z]/hints.txt' -o \
    -path './tests/exercises/P[0-9]/hints.txt' -o \
    -path './tests/exercises/[0-9][0-9][a-z]/calls.c' -o \
    -path './tests/exercises/[0-9][0-9][a-z]/call.h' -o \
    -path './tests/exercises/P[0-9]/calls.c' -o \
    -path './plots/*.gp' -o \
    -path './plots/*.awk' -o -path ./plots/films -o -path ./plots/show -o \
    -path './plots/data/*.dat' \) -o \
    -path ./README.md -o -path ./LICENSE -o -path ./CITATION.cff -o \
    -path ./Makefile -o -path ./bonkers.pdf -o \
    -path ./chapters/press/recipes -o -path ./chapters/press/lines -o \
    -path ./tests/lists.awk -o -path ./tests/remote.awk -o \
    -path ./tests/types.awk -o \
    -path ./plots/plots.mk -o -path ./src/compile.mk -o \
    -path ./src/studies/bench.mk -o -path ./src/examiner/check.mk -o \
    -path ./tests/equations.txt -o -path ./.ci/install -o \
    -path ./.clang-format -o -path ./.editorconfig -o -path ./.gitignore -o \
    -path ./.gitattributes -o \
    -path './site/*.html' -o -path './site/*.js' -o -path ./site/page.css -o \
    -path './site/*.otf' -o -path './site/figures/*.svg' -o \
    -path './site/live/*.js' -o -path ./site/live/player.css \))
equal 'no file of another kind' '' "$strangers"
# $folders: those of the exercises, which are in no other place.
folders=$(cd tests/exercises && ls -d [0-9][0-9][a-z] P[0-9])
equal 'no folder of another kind' "$({ printf '%s\n' .ci chapters \
    chapters/press exercises plots plots/data src src/box src/choosing \
    src/examiner src/forces src/line src/page src/programs src/scenes src/studies \
    src/toolbox tests tests/exercises site site/figures site/live site/src
    printf 'tests/exercises/%s\n' $folders; } | sort)" \
    "$(cd "$place" && find . -mindepth 1 -type d | sed 's/..//' | sort)"
equal 'and each exercise has its four files' "$(for ex in $folders; do
    called=calls.c
    [ ! -e tests/exercises/$ex/call.h ] || called=call.h
    printf "$ex/%s\n" $called hints.txt stub.c suite.c; done)" \
    "$(cd "$place/tests/exercises" && find . -type f | sed 's/..//' | sort)"
holds 'the book is the one just made' cmp build/bonkers.pdf \
    "$place/bonkers.pdf"
holds 'and their pages' test -s "$place/site/index.html" -a \
    -s "$place/site/search-data.js"
for folder in src tests/exercises plots
do
    holds "$folder is what it is here" sh -c '
        cd "$1" && find . -type f ! -name 'call*.[ch]' | while read -r file; do
            cmp "$file" "$2/$file" || echo differs
        done | grep . && exit 1; exit 0' - "$place/$folder" "$root/$folder"
done

# A lecturer's folder has seen work: exercises solved, a note to self, files
# touched by somebody with another umask. $work/kit has no git at first.
kit=$work/kit
mkdir "$kit"
tar cf - --exclude=./build --exclude=./.git . | (cd "$kit" && tar xf -)
chmod -R u+w "$kit"
mkdir "$kit/build"
# Of the book a first part, of the pages' figures one is enough here, and packed
# sooner.
head -c 100000 build/bonkers.pdf >"$kit/build/bonkers.pdf"
cp -R build/site "$kit/build"
find "$kit/build/site/figures" -name '*.svg' ! -name '01-map.svg' \
    -exec rm -f {} +
cp "$kit"/solutions/*.c "$kit/exercises"
echo 'marks, private' >"$kit/tests/exercises/note-to-self.txt"
# And a lecturer's files lie in the folders of exercises, old and new, one
# below another.
mkdir "$kit/tests/exercises/02z" "$kit/tests/exercises/01b/suite.c.d"
for folder in 01a 02z 01b/suite.c.d; do
    for name in hidden.c remote.c call.h right-x.c wrong-x.c wrong.diff plain.c notes.txt; do
        echo "/* planted: $name */" >>"$kit/tests/exercises/$folder/$name"
    done
done
echo "/* planted: deeper */" >"$kit/tests/exercises/01b/suite.c.d/suite.c"
(cd "$kit" && chapters/press/handout) >"$work/out" 2>&1
holds 'a folder without git makes one' test $? -eq 0
cp "$kit/$archive" "$work/first.tar.gz"
find "$kit" -type f -exec touch {} +
chmod -R go-rwx "$kit"
(umask 027 && cd "$kit" && chapters/press/handout) >"$work/out" 2>&1
holds 'and the same again, byte for byte' cmp "$kit/$archive" \
    "$work/first.tar.gz"
(cd "$kit" && WITH_CHAPTERS=1 chapters/press/handout) >"$work/out" 2>&1
tar xzf "$kit/$archive" -C "$work/all"
for ex in $folders; do
    cmp "tests/exercises/$ex/stub.c" "$work/all/$course/exercises/$ex"-*.c ||
        echo "$ex"
done >"$work/a"
holds 'exercises/ are the stubs as they came' test ! -s "$work/a"
equal 'under the names of the solutions' "$(cd solutions && ls ./*.c)" \
    "$(cd "$work/all/$course/exercises" && ls ./*)"
equal 'of what was planted in their folders nothing goes out' '' \
    "$(cd "$work/all/$course" && grep -rl 'planted: ' . )"
equal 'nor a file of such a name' '' "$(cd "$work/all/$course/tests" &&
    find . -name 'hidden*' -o -name 'remote.c' -o -name 'right*' -o \
        -name 'wrong*' -o -name 'plain*' -o -name 'notes*')"
equal 'a note stays at home' '' \
    "$(find "$work/all" -name 'note-to*' -o -name 'handout*')"
equal 'WITH_CHAPTERS=1 adds chapters/ and nothing else' 'chapters' \
    "$(tar tzf "$kit/$archive" | sort >"$work/with"
        tar tzf "$work/first.tar.gz" | sort | comm -13 - "$work/with" |
            cut -d / -f 2 | uniq)"
files_of() { (cd "$1" && find . -type f ! -name 'handout*' | sort); }
equal 'all of the chapters' "$(files_of chapters)" \
    "$(files_of "$work/all/$course/chapters")"

# With git, what it does not know is left out, and named.
if command -v git >/dev/null 2>&1; then
    (cd "$kit" && rm -f tests/exercises/note-to-self.txt && git init -q &&
        git add -A && echo 'int x;' >src/line/mine.c &&
        git ls-files | grep -c '/wrong-x.c$' >"$work/planted" &&
        SOURCE_DATE_EPOCH=0 chapters/press/handout) >"$work/out" 2>&1
    equal 'the planted files are known to git' 3 "$(cat "$work/planted")"
    holds 'and stay at home; so does what git does not know' \
        cmp "$kit/$archive" "$work/first.tar.gz"
    holds 'and named' grep -qx \
        'handout: left out, for git does not know it: src/line/mine.c' "$work/out"
    rm -f "$kit/src/line/mine.c"
fi

# refused NAME STATUS PATTERN COMMAND...: in one line.
refused() {
    what=$1 want=$2 pattern=$3
    shift 3
    "$@" >"$work/said" 2>&1 </dev/null
    got=$?
    if [ "$got" -eq "$want" ] && [ "$(wc -l <"$work/said")" -eq 1 ] &&
        grep -q -e "$pattern" "$work/said"; then ok "$what"; else
        not_ok "$what" "status $got, said: $(head -c 300 "$work/said")"; fi
}
refused 'no book with solutions' 2 'EDITION: students get the book without' \
    $make -s handout EDITION=instructor
refused 'WITH_CHAPTERS is 1 or 0' 2 "^handout: WITH_CHAPTERS: 'yes' is" \
    env WITH_CHAPTERS=yes "$kit/chapters/press/handout"
refused 'YEAR is a year' 2 "^handout: YEAR: 'soon' is" \
    env YEAR=soon "$kit/chapters/press/handout"
(cd "$kit" && YEAR=2031 chapters/press/handout) >"$work/out" 2>&1
equal 'and draws the numbers of the projects, which are all that it changes' \
    '#define PROJECT_YEAR 2031' "$(mkdir "$work/year" &&
        tar xzf "$kit/$archive" -C "$work/year" &&
        tar xzf "$work/first.tar.gz" -C "$work/year" \
            --transform 's/^/first-/' && cd "$work/year" &&
        diff -r "first-$course" "$course" | sed -n 's/^> //p' | sort -u)"
rm "$kit/tests/exercises/01a/stub.c"
[ -e "$kit/.git" ] && (cd "$kit" && git add -A)
refused 'no suite without a stub' 1 \
    'tests/exercises/01a/suite.c has no tests/exercises/01a/stub.c' \
    "$kit/chapters/press/handout"
rm "$kit/build/bonkers.pdf"
refused 'no archive without a book' 2 \
    '^handout: build/bonkers.pdf is missing' "$kit/chapters/press/handout"

# ---- what a student does with it -------------------------------------------

# Whether it builds, not how fast it runs.
CFLAGS=-O0
export CFLAGS
cd "$place" || exit 1
$make -j2 -s check >"$work/out" 2>&1
holds 'make check works on its own' test $? -eq 0
holds 'every stub says how to get a hint' sh -c 'cd exercises &&
    for stub in *.c; do
        grep -q "make hint EX=${stub%%-*}\( \|$\)" "$stub" || exit 1
    done'
holds 'nothing is begun' grep -q 'Nothing is begun' "$work/out"
equal 'in every exercise' "$(ls tests/exercises | wc -l)" \
    "$(grep -c '^[0-9P][0-9][a-z ] .* not begun' "$work/out")"
cp "$root"/solutions/01a-*.c exercises
$make -s check EX=01a >"$work/out" 2>&1
holds 'a right answer ends well' test $? -eq 0
holds 'and passes' grep -q '^01a .* passed' "$work/out"
# Each of the six states once.
cp "$root"/tests/exercises/01b/wrong-always.c exercises/01b-measure.c
sed 's/;$//' tests/exercises/01c/stub.c >exercises/01c-stack.c
sed 's/NOT_DONE_YET([^)]*)/*(volatile double *)0/' tests/exercises/01d/stub.c \
    >exercises/01d-aim.c
sed 's/return .*/for (volatile int i = 0;; i = i) {}/' \
    tests/exercises/02a/stub.c >exercises/02a-ring.c
build/check/examine --seconds 1 01 02a 02b >"$work/out" 2>&1
holds 'a wrong answer ends badly' test $? -eq 1
for pair in 01a:passed 01b:failed '01c:does not build' 01d:crashed \
    '02a:timed out' '02b:not begun'; do
    holds "$pair" grep -q "^${pair%%:*} .* ${pair#*:}" "$work/out"
done
# What the grader finds out, the check here does: a value behind the last bin.
sed 's/^{$/{ edge[bins + 1] = 7;/' "$root"/solutions/03a-bins.c \
    >exercises/03a-bins.c
build/check/examine 03a >"$work/out" 2>&1
holds 'who writes behind a place is found out' sh -c "grep -q -e edge '$work/out' &&
    ! grep -q '^03a .* passed' '$work/out'"
for name in exercises/*.c; do
    name=${name#*/}
    cp "tests/exercises/${name%%-*}/stub.c" "exercises/$name"
done

# What make help offers can be made, and what cannot says so in one line.
$make -s help >"$work/help" 2>&1
for goal in $(sed -n 's/^make \([a-z][a-z_.-]*\) .*/\1/p' "$work/help"); do
    holds "make $goal is offered, and can be made" $make -n "$goal"
done
for goal in book test memcheck handout mutants grade tangle check-tangle \
    solution; do
    refused "make $goal cannot, and says why" 2 \
        "$goal needs [a-z/.]*, which is not part of the course" \
        $make -s "$goal"
    holds "make help does not offer $goal" \
        sh -c "! grep -q '^make $goal ' '$work/help'"
done
$make -j2 -s >"$work/out" 2>&1
holds 'make works on its own' test $? -eq 0
holds 'and shows where to go on' \
    grep -qx 'Next: make check .*, the book (bonkers.pdf), make help' \
    "$work/out"
holds 'a figure can be drawn' $make -s build/figures/01-geometry.svg
holds 'a movie can be made' \
    $make -s movie PRESET=two EVERY=0.1 UNTIL=0.3 FPS=5

# The README names only what is here.
grep -o '`make [a-z]*' README.md | sed 's/^.make //' | sort -u |
    while read -r goal; do
        grep -q "^make $goal " "$work/help" || [ "$goal" = help ] ||
            echo "$goal"
    done >"$work/out"
equal 'each goal of its README is offered' '' "$(cat "$work/out")"
grep -o '`[a-z]*/[a-z0-9./-]*`' README.md | tr -d '`' | grep -v '^build/' |
    while read -r name; do
        [ -e "$name" ] || echo "$name"
    done >"$work/out"
equal 'each path of its README is there' '' "$(cat "$work/out")"
cd "$root" || exit 1

# ---- no answer in it -----------------------------------------------------

# Function bodies of fewer words say nothing: `return a - b;` has 5. No body
# of the answers has between 10 and 14 as this is written, and a dot product
# has 21.
least=12
# A line of an answer is told from any other by so many: a loop over an array
# is no answer and is left out, `e = exp(-g * t)` has 10, and the centre of
# mass 15.
key=11
# A reference value has so many significant digits, or more.
digits=8

# Leaks are told one a line. Exempt is
# - a body that src/ prints, and a number that src/, chapters/ or plots/data/
#   (which the figures show) print: they are the book's;
# - a helper that the exercise's own stub gives, under the same name: that
#   the stub is no answer is the business of tests/exercises/all.sh;
# - a helper of hidden tests, no test itself, that a public suite has under
#   the same name.

# hidden_lists FILE...: what stands in their check_hidden[], on one line.
hidden_lists() {
    sed -n '/check_hidden\[\]/,/};/p' "$@" | tr '\n' ' ' |
        sed 's/" *"//g'
}

# values FILE...: each long number in it, as FILE<tab>DIGITS.
values() {
    awk -v least=$digits '{
        rest = tolower($0)
        while (match(rest, /0x[0-9a-f.]+|[0-9]+\.?[0-9]*|\.[0-9]+/)) {
            before = RSTART > 1 ? substr(rest, RSTART - 1, 1) : ""
            number = substr(rest, RSTART, RLENGTH)
            rest = substr(rest, RSTART + RLENGTH)
            if (before ~ /[a-z0-9_]/)
                continue
            if (number !~ /^0x/) {
                gsub(/\./, "", number)
                gsub(/^0+|0+$/, "", number)
            }
            # 10000001 and 9999999 are round numbers, nearly.
            if (length(number) >= least + 2 * (number ~ /^0x/) &&
                number !~ /^[0-9]00000+[0-9]$|^[0-9]?999999+$/)
                print FILENAME "\t" number
        }
    }' "$@" /dev/null
}

# same_values: of the second list those that are in the first, when both are
# cut to the shorter one of the two.
same_values() {
    awk -F '\t' 'function same(a, b,    n, d) {
        if (a ~ /^0x/ || b ~ /^0x/)
            return a == b
        n = length(a) < length(b) ? length(a) : length(b)
        n = n < 15 ? n : 15
        d = substr(a, 1, n) - substr(b, 1, n)
        return d * d <= 1
    }
    function key(a) { return a ~ /^0x/ ? a : substr(a, 1, 7) + 0 }
    FNR == NR {
        for (i = a = key($2); i <= a + 1 || i == a; ++i) {
            known[i] = known[i] " " $2
            if (a ~ /^0x/)
                break
        }
        if (a !~ /^0x/)
            known[a - 1] = known[a - 1] " " $2
        if (!($2 in from))
            from[$2] = $1
        next
    }
    {
        n = split(known[key($2)], list, " ")
        for (i = 1; i <= n; ++i)
            if (same(list[i], $2)) {
                print $1 ": " $2 " is a value of " from[list[i]] "\t" list[i]
                break
            }
    }' "$1" "$2"
}

# The key lines of the solutions: their statements, conditions, and what these
# compute, each alone in a function, in a file $work/keys/NNx.c.
key_lines() {
    mkdir "$work/keys"
    "$tokens" solutions/*.c | awk -v folder="$work/keys" '
        function emit(from, to,    text) {
            for (text = ""; from <= to; ++from)
                text = text " " $from
            printf "void line_%d(void) {%s }\n", ++count, text >file
        }
        function statement(from, to,    i, depth) {
            if ($from ~ /^(if|for|while)$/) {
                i = from
                do
                    depth += ($++i == "(") - ($i == ")")
                while (depth && i < to)
                if ($from != "for")
                    emit(from + 1, i)
                statement(i + 1, to)
            } else if ($from == "return") {
                emit(from + 1, to)
            } else {
                for (i = from; i <= to && $i != "="; ++i)
                    depth += ($i == "(") - ($i == ")")
                if (i <= to && depth == 0)
                    emit(i + 1, to)
                emit(from, to)
            }
        }
        {
            file = $1
            sub(/.*\//, "", file)
            sub(/-.*/, "", file)
            file = folder "/" file ".c"
            from = 3
            for (i = 3; i <= NF; ++i) {
                open += ($i == "(") - ($i == ")")
                if (!open && $i ~ /^[;{}]$/) {
                    if (i > from)
                        statement(from, i - 1)
                    from = i + 1
                }
            }
        }'
}

# The exercise and the kind of a file of answers, of the stub or the suite.
kinds='function exercise_of(path) {
        if (match(path, /tests\/exercises\/[0-9P][0-9][a-z]?\//))
            return substr(path, RSTART + 16, RLENGTH - 17)
        sub(/.*\//, "", path)
        sub(/[-.].*/, "", path)
        return path
    }
    function kind_of(path) {
        return path ~ /\/stub\.c/ ? "stub" : path ~ /\/suite\.c/ ? "suite" : \
            path ~ /\/hidden/ ? "hidden" : path ~ /\/(right-|plain)/ ? "right" : \
            path ~ /\/wrong-/ ? "wrong" : "solution"
    }'

# without EXERCISE...: what these have no text of, of bodies that are sought.
without() {
    awk -v least=$least -v folders="$*" "$kinds"'
        NF - 2 >= least { found[exercise_of($1) " " kind_of($1)] }
        END {
            n = split(folders, name, " ")
            m = split("solution right wrong hidden", kind, " ")
            for (i = 1; i <= n; ++i)
                for (k = 1; k <= m; ++k)
                    if (!(name[i] " " kind[k] in found))
                        print name[i], kind[k]
        }' "$work/bodies"
}

# The answers, by folder, what is exempt, and the hidden tests, worked out
# once: into $work/exempt, $work/values, $work/names; $1 is one more file of
# hidden tests.
learn() {
    hidden="$(ls tests/exercises/*/hidden.c) $1"
    for ex in $folders; do
        tests/exercises/answers "$ex" "$work/tests/exercises/$ex" || not_ok answers "$ex"
    done
    answers="$(ls solutions/*.c "$work"/tests/exercises/*/*.c) $hidden"
    # shellcheck disable=SC2086
    "$tokens" $answers >"$work/bodies"
    # shellcheck disable=SC2086
    "$tokens" --within $least $answers -- src/*/*.[ch] |
        cut -f 1 >"$work/exempt"
    # shellcheck disable=SC2086
    {
        hidden_lists /dev/null $hidden | sed 's/"[^"]*"//g' |
            tr -c 'a-zA-Z0-9_' '\n'
        cat "$work/bodies"
        "$tokens" tests/exercises/*/stub.c tests/exercises/*/suite.c
    } | awk "$kinds"'
        # FILE:LINE: NAME: TOKENS, and before them the words of the lists.
        NF == 1 { listed[$1] }
        NF < 3 { next }
        {
            kind = kind_of($1)
            key = (kind ~ /suite|hidden/ ? "" : exercise_of($1)) \
                substr($0, length($1) + 1)
            if (kind ~ /stub|suite/)
                known[key]
            else if (kind != "hidden" || !(substr($2, 1, \
                    length($2) - 1) in listed))
                key_of[$1 " " substr($2, 1, length($2) - 1)] = key
        }
        END {
            for (body in key_of)
                if (key_of[body] in known)
                    print body
        }' >>"$work/exempt"

    key_lines
    "$tokens" --within $key "$work"/keys/*.c -- src/*/*.[ch] \
        tests/exercises/*/stub.c | cut -f 1 >"$work/known-lines"

    # shellcheck disable=SC2086
    values $answers tests/library/*.c >"$work/all-values"
    values $(find src chapters plots/data -type f) >"$work/book-values"
    same_values "$work/book-values" "$work/all-values" | cut -f 1 |
        sed 's/: \([^ ]*\) is a value of .*/\t\1/' >"$work/printed"
    grep -vxF -f "$work/printed" "$work/all-values" >"$work/values"

    # shellcheck disable=SC2086
    hidden_lists /dev/null $hidden | grep -o '"[^"]*"' |
        sort -u >"$work/strings"
    tr -cs 'a-zA-Z0-9\n' ' ' <"$work/strings" | grep '[a-z] .* .* ' \
        >"$work/names"
}

# leaks FOLDER: what the files in it give away.
leaks() {
    rm -f "$work"/*.pdf.txt "$work"/*.html.txt
    find "$1" -type f ! -name '*.pdf' ! -name '*.html' | sort >"$work/texts"
    # A page without its marks; a thin space in a number is one, as on paper.
    for page in $(find "$1" -name '*.html'); do
        sed 's/<mspace[^>]*>/ /g; s/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&amp;/\&/g' \
            "$page" >"$work/${page##*/}.txt"
        echo "$work/${page##*/}.txt"
    done >>"$work/texts"
    for pdf in $(find "$1" -name '*.pdf'); do
        cp "$("$root/tests/text-of" "$pdf")" "$work/${pdf##*/}.txt"
        echo "$work/${pdf##*/}.txt"
    done >>"$work/texts"
    # shellcheck disable=SC2046,SC2086
    "$tokens" --within $least $answers -- $(cat "$work/texts") |
        awk -F '\t' 'FNR == NR { exempt[$0]; next }
            NF == 2 && !($1 in exempt) { print $2 ": the body of " $1 }' \
            "$work/exempt" -
    # A line of one exercise may stand in the suite of another.
    # shellcheck disable=SC2046
    "$tokens" --within $key "$work"/keys/*.c -- $(cat "$work/texts") |
        awk -F '\t' 'FNR == NR { known[$0]; next }
            NF == 2 && !($1 in known) {
                ex = $1
                sub(/\.c:.*/, "", ex)
                sub(/.*\//, "", ex)
                if ($2 !~ /tests\/exercises\/[^\/]*\/suite\.c/ ||
                    index($2, "tests/exercises/" ex "/"))
                    print $2 ": a key line of solutions/" ex
            }' "$work/known-lines" -
    # A page of print may cut a function in two: lines of 24 characters and
    # more, spaces not counted, are looked for on their own.
    # shellcheck disable=SC2046,SC2086
    awk '{ line = $0; gsub(/[ \t\f\r]/, "", line) }
        kind == "book" { book[line]; next }
        kind == "answer" {
            if (length(line) >= 24 && line ~ /[;{}(),=]/ && !(line in book))
                from[line] = FILENAME ":" FNR
            next
        }
        line in from { print FILENAME ":" FNR ": the line " from[line] }
        ' kind=book src/*/*.[ch] tests/exercises/*/stub.c \
        tests/exercises/*/hints.txt \
        kind=answer $answers kind=text \
        $(grep "^$work/[^/]*\.\(pdf\|html\)\.txt$" "$work/texts")
    values $(cat "$work/texts") >"$work/found"
    same_values "$work/values" "$work/found" | cut -f 1 | sort -u
    # Names may be broken over lines, with the marks of a comment between.
    # shellcheck disable=SC2046
    {
        awk 'FNR == 1 { printf "\n%s: ", FILENAME }
            gsub(/[^a-zA-Z0-9]+/, " ") {
                sub(/^ /, "")
                sub(/ $/, "")
            }
            { printf "%s ", $0 }
            END { print "" }' $(cat "$work/texts") |
            grep -iF -f "$work/names" | sed 's/: .*//'
        grep -lF -f "$work/strings" $(cat "$work/texts")
    } | sort -u | sed 's/$/: the name of a hidden test/'
}

# Hidden tests of our own, so that there are some to leak.
mkdir "$work/hidden"
cat >"$work/hidden/01a-planted.c" <<'END'
static bool planted_run(void)
{
    return check_draw(1.0, 9.0) * check_draw(2.0, 3.0) > 7.25;
}

const struct check_test check_hidden[] = {
    {"a planted secret "
     "of the grader", planted_run, 1},
    {0},
};
END
learn "$work/hidden/01a-planted.c"
# The wrong answers of projects are changes of the right ones, in *.sed.
small=$(printf '%s\n' $folders | grep -v P)
equal 'every exercise yields a solution, right and wrong ones, hidden tests' \
    '' "$(without $small)"
equal 'and every project a solution and right ones' '' \
    "$(without P1 P2 P3 P4 | grep -v 'wrong$\|hidden$')"
grep -v -e '/exercises/05b/right-' -e '/exercises/05b/plain' -e '^solutions/07a' \
    -e '/exercises/08c/wrong-' -e '^tests/exercises/12c/hidden' \
    "$work/bodies" >"$work/fewer" && mv "$work/fewer" "$work/bodies"
equal 'where one yields none it is named' "$(printf '%s\n' '05b right' \
    '07a solution' '08c wrong' '12c hidden' '13a solution' '13a right' \
    '13a wrong' '13a hidden')" "$(without $small 13a)"
holds 'answers are sought' test "$(echo $answers | wc -w)" -gt 300
holds 'and values' test "$(wc -l <"$work/values")" -gt 20
holds 'and the names of hidden tests' test -s "$work/names"
# The book whole, as it is handed out.
tar xzf "$work/made.tar.gz" -C "$work/all" "$course/bonkers.pdf"
holds 'it is whole' cmp build/bonkers.pdf "$work/all/$course/bonkers.pdf"
leaks "$work/all/$course" >"$work/leaks"
sed "s|^$work/all/$course/||; s|^$work/||" "$work/leaks" >"$work/out"
if [ -s "$work/out" ]; then
    sed 's/^/    /' "$work/out"
    not_ok 'no answer in the course' \
        "$(wc -l <"$work/out") leaks, the first: $(head -n 1 "$work/out")"
else
    ok 'no answer in the course'
fi

# The search must be able to fail. It looks at one text after the other, so that
# here it has those alone in which there is something.
plant() { # FILE: of the course, with what comes in behind it
    mkdir -p "$work/changed/${1%/*}"
    cat "$work/all/$course/$1" - >"$work/changed/$1"
}
sed 's/im1/p/g; s/im2/q/g; s/u1/left/g; s/u2/right/g; s/const //
    s/;/; \/\* mine \*\//' solutions/01a-collide.c | plant src/line/collide.h
echo '/* See also: a planted' '
   secret of the grader. */' | plant src/line/schedule.c
echo 'Why not return draw(1, 9) * draw(2.00, 3) > 7.250; as it were?' |
    plant tests/exercises/02a/hints.txt
grep -v '^/\*' tests/exercises/01b/wrong-always.c | sed 's/^/# /' |
    plant plots/01-forms.gp
grep -v '^/\*' tests/exercises/01c/right-pairs.c | sed 's/.*/"&\\n"/' |
    plant src/line/statistics.c
sed -n '/centre = /s/centre/all/p' solutions/01a-collide.c |
    plant tests/exercises/01a/suite.c
sed -n 's/.*return (/ * Or is it (/p' solutions/01d-aim.c |
    plant plots/03-finite.gp
value=$(sed -n 's/^tests\/library.*\t\([0-9]\{9\}\).*/\1/p' "$work/values" |
    head -n 1)
echo "# The limit is 0.$value." | plant plots/02-drift.gp
mkdir "$work/changed/site"
cp build/site-instructor/01-collide.html "$work/changed/site/answers.html"
if [ -s build/bonkers-instructor.pdf ]; then
    cp build/bonkers-instructor.pdf "$work/changed/answers.pdf"
fi
leaks "$work/changed" | sed "s|^$work/changed/||; s|^$work/||" >"$work/out"
found() { # NAME PATTERN
    holds "found out: $1" grep -q "^$2" "$work/out"
}
found 'a solution with its variables renamed, in a header' \
    'src/line/collide.h:[0-9]*: the body of solutions/01a-'
found 'the name of a hidden test, in a comment on two lines' \
    'src/line/schedule.c: the name of a hidden test'
found 'what a hidden test does, among the hints' \
    'tests/exercises/02a/hints.txt:[0-9]*: the body of .*planted_run'
found 'a wrong answer, in the comments of a figure' \
    'plots/01-forms.gp:[0-9]*: the body of .*/exercises/01b/wrong-always.c'
found 'a right answer, in a string' \
    'src/line/statistics.c:[0-9]*: the body of .*/exercises/01c/right-pairs.c'
found 'a line of a solution, in its suite' \
    'tests/exercises/01a/suite.c:[0-9]*: a key line of solutions/01a'
found 'a line of a solution, in a script' \
    'plots/03-finite.gp:[0-9]*: a key line of solutions/01d'
found "the reference value 0.$value" \
    "plots/02-drift.gp: $value is a value of tests/library/"
found 'the solutions among the pages' \
    'answers.html.txt:.* the body of solutions/01a'
[ -e "$work/changed/answers.pdf" ] && for file in solutions/*.c; do
    found "$file, in an instructor's book" "answers.pdf.txt:.* $file:"
done
# The last ones are of the solutions, one by one.
echo "1..$((102 + $(ls solutions/*.c | wc -l)))"
