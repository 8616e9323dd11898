#!/bin/sh
# Every figure, as the book has it and as slides of a lecture, both from the
# book's data: its words do not lie over each other, none leaves the page,
# none is smaller than 7 points in the book and 14 on a slide. What lies over
# data is for the eye: make contact.
. tests/programs/common

# What is wrong with the words of FILE.pdf, one line each, or nothing.
# pdftotext leaves out what is not on the page: it gets a larger one. (What
# begins beyond the left or the lower edge gnuplot does not draw: for the eye.)
# Its boxes are as high as a line; letters fill them but for a fifth above and
# an eighth below. That a word stands on end it does not say: this is told by
# the word's letters, or by a longer word in its line.
# In what a newer cairo draws the page stands compressed: pdfseparate writes it
# out, after which it can be edited.
wrong() { # FILE.pdf LEAST-TYPE
    pdfseparate "$1" "$work/page.pdf" 2>/dev/null
    size=$(LC_ALL=C sed -n 's|.*/MediaBox *\[ *0 0 \([0-9.]* [0-9.]*\) *\].*|\1|p' \
        "$work/page.pdf")
    [ -n "$size" ] || { echo 'no page'; return; }
    LC_ALL=C sed 's|/MediaBox *\[[^]]*\]|/MediaBox [ -99 -99 1999 1999 ]|' \
        "$work/page.pdf" >"$work/larger.pdf"
    pdftotext -bbox "$work/larger.pdf" "$work/words" 2>/dev/null &&
        LC_ALL=C awk -v least="$2" -v size="$size" '
    function width(text,    i, c, sum) {
        for (i = 1; i <= length(text); ++i) {
            c = substr(text, i, 1)
            sum += c ~ /[ijl.,:;|()!]/ ? 0.3 : c ~ /[mwMW]/ ? 0.8 : \
                c ~ /[^ -~]/ ? 0.25 : 0.5
        }
        return sum / 1.46
    }
    function far(a, b) { a = log(a / b); return a < 0 ? -a : a }
    function least_of(a, b) { return a < b ? a : b }
    BEGIN {
        split(size, at)
        left = 99; right = left + at[1]
        bottom = 1999; top = bottom - at[2]
    }
    /<word / {
        split($0, at, "\"")
        ++n
        x[n] = at[2]; y[n] = at[4]; X[n] = at[6]; Y[n] = at[8]
        word[n] = $0
        gsub(/.*">|<\/word>.*/, "", word[n])
        gsub(/&[a-z0-9#]*;/, "x", word[n])
        aspect = (X[n] - x[n]) / (Y[n] - y[n])
        flat = far(1 / aspect, width(word[n])) - far(aspect, width(word[n]))
        lies[n] = flat > -0.15
        if (flat < -0.5) stands_at[x[n], X[n]]
        if (flat > 0.5) lies_at[y[n], Y[n]]
    }
    END {
        for (j = 1; j <= n; ++j) {
            if ((x[j], X[j]) in stands_at) lies[j] = 0
            else if ((y[j], Y[j]) in lies_at) lies[j] = 1
            if (lies[j]) {
                high = Y[j] - y[j]
                y[j] += 0.2 * high; Y[j] -= 0.13 * high
            } else {
                high = X[j] - x[j]
                x[j] += 0.2 * high; X[j] -= 0.13 * high
            }
            if (high / 1.46 < least - 0.2)
                printf "%s has %.1f points\n", word[j], high / 1.46
            if (x[j] < left || X[j] > right || y[j] < top || Y[j] > bottom)
                print word[j] " leaves the page"
            area[j] = (X[j] - x[j]) * (Y[j] - y[j])
            for (i = 1; i < j; ++i) {
                dx = least_of(X[i], X[j]) + least_of(-x[i], -x[j])
                dy = least_of(Y[i], Y[j]) + least_of(-y[i], -y[j])
                if (dx > 0 && dy > 0 &&
                    dx * dy > least_of(area[i], area[j]) / 20)
                    print word[j] " lies over " word[i]
            }
        }
    }' "$work/words"
}

# Drawn, and with nothing wrong. What make has drawn for the book is looked at
# as it is, where no script is younger.
sound() { # NAME MEDIUM SCRIPT LEAST-TYPE
    drawn=build/figures/$1.pdf
    if [ "$2" = pdf ] && [ -s "$drawn" ] &&
        [ -z "$(find plots -name '*.gp' -newer "$drawn")" ]; then
        cp "$drawn" "$work/$1.pdf"
    elif ! chapters/press/recipes --figure "$2" "$work/$1.pdf" "$3" >"$work/said" 2>&1
    then
        not_ok "$1, $2" "$(head -n 1 "$work/said")"
        return
    fi
    found=$(wrong "$work/$1.pdf" "$4" 2>&1) || found="unread: $found"
    if [ -z "$found" ]; then ok "$1, $2"; else
        not_ok "$1, $2" "$(printf '%s\n' "$found" | head -n 5 | tr '\n' ';')"
    fi
}
slides=
for script in plots/[0-9]*.gp; do
    name=${script##*/}
    sound "${name%.gp}" pdf "$script" 7
    its=$(chapters/press/recipes --slides "$script")
    for name in $its; do
        sound "$name" slide "$script" 14
    done
    slides="$slides $its"
done

# The test sees what it is to see, in words that lie and words that stand.
sees() { # WHAT GNUPLOT-LINES
    printf '%s\n' '# alt: planted' 'width = 14' 'height = 7' \
        "load 'plots/style.gp'" 'unset tics' 'unset border' \
        'set margins 0,0,0,0' \
        "set label 1 'some words' at screen 0.5,0.5" \
        "set label 2 'and more' at screen 0.3,0.5 rotate" "$2" \
        'plot [0:1] x' >"$work/00-planted.gp"
    chapters/press/recipes --figure slide "$work/00-planted.pdf" \
        "$work/00-planted.gp" >"$work/said" 2>&1
    found=$(wrong "$work/00-planted.pdf" 14 2>&1 | head -n 1)
    # shellcheck disable=SC2254
    case $found in
    $1) ok "planted: ${2:-nothing}" ;;
    *) not_ok "planted: ${2:-nothing}" "'$found', not '$1'" ;;
    esac
}
sees '' ''
sees 'some lies over other' "set label 3 'other' at screen 0.48,0.51"
sees 'other lies over more' "set label 3 'other' at screen 0.3,0.6 rotate"
sees 'other has 12.* points' \
    "set label 3 'other' at screen 0.1,0.1 font face.',12.5'"
sees 'other has 12.* points' \
    "set label 3 'other' at screen 0.1,0.1 rotate font face.',12.5'"
for place in 'screen 0.97,0.3' 'screen 0.01,0.3 center' 'screen 0.1,0.99' \
    'screen 0.1,0.01' 'screen 0.995,0.3 rotate' 'screen 0.01,0.3 rotate'; do
    sees 'other leaves the page' "set label 3 'other' at $place"
done

# A method has one style in all figures, that of plots/methods.gp: no script
# paints one by hand.
list=$(sed -n "s/^known = '\(.*\)'$/\1/p" plots/methods.gp | tr ' ' '|')
list="$list|$(sed -n "s/^array called.*= \[\(.*\)\]$/\1/p" plots/methods.gp |
    sed "s/', '/|/g; s/'//g; s/ ([A-Z]*)//g")"
painted() { # FILE...
    grep -E "(ls [0-9]|lc rgb)[^,]*title '[^']*($list)" "$@"
}
echo "plot 'file' with points ls 2 title 'at last Yoshida 4'" >"$work/painted"
holds 'a method that is painted by hand is seen' painted "$work/painted"
by_hand=$(painted plots/[0-9]*.gp)
holds 'none is' sh -c "printf '%s\n' \"\$0\"; test -z \"\$0\"" "$by_hand"

# A function of a script may not have the name of one of gnuplot's own, of any
# version: these are those of gnuplot 6, with the libraries that it may be built
# with, so that a gnuplot 5 sees it too.
builtin='abs acos acosh airy Ai arg asin asinh atan atan2 atanh besi0 besi1 besin
besj0 besj1 besjn BesselH1 BesselH2 BesselI BesselJ BesselK BesselY besy0 besy1
besyn Bi cbrt cdawson ceil cerf column columnhead columnheader conj conjg cos cosh
defined EllipticE EllipticK EllipticPi erf erfc erfi exist exists exp expint
faddeeva floor FresnelC FresnelS gamma gprintf hsv2rgb ibeta igamma imag index int
inverf invibeta invigamma invnorm join LambertW lambertw lgamma lnGamma log log10
norm palette rand real rgbcolor round sgn Sign sin sinh split sprintf sqrt strcol
strftime stringcolumn strlen strptime strstrt substr SynchrotronF system tan tanh
time timecolumn tm_hour tm_mday tm_min tm_mon tm_sec tm_wday tm_week tm_yday
tm_year trim uigamma valid value voigt voxel VP VP_fwhm weekdate_cdc weekdate_iso
word words zeta'
builtin=$(echo $builtin | tr ' ' '|')
taken() { # FILE...
    grep -nE "(^|[;{\"' ])($builtin) *\([A-Za-z_0-9, ]*\) *=[^=~]" "$@"
}
printf '%s\n' 'half(x) = x / 2; round(x, y) = floor(x)' >"$work/taken.gp"
holds 'a function with the name of one of gnuplot 6 is seen' taken "$work/taken.gp"
found=$(taken plots/*.gp plots/show chapters/press/* solutions/*.gp 2>/dev/null)
holds 'no script has one' sh -c "printf '%s\n' \"\$0\"; test -z \"\$0\"" "$found"

# One of them, by its name.
make=${MAKE:-make}
$make -n -W plots/04-state.gp figure FIGURE=04-state QUALITY=lecture \
    >"$work/out" 2>&1
holds 'a slide for each row of a tall figure' sh -c "
    grep -q -- '--figure lecture build/lecture/04-state-1.pdf' '$work/out' &&
    grep -q -- '--figure lecture build/lecture/04-state-2.pdf' '$work/out'"
$make -n figure FIGURE=04 >"$work/out" 2>&1
holds 'a figure that is none is refused' \
    grep -q "figure: FIGURE: '04' is no figure of plots/" "$work/out"
# Each figure, each slide.
set -- plots/[0-9]*.gp
echo "1..$((17 + $# + $(echo $slides | wc -w)))"
