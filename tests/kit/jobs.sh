#!/bin/sh
# Lists of jobs for more machines than one: whatever the order, however often,
# and though some are killed, what is collected has the bytes of one machine.
# (Those of make grade are in tests/grader/jobs.sh; a cluster that loses a
# machine is make test-cluster.)
. tests/programs/common
make=${MAKE:-make}
unset MAKEFLAGS MFLAGS SEED REQUESTS KIND BONK OF QUALITY
root=$(pwd)

# A kit of its own: the rules, and programs that take no time.
kit=$work/kit
mkdir -p "$kit/build/bin" "$kit/build/tests/hunt" "$kit/tests/hunt" \
    "$kit/plots" "$kit/src" "$kit/chapters/press"
for file in src/jobs.mk plots/plots.mk plots/atlas.awk \
    chapters/press/recipes chapters/press/lines tests/hunt/run; do
    cp $file "$kit/$file"
done
$make -s build/bin/bonk build/bin/bonk-studies build/tests/hunt/generate \
    build/tests/hunt/truth build/tests/hunt/truth-fast >/dev/null
cp build/bin/bonk "$kit/build/bin"
cp build/tests/hunt/generate build/tests/hunt/truth build/tests/hunt/truth-fast \
    "$kit/build/tests/hunt"
# The rule of make hunt, too.
{
    cat <<'END'
all:
gsl = yes
need = @:
.PHONY: programs build/check/examine
programs build/check/examine build/bin/bonk build/bin/bonk-studies:
build/tests/hunt/generate build/tests/hunt/truth build/tests/hunt/truth-fast:
include src/jobs.mk plots/plots.mk
END
    sed -n '/^hunt_with = /,/^build.made/p' tests/tests.mk | sed '$d'
    sed -n '/^$(kept): /,/^$(if $(lost)/p' Makefile
} >"$kit/Makefile"
cd "$kit" || exit 1

# How the book runs such a list with make.
line=$(sed -n '/^  awk .*\\$/{ N; s/^ *//; s/ *\\\n *build.jobs.grade | make -kj 8 -f -$//p; }' \
    "$root/chapters/B-lecturers.nw")
engine() { # LIST
    sh -c "$line"' "$0"' "$1" | $make -s -kj 2 -f - >/dev/null 2>&1
}
holds 'the book has a line for make' test -n "$line"
backwards() { sed '1!G;h;$!d' "$1"; }
# killed NAME: the first job of the list, killed after a short while.
killed() {
    timeout -s KILL "${2:-0.2}" sh -c "$(sed 1q "build/jobs/$1")" \
        >/dev/null 2>&1
}
listed() { # OF NUMBER [VARIABLE=VALUE]: make jobs lists so many
    of=$1 number=$2
    shift 2
    $make -s jobs OF="$of" "$@" >"$work/list" 2>&1
    [ "$(wc -l <"build/jobs/$of")" -eq "$number" ] && grep -q \
        "^Jobs: $number in build/jobs/$of\$" "$work/list" ||
        { cat "$work/list" "build/jobs/$of"; false; }
}
# twice LIST: by two engines at a time, one from behind.
twice() {
    backwards "$1" >"$work/behind"
    engine "$1" &
    engine "$work/behind"
    wait
}

# ---- the hunt -------------------------------------------------------------

asked='REQUESTS=101 KIND=graze SEED=7'
tests/hunt/run -n 101 -s 7 graze >"$work/one" # one machine's report
mv build/hunt "$work/hunt-one"
# shellcheck disable=SC2086
holds 'of 101 requests are two jobs' listed hunt 2 $asked
killed hunt
holds 'one that is killed has no file' \
    test -z "$(find build/hunt -type f ! -name '*+*.??????')"
twice build/jobs/hunt
# shellcheck disable=SC2086
holds 'what is done is not listed' listed hunt 0 $asked
# shellcheck disable=SC2086
$make -s hunt $asked >"$work/two"
holds 'the report of the hunt is that of one machine' \
    cmp "$work/one" "$work/two"
holds 'and has all requests' \
    test "$(awk '{ n += $1 } END { print n }' "$work/two")" = 101
holds 'its files, too' diff -r "$work/hunt-one" build/hunt
echo >>build/tests/hunt/truth
# shellcheck disable=SC2086
holds 'what another program found is not taken' listed hunt 2 $asked
printf '#!/bin/sh\necho "bonk: cannot write it: No space left on device" >&2\nexit 1\n' \
    >build/bin/bonk
tests/hunt/run -n 1 -s 7 graze >"$work/full" 2>"$work/why"
holds 'a full disk is no refusal' grep -q '1 hundreds were not kept' "$work/full"
holds 'and named' grep -q 'No space left' "$work/why"
# shellcheck disable=SC2086
holds 'and listed again' listed hunt 1 REQUESTS=1 KIND=graze SEED=7

# ---- the data of figures --------------------------------------------------

cat >build/bin/walk <<'END'
#!/bin/sh
for arg; do file=$arg; done
echo 1 >"$file"
sleep "${NAP-0.4}"
echo 2 >>"$file"
END
chmod +x build/bin/walk
for name in a b; do
    cat >plots/01-$name.gp <<END
# data: build/data/01-$name.dat
# command: build/bin/walk -o build/data/01-$name.dat
# lecture: build/bin/walk --long -o build/data/01-$name.dat
# alt: A walk.
END
done
touch plots/style.gp
holds 'data of two figures are two jobs' listed figures 2
holds 'of their slides two more' listed figures 4 QUALITY=lecture
# However late it is killed, this one is not done.
NAP=20 killed figures
holds 'what is killed half way has not got the name' \
    test ! -e build/data/01-a.dat -a -e "$(echo build/data/01-a.dat.*/01-a.dat)"
twice build/jobs/figures
holds 'all are there' listed figures 0 QUALITY=lecture
holds 'whole' test "$(cat build/data/01-?.dat build/lecture/data/01-?.dat |
    tr '\n' ' ')" = '1 2 1 2 1 2 1 2 '
rm build/data/01-b.dat
holds 'and what is lost is listed alone' listed figures 1

# ---- the atlas ------------------------------------------------------------

# Three scenes that take no time, as the program writes them; and the form of
# what it writes.
cat >build/bin/bonk-studies <<'END'
#!/bin/sh
[ "$2" != scenes ] || { printf '# scenes\nring\nfall\ntop\n'; exit; }
scene= out=
while [ $# -gt 0 ]; do
    case $1 in
    --scene) scene=$2 ;;
    -o) out=$2 ;;
    esac
    shift
done
{
    echo '# bonk-studies'
    echo "# command: bonk-studies --study atlas${scene:+ --scene $scene}"
    echo '# picks'
    for s in ${scene:-ring fall top}; do echo "$s 1"; done
    case $scene in
    ring) printf '#= unsure 2e-15\n#= good 3\n#= dear 0\n' ;;
    fall) sleep 0.4; printf '#= unsure 1.1e-13\n#= good 2\n#= dear 1\n' ;;
    top) printf '#= unsure 0\n#= good 3\n#= dear 0\n' ;;
    *) printf '#= unsure 1.1e-13\n#= good 8\n#= dear 1\n' ;;
    esac
} >"$out.part" && mv "$out.part" "$out"
END
chmod +x build/bin/bonk-studies
build/bin/bonk-studies --study atlas -o "$work/one"
holds 'of three scenes are three jobs' listed atlas 3
sed -i 1d build/jobs/atlas # begins with the one that takes its time
killed atlas
holds 'all of them are listed still' listed atlas 3
sed 1q build/jobs/atlas >"$work/first"
engine "$work/first"
holds 'but not what is done' listed atlas 2
twice build/jobs/atlas
holds 'until none is' listed atlas 0
$make -s atlas >"$work/counts"
holds 'the maps are those of one machine' cmp "$work/one" build/data/12-atlas.dat
holds 'and counted' test "$(tr '\n' ' ' <"$work/counts")" = \
    'unsure 1.1e-13 good 8 dear 1 '
cd "$root" || exit 1
$make -s build/data/12-atlas.dat >/dev/null 2>&1
build/bin/bonk-studies --study atlas --scene ring -o "$work/ring"
rows() { # FILE: those of this scene, and where it is named
    grep -e '^ring' -e '^# command: ' "$1" | sed 's/ --scene ring$//'
}
holds 'a scene alone has the map that it has among the others' \
    test "$(rows "$work/ring")" = "$(rows build/data/12-atlas.dat)"
holds 'and its numbers are called so' test \
    "$(sed -n 's/^#= //; T; s/ .*//p' "$work/ring" | tr '\n' ' ')" = \
    'unsure good beyond dear refused '
holds 'a list of nothing is refused' \
    sh -c "! $make -s jobs OF=book 2>&1 | grep -qv \"OF: 'book' is not\""
echo 1..26
