#!/bin/sh
# What make asks of the compiler, and what it hands on: flags reach every
# compilation, another compiler or flag compiles anew, what is probed is
# linked and run, and a variable's value is never run as a command.
. tests/programs/common
make=${MAKE:-make}
unset CPPFLAGS CFLAGS LDFLAGS EX SUBMISSIONS REPORT JOBS HIDDEN RESULTS TEXTS \
    SECONDS MAKEFLAGS MFLAGS
copy_kit Makefile src tests exercises solutions plots chapters

# Every compilation of every kind of object.
$make -n V=1 programs check grade-parts test-parts memcheck \
    build/fuzz/scene CPPFLAGS=-DMARK CFLAGS=-DMARC LDFLAGS=-LMARK \
    >"$work/plan" 2>/dev/null
joined() { sed -e ':a' -e '/\\$/N; s/\\\n//; ta' "$work/plan"; }
joined | grep -e '-std=c11\|check/flags' | grep -e ' -o ' >"$work/compiled"
holds 'there are compilations to look at' \
    test "$(wc -l <"$work/compiled")" -gt 200
holds 'CPPFLAGS reach each of them' sh -c "
    ! grep -v -e -DMARK -e check/flags '$work/compiled' | grep ."
holds 'CFLAGS those of the kit' sh -c "
    ! grep 'build/obj' '$work/compiled' |
    grep -v -e -DMARC | grep ."

holds 'and each of them writes down what it reads' sh -c "
    ! grep '[a-z]\.c\( \|$\)' '$work/compiled' | grep -v -e ' -MM' \
    -e /probe.c -e ' build/fuzz/scene.new' -e '-o build/check/[^ ]*stub ' -e '-o build/grade/[^ ]*.stub.o' |
    grep ."

# Another flag, another compiler: compiled anew, and only then.
object=build/obj/line/collide.o
up_to_date() { $make -q "$@" $object >/dev/null 2>&1; }
$make -s $object >/dev/null 2>&1
holds 'what is built is built' up_to_date
holds 'other CFLAGS compile anew' sh -c "! $make -q CFLAGS=-O1 $object"
$make -s CFLAGS=-O1 $object >/dev/null 2>&1
holds 'once' up_to_date CFLAGS=-O1
holds 'and so do the old ones' sh -c "! $make -q $object"
printf '#!/bin/sh\necho "$@" >>%s\nexec cc "$@"\n' "$work/asked" >"$work/other"
chmod +x "$work/other"
$make -s CC="$work/other" $object >/dev/null 2>&1
holds 'another compiler compiles anew' grep -q -e '-c -o build/obj' "$work/asked"
holds 'and is asked what it can do' grep -q -e -fopenmp "$work/asked"

# compiler NAME PATTERN ACTION: a compiler that does ACTION when its
# arguments match.
compiler() {
    printf '#!/bin/sh\ncase " $* " in *" %s"*) %s ;; esac\nexec cc "$@"\n' \
        "$2" "$3" >"$work/$1" && chmod +x "$work/$1"
    $make -n CC="$work/$1" programs >"$work/plan" 2>/dev/null
}
compiler whole -none- ':'
holds 'with GSL there is a histogram' grep -q 'bin/histogram[^0]' "$work/plan"
compiler headers -lgsl 'exit 1'
holds 'headers without a library are no GSL' \
    sh -c "! grep -q 'bin/histogram[^0]' '$work/plan'"
# Its output is not what it was told to make, but ends with status 1.
compiler threads -fopenmp 'for o; do [ "$last" = -o ] && out=$o; last=$o; done
    printf "#!/bin/sh\\nexit 1\\n" >"$out"; chmod +x "$out"; exit 0'
holds 'OpenMP that links and does not run is none' \
    sh -c "! grep -q OPENMP build/compiler.mk"
compiler whole -none- ':'
holds 'OpenMP that runs is some' grep -q OPENMP build/compiler.mk

# A value is a value: no recipe has it in its text.
for value in '1;touch MARK' '$(touch MARK)' '$(shell touch MARK)' "'MARK"; do
    set --
    for variable in $(sed -n '/^given =/,/[^\\]$/{s/.*=//;s/\\//;p;}' Makefile); do
        set -- "$@" "$variable=$value"
    done
    $make -n "$@" check hint grade fuzz movie inspect chart book \
        >"$work/plan" 2>&1
    $make -n "WITH_CHAPTERS=$value" handout >>"$work/plan" 2>&1
    holds "$value in any variable stays a value" \
        sh -c "! grep MARK '$work/plan' && ! ls MARK && grep 'plots/show chart' '$work/plan' &&
            grep handout '$work/plan'"
    rm -f MARK
done
cd "$OLDPWD" || exit 1
hit=$work/hit
for value in "01a;touch $hit" "\$(touch $hit)" "\$(shell touch $hit)"; do
    $make -s check EX="$value" >"$work/out" 2>&1
    status=$?
    holds "make check EX='$value' asks for an exercise" \
        sh -c "[ $status -ne 0 ] && [ ! -e '$hit' ] && grep -q '^examine: ' '$work/out'"
done

# What changes every result is refused where it is compiled.
fewer=0
for flag in -Ofast -ffast-math -fassociative-math\ -fno-signed-zeros\ -fno-trapping-math \
    -mfpmath=387; do
    case $flag$(uname -m) in
    *387x86_64) ;;
    *387*) fewer=2 && continue ;;
    esac
    # shellcheck disable=SC2086
    cc -std=c11 -D_POSIX_C_SOURCE=200809L $flag -Isrc -fsyntax-only \
        src/toolbox/table.c >"$work/out" 2>&1
    holds "$flag is refused, with the way out" sh -c \
        "[ $? -ne 0 ] && grep -q 'error.*BONKERS_ANY_ROUNDING' '$work/out'"
    # shellcheck disable=SC2086
    holds 'which is taken' cc -std=c11 -D_POSIX_C_SOURCE=200809L $flag \
        -DBONKERS_ANY_ROUNDING -Isrc -fsyntax-only src/toolbox/table.c
done
echo "1..$((29 - fewer))"
