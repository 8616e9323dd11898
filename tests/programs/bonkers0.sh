#!/bin/sh
# The whole program of chapter 2, which stands by itself, and the engines: they
# have found the same collisions. Its beads are those of the chapter's figures.
. tests/programs/common
source=src/programs/bonkers0.c
build/bin/bonkers0 >"$work/zero"

# Its numbers: the masses from its text, places and velocities from its first
# row, which has them as they are written.
masses=$(tr -d ' \n' <$source |
    sed 's/.*mass\[BEADS+2\]={INFINITY,\([0-9.,]*\),INFINITY};.*/\1/')
list() { # FIRST COLUMN: every second number of the first row
    awk -v k="$1" 'NR == 1 { for (i = k; i <= NF; i += 2)
        printf "%s%s", (i > k ? "," : ""), $i }' "$work/zero"
}
places=$(list 3) velocities=$(list 4)
holds 'ten beads, eleven rows' test \
    "$(echo "$masses,$places,$velocities" | tr ',' '\n' | grep -c '^[0-9.]*$')" \
    -eq 30 -a "$(grep -vc '^#' "$work/zero")" -eq 11

# same ENGINE: every number of every row, but for the digits printed.
same() {
    build/bin/bonkers --masses "$masses" --positions "$places" \
        --velocities "$velocities" --walls 0,12 --every 1 --until 10 \
        --engine "$1" -o "$work/table" --summary "$work/summary"
    # Behind time and energy the engines' rows have the left stop, at the end
    # the right one.
    grep -v '^#' "$work/table" | cut -d ' ' -f 1,2,5-24 >"$work/rows"
    grep -v '^#' "$work/zero" | paste -d ' ' - "$work/rows" | awk '
        NF != 44 { exit 1 }
        { for (i = 1; i <= 22; ++i) {
              difference = $i - $(i + 22)
              if (difference > 1e-8 || difference < -1e-8)
                  exit 1
          }
          ++n }
        END { exit n != 11 }' &&
        [ "# collisions $(key "$work/summary" collisions)" = \
            "$(tail -n 1 "$work/zero")" ]
}
for engine in naive scan heap slab; do
    holds "the engine $engine agrees with it" same $engine
done
velocities=2.0001,${velocities#*,}
same scan && not_ok 'and another start is seen' 'it was not' ||
    ok 'and another start is seen'
velocities=$(list 4)

holds 'it is no longer than a reader likes' \
    test "$(tail -n +3 $source | grep -c .)" -le 75
holds 'the figures have its beads' test "$(grep -lF -e "--masses $masses \
--positions $places --velocities $velocities --walls 0,12 " \
    plots/02-strip.gp plots/02-worldlines.gp | wc -l)" -eq 2
echo 1..8
