#!/bin/sh
# The front door: what README.md shows and says is so, what CONTRIBUTING.md and
# the editor's tasks name is there, and all that has a version has the same.
. tests/programs/common
LC_ALL=C
export LC_ALL
unset EX V
make=${MAKE:-make}

# equal NAME EXPECTED GOT
equal() {
    if [ "$2" = "$3" ]; then ok "$1"; else
        not_ok "$1" "expected '$2', got '$(echo "$3" | head -c 300)'"; fi
}
# between NAME LEAST NUMBER MOST
between() {
    if [ "${3:-x}" -ge "$2" ] && [ "$3" -le "$4" ]; then ok "$1"; else
        not_ok "$1" "$3 is not from $2 to $4"; fi
}
words() { tr '\n' ' ' <"${1:-README.md}" | tr -s ' '; }

# ---- what is shown --------------------------------------------------------

# Pictures and links lead to files; each picture has a word for who cannot see.
pictures() {
    words | grep -o '!\[[^]]*\]([^)]*)\|<img [^>]*>' |
        sed 's/^!\[\([^]]*\)\](\([^)]*\))$/\2 \1/
            s/^<img .*src="\([^"]*\)".* alt="\([^"]*\)".*/\1 \2/'
}
pictures >"$work/pictures"
equal 'README shows a film, two pages and a figure of each chapter' '1 2 12' \
    "$(for kind in '[.]gif ' '/page-' '/[01][0-9]-'; do
        grep -c "$kind" "$work/pictures"
    done | tr '\n' ' ' | sed 's/ $//')"
while read -r name says; do
    [ -s "$name" ] && [ ${#says} -ge 20 ] || echo "$name"
done <"$work/pictures" >"$work/out"
equal 'each is there, and is described' '' "$(cat "$work/out")"
equal 'and no other is committed' "$(cut -d ' ' -f 1 "$work/pictures" | sort)" \
    "$(ls plots/front/*)"
between 'the film is one of at most 1 MB' 1000 "$(wc -c <plots/front/ring.gif)" 1000000
equal 'in the format of films' 'GIF89a' "$(head -c 6 plots/front/ring.gif)"
between 'all pictures together are at most 1.5 MB' 1000 \
    "$(cat plots/front/* | wc -c)" 1500000
for file in README.md CONTRIBUTING.md SECURITY.md CHANGELOG.md; do
    words $file | grep -o ']([^)]*)' | sed 's/^](//; s/)$//' | grep -v '^http' |
        while read -r name; do [ -e "$name" ] || echo "$file: $name"; done
done >"$work/out"
equal 'each link leads to a file' '' "$(cat "$work/out")"

# Twelve lines of a failed check, as they come.
sed -n '/^01a: /,/^```$/p' README.md | sed '$d' >"$work/shown"
build/check/examine --as 01a --file tests/exercises/01a/wrong-still-wall.c |
    sed 's/tests.exercises.01a.wrong-still-wall[.]c/exercises\/01a-collide.c/' |
    sed -n '/^01a: /,$p' >"$work/check"
equal 'the failed check has twelve lines' 12 "$(wc -l <"$work/shown")"
equal 'which are those of the examiner' "$(head -n 12 "$work/check")" \
    "$(cat "$work/shown")"
holds 'and ask a question' grep -q '?' "$work/shown"

# The table of chapters: their titles, a figure of theirs, their exercises.
grep '^| \*\*[0-9]' README.md >"$work/rows"
equal 'the table has twelve chapters' 12 "$(wc -l <"$work/rows")"
n=0
while read -r row; do
    n=$((n + 1))
    two=$(printf %02d $n)
    title=$(sed -n 's/^.chapter{\([^}]*\)}.*/\1/p' chapters/$two-*.nw | head -n 1)
    set -- $(cat tests/exercises/$two?/suite.c |
        sed -n 's/^ *[.]minutes = \([0-9]*\),.*/\1/p' |
        awk '{ sum += $1 } END { print NR, sum }')
    case $row in
    "| **$n $title**<br><img src=\"plots/front/$two-"*"> | "*"? | $1, $2 minutes |") ;;
    *) echo "$row" ;;
    esac
done <"$work/rows" >"$work/out"
equal 'each with its title, a figure, a question, and the time of its exercises' '' \
    "$(cat "$work/out")"

# ---- what is counted ------------------------------------------------------

# number PATTERN: what stands in the place of N in it.
number() { words | sed -n "s/.*$(echo "$1" | sed 's/N/\\([0-9]*\\)/').*/\1/p"; }
near() { # NAME SAID COUNTED: to two hundredths
    between "$1 ($2)" $(($3 * 98 / 100)) "${2:-0}" $(($3 * 102 / 100))
}
pages() { pdfinfo "build/$1.pdf" | sed -n 's/^Pages: *//p'; }
near 'so many pages has the book' "$(number 'Some N pages, or the')" "$(pages bonkers)"
equal 'so many exercises' "$(ls -d tests/exercises/[01]*/ | wc -l)" \
    "$(number 'There are N exercises, and')"
equal 'and four projects' 4 "$(ls -d tests/exercises/P*/ | wc -l)"
holds 'as README says' grep -q 'exercises, and four projects' README.md
set -- one two three four five six seven eight nine ten eleven twelve
shift $(($(grep -ho 'livefigure{[a-z]*}' chapters/*.nw | sort -u | wc -l) - 1))
holds "and $1 figures move" sh -c "tr '\n' ' ' <README.md |
    grep -q 'where $1 of the figures move'"
first=$(sed -n 's/.*| \([0-9]*, [0-9]*\) minutes |$/\1/p' "$work/rows" | sed 1q)
set -- one two three four five six seven eight nine ten
shift $((${first%,*} - 1))
equal 'the week has the time of the first chapter' "${first#*, }" \
    "$(number "an hour to read, N minutes for its $1 exercises")"
holds 'which takes an hour to read, and one in the laboratory' \
    grep -q '^.boxline{Time}{60 minutes to read; .* one lab hour' chapters/01-collide.nw
# Another test makes the course anew, perhaps just now.
size=$(($(cat build/bonkers-course.tar.gz 2>/dev/null | wc -c) / 100000))
said=$(number 'archive for your students (N MB)')
[ "$size" -gt 0 ] || size=${said}0
between "so large is the course ($said MB)" $((size - 10)) "${said}0" $((size + 10))

# ---- what is named --------------------------------------------------------

$make -s help >"$work/help" 2>&1
for file in README.md CONTRIBUTING.md SECURITY.md CHANGELOG.md; do
    words $file | grep -o '`make [a-z][a-z-]*' | sed 's/^.make //' | sort -u |
        while read -r goal; do
            case $file:$goal in *:help | CHANGELOG.md:native | CHANGELOG.md:works) continue ;; esac
            grep -q "^make $goal " "$work/help" ||
                grep -q "^[a-z -]*$goal[ :]" tests/tests.mk src/*/*.mk ||
                echo "$file: $goal"
        done
    words $file | grep -o '`[.a-z0-9A-Z-]*/[a-zA-Z0-9./-]*`' | tr -d '`' |
        grep -v '^build/\|^[.]\{0,1\}[a-z]*/[NM][N0-9]' | while read -r name; do
        [ -e "$name" ] || [ -d "src/$name" ] ||
            [ -n "$(find src tests plots chapters -path "*/${name%/}")" ] ||
            echo "$file: $name"
    done
done | grep -v 'tests/exercises/01f/$\|^CHANGELOG.md: src/enough$' >"$work/out"
equal 'each goal and each path that is named is there' '' "$(cat "$work/out")"
holds 'the film of README is one that can be made' env SCENE=ring \
    KEYS='--factor 1000' VIEW=tilted plots/show movie --wanted

# ---- one version ----------------------------------------------------------

version=$(sed -n 's/^#define TOOLBOX_VERSION "\(.*\)"$/\1/p' src/toolbox/version.h)
for program in build/bin/* build/check/examine build/grade/grade; do
    name=${program##*/}
    case $name in
    # What the book prints whole has no options.
    *0 | check-collide) ;;
    *) [ "$($program --version)" = "$name (Bonkers) $version" ] || echo "$name" ;;
    esac
done >"$work/out"
equal 'every program says the version' '' "$(cat "$work/out")"
equal 'so does build/bonkers.pdf' "Version $version" \
    "$(pdfinfo build/bonkers.pdf | sed -n 's/^Subject: *//p')"
holds 'and its title page' sh -c "pdftotext -l 1 build/bonkers.pdf - |
    grep -qx 'Version $version'"
holds 'and CITATION.cff' grep -qx "version: \"$version\"" CITATION.cff
date=$(sed -n 's/^date-released: "\(.*\)"$/\1/p' CITATION.cff)
holds 'and the head of CHANGELOG, of the same day' sh -c "grep '^## [0-9]' CHANGELOG.md |
    sed 1q | grep -x '## $version, .* ($date)'"
index=build/site/index.html
[ -s $index ] || index=$work/index
[ -s $index ] || echo "<p>Version $version</p>" >"$index"
holds 'and the front page of the pages' grep -q "Version $version<" "$index"

# ---- what an editor is told ------------------------------------------------

# The tasks of an editor are JSON; what they look for in the examiner's words
# is found there, with the line and the column.
json() { build/tests/grader/schema --values "$1" "$2"; }
holds 'the container uses the kit'"'"'s own script' \
    [ "$(json onCreateCommand .devcontainer/devcontainer.json)" = \
    'sh .ci/install test' ]
json regexp .vscode/tasks.json >"$work/patterns"
build/check/examine --as 01a --file tests/before/01a-semicolon.c |
    sed 's/tests.before.01a-semicolon[.]c/exercises\/01a-collide.c/' >"$work/broken"
equal 'an error of the compiler is found' \
    "exercises/01a-collide.c:12:14 error: expected ';' before 'v'" \
    "$(sed -En "s~$(sed -n 1p "$work/patterns")~\1:\2:\3 \4: \5~p" "$work/broken" |
        tr '`‘’' "'")"
equal 'and so is a check that fails' 'exercises/01a-collide.c' \
    "$(sed -En "s~$(sed -n 2p "$work/patterns")~\1~p" "$work/check")"
for pattern in $(json beginsPattern .vscode/tasks.json | tr ' ' '~') ; do
    holds 'a round of the watch begins as the tasks have it' \
        grep -Eq "$(echo "$pattern" | tr '~' ' ')" <<END
$(build/check/examine --as 01a --file tests/before/01a-semicolon.c | sed 1q)
END
done
holds 'and ends so' grep -q "\"$(json endsPattern .vscode/tasks.json |
    sed 's/^^/.n/')" src/examiner/watch.c
echo 1..33
