#!/bin/sh
# The pages in a real browser: tests/site/browser/pages.js. What moves is in
# live.sh.
. tests/programs/common
modules=build/browser/node_modules
for need in /usr/bin/chromium $modules/playwright-core $modules/axe-core; do
    [ -e "$need" ] || {
        echo "not ok browser - $need is missing; it comes with: sh .ci/install test"
        echo 1..1
        exit 1
    }
done
pages=$(ls build/site/*.html | wc -l)
NODE_PATH=$PWD/$modules node tests/site/browser/pages.js build/site \
    >"$work/out" 2>&1
cat "$work/out"
[ "$(grep -c '^ok .*\.html$\|^not ok .*\.html' "$work/out")" -ge "$pages" ] ||
    echo "not ok browser - not all of $pages pages were opened"
