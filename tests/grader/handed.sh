#!/bin/sh
# Nothing that was handed in vanishes: it is graded, or a line below the table
# says why not. Nobody's program runs here: all files are the stub, or could not be
# built; what counts is whose they are, and which.
topic='handed in'
. tests/grader/hostile/kit

kit
# put PATH...: an answer that does not build, which is soon seen.
put() {
    for file; do
        mkdir -p "$(dirname "$scratch/in/$file")"
        echo "#error $file" >"$scratch/in/$file"
    done
}
# told STUDENT TEXT: a line below the table says so of the student.
told() {
    sed '1,/^For a human eye:/d' "$scratch/said" | grep -q "^  $1  *[-0a1]*  $2" ||
        why "$(sed '1,/^For a human eye:/d' "$scratch/said")"
}
# has STUDENT FILE: this one of his was graded.
has() {
    [ -f "$(result "$1")" ] || why "no $1 in $(ls "$out/marks")" || return 1
    grep -q "^ \"file\": \"$2\",\$" "$(result "$1")" ||
        why "$(grep '"file"\|"note"' "$(result "$1")")"
}
students() { # NUMBER
    [ "$(ls "$out/marks" | wc -l)" -eq "$1" ] || why "$(ls "$out/marks")"
}
# graded: what has been put so far, as a batch; and begins anew.
graded() {
    rm -rf "$scratch/out"
    grade "$scratch/in" "$scratch/out"
    rm -rf "$scratch/in"
    verdict "$1: the batch ends well" ended 0
}

# ---- flat, as platforms have it ----

m=_assignsubmission_file_
put "Ada Lovelace_1201${m}01a-collide.c" "Bo_1202${m}01a-collide.c" \
    "Cy de la Cruz_1203${m}01a-collide.c"
: >"$scratch/in/Di_1204${m}work.zip"
graded 'Moodle, flat'
verdict 'Moodle, flat: everybody is somebody' students 4
verdict 'Moodle, flat: with a file' has Ada%20Lovelace_1201 \
    "Ada Lovelace_1201${m}01a-collide.c"
verdict 'Moodle, flat: an archive is told of' told Di_1204 'an archive'

put "Ada_1201$m/01a-collide.c" 'Bo_1202_assignsubmission_file/01a-collide.c' \
    'Bo_1202_assignsubmission_onlinetext/onlinetext.html'
graded 'Moodle, folders'
verdict 'Moodle, folders: two of one student are one' students 2
verdict 'Moodle, folders: the name is the student' has Ada_1201 01a-collide.c
verdict 'Moodle, folders: both' has Bo_1202 01a-collide.c

put lovelaceada_11_91_01a-collide.c lovelaceada_11_92_02b-heap.c \
    babbagech_LATE_12_93_01a-collide-1.c anon_xY3z_94_01a-collide.c
put lovelaceada_11_95_notes.pdf
graded 'Canvas'
verdict 'Canvas: the number of a file is no student' students 3
verdict 'Canvas: with a file' has lovelaceada_11 lovelaceada_11_91_01a-collide.c
verdict 'Canvas: a second try is a file' has babbagech_12 \
    babbagech_LATE_12_93_01a-collide-1.c
verdict 'Canvas: who is late is told of' told babbagech_12 'handed in late'
verdict 'Canvas: letters for a name' has anon_xY3z anon_xY3z_94_01a-collide.c
verdict 'Canvas: what there is no exercise for is told of' \
    told lovelaceada_11 'there is no such exercise: .*02b'

put dijkstra_31_96_01a-collide.c dijkstra_31_97_01a-collide-1.c \
    dijkstra_31_98_01a-collide-2.c
graded 'Canvas, again'
verdict 'Canvas: what was handed in again is later' \
    has dijkstra_31 dijkstra_31_98_01a-collide-2.c
verdict 'Canvas: and that is told of' \
    told dijkstra_31 'of 3 attempts the last was taken'

# platform NAME: puts the files that the platform has in its archives, as they
# are listed.
platform() {
    while IFS= read -r file; do
        put "$file"
    done <"tests/grader/platforms/$1"
    graded "$1"
}
platform blackboard
verdict 'Blackboard: two students' students 2
verdict 'Blackboard: the last attempt' has Week%202_ada_l \
    'Week 2_ada_l_attempt_2026-11-28-09-05-00_01a-collide.c'
verdict 'Blackboard: and that is told of' \
    told 'Week 2_ada_l' 'of 2 attempts the last was taken'
verdict 'Blackboard: one attempt' has Week%202_cbab \
    'Week 2_cbab_attempt_2026-11-27-08-00-00_01a-collide.c'
platform brightspace
verdict 'Brightspace: two students' students 2
verdict 'Brightspace: the last attempt, after noon' \
    has 1201-88%20-%20Ada%20Lovelace \
    '1201-88 - Ada Lovelace - Nov 28, 2026 105 PM - 01a-collide.c'
verdict 'Brightspace: and that is told of' \
    told '1201-88 - Ada Lovel~' 'of 2 attempts the last was taken'
verdict 'Brightspace: a folder of an attempt' \
    has 1202-88%20-%20Cy%20Babbage 01a-collide.c
verdict 'Brightspace: and the last of two' \
    told '1202-88 - Cy Babbage' 'of 2 attempts the last was taken: 1202-88 - Cy'

put Ann_123_01a-collide.c Ben_124_01a-collide.c cat_01a.c 01a-collide.c 01a-dan.c
graded 'another platform'
verdict 'another platform: three students' students 3
verdict 'another platform: by what is before' has Ann_123 Ann_123_01a-collide.c
verdict 'another platform: and that is told of' told Ann_123 'whose it is was gu'
verdict 'another platform: what has nothing before is told of' \
    told - 'of no student: 01a-collide.c'
verdict 'another platform: that, too' told - 'of no student: 01a-dan.c'

put 01a-ann.c 01a-ben.c 01a-cat.c
graded 'nobody'
verdict 'three files without a name are one student, and doubtful' \
    told in '3 files could be it: 01a-ann.c, 01a-ben.c'

# ---- folders of students ----

put upper/01A-COLLIDE.C prefixed/Name_123_01a-collide.c \
    two/01a-collide.c two/01a-again.c places/backup/01a-collide.c \
    places/exercises/01a-collide.c 'text/01a-collide.c.txt' cpp/01a-collide.cpp \
    other/collide.c backups/01a-collide.c backups/01a-collide.c~ \
    backups/01a-collide.o hidden/.old/01a-collide.c system/__MACOSX/01a-x.c \
    system/.git/01a-x.c system/._01a-x.c deep/1/2/3/4/01a-collide.c \
    kit/exercises/01a-collide.c kit/src/line.c kit/tests/exercises/01a-collide.c \
    kitless/src/01a-collide.c archive/work.zip archive/Makefile loose/01a-collide.c \
    late.zip README.txt 'x.part/02a-heap.c' many/a.c many/b.c many/c.c many/d.c \
    many/e.c many/f.c many/g.c many/h.c many/i.c many/j.c many/k.c many/l.c \
    many/m.c many/n.c many/o.c "$(printf 'odd/line\nbreak.zip')" \
    "$(printf 'bytes/\377.zip')"
mkdir "$scratch/in/empty"
ln -s "$scratch/in/two" "$scratch/in/linked"
ln -s "$scratch/in/two" "$scratch/in/loose/linked"
mkfifo "$scratch/in/pipe"
graded 'folders'
verdict 'in capitals: taken' has upper 01A-COLLIDE.C
verdict 'and told of' told upper 'taken in spite of its name: .*COLLIDE.C'
verdict 'with a name before it: taken' has prefixed Name_123_01a-collide.c
verdict 'and told of' told prefixed 'taken in spite of its name'
verdict 'of two the usual name is taken' has two 01a-collide.c
verdict 'and the other is told of' \
    told two 'of 2 files was taken 01a-collide.c, not 01a-again.c'
verdict 'of two places exercises is taken' \
    told places 'of 2 files was taken exercises/01a'
verdict 'a text is told of' told text 'not graded, since its name'
verdict 'C++ is told of' told cpp 'not graded, since its name'
verdict 'a file without a number is told of' told other 'not taken for any ex'
verdict 'a backup beside the file is not' has backups 01a-collide.c
quiet() { # STUDENT...: of these nothing is told
    for name; do
        ! told "$name" . || why "$(grep "^  $name " "$scratch/said")" || return 1
    done
}
verdict 'and there is no word of it' quiet backups kit loose/none
verdict 'what is hidden is told of' told hidden 'hidden, and not graded'
verdict 'what the system has made is nothing' told system 'no file of an exercise$'
verdict 'what is too deep is told of' told deep 'too deep, not looked into'
verdict 'a whole kit has one file' has kit 01a-collide.c
verdict 'a folder of the kit alone is a folder' has kitless 01a-collide.c
verdict 'an archive is told of' told archive 'an archive that is not unpacked'
verdict 'an empty folder is told of' told empty 'no file of an exercise$'
verdict 'a linked folder is told of' told linked 'a link, which is not'
verdict 'a link within is told of' told loose 'a link, which is not'
verdict 'an archive among folders is told of' told - 'an archive .*late.zip'
verdict 'any other file among them, too' told - 'of no student: README.txt'
verdict 'and what is no file' told - 'of no student: pipe'
verdict 'an exercise that is none is told of' told x.part 'there is no such ex'
verdict 'a dozen lines are enough' told many '... and more'
verdict 'a line break stays in its line' told odd 'an archive .*line[\]x0abreak.zip'
verdict 'a byte that is no text is told of' told bytes 'an archive .*xff'
# The same lines, whole, are kept in files.
noted() { # STUDENT TEXT
    grep -q -x -e "$1  $2" "$out/by-hand/notes.txt" ||
        why "$(grep -e "^$1 " "$out/by-hand/notes.txt")"
}
verdict 'a note is kept in by-hand, too' noted two \
    '01a  of 2 files was taken 01a-collide.c, not 01a-again.c'
verdict 'a note on nobody as well' noted - '-  of no student: README.txt'
verdict 'one line for each' [ "$(wc -l <"$out/by-hand/notes.txt")" -gt 30 ]
verdict 'and they are for the lecturer alone' \
    [ "$(stat -c %a "$out/by-hand/notes.txt")" = 600 ]
verdict 'and where they are is said' \
    grep -q "^What is for a human eye, line by line: .*/by-hand/notes.txt$" "$scratch/said"
cell() { # STUDENT TEXT: the last cell of the student's row
    grep -q "^\"$1\",.*,\"$2\".\$" "$out/grades.csv" ||
        why "$(grep "^\"$1\"" "$out/grades.csv")"
}
verdict 'the CSV has a column of notes' cell student note
verdict 'with those on each student' cell two \
    '01a: of 2 files was taken 01a-collide.c, not 01a-again.c'
verdict 'several in one cell' cell many '.*; .*; [.][.][.] and more'
verdict 'and none where there is none' cell backups ''

# ---- what is in names and messages is shown as what it is ----

put "$(printf 'turned/\342\200\256zip.zip')" "$(printf 'li\nne/01a-collide.c')" \
    "$(printf 'na\342\200\256me\033[2J/01a-collide.c')"
mkdir "$scratch/in/message" "$scratch/in/wide" "$scratch/in/unmarked"
printf '#error \342\200\256turned \033[2J cleared \303\244 \377 \000 zero\n' \
    >"$scratch/in/message/01a-collide.c"
printf 'int x;\n' | sed 's/./&@/g; s/$/@/' | tr '@\n' '\000\n' >"$scratch/utf16"
{ printf '\377\376'; cat "$scratch/utf16"; } >"$scratch/in/wide/01a-collide.c"
cp "$scratch/utf16" "$scratch/in/unmarked/01a-collide.c"
graded 'escapes'
verdict 'a name of a file that turns the writing is shown escaped' \
    told turned 'an archive .*[\]u202ezip.zip'
verdict 'a name of a student of two lines is one line of the table' \
    grep -q '^li[\]x0ane ' "$scratch/said"
verdict 'so is a name of a student in the table' \
    grep -q '^na[\]u202eme[\]x1b' "$scratch/said"
verdict 'and in the CSV' grep -q '^"na[\]u202eme[\]x1b' "$out/grades.csv"
clean_of() { # FILE...: neither a control nor what turns the writing is in it
    ! LC_ALL=C grep -l "$(printf '[\001-\010\013\014\016-\037\177]\|\342\200\256')" "$@"
}
verdict 'nothing that is written has them as they are' clean_of \
    "$scratch/said" "$out/grades.csv" "$out"/marks/*/01a.json
story() { # STUDENT TEXT
    sed -n 's/^ "story": //p' "$(result "$1")" | grep -q -e "$2" ||
        why "$(grep '"story"' "$(result "$1")" | head -c 300)"
}
verdict 'what the compiler quotes, too' story message 'u202eturned .*x1b\[2J cleared'
verdict 'UTF-16 is named' story wide 'is UTF-16: save it as UTF-8'
verdict 'without a mark, too' story unmarked 'is UTF-16: save it as UTF-8'
verdict 'and no wall of errors' eval '! story wide "error:"'

# ---- the folder of results ----

put anna/01a-collide.c
grade "$scratch/in" "$scratch/out"
private() {
    for file in grades.csv hidden.seed; do
        [ "$(stat -c %a "$scratch/out/$file")" = 600 ] ||
            why "$(ls -l "$scratch/out")" || return 1
    done
}
verdict 'marks and seed are for the lecturer alone' private
within() {
    for place in in in/results in/anna; do
        grade "$scratch/in" "$scratch/$place"
        ended 2 && grep -q 'is in the folder of submissions' "$scratch/said" ||
            why "$place: $(cat "$scratch/said")" || return 1
    done
}
verdict 'results are not put among the submissions' within
echo 1..87
