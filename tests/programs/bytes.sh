#!/bin/sh
# The same seed gives the same bytes: the build that is there, and gcc at -O3
# and clang at -O1 with the instructions of this machine; one thread and many.
# Where the loops are compiled once, their modules pass their tests as well.
. tests/programs/common
# More threads than idle cores: one that waits leaves its core to the others.
OMP_WAIT_POLICY=passive
export OMP_WAIT_POLICY
rooms=$(echo src/toolbox src/line src/box src/scenes src/forces src/choosing)
all="$(for room in $rooms; do
    grep -LE '^.include ("line/laws.h"|<gsl/)' "$room"/*.c
done) src/forces/reference.c"
programs='bonk collide collide-forms bonkers bonkers-studies disks
    gravity-studies sample sample-studies scene step step-studies
    spheres-studies springs-studies'
# What is stepped, and chosen for: gravity, springs with dashpots, and
# contacts.
for scene in figure-eight 'ring --particles 150' 'membrane --damping 0.1' \
    double-pendulum gas break solar-system; do
    # shellcheck disable=SC2086
    build/bin/scene $scene -o "$work/${scene%% *}.plist"
done

methods=$(methods)

# run_all FOLDER: what the programs of the folder print, timings left out.
run_all() {
    case $1 in /*) bin=$1 ;; *) bin=$PWD/$1 ;; esac
    "$1/collide" --tests 10 --dimensions 3 --seed 3 --mass-ratio 100 -o - \
        --restitution 0.7
    "$1/collide" --tests 20000 --mass-ratio 1e6 --form complement
    "$1/collide-forms" --study rounding --mass-ratio 2,1e6 --tests 20000
    "$1/collide-forms" --study drift --collisions 200000
    "$1/collide-forms" --study galperin --digits 4
    "$1/collide-forms" --study map --tests 50
    for preset in four mixed cradle thermal piston two random; do
        "$1/bonkers" --preset $preset --every 5
    done
    for engine in naive scan heap slab; do
        "$1/bonkers" --preset thermal -N 60 --every 5 --until 20 \
            --engine $engine
        "$1/bonkers" --preset random -N 40 --restitution 0.98 --until 5 \
            --every 1 --engine $engine
        "$1/bonkers" --preset galperin --mass-ratio 1e6 --collisions 3000 \
            --engine $engine
    done
    "$1/bonkers" --preset adiabatic --every 2 --until 6
    "$1/bonkers" --preset random -N 30000 --collisions 60000
    "$1/bonkers" --preset piston --ensemble 20 --every 10 --until 50
    "$1/bonkers-studies" --study drift --collisions 20000
    "$1/bonkers-studies" --study reverse --collisions 5000
    "$1/bonkers-studies" --study collapse
    "$1/bonkers-studies" --study islands
    for engine in pairs cells; do
        "$1/disks" --disks 60 --packing 0.5 --every 2 --until 6 \
            --engine $engine
        "$1/disks" --disks 400 --dimensions 3 --packing 0.3 --until 1 \
            --boundary periodic --temperature 1 --engine $engine
    done
    "$1/disks" --measure positions --every 0.5 --samples 300
    "$1/disks" --disks 300 --packing 0.3 --boundary periodic --every 0.5 \
        --samples 30 --measure speeds
    "$1/disks" --disks 300 --packing 0.2 --measure relaxation --every 0.2 \
        --until 3
    "$1/disks" --disks 100 --packing 0.2 --measure pressure --every 1 --until 9
    "$1/disks" --disks 100 --packing 0.1 --heavy 20,2 --start random \
        --boundary periodic --measure brownian --every 0.2 --until 30
    for method in direct markov; do
        "$1/sample" --method $method --samples 3000 --bins 10
        "$1/sample" --method $method --samples 30 --measure states \
            --boundary periodic
        "$1/sample" --method $method --disks 3 --box 1.5,1,1 --samples 500 \
            --small 0.1,4 --measure distances --bins 20
    done
    "$1/sample" --method markov --radius 0.24 --samples 1000 --bins 20
    "$1/sample" --method chains --boundary periodic --samples 3000 --bins 10
    "$1/sample-studies" --study mistakes --samples 2000
    "$1/sample-studies" --study memory --radii 0.1,0.2 --step 0.1,0.3 \
        --samples 2000
    "$1/sample-studies" --study acceptance --samples 500
    for study in spin errors rod sag shapes; do
        "$1/springs-studies" --study $study
    done
    for study in rows late rest break; do
        "$1/spheres-studies" --study $study
    done
    for study in sun-earth circumbinary choreography figure-eight ring-speeds \
        'ring --kernel portable --orbits 0.05'; do
        # shellcheck disable=SC2086
        "$1/gravity-studies" --study $study
    done
    studies "$1/step-studies"
    for method in $methods; do
        (cd "$work" && "$bin/step" figure-eight.plist --method $method &&
            "$bin/step" membrane.plist --method $method --until 1 \
                --observe parts,z:30)
    done
    for method in wisdom-holman sbab4; do
        (cd "$work" && "$bin/step" solar-system.plist --method $method --dt 4)
    done
    for threads in 1 2; do
        (cd "$work" && for scene in ring membrane double-pendulum; do
            "$bin/step" $scene.plist --threads $threads --sums compensated \
                --observe energy,momentum --track 1,2
        done
        "$bin/step" ring.plist --threads $threads --kernel tree --track 1,2)
    done
    (cd "$work" && for scene in gas break; do
        "$bin/step" $scene.plist --sums compensated --observe energy,momentum \
            --track 1,2
        "$bin/step" $scene.plist --contact located --until 0.02 --track 1,2
        (cat $scene.plist && echo linear 1e4 1) |
            "$bin/step" - --until 0.02 --track 1,2
    done)
    (cd "$work" && for scene in figure-eight membrane double-pendulum gas \
        break; do
        "$bin/bonk" $scene.plist --until 2 --tolerance 1e-6 --explain 2>&1
    done)
    for scene in $(build/bin/scene --help |
        sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p'); do
        "$1/scene" "$scene"
    done
}
run_all build/bin >"$work/expected"
holds 'the programs run' test "$(wc -l <"$work/expected")" -gt 800
# The ends: the build that is there, whose loops choose their version when
# they run, and loops that are compiled once, for this machine, by either
# compiler, by one as far as it can and by the other as little as makes sense.
# What lies between is made of the same parts.
for build in 'gcc -O3' 'clang -O1'; do
    cc=${build% *}
    flags="-std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off ${build#* }
        -march=native -DVECTOR_PLAIN"
    mkdir -p "$work/bin" "$work/obj"
    for file in $all; do
        # shellcheck disable=SC2086
        $cc $flags -Isrc -c -o "$work/obj/$(basename "$file" .c).o" "$file" ||
            not_ok "$cc" "$file does not compile"
    done
    for program in $programs; do
        # shellcheck disable=SC2086
        $cc $flags -Isrc -o "$work/bin/$program" src/[ps]*[md]*s/"$program.c" \
            "$work"/obj/*.o -lm || not_ok "$cc" 'does not build'
    done
    run_all "$work/bin" >"$work/got"
    holds "$build for this machine gives the same bytes" \
        cmp "$work/expected" "$work/got"
    # A test's own code is not what is asked about.
    for test in gravity gravity_lanes springs stepping; do
        # shellcheck disable=SC2086
        $cc $flags -O0 -Isrc -Itests -o "$work/bin/$test" \
            tests/library/$test.c "$work"/obj/*.o -lcunit -lm &&
            "$work/bin/$test"
    done >"$work/said" 2>&1
    holds "$cc, plain loops: 4 modules pass their tests" test \
        "$(grep -c '^1\.\.' "$work/said") $(grep -c '^not ok' "$work/said")" \
        = '4 0'
    rm -r "$work/bin" "$work/obj"
done
echo 1..5
