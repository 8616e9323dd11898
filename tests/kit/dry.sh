#!/bin/sh
# make -n says what it would do, and does nothing of it, even where a recipe
# names $(MAKE): that make runs under -n as well.
. tests/programs/common
make=${MAKE:-make}
unset EX OF QUALITY TEXTS COMMANDS
# The kit, but for a runner of tests that leaves a mark.
kit=$work/kit
mkdir "$kit" "$kit/tests"
for file in * tests/*; do
    [ "$file" = tests ] || [ "$file" = tests/run ] || ln -s "$PWD/$file" "$kit/$file"
done
printf '#!/bin/sh\necho "$*" >>"%s"\n' "$work/ran" >"$kit/tests/run"
chmod +x "$kit/tests/run"

# does_nothing FLAGS GOAL...: neither a test nor a list of jobs. What calls
# make only is left out.
does_nothing() {
    rm -f "$work/ran"
    before=$(ls -l build/jobs 2>&1)
    MAKEFLAGS='' $make -C "$kit" "$@" MAKE=: >"$work/plan" 2>&1
    [ ! -e "$work/ran" ] && [ "$(ls -l build/jobs 2>&1)" = "$before" ]
}
holds 'make -n runs no test, and lists no jobs' \
    does_nothing -n test test-cluster jobs OF=figures
holds 'but says what it would run' \
    grep -q 'tests/run .* tests/book/book.sh' "$work/plan"
holds 'nor does it with other options' does_nothing --no-print-directory -sn -j2 test
MAKEFLAGS='' $make -C "$kit" --no-print-directory -o has-tex -o has-site \
    -o has-test-tools MAKE=: test >/dev/null 2>&1
holds 'make test runs them' grep -q 'tests/book/book.sh' "$work/ran"
echo 1..4
