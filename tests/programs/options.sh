#!/bin/sh
# An option that means nothing where it stands is refused. Where it means
# something is what the headings of --help say: from them come the cases,
# each option beside each value of what the headings depend on, and what is
# expected of each. What is accepted gets as far as its output, which is in
# no folder.
. tests/programs/common
bin=build/bin
$bin/bonkers --preset thermal --every 1 --samples 9 -o "$work/table"
$bin/disks --every 1 --samples 1 -o "$work/states"
{ $bin/scene ring --particles 40 && echo contact; } >"$work/scene"
$bin/scene sun-earth -o "$work/pair"

# What an option is given: PROGRAM (- is any) OPTION VALUE; and beside which
# value of another it fits, if not all.
cat >"$work/values" <<END
- at 50
- bins 7
- body 5
- bound 3
- boundary periodic
- box 2,2
- checkpoint 9
- collisions 2000
- digits 3
- dimensions 2
- disks 3
- dt 0.001
- energies 3,4
- contact stepwise
- engine auto
- ensemble 3
- every 1
- factor 2
- fit 0.2,0.1
- form cm
- gas-masses 5,5
- gravity 9.81
- heavy 2,0.1
- inverse-masses 1,2
- kernel portable
- length 11
- mass 30
- mass-ratio 3
- mixed 2
- moon 0.001
- normal 1
- observe energy
- offset 3
- orbits 3
- order deepest
- output $work/none/t
- packing 0.2
- particles 7
- radii 0.1
- radius 0.1
- range 0,1
- restitution 0.9
- rule all
- runs 3
- samples 1000
- save $work/saved
- scene ring
- seed 3
- shift back
- small 0.1,3
- speed 2
- species $work/species
- start 5
- starts 3
- step 0.3
- summary /dev/null
- sums plain
- table $work/table
- temperature 2
- tests 3
- theta 0.3
- threads 2
- tolerance 0.1
- track 1
- until 3
- velocity 2
- walls 0,40
- warmup 3
- window 8
bonk chart $work/none/c
bonk every 10
bonk model kepler
bonk reason 3
bonkers masses 1,2,3,4 four
bonkers positions 1,2,3,4 four
bonkers radii 0.1,0.1,0.1,0.1 four
bonkers velocities 1,2,3,4 four
collide velocities 1,0
disks start random
histogram against 1
histogram column 2
histogram fit gaussian
histogram law normal
histogram skip 1
piston method rk4
sample-studies radii 0.1,0.2
step every 4
step until 400
END
echo '3 1 0.1' >"$work/species"

# What cannot be without another option: PROGRAM OPTION VALUE OTHER.
cat >"$work/needs" <<END
piston study measure table
piston study gases table
sample method chains boundary
disks measure positions every
disks measure speeds every
disks measure relaxation every
disks measure brownian every
disks measure brownian heavy
collide velocities 1,0 inverse-masses
collide inverse-masses 1,2 velocities
bonkers masses 1,2,3,4 positions
bonkers radii 0.1,0.1,0.1,0.1 positions
bonkers velocities 1,2,3,4 positions
END

# Cases: ok or no, and a command line without its program.
cat >"$work/cases.awk" <<'END'
function value_of(option) {
    return (program, option) in sample ? sample[program, option] : \
        sample["-", option]
}

# Adds an option, and what it cannot be without, to what is given.
function give(option, value,    key, part) {
    if (option in given)
        return
    given[option] = value
    for (key in needs) {
        split(key, part, SUBSEP)
        if (part[1] == program && part[2] == option && part[3] == value)
            give(part[4], value_of(part[4]))
    }
}

function has(list, value,    item, n, i) {
    n = split(list, item, ", ")
    for (i = 1; i <= n; ++i)
        if (item[i] == value)
            return 1
    return 0
}

# Splits a condition into no, name and list.
function take(condition,    part) {
    no = sub(/^no /, "", condition)
    name = list = condition
    sub(/^--/, "", name)
    sub(/ .*/, "", name)
    if (!sub(/^[^ ]* /, "", list))
        list = ""
}

# What can be given for the name that was taken.
function first(    item) {
    if (list == "")
        return value_of(name)
    split(list, item, ", ")
    return item[1]
}

# Gives what the heading of an option asks for.
function satisfy(option,    part, n, i) {
    n = split(heading[option], part, "; ")
    for (i = 1; i <= n; ++i) {
        take(part[i])
        if (!no && !(name in given)) {
            give(name, first())
            satisfy(name)
        }
    }
}

# Do the headings of all that is given hold?
function fits(    option, part, n, i, value) {
    for (option in given) {
        n = split(heading[option], part, "; ")
        for (i = 1; i <= n; ++i) {
            take(part[i])
            value = name in given ? given[name] : usual[name]
            if (no != (list != "" ? !has(list, value) : !(name in given)))
                return 0
        }
    }
    return 1
}

function write_case(    option, line) {
    if (!bare)
        give("output", sample["-", "output"])
    if ("study" in choices && usual["study"] == "")
        give("study", choice["study", 0])
    line = fits() ? "ok" : "no"
    for (option in given)
        line = line " --" option \
            (given[option] == "-" ? "" : " " given[option])
    if (!seen[line]++)
        print line
}

FILENAME ~ /values$/ { sample[$1, $2] = $3; beside[$1, $2] = $4; next }
FILENAME ~ /needs$/ { needs[$1, $2, $3, $4] = 1; next }
FILENAME ~ /choices$/ { # OPTION VALUE...
    for (i = 2; i <= NF; ++i)
        choice[$1, choices[$1]++] = $i
    next
}
/^with .*:$/ { now = substr($0, 6, length($0) - 6) }
/^always:$/ { now = "" }
/^  (-.,|   ) --/ {
    last = $0
    sub(/^[^-]*(-., )?--/, "", last)
    takes = last ~ /^[a-z-]+ [^ ]/
    sub(/ .*/, "", last)
    if (last !~ /^(help|version|output)$/)
        heading[last] = now
    if (!takes)
        sample[program, last] = "-"
}
/\)$/ { # what holds unless another is given
    usual[last] = $0
    sub(/.*\(/, "", usual[last])
    sub(/\)$/, "", usual[last])
}
/^The summary says:/ { exit }
END {
    for (option in heading) {
        if (value_of(option) == "" && !(option in choices)) {
            print "no value is known for --" option
            continue
        }
        # With each value of each option that headings depend on.
        for (other in choices)
            for (i = 0; i < choices[other]; ++i) {
                if (other == option && i > 0)
                    break
                if (beside[program, option] != "" && \
                    beside[program, option] != choice[other, i])
                    continue
                split("", given)
                if (other != option)
                    give(other, choice[other, i])
                give(option, option in choices ? choice[option, 0] : \
                    value_of(option))
                satisfy(option)
                write_case()
            }
        # Against each condition of its heading.
        n = split(heading[option], part, "; ")
        for (i = 1; i <= n; ++i) {
            split("", given)
            give(option, value_of(option))
            take(part[i])
            if (no)
                give(name, first())
            bare = name == "output"
            write_case()
            bare = 0
        }
        split("", given)
        give(option, option in choices ? choice[option, 0] : value_of(option))
        satisfy(option)
        write_case()
    }
}
END

# names_what_was_given COMMAND-LINE: an option "with" which another means
# nothing, as $work/err has it, stands on the line or is called the default.
names_what_was_given() {
    with=$(sed -n '/, the default$/d
        s/.*: means nothing with \(--[a-z-]*\).*/\1/p' "$work/err")
    case " $1 " in *" $with "*) ;; *) [ -z "$with" ] ;; esac
}

# tries PROGRAM [ARGUMENT...]: all its cases, with what it always needs.
total=0
tries() {
    program=$1
    shift
    $bin/"$program" --help >"$work/help"
    : >"$work/choices"
    # The options with values in a heading, and which these can be.
    for option in $(sed -n 's/^with \(.*\):$/\1/p' "$work/help" |
        tr ';' '\n' | sed -n 's/^ *--\([a-z-]*\) .*/\1/p' | sort -u); do
        if [ "$program $option" = 'disks start' ]; then
            echo "start lattice random $work/states"
        elif [ "$program $option" = 'step method' ]; then
            # Those by which any scene can be stepped.
            build/bin/step-studies --study methods |
                sed '/^#/d; /ellipses$/d; s/ .*//' | tr '\n' ' ' |
                sed 's/.*/method &rk8pd\n/'
        else
            $bin/"$program" "--$option" '' 2>&1 |
                sed -n "s/.*: '' is not /$option /p" | sed 's/,//g; s/ or / /'
        fi >>"$work/choices"
    done
    # Ellipses with kicks go round a star and touch nothing: not in this scene;
    # and a device that sums need not be there: opencl.sh has it.
    sed "s/ wisdom-holman\\>//; s/ sbab4\\>//; s/ opencl\\(-float\\)*//g" \
        "$work/choices" >"$work/other"
    mv "$work/other" "$work/choices"
    awk -v program="$program" -f "$work/cases.awk" "$work/values" \
        "$work/needs" "$work/choices" "$work/help" >"$work/cases"
    # A tree is refused where forces must be smooth: step.sh has these.
    sed -i '/--kernel tree/{
        /--method \(dopri5\|radau15\|rk8pd\|gauss4\|implicit-midpoint\)/d
    }' "$work/cases"
    wrong=0
    while read -r expected line; do
        # shellcheck disable=SC2086
        $bin/"$program" "$@" $line >"$work/out" 2>"$work/err" </dev/null
        got=$?
        if [ "$expected" = ok ]; then
            [ $got -eq 1 ] && grep -q "$work/none/t" "$work/err"
        else
            [ $got -eq 2 ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
                grep -q "^$program: --[a-z-]*: means nothing with" "$work/err" &&
                names_what_was_given "$line"
        fi || {
            not_ok "$program $* $line" \
                "expected $expected, status $got: $(cat "$work/err")"
            wrong=1
        }
    done <"$work/cases"
    cases=$(wc -l <"$work/cases")
    total=$((total + cases))
    [ $wrong -eq 1 ] || ok "$program: $cases cases do as its help says"
}

for program in bonk-studies bonkers bonkers-studies collide \
    collide-forms disks disks-speed disks-studies gravity-studies piston \
    sample sample-studies spheres-studies springs-studies step-studies; do
    tries $program
done
tries histogram "$work/table"
tries step "$work/scene"
tries bonk "$work/pair" --until 100 --tolerance 0.1
[ $total -gt 900 ] || not_ok 'there are cases' "$total"

# A heading stands once.
holds 'no help has a heading twice' sh -c 'for p in build/bin/*; do
    case $p in *0 | */check-collide) continue ;; esac # no options
    "$p" --help | grep -E "^(with|always)" | sort | uniq -d; done |
    { ! grep .; }'

# What no help knows, because it depends on the scene or on lists.
$bin/scene cradle -o "$work/cradle"
for option in '--rule all' '--shift back' '--order deepest' '--threads 2' \
    '--kernel portable' '--contact located'; do
    # shellcheck disable=SC2086
    refuses 2 'means nothing' $bin/step "$work/pair" $option
done
refuses 2 'kernel: means nothing without gravity' \
    $bin/step "$work/cradle" --kernel portable
refuses 2 'threads: means nothing without springs' \
    $bin/step "$work/cradle" --threads 2
refuses 2 'particles: means nothing with lists' \
    $bin/bonkers --positions 1,2 --particles 2

refuses 2 'moon-distance: means nothing without --moon' \
    $bin/scene ring --moon-distance 3
refuses 2 'seed: means nothing without --jitter' $bin/scene break --seed 2
refuses 2 'every: means nothing with an average' $bin/bonk "$work/cradle" \
    --until 100 --tolerance 0.1 --observe mean:x:0 --every 1

# Some that were taken once, and did nothing.
refuses 2 'mass: means nothing with --study measure' \
    $bin/piston --study measure --table "$work/table" --mass 3
refuses 2 'bins: means nothing with --table blocks' \
    $bin/histogram --table blocks --bins 3 "$work/table"
refuses 2 'step: means nothing without --method markov' $bin/sample --step 0.1
refuses 2 'tolerance: means nothing without --method dopri5' \
    $bin/step "$work/pair" --tolerance 0.1
refuses 2 'threads: means nothing without --ensemble' $bin/bonkers --threads 2
seeded='--preset thermal, piston, adiabatic, random'
refuses 2 "seed: means nothing without $seeded\$" $bin/bonkers --seed 2
refuses 2 "seed: means nothing without $seeded\$" \
    $bin/bonkers --masses 1,2 --positions 1,2 --seed 2
refuses 2 'seed: means nothing with --preset four (only with thermal' \
    $bin/bonkers --preset four --masses 1,2,3,4 --seed 2
echo 1..39
