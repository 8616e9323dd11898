#!/bin/sh
# What a summary says is what --help lists, with a unit: all of it, and no
# more. That no run writes another key, and that each writes all keys above
# the first "if", the programs assert in every run of tests and book; so here
# are runs that together write what is listed below an "if".
. tests/programs/common
bin=${BIN-build/bin}

# listed COMMAND...: its keys and their units.
listed() {
    "$@" --help | sed -n '1,/^The summary says:$/d
        s/^  \([^ ]*\) \[\(.*\)\]\( .*\)*$/\1 \2/p'
}

# runs NAME COMMAND...: adds the keys of a run to $work/NAME.
runs() {
    name=$1
    shift
    "$@" -o "$work/table" --summary "$work/s" >"$work/out" 2>&1 ||
        not_ok "$*" "status $?: $(tail -n 1 "$work/out")"
    cat "$work/s" >>"$work/$name"
}

# same NAME COMMAND...: the keys of $work/NAME are those that it lists.
same() {
    name=$1
    shift
    listed "$@" >"$work/listed"
    holds "$* lists what its runs write" awk '
        FNR == NR {
            pattern = $1
            gsub(/[.+*]/, "[&]", pattern)
            gsub(/<[^>]*>/, ".+", pattern)
            of[$1] = "^" pattern "$"
            if ($2 == "") bad = bad " " $1 " has no unit,"
            next
        }
        { for (k in of) if ($1 ~ of[k]) { seen[k] = found[$1] = 1 }
          if (!($1 in found)) bad = bad " " $1 " is not listed," }
        END { for (k in of) if (!(k in seen)) bad = bad " nobody writes " k ","
              print bad; exit bad != "" || FNR == NR }' \
        "$work/listed" "$work/$name"
}

runs collide $bin/collide
runs collide $bin/collide --velocities 1,0 --inverse-masses 1,1
same collide $bin/collide
runs bonkers $bin/bonkers --until 2 --every 1
runs bonkers $bin/bonkers --preset random -N 4 --restitution 0.9 --until 1
runs bonkers $bin/bonkers --ensemble 2 --preset random -N 4 --until 1 --every 1
same bonkers $bin/bonkers
$bin/bonkers --preset thermal --every 1 --samples 2000 -o "$work/rows"
for more in '--law normal --fit gaussian --bins 16' \
    '--law normal:0,1 --table columns' \
    '--against x1 --table correlation' '--table blocks'; do
    # shellcheck disable=SC2086
    runs histogram $bin/histogram --skip 1 --column v4 $more "$work/rows"
done
same histogram $bin/histogram
$bin/bonkers --preset piston --every 0.5 --until 150 -o "$work/rows"
runs measure $bin/piston --study measure --table "$work/rows" --at 50
same measure $bin/piston --study measure
runs run $bin/piston --until 1
same run $bin/piston
runs sample $bin/sample --samples 100
runs sample $bin/sample --samples 100 --method markov
runs sample $bin/sample --samples 100 --method chains --boundary periodic
same sample $bin/sample
gas='--disks 40 --packing 0.2 --warmup 1 --every 0.1 --samples 40'
# shellcheck disable=SC2086
{
    runs disks $bin/disks --restitution 0.9 --collisions 20
    runs disks $bin/disks $gas --measure speeds
    runs disks $bin/disks $gas --measure brownian --heavy 5,1 --start random \
        --boundary periodic
}
same disks $bin/disks
runs speed $bin/disks-speed --particles 100 --collisions 100
same speed $bin/disks-speed
$bin/scene sun-earth -o "$work/sun-earth"
runs step $bin/step "$work/sun-earth" --until 100
runs step $bin/step "$work/sun-earth" --until 100 --method dopri5
same step $bin/step
runs bonk $bin/bonk "$work/sun-earth" --until 100 --tolerance 1e-3
same bonk $bin/bonk
runs reverse $bin/bonkers-studies --study reverse --collisions 1000
same reverse $bin/bonkers-studies --study reverse
runs membranes $bin/springs-studies --study membranes --until 1
same membranes $bin/springs-studies --study membranes
grep -v '^#' plots/data/02-ratios.dat >"$work/speed" # by make bench
same speed $bin/bonkers-studies --study speed

# Every program that writes a summary lists it. Of studies each is run by the
# book, the bench or a test, and so keeps its list.
{
    awk '/^%run/ || more { more = sub(/ \\$/, ""); sub(/^%   /, " ")
        printf more ? "%s" : "%s\n", $0 }' \
        $(find chapters -name '*.nw')
    grep -h '^# [a-z]*:' plots/*.gp
    grep -h 'study ' src/studies/bench.mk plots/plots.mk tests/*/*.sh
    echo study run # piston, when nothing is said
} >"$work/all"
for program in $bin/*; do
    name=${program#"$bin/"}
    case $name in *0 | check-collide) continue ;; esac # no options
    case $($program --help) in
    *'--study NAME --help lists them'*)
        idle=
        for study in $($program --study '' 2>&1 |
            sed 's/.* is not//; s/,//g; s/ or / /'); do
            grep -Eq "study (.*[ ,])?$study([ ;,]|$)" "$work/all" || idle="$idle $study"
        done
        holds "$name: each study is run" test -z "$idle" ;;
    *--summary*)
        holds "$name lists its summary" test -n "$(listed "$program")" ;;
    esac
done
echo 1..32
