#!/bin/sh
# Figures that live, and the scene player: in a browser, by keyboard, and
# against what the programs write in a terminal.
. tests/programs/common

${MAKE:-make} -s live build/bin/step build/bin/scene build/bin/bonkers \
    build/bin/disks build/bin/sample build/bin/step-studies >"$work/made" 2>&1 ||
    not_ok 'figures that live are made' "$(tail -3 "$work/made" | tr '\n' ' ')"
# A figure that lives has its script, and a script its place in a chapter.
sed -n 's/^\\livefigure{\(.*\)}$/\1/p' chapters/*.nw | sort >"$work/named"
ls build/site/live/*.js | sed 's/.*\///; s/\.js$//; /^live$/d; /^player$/d' |
    sort >"$work/scripts"
holds 'chapters name the figures that are there' cmp "$work/named" "$work/scripts"

# What drives the browser comes with .ci/install test.
modules=build/browser/node_modules
holds 'what drives the browser is there' test -d $modules/playwright-core
NODE_PATH=$PWD/$modules node tests/site/browser/live.js build/site "$work"
echo 1..70
