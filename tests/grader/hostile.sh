#!/bin/sh
# Everything that somebody may hand in who would rather be clever than right,
# or who is just unlucky: a file each, from hostile/. The first line of a file
# says the state it should be given, `earns:` what it should earn; a file
# without a function gets a right one, which calls its trick in the first of
# the tests. All are graded in one batch, with two honest students among
# them. A trick that works prints BROKEN. LONG=1 also takes those that cost the
# compiler a minute.
topic='hostile'
. tests/grader/hostile/kit

kit
mounts >"$scratch/mounts"
sums >"$scratch/kit.before"

# ---- one file for each trick ----

for file in "$hostile"/*.c; do
    name=${file##*/}
    if [ "${LONG-}" = 1 ] || ! grep -q '^/\* long \*/$' "$file"; then
        prepare "$file" "$scratch/tricks/${name%.c}"
    fi
done
# More than a compiler can say in its time.
many() { # COUNT LINE: with the number in place of N
    awk -v count="$1" -v line="$2" 'BEGIN { print "#include \"exercise.h\""
        for (i = 0; i < count; ++i) { text = line; gsub(/N/, i, text); print text } }'
}
many 20000 'signed char nN = 1000;' >"$scratch/warnings.c"
{ echo '/* does not build */' && many 50000 'int nN = mN;'; } >"$scratch/errors.c"
{ echo '/* does not build */' && many 9000 'signed char nN = 1000;' &&
    echo 'int *wrong = 3;'; } >"$scratch/both.c"
for name in warnings errors both; do
    prepare "$scratch/$name.c" "$scratch/tricks/many-$name"
done
honest "$scratch/tricks"
grade "$scratch/tricks" "$scratch/out"
verdict 'the batch ends well' ended 0
grep -q 'sealed namespaces' "$scratch/said"
sealed=$?
fewer=0
for file in "$hostile"/*.c; do
    name=${file##*/}
    name=${name%.c}
    if [ ! -d "$scratch/tricks/$name" ] ||
        { [ "$name" = sealed ] && [ "$sealed" -ne 0 ]; }; then
        [ "$name" != sealed ] || fewer=1
        continue
    fi
    state=$(sed -n '1s/^\/\* \(.*\): .* \*\/$/\1/p' "$file")
    verdict "$name is $state" judged "$name" "$state" "$(earns "$file")"
done
story() { # NAME TEXT
    sed -n 's/^ "story": //p' "$(result "$1")" | grep -q "$2" ||
        why "$(sed -n 's/^ "story": //p' "$(result "$1")" | head -c 300)"
}
verdict '20000 warnings cost nobody a point' judged many-warnings passed "$full"
verdict '50000 errors do not build' judged many-errors 'does not build' 0
verdict 'and 20 of them are enough' story many-errors \
    "m0' undeclared.*and 19 more"
verdict 'an error among 9000 warnings does not build' \
    judged many-both 'does not build' 0
verdict 'and is what is told' \
    story many-both 'error: initialization of .int \*'
advice() { # NAME TEXT
    sed -n 's/^ "advice": //p' "$(result "$1")" | grep -q "$2" ||
        why "$(sed -n 's/^ "advice": //p' "$(result "$1")" | head -c 300)"
}
heard() { # NAME TEXT: of a test
    sed -n 's/^   "story": //p' "$(result "$1")" | grep -q "$2" ||
        why "$(sed -n 's/^   "story": //p' "$(result "$1")" | head -c 300)"
}
verdict 'who goes round for ever is told so' heard round 'never have ended'
verdict 'and who counts is not' heard loop 'stopped after 1 s'
verdict 'memory that was lost is told' advice leak 'lost it without free'
verdict 'with the line that asked for it' advice leak '01a-collide.c:8'
verdict 'and others hear of no such thing' advice honest '^"",$'
honest_judged 'among tricks'

# What a student prints is text in the end, and his secrets are no others'.
plain() {
    ! LC_ALL=C grep -q "$(printf '[\001-\010\013-\037\177\377]')" \
        "$(result prints)" || why 'control characters' || return 1
    grep -q 'xff..xfe..x00..x01..x02..x1b' "$(result prints)" ||
        why "$(grep '"prints"' "$(result prints)")"
}
verdict 'what it prints becomes text, and loses no byte' plain
verdict 'nothing is left behind' clean
unchanged() {
    sums | cmp -s - "$scratch/kit.before" || why 'the kit was changed'
}
verdict 'the kit is as it was' unchanged

# ---- what is handed in is no file, or has a name that is no name ----

encoded() { # NAME: as the folder of results is called
    printf '%s' "$1" | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i)
        if (($i >= 48 && $i <= 57) || ($i >= 65 && $i <= 90) || $i == 45 ||
            ($i >= 97 && $i <= 122) || $i == 95) printf "%c", $i
        else printf "%%%02X", $i }'
}
# hand_in FOLDER FILE [STUB]: a file that does not build, which is soon seen,
# or the stub, which is sooner seen.
hand_in() {
    mkdir -p "$scratch/names/$1" && if [ $# -eq 2 ]; then
        echo '#error this is no answer' >"$scratch/names/$1/$2"
    else
        cp tests/exercises/01a/stub.c "$scratch/names/$1/$2"
    fi
}
line='line
break'
bytes=$(printf 'bytes \377\376\201')
long=$(printf '%0127d' 0 | sed 's/0/ä/g')
blanks=$(printf '%0240d' 0 | sed 's/0/ /g')
set -- 'with blank' "quote ' s" 'double " quote' "$line" "$bytes" -rf \
    --help '$(touch hostile-was-here)' '`touch hostile-was-here`' '*' '%20' \
    'a%20b' 'a b' "a'; touch hostile-was-here; '" seed hidden.seed grades.csv \
    junit.xml gradescope tests exercises CON '\' '&amp;<b>' "$long" NAME name \
    Name "$blanks" "${blanks}x" "${blanks}y"
for name; do
    hand_in "$name" 01a-collide.c
done
for name in "${blanks}x" Name 'a b'; do
    hand_in "$name" 01a-collide.c stub
done
for name in '01a collide.c' "01a-'quote'.c" "01a-$line.c" "01a-$bytes.c" \
    '01a-$(touch hostile-was-here).c' '01a.c' "01a-%s%n%n%s.c"; do
    folder="file $(encoded "$name")"
    hand_in "$folder" "$name"
done

cd "$scratch/names" || exit 1
mkdir no-file empty-file fifo folder link two-usual two kit deep too-deep \
    large hard device other hidden-file
: >empty-file/01a-collide.c
mkfifo fifo/01a-collide.c
mkdir folder/01a-collide.c
ln -s /etc/passwd link/01a-collide.c
ln -s "$root/solutions" linked-folder
ln -s "$root/solutions/01a-collide.c" linked-file
right=$scratch/tricks/honest/01a-collide.c
partly=$scratch/tricks/partly/01a-collide.c
cp "$right" two-usual/01a-collide.c && cp "$partly" two-usual/01a-again.c
cp "$right" two/01a-mine.c && cp "$partly" two/01a-again.c
mkdir -p kit/exercises kit/solutions kit/tests/exercises/01a
cp "$partly" kit/exercises/01a-collide.c
cp "$right" kit/solutions/01a-collide.c
cp "$right" kit/tests/exercises/01a-collide.c
cp "$root"/tests/exercises/01a/stub.c kit/tests/exercises/01a
mkdir -p deep/1/2 too-deep/1/2/3/4/5 && cp "$right" deep/1/2/01a-collide.c &&
    cp "$right" too-deep/1/2/3/4/5/01a-collide.c
{
    cat "$right"
    head -c 2000000 /dev/zero | tr '\0' ' '
} >large/01a-collide.c
cp "$right" "$scratch/hard.c"
ln "$scratch/hard.c" hard/01a-collide.c
mknod device/01a-collide.c c 1 5 2>/dev/null || rmdir device
cp "$right" other/01ab-collide.c && cp "$right" other/x01a-collide.c
cp "$right" hidden-file/.01a-collide.c
cd "$root" || exit 1

grade "$scratch/names" "$scratch/out"
verdict 'a batch of strange names ends well' ended 0
for name; do
    case $name in
    "$blanks"* | "$long") continue ;;
    Name | 'a b') verdict "the student $(encoded "$name") is not another" \
        judged "$(encoded "$name")" 'not begun' 0 ;;
    *) verdict "the student $(encoded "$name") is found" \
        judged "$(encoded "$name")" 'does not build' 0 ;;
    esac
done
# Names so long that the folder's cannot hold them are kept apart all the same.
apart() {
    right=$(grep -l '"student": ".\{240\}y\?",' "$scratch"/out/marks/*/01a.json |
        xargs grep -l '^ "state": "does not build"' | wc -l)
    wrong=$(grep -l '"student": ".\{240\}x",' "$scratch"/out/marks/*/01a.json |
        xargs grep -l '^ "state": "not begun"' | wc -l)
    [ "$right" -eq 2 ] && [ "$wrong" -eq 1 ] || why "$right right, $wrong wrong"
}
verdict 'long names that begin alike are kept apart' apart
for folder in "$scratch"/names/file*; do
    verdict "the ${folder##*/} is taken" \
        judged "$(encoded "${folder##*/}")" 'does not build' 0
done
says() { # FOLDER TEXT
    grep -q "^ \"\(file\|note\)\": \".*$2" "$(result "$1")" ||
        why "$(grep '"file"\|"note"' "$(result "$1")")"
}
nothing() { # FOLDER TEXT
    judged "$1" 'not begun' 0 && says "$1" "$2"
}
verdict 'a folder without files is not begun' nothing no-file 'no file'
verdict 'a named pipe is refused' nothing fifo 'no regular file'
verdict 'a folder called like a file is refused' nothing folder 'no regular'
verdict 'a symbolic link is refused' nothing link 'no regular file'
[ -d "$scratch/names/device" ] &&
    verdict 'a device is refused' nothing device 'no regular file'
verdict 'a file of 2 MB is refused' nothing large 'larger than 1 MiB'
verdict 'two files of which none has the name are none' nothing two '2 files could be it'
verdict 'of two files that with the name is taken' judged two-usual passed "$full"
verdict 'a file of another exercise is none' nothing other 'no file'
verdict 'a file that nobody sees is none' nothing hidden-file 'no file'
verdict 'an empty file does not build' judged empty-file 'does not build' 0
verdict 'of a whole kit only exercises/ counts' \
    judged kit failed $((full - first))
verdict 'a hard link is a file' judged hard passed "$full"
verdict 'folders in folders are searched' judged deep passed "$full"
verdict 'but not for ever' nothing too-deep 'no file'
verdict 'a link to a folder is somebody, and not followed' \
    nothing linked-folder 'no file'
links() {
    [ ! -e "$out/marks/linked-file" ] || why 'a link was followed'
}
verdict 'a link to a file is nobody' links
verdict 'nothing is left of strange names' clean

# ---- other users, other boxes ----

some() { # FOLDER TRICK...: these and the honest ones
    into=$scratch/$1
    shift
    for trick; do
        prepare "$hostile/$trick.c" "$into/$trick"
    done
    honest "$into"
}
# batch WHERE FOLDER OUTPUT TRICK...: grades them and looks at each.
batch() {
    where=$1 from=$2 to=$3
    shift 3
    some "$from" "$@"
    # shellcheck disable=SC2086
    grade "$scratch/$from" "$scratch/$to" $more
    verdict "$where: the batch ends well" ended 0
    for trick; do
        file=$hostile/$trick.c
        state=$(sed -n '1s/^\/\* \(.*\): .* \*\/$/\1/p' "$file")
        verdict "$where: $trick is $state" \
            judged "$trick" "$state" "$(earns "$file")"
    done
    honest_judged "$where"
    verdict "$where: nothing is left behind" clean
}
told() {
    grep -q -e "$1" "$scratch/said" || why "$(tail -3 "$scratch/said")"
}
more=

# Nobody's program has a user of its own then.
if [ "$(id -u)" -eq 0 ]; then
    mkdir "$scratch/plain" && chown -R 64999:64999 "$scratch/plain" \
        "$scratch/kit" && user='setpriv --reuid 64999 --regid 64999
        --clear-groups'
    batch 'an ordinary user' ordinary plain/out output-locked pipe-full \
        settle-half settle-silent kill-all proc network rights read-files \
        disk fork-left memory-children close-all
    # Among the files of an ordinary user some are not for him.
    mkdir "$scratch/secret" && hand_in ../secret/none 01a-collide.c &&
        hand_in ../secret/locked 01a-collide.c &&
        chmod 0 "$scratch/secret/none" "$scratch/secret/locked/01a-collide.c"
    grade "$scratch/secret" "$scratch/plain/out"
    verdict 'an ordinary user: what cannot be read stops nobody' ended 0
    verdict 'an ordinary user: a locked file is not begun, for a reason' \
        nothing locked 'cannot be read'
    verdict 'an ordinary user: a locked folder is told of' \
        grep -q '^  none  *-  a folder that cannot be read' "$scratch/said"
    chown -R 0:0 "$scratch/kit"
    user=
else
    fewer=$((fewer + 20))
fi

# A bubblewrap that refuses what other machines refuse.
refuse() { # NAME WORD
    mkdir -p "$scratch/$1" && cat >"$scratch/$1/bwrap" <<END
#!/bin/sh
case " \$* " in *" $2 "*) exit 1 ;; esac
exec $(command -v bwrap) "\$@"
END
    chmod 755 "$scratch/$1/bwrap"
}

refuse nested --disable-userns
refuse rooted --unshare-user
user="env PATH=$scratch/nested:$PATH"
batch 'where boxes can be nested' other nested/out kill-all rights proc
verdict 'the lecturer is told which sandbox' told 'in: namespaces'
if [ "$(id -u)" -eq 0 ]; then
    user="env PATH=$scratch/rooted:$PATH"
    batch 'where users have no namespaces' other rooted/out kill-all rights \
        network read-files proc fork-left memory-children
    verdict 'the lecturer is told that root has made them' told "in: root's"
else
    fewer=$((fewer + 12))
fi

# Without bubblewrap nothing is run, unless it is asked for.
mkdir "$scratch/bare"
for tool in env sh setpriv rm prlimit; do
    ln -s "$(command -v $tool)" "$scratch/bare/$tool"
done
user="env PATH=$scratch/bare"
grade "$scratch/other" "$scratch/bare/out"
verdict 'without a sandbox nothing is run' ended 2
verdict 'and the lecturer is told why' told 'CANNOT BE ISOLATED'
verdict 'and what to do' told '--unsafe'
empty() {
    set -- "$scratch"/bare/out/marks/*/*.json
    [ ! -e "$1" ] || why "there is $1"
}
verdict 'and there is no result' empty
verdict 'and nothing is left' clean
rm -r "$scratch/other"
more=--unsafe
if [ "$(id -u)" -eq 0 ]; then
    batch 'without a sandbox' other bare/out fork-left exit close-all
else
    batch 'without a sandbox' other bare/out exit close-all
    fewer=$((fewer + 1))
fi
verdict 'the lecturer is told that there is none' told 'NONE'
echo "1..$((204 - fewer))"
