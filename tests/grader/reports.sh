#!/bin/sh
# The reports of a course that reports.c makes up: JSON against the schemas,
# JUnit by a real parser, a spreadsheet read again by another hand, names and
# stories of any bytes, and nothing that is hidden. Where a check could pass
# because it looks at nothing, it is also seen failing.
. tests/programs/common
reports=build/tests/grader/reports
schema=build/tests/grader/schema
schemas=tests/grader/schemas
LC_ALL=C.UTF-8
export LC_ALL
unset CLASSROOM ASSIGNMENT ASSIGNMENT_TYPE OWNER SUBMISSION_TAG COMMIT_URL \
    RELEASE_URL REVIEW_URL

# refused STATUS PATTERN COMMAND...: it ends so and says something like that.
refused() {
    want=$1 pattern=$2
    shift 2
    got=0
    "$@" >"$work/refusal" 2>&1 || got=$?
    [ "$got" -eq "$want" ] && grep -q "$pattern" "$work/refusal" && return
    echo "status $got, not $want: $(head -c 300 "$work/refusal")"
    return 1
}
# finds WHAT FILE...: the word stands in each of the files.
finds() {
    word=$1
    shift
    for file; do grep -q "$word" "$file" || { echo "$file"; return 1; }; done
}
# lacks WHAT FOLDER: the word stands nowhere below it.
lacks() { ! grep -r -l -e "$1" "$2"; }

for course in plain strange many one; do
    out=$work/$course
    mkdir "$out"
    "$reports" "$course" --names "$out" || exit 1
    tr '\0\n' '\n?' <"$out/names" | sed 's/?/\\n/g' >"$out/names.txt"
    students=$(wc -l <"$out/names.txt")
    for report in csv gradescope classroom50 github junit; do
        holds "$course: $report is written" "$reports" "$course" "$report" "$out"
    done
    "$reports" "$course" table "$out" >"$out/table"
    for kind in gradescope classroom50 github; do
        holds "$course: $kind agrees with the schema" \
            "$schema" "$schemas/$kind.json" "$out/$kind"/*
        holds "$course: $kind has a file for each student" \
            test "$(ls -A "$out/$kind" | wc -l)" -eq "$students"
        holds "$course: $kind hides what is hidden" lacks SECRET "$out/$kind"
        holds "$course: $kind tells what is public" finds PUBLIC "$out/$kind"/*
    done
    holds "$course: junit agrees with the schema" \
        xmllint --noout --huge --schema "$schemas/junit.xsd" "$out/junit.xml"
    holds "$course: junit hides what is hidden" sh -c "! grep -q SECRET '$out/junit.xml'"
    holds "$course: junit tells what is public" finds PUBLIC "$out/junit.xml"
    holds "$course: no half of a file is left" \
        test -z "$(find "$out" -name '*.part')"
    holds "$course: the table fits into 80 columns" \
        test "$(wc -L <"$out/table")" -le 80
done

# The schemas refuse what is not right.
ada=$work/plain/gradescope/Ada.json
room=$work/plain/classroom50/Ada.json
spoilt() { # KIND FILE SED PATTERN
    sed "$3" "$2" >"$work/spoilt.json"
    ! cmp -s "$2" "$work/spoilt.json" &&
        refused 1 "$4" "$schema" "$schemas/$1.json" "$work/spoilt.json"
}
holds 'a score that is text is refused' spoilt gradescope "$ada" \
    '2s/: \(.*\),/: "\1",/' '/score: not of type integer'
holds 'a score below 0 is refused' spoilt gradescope "$ada" \
    '2s/: /: -/' 'less than 0'
holds 'a field too many is refused' spoilt gradescope "$ada" \
    '2s/^/"leaderboard": [],/' '/leaderboard: no such field'
holds 'a missing field is refused' spoilt gradescope "$ada" \
    '/"max_score"/d' "/tests/0: 'max_score' is missing"
holds 'an unknown visibility is refused' spoilt gradescope "$ada" \
    's/"visibility": "hidden"/"visibility": "secret"/' 'none of the values'
holds 'another schema is refused' spoilt classroom50 "$room" \
    's/result\/v1/result\/v2/' '/schema: not the one'
holds 'a fraction of a point is refused' spoilt classroom50 "$room" \
    's/"score": 1,/"score": 0.5,/' 'not of type integer'
holds 'a name that is too long is refused' spoilt classroom50 "$room" \
    's/"test-name": "01a.1/&xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx/' \
    'more than 100 characters'
holds 'a test without a status is refused' spoilt github \
    "$work/plain/github/Ada.json" '/"status": "error"/d' "'status' is missing"
holds 'a message that is none is refused' spoilt github \
    "$work/plain/github/Ada.json" 's/"message": ".*"/"message": null/' \
    'not of type string'
holds 'a time that is none is refused' spoilt classroom50 "$room" \
    's/T09:30/T24:30/' '/datetime: does not match'
sed '1s/{/{"maximum": 3,/' "$schemas/gradescope.json" >"$work/schema.json"
holds 'a keyword that is not known is refused' \
    refused 2 "unknown keyword 'maximum'" "$schema" "$work/schema.json" "$ada"
head -c 2000 "$ada" >"$work/half.json"
holds 'half a file is refused' \
    refused 2 half.json "$schema" "$schemas/gradescope.json" "$work/half.json"

# Points: what the tests have earned is the total, in each report the same.
values() { key=$1; shift; "$schema" --values "$key" "$@"; }
sum() { awk '{ sum += $1 } END { print sum + 0 }'; }
totals() { # KIND TOTAL: the first score of each file is the sum of the others
    for file in "$work/$1/gradescope"/*; do
        total=$(values score "$file" | head -1)
        [ "$total" -eq "$(values score "$file" | sed 1d | sum)" ] &&
            [ "$(values possible "$file")" -eq "$(values max_score "$file" | sum)" ] || {
            echo "$file"
            return 1
        }
    done
    for file in "$work/$1/classroom50"/*; do
        [ "$(values score "$file" | sum)" -eq \
            $((2 * $(sed -n 's/^  "score": \([0-9]*\),$/\1/p' "$file"))) ] &&
            [ "$(values max-score "$file" | sum)" -eq \
                $((2 * $(sed -n 's/^  "max-score": \([0-9]*\),$/\1/p' "$file"))) ] || {
            echo "$file"
            return 1
        }
    done
}
holds 'the totals are the sums of the tests' totals strange
holds 'Ada has 111 points of 189' sh -c "
    grep -q '^  \"score\": 111,' '$ada' && grep -q '\"possible\": 189' '$ada' &&
    grep -q '^  \"score\": 111,' '$room' && grep -q '^  \"max-score\": 189,' '$room' &&
    grep -q '^\"Ada\",.*,111,189,\".*\".\$' '$work/plain/grades.csv' &&
    grep -q '^Ada  *111 ' '$work/plain/table'"

# GitHub Classroom adds up what the tests have earned, and takes the sum of the
# runners' max_score, so both must be in one file; and 'fail' fails the job.
github() {
    for file in "$work"/*/github/*; do
        classroom=${file%/github/*}/classroom50/${file##*/}
        [ "$(values score "$file" | sum)" -eq \
            "$(sed -n 's/^  "score": \([0-9]*\),$/\1/p' "$classroom")" ] &&
            [ "$(values max_score "$file")" -eq \
                "$(sed -n 's/^  "max-score": \([0-9]*\),$/\1/p' "$classroom")" ] &&
            [ "$(values status "$file" | head -1)" = fail ] || {
            echo "$file"
            return 1
        }
    done
    for status in pass fail error; do
        values status "$work/plain/github/Ada.json" | grep -qx $status || return 1
    done
}
holds 'GitHub Classroom comes to the same points' github

# Gradescope: hidden tests are marked as such, have no story and no name.
hidden() {
    awk '/"name":/ { name = $0 } /"visibility": "hidden"/ { ++n
        if (name !~ /: hidden check [12]",$/) { print name; bad = 1 } }
        END { exit bad || n != 18 }' "$ada"
}
holds 'hidden tests are hidden, and have neutral names' hidden
holds 'an exercise shows the state of its public tests' \
    grep -q '01b A title: passed, 10 of 10 points' "$ada"
holds 'a file that does not build is called that' \
    grep -q '01d A title: does not build, 0 of 10' "$ada"
holds 'why a file was refused is told' grep -q 'no regular file: x.c' "$ada"
holds 'and what else was handed in' grep -q 'Also handed in:.*work.zip' \
    "$work/plain/gradescope/Björn.json"

# Classroom 50: names of at most 100 bytes, none twice, no character halved.
short() {
    for file in "$work"/*/classroom50/*; do
        values test-name "$file" >"$work/test-names"
        LC_ALL=C awk 'length > 100 { exit 1 }' "$work/test-names" &&
            [ -z "$(sort "$work/test-names" | uniq -d)" ] &&
            iconv -f UTF-8 -t UTF-8 "$work/test-names" >"$work/converted" || {
            echo "$file"
            return 1
        }
    done
    LC_ALL=C awk 'length == 100 { ++n } END { exit n == 0 }' "$work/test-names"
}
holds 'names of tests are short, whole and different' short
in_the_runner() {
    CLASSROOM=phys ASSIGNMENT=chapter-2 OWNER=ada SUBMISSION_TAG=submit/x \
        COMMIT_URL=https://c RELEASE_URL=https://r REVIEW_URL=https://w \
        "$reports" "$1" classroom50 "$work/runner-$1" &&
        for file in "$work/runner-$1/classroom50"/*; do
            for key in classroom assignment owner submission commit release \
                review; do
                values "$key" "$file"
            done | tr '\n' ' '
        done
}
holds 'Classroom 50 says itself whose result it is' \
    test "$(in_the_runner one)" = \
    'phys chapter-2 ada submit/x https://c https://r https://w '
holds 'but not for a whole course' \
    sh -c "case '$(in_the_runner plain)' in *ada*) exit 1 ;; *Ada*Bj*) ;; *) exit 1 ;; esac"

# JUnit: a case for each test, totals that are right, no name twice.
counts() { # COURSE
    xml=$work/$1/junit.xml
    x() { xmllint --huge --xpath "$1" "$xml"; }
    for pair in tests:testcase failures:failure errors:error skipped:skipped; do
        [ "$(x "number(/testsuites/@${pair%:*})")" = "$(x "count(//${pair#*:})")" ] &&
            [ "$(x "sum(//testsuite/@${pair%:*})")" = "$(x "count(//${pair#*:})")" ] &&
            [ "$(x "count(//testsuite[@${pair%:*} != count(.//${pair#*:})])")" = 0 ] || {
            echo "$pair"
            return 1
        }
    done
    [ "$(x 'count(//error)')" -gt 0 ] && [ "$(x 'count(//failure)')" -gt 0 ] &&
        [ "$(x 'count(//skipped)')" -gt 0 ]
}
holds 'the totals of junit are right' counts plain
holds 'the totals of junit are right for strange names' counts strange
holds 'each case has its own time' test "$(xmllint --xpath \
    '//testsuite[1]/testcase/@time' "$work/plain/junit.xml" | tr -d ' \n')" = \
    'time="0.010"time="0.020"time="0.030"time="0.040"time="0.050"time="0.060"'
holds 'a crash is an error' sh -c "
    xmllint --xpath 'string(//testcase[starts-with(@name, \"Ada, test 3\")]\
[@classname = \"02a\"]/error/@message)' '$work/plain/junit.xml' | grep -qx crashed"
sed 's/, test 2:/, test 1:/' "$work/plain/junit.xml" >"$work/double.xml"
holds 'two cases of one name are refused' \
    refused 3 'Duplicate key' xmllint --noout --schema "$schemas/junit.xsd" \
    "$work/double.xml"
sed 's/failures="[0-9]*"//' "$work/plain/junit.xml" >"$work/less.xml"
holds 'a missing total is refused' \
    refused 3 failures xmllint --noout --schema "$schemas/junit.xsd" \
    "$work/less.xml"

# Names and long stories arrive as they are.
same_names() {
    for file in "$work/strange/gradescope"/*; do
        "$schema" --values student "$file"
    done | sort >"$work/got"
    sed 's/\\n/ /g' "$work/strange/names.txt" | sort | diff - "$work/got"
}
holds 'names survive in JSON' same_names
junit_names() {
    n=0
    while IFS= read -r name; do
        case $name in twin) name="twin ($((n + 1)))" ;; esac
        got=$(xmllint --huge --xpath \
            "string(/testsuites/testsuite[$((n * 9 + 1))]/@name)" \
            "$work/strange/junit.xml" | tr '\n' '?' | sed 's/?$//; s/?/\\n/g')
        [ "$got" = "$name: 01a A title" ] ||
            [ "$got" = "$name: 01a Titles & <such> ]]> \"x\"" ] || {
            echo "$got, not $name"
            return 1
        }
        n=$((n + 1))
    done <"$work/strange/names.txt"
    [ "$n" -eq 29 ]
}
holds 'names survive in XML' junit_names
whole() {
    xmllint --huge --xpath '//failure[contains(., "PUBEND")]/text()' \
        "$work/strange/junit.xml" | grep -q '\\x1b\[1m' &&
        [ "$(xmllint --huge --xpath \
            'count(//failure[string-length(.) > 1000000])' \
            "$work/strange/junit.xml")" -eq 1 ] &&
        values output "$work/strange/gradescope"/%2B1* |
        awk 'length > 1000000 && /PUBEND/ { ++n } END { exit n != 2 }'
}
holds 'a story of a megabyte survives whole' whole

# The spreadsheet, read again: one line "row column cell" for each cell.
cat >"$work/csv.awk" <<'AWK'
function give() {
    gsub(/\n/, "\\n", cell)
    printf "%d\t%d\t%s%s\n", row, column, quoted ? "" : "#", cell
    cell = ""; quoted = 0; ++column
}
{ text = text $0 "\n" }
END {
    row = column = 1
    for (i = 1; i <= length(text); ++i) {
        c = substr(text, i, 1)
        if (inside) {
            if (c != "\"") cell = cell c
            else if (substr(text, i + 1, 1) == "\"") { cell = cell c; ++i }
            else inside = 0
        } else if (c == "\"") {
            if (cell != "") { print "a quote within a cell"; exit 1 }
            inside = quoted = 1
        } else if (c == ",") give()
        else if (c == "\r" && substr(text, i + 1, 1) == "\n") {
            give(); ++row; column = 1; ++i
        } else if (quoted || c !~ /[0-9]/) { print "stray '" c "'"; exit 1 }
        else cell = cell c
    }
    if (inside || column > 1) { print "no end"; exit 1 }
}
AWK
sheet() { awk -f "$work/csv.awk" "$1"; }
read_again() { # COURSE COLUMNS
    sheet "$work/$1/grades.csv" >"$work/cells" || { cat "$work/cells"; return 1; }
    awk -F'\t' -v wide="$2" '
        { ++n[$1] }
        $1 > 1 && $2 > 1 && $2 < wide - 2 { sum[$1] += substr($3, 2) }
        $2 == wide - 2 { total[$1] = substr($3, 2) }
        END { for (r in n) if (n[r] != wide ||
            (r > 1 && (sum[r] != total[r] || total[r] == ""))) {
            print "row " r; exit 1 } }' "$work/cells"
}
holds 'the spreadsheet has whole rows and right totals' read_again plain 13
holds 'the spreadsheet survives strange names' read_again strange 13
csv_names() { # an apostrophe before what would be a formula, and else as it is
    sheet "$work/strange/grades.csv" | awk -F'\t' '$1 > 2 && $2 == 1' |
        cut -f 3- >"$work/got"
    sed "s/^[-=+@＝]/'&/; s/^\\\\n/'&/" "$work/strange/names.txt" |
        diff - "$work/got"
}
holds 'names survive in the spreadsheet, formulas as text' csv_names
holds 'no cell begins like a formula' sh -c "
    ! grep -q -e '^\"[-=+@]' -e ',\"[-=+@]' -e ',[-+]' '$work/strange/grades.csv' &&
    grep -q -e \"^\\\"'=HYPER\" '$work/strange/grades.csv'"

# The table: every row of a block is equally wide, and has its own line.
straight() { # COURSE
    while IFS= read -r line; do
        case $line in
        -:*) break ;;
        *) printf '%s\n' "$line" | wc -L ;;
        esac
    done <"$work/$1/table" | sed 1,2d >"$work/widths"
    awk -v students="$(wc -l <"$work/$1/names.txt")" '
        $1 == 0 { bad = bad || rows != students + 2; rows = 0; next }
        !rows++ { first = $1; ++blocks }
        $1 != first { print NR ": " $1 ", not " first; bad = 1 }
        END { exit bad || !blocks }' "$work/widths"
}
holds 'the columns of the table are straight' straight many
holds 'the columns are straight for strange names' straight strange
holds 'many exercises make several blocks' \
    test "$(grep -c '^possible ' "$work/many/table")" -gt 1
human() {
    for line in 'Ada *01b *passes what is public, but 5 of 11 hidden' \
        'Ada *02b *timed out' 'Ada *02d *refused, since' \
        'Ada *03a *advice: PUBLIC heap-buffer-overflow$' \
        'Björn *-  an archive .*: work.zip$' '-  *-  of no student: x.pdf$'; do
        grep -q "^  $line" "$work/plain/table" || { echo "$line"; return 1; }
    done
    ! grep -q 'Ada *02c' "$work/plain/table"
}
holds 'what needs a human eye stands below the table' human
holds 'the table sends no control characters' \
    sh -c "! LC_ALL=C grep -q '[[:cntrl:]]' '$work/strange/table'"
holds 'the table turns no line round' \
    sh -c "! grep -q '$(printf '\342\200\256')' '$work/strange/table' &&
    grep -q '^[\\]u202eturned round' '$work/strange/table'"

# What was not graded is not zero points.
lost() {
    mkdir -p "$work/lost/gradescope" && cp "$ada" "$work/lost/gradescope/Björn.json"
    for report in csv gradescope classroom50 junit table; do
        "$reports" lost "$report" "$work/lost" >"$work/lost/table" || return 1
    done
    [ "$(cd "$work/lost" && echo gradescope/* classroom50/*)" = \
        "$(for kind in gradescope classroom50; do
            printf '%s ' $kind/Ada.json $kind/Grace.json $kind/Zoe.json
        done | sed 's/ $//')" ] || { ls "$work/lost/"*; return 1; }
}
holds 'who was not graded whole has no result' lost
holds 'who was not graded has empty cells' sh -c "
    grep -q '^\"Björn\",15,,0,18,17,0,0,21,21,,189' '$work/lost/grades.csv' &&
    grep -q '^\"points possible\",21,21,' '$work/lost/grades.csv'"
holds 'who was not graded has question marks' sh -c "
    grep -q '^Björn  *?  15   ?   b ' '$work/lost/table' &&
    grep -q 'Björn *01b  NOT GRADED: the grader failed' '$work/lost/table'"
holds 'who was not graded has an error' sh -c "
    xmllint --noout --schema '$schemas/junit.xsd' '$work/lost/junit.xml' 2>&1 &&
    [ \"\$(xmllint --xpath 'string(//error[@message = \"not graded\"])' \
        '$work/lost/junit.xml')\" = 'NOT GRADED: the grader failed' ]"
holds 'the totals of junit count it' counts lost

# A disk that is full, a place that is none, a report that is none.
full() { # REPORT FILE
    mkdir "$work/full-$1" && echo old >"$work/full-$1/$2" &&
        refused 2 "cannot write .*$2" sh -c "trap '' XFSZ; ulimit -f 1
            exec $reports many $1 $work/full-$1" &&
        [ "$(cat "$work/full-$1/$2")" = old ] &&
        [ -z "$(find "$work/full-$1" -name '*.part')" ]
}
holds 'a full disk leaves the old spreadsheet' full csv grades.csv
holds 'a full disk leaves the old junit.xml' full junit junit.xml
mkdir "$work/full-gradescope" "$work/full-gradescope/gradescope"
holds 'a full disk leaves no half of a result' refused 2 'cannot write' sh -c "
    trap '' XFSZ; ulimit -f 1; exec $reports many gradescope $work/full-gradescope"
holds 'nothing is left of it' test -z "$(ls -A "$work/full-gradescope/gradescope")"
holds 'a full screen is an error' refused 2 'cannot write the table' \
    sh -c "exec 2>&1 >/dev/full; $reports many table ."
: >"$work/file"
holds 'a file in place of the folder is an error' \
    refused 2 "$work/file/grades.csv" "$reports" plain csv "$work/file"
holds 'an unknown report is refused' \
    refused 2 "no report 'pdf'; there are table" "$reports" plain pdf "$work"
echo 1..143
