#!/bin/sh
# The two volumes lie side by side: each link from the one has its place in
# the other, in the edition for lecturers, too. TeX has written
# down the links that it set (JOB.links: file, place).
set -u
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
LC_ALL=C
export LC_ALL
places() { pdfinfo -dests "$1" | sed -n 's/^.*"\(.*\)"$/\1/p' | sort; }
for volume in bonkers works; do
    places "build/$volume.pdf" >"$scratch/$volume"
done
lost() { # LINKS FILE VOLUME: links that lead elsewhere than to a place of it
    sed "s/^$2 //" "$1" | sort -u | comm -23 - "$scratch/$3"
}
leads() { # NAME LINKS FILE VOLUME LEAST
    if [ ! -s "$2" ] || [ ! -s "$scratch/$4" ]; then
        echo "not ok links: $1 - no $2, or nothing in build/$4.pdf"
        return
    fi
    lost "$2" "$3" "$4" >"$scratch/lost"
    if [ "$(wc -l <"$2")" -lt "$5" ]; then
        echo "not ok links: $1 - only $(wc -l <"$2") of them"
    elif [ -s "$scratch/lost" ]; then
        echo "not ok links: $1 - $(wc -l <"$scratch/lost") lead nowhere," \
            "the first to $(head -n 1 "$scratch/lost")"
    else
        echo "ok links: $1"
    fi
}
leads 'from the book to Works' build/book/book.links works.pdf works 40
leads 'from the instructor'"'"'s edition' build/book-instructor/book.links \
    works.pdf works 40
leads 'from Works to the book' build/works/works.links bonkers.pdf bonkers 1000

# A place that is missing is seen, and a file of another name.
name=$(sed -n 's/^works\.pdf //p' build/book/book.links | head -n 1)
sed -i "/^$name\$/d" "$scratch/works"
[ "$(lost build/book/book.links works.pdf works)" = "$name" ] &&
    echo 'ok links: a place that is missing is seen' ||
    echo 'not ok links: a place that is missing is seen - it was not'
echo 'other.pdf Doc-Start' >"$scratch/links"
[ "$(lost "$scratch/links" works.pdf works)" = 'other.pdf Doc-Start' ] &&
    echo 'ok links: another file is seen' ||
    echo 'not ok links: another file is seen - it was not'
echo 1..5
