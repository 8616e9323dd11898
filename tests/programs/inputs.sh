#!/bin/sh
# No output takes the place of a file that is read: by its name, by another
# name or link, or as standard input. The file is left as it was.
. tests/programs/common
bin=$PWD/build/bin
cd "$work" || exit 1
"$bin/bonkers" --preset four --samples 40 --every 0.1 -o table
"$bin/bonkers" --preset piston --samples 400 --every 0.1 -o piston
"$bin/scene" sun-earth -o scene
printf '2 1 0.1\n2 4 0.15\n' >species
"$bin/disks" --measure states --until 1 -o start 2>/dev/null

# spares FILE OPTION COMMAND...: COMMAND reads FILE, and OPTION must not
# write it under any of its names.
spares() {
    file=$1 option=$2
    shift 2
    ln -sf "$file" link
    ln -f "$file" hard
    cksum <"$file" >before
    for name in "$file" "./$file" link hard; do
        refuses 2 "--$option: '$name' is read, and would be lost" \
            "$@" "--$option" "$name"
    done
    holds "$file is as it was after $option" sh -c "cksum <$file | cmp - before"
    rm -f link hard
}
for option in output summary; do
    spares table $option "$bin/histogram" table
    spares piston $option "$bin/piston" --study measure --table piston
    spares species $option "$bin/disks" --species species --every 1 --until 1
    spares start $option "$bin/disks" --start start --every 1 --until 1
    spares scene $option "$bin/step" scene
    spares scene $option "$bin/bonk" scene --until 1 --tolerance 0.1
done
spares scene save "$bin/step" scene
spares scene chart "$bin/bonk" scene --until 1 --tolerance 0.1

# Standard input from a file is that file.
# shellcheck disable=SC2016
for command in 'histogram -' 'step -' 'bonk - --until 1 --tolerance 0.1'; do
    case $command in his*) file=table ;; *) file=scene ;; esac
    cksum <$file >before
    sh -c "'$bin'/$command -o $file <$file" >out 2>err
    holds "$command spares what it reads" sh -c \
        "[ $? -eq 2 ] && grep -q 'is read' err && cksum <$file | cmp - before"
done

# What else is called so is no input, and other files may be written.
echo 1 >lattice
holds 'a start named lattice is no file' \
    "$bin/disks" --start lattice --every 1 --until 1 -o lattice
holds 'a file of its own is written' "$bin/histogram" table -o other
echo 1..75
