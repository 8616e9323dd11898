#!/bin/sh
# What make dist publishes is whole: the files, their checksums, the archives
# and what they hold; the same files make the same bytes; what is missing or
# of another version is refused.
. tests/programs/common
LC_ALL=C
export LC_ALL
unset SOURCE_DATE_EPOCH WITH_CHAPTERS YEAR
root=$(pwd)

# In a copy, since another test makes the course anew; of the pages the first
# is enough.
kit=$work/kit
mkdir "$kit"
tar cf - --exclude=./build --exclude=./.git . | (cd "$kit" && tar xf -)
mkdir -p "$kit/build/site/pages"
cp build/bonkers.pdf "$kit/build"
echo '<title>Bonkers</title>' >"$kit/build/site/index.html"
echo 'p { margin: 0 }' >"$kit/build/site/pages/a b.css"
cd "$kit" || exit 1
chapters/press/handout >"$work/out" 2>&1 ||
    not_ok 'the course is made' "$(tail -1 "$work/out")"

dist() { env SOURCE_DATE_EPOCH=1000000000 chapters/press/dist >"$work/out" 2>&1; }
holds 'a release is made' dist
holds 'and says where it is' grep -q '^The release: build/dist/, ' "$work/out"
is() { if [ "$2" = "$3" ]; then ok "$1"; else not_ok "$1" "got '$3'"; fi; }
is 'book, course, pages and checksums, no more' \
    'SHA256SUMS bonkers-course.tar.gz bonkers-site.tar.gz bonkers.pdf' \
    "$(ls -A build/dist | tr '\n' ' ' | sed 's/ $//')"
is 'nor half of one' '' "$(find build -name '*.part')"
for file in bonkers.pdf bonkers-course.tar.gz; do
    holds "$file is what was made" cmp "build/$file" "build/dist/$file"
done
sums() { (cd "$1" && sha256sum --check --strict --quiet SHA256SUMS); }
holds 'the checksums hold' sums build/dist
is 'of every file' 3 "$(grep -c '^[0-9a-f]\{64\}  [a-z.-]*$' build/dist/SHA256SUMS)"
cp -R build/dist "$work/spoilt"
for file in bonkers.pdf bonkers-course.tar.gz bonkers-site.tar.gz; do
    cp "build/dist/$file" "$work/spoilt/$file"
    printf x | dd of="$work/spoilt/$file" bs=1 seek=1000 conv=notrunc 2>/dev/null
    holds "and not of another $file" sh -c "! (cd '$work/spoilt' &&
        sha256sum --check --quiet SHA256SUMS >/dev/null 2>&1)"
    cp "build/dist/$file" "$work/spoilt/$file"
done

# Unpacked, the pages are those that were made.
mkdir "$work/pages" "$work/course"
tar xzf build/dist/bonkers-site.tar.gz -C "$work/pages"
holds 'the pages are whole' diff -r build/site "$work/pages/bonkers-site"
tar xzf build/dist/bonkers-course.tar.gz -C "$work/course"
holds 'and so is the course' test -s "$work/course/bonkers-course/bonkers.pdf" \
    -a -s "$work/course/bonkers-course/exercises/01a-collide.c"

version=$(sed -n 's/^#define TOOLBOX_VERSION "\(.*\)"$/\1/p' src/toolbox/version.h)
is 'all of one version' "Version $version, version: \"$version\"" \
    "$(pdfinfo "$work/course/bonkers-course/bonkers.pdf" |
        sed -n 's/^Subject: *//p'), $(grep '^version:' \
        "$work/course/bonkers-course/CITATION.cff")"

cp -R build/dist "$work/first"
find build/site -exec touch {} +
chmod -R go-rwx build/site
dist
holds 'the same files make the same release' diff -r "$work/first" build/dist

# refused NAME PATTERN: in one line.
refused() {
    chapters/press/dist >"$work/out" 2>&1
    got=$?
    if [ $got -eq 2 ] && [ "$(wc -l <"$work/out")" -eq 1 ] &&
        grep -q "^dist: $2" "$work/out"; then ok "$1"; else
        not_ok "$1" "status $got, said: $(head -c 200 "$work/out")"; fi
}
sed -i 's/TOOLBOX_VERSION "/&9./' src/toolbox/version.h
refused 'a course of another version' 'build/bonkers-course.tar.gz is of another'
holds 'and the release that there was is still there' sums build/dist
for file in bonkers.pdf bonkers-course.tar.gz site/index.html; do
    mv "build/$file" away
    refused "no release without $file" "build/$file is missing; make dist"
    mv away "build/$file"
done
cd "$root" || exit 1
echo 1..20
