#!/bin/sh
# What comes out of a run is read from it and not typed. In a figure's script no
# guide line has a number for its factor, no label a decimal number of three
# digits, and no line a constant of five; in a caption no decimal number of three
# digits stands outside \result and \datum. Those that do are listed here, each
# with the reason why no run can change it.
. tests/programs/common

cat >"$work/list" <<'END'
plots/03-series.gp 98765432.0 a seed
plots/03-series.gp 16807.0 random numbers
plots/03-series.gp 2147483647.0 random numbers
plots/06-throws.gp 16807.0 random numbers
plots/06-throws.gp 2147483647.0 random numbers
plots/06-two.gp 2* the radius, twice
plots/07-cells.gp 3.5449 a sketch, with its disks
plots/07-cells.gp 1.2678 a sketch, with its disks
plots/07-eos.gp 2.3647684 Kolafa's equation
plots/07-eos.gp 0.8698551 Kolafa's equation
plots/07-eos.gp 1.1062803 Kolafa's equation
plots/07-eos.gp 1.1014221 Kolafa's equation
plots/07-eos.gp 0.66605866 Kolafa's equation
plots/07-eos.gp 0.03633431 Kolafa's equation
plots/07-eos.gp 0.20965164 Kolafa's equation
plots/07-eos.gp 0.10555569 Kolafa's equation
plots/07-eos.gp 0.0087238 Kolafa's equation
plots/08-stability.gp 1.0000001 where a colour ends
plots/08-trace.gp 0.999 a tic of the axis
plots/08-trace.gp 1.001 a tic of the axis
plots/09-sun-earth.gp 365.25 days in a year
chapters/01-collide.nw 18.4 the arc tangent of 1/3, in degrees
chapters/02-bonkers.nw 1.618 the golden ratio
chapters/06-room.nw 0.283 packing of four disks of radius 0.15 in the unit box
chapters/06-room.nw 0.503 packing of four disks of radius 0.2 in the unit box
chapters/06-room.nw 0.2071 (sqrt 2 - 1) / 2
chapters/07-gas.nw 0.907 pi / sqrt 12
chapters/09-gravity.nw 0.7048 a start that was chosen
chapters/09-gravity.nw 0.445 a start that was chosen
END

# Prints "FILE:LINE: NUMBER" for each such number in scripts and chapters.
typed() { # FILE...
    awk '
    function digits(s) {
        sub(/[eE].*/, "", s)
        sub(/\./, "", s)
        sub(/^0+/, "", s)
        return length(s)
    }
    # The decimal numbers in a text that have at least so many digits.
    function look(text, least,    word) {
        while (match(text, /(^|[^A-Za-z0-9_.#])[0-9]*\.[0-9]+/)) {
            word = substr(text, RSTART, RLENGTH)
            text = substr(text, RSTART + RLENGTH)
            sub(/^[^0-9.]/, "", word)
            if (digits(word) >= least)
                print FILENAME ":" FNR ": " word
        }
    }
    # A number that multiplies or divides x, its root or its exponential.
    function guide(text,    word) {
        while (match(text, /(^|[^A-Za-z0-9_.])[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?[*\/](sqrt\(x|exp\(-?x|x)($|[^A-Za-z0-9_(])/)) {
            word = substr(text, RSTART, RLENGTH)
            text = substr(text, RSTART + RLENGTH)
            sub(/^[^0-9.]/, "", word)
            sub(/[*\/].*/, "", word)
            if (word != 1)
                print FILENAME ":" FNR ": " word "*"
        }
    }
    function script(line,    rest, word, n, part, i) {
        if (line ~ /set +[xyz]range/)
            return
        look(line, 5)
        rest = line
        while (match(rest, /\047[^\047]*\047|"[^"]*"/)) {
            word = substr(rest, RSTART, RLENGTH)
            rest = substr(rest, RSTART + RLENGTH)
            look(word, 3)
        }
        if (!match(line, /(^|[ ;{])plot /))
            return
        n = split(substr(line, RSTART + RLENGTH), part, /, */)
        for (i = 1; i <= n; ++i)
            if (part[i] !~ / using /)
                guide(part[i])
    }
    FNR == 1 { ends = held = caption = "" }
    FILENAME ~ /\.gp$/ {
        if (ends != "") {
            if ($0 == ends)
                ends = ""
            next
        }
        if (/^#/)
            next
        if (/<< *[A-Z]+$/) {
            ends = $NF
            sub(/.*<</, "", ends)
            next
        }
        $0 = held $0
        held = ""
        if (sub(/\\$/, "")) {
            held = $0
            next
        }
        script($0)
        next
    }
    /^\\plotfigure/ { caption = " " }
    caption != "" {
        caption = caption $0 "\n"
        rest = caption
        if (gsub(/\{/, "", rest) != gsub(/\}/, "", rest))
            next
        gsub(/\\(result|datum)(\[[^]]*\])?(\{[^}]*\})+/, "", caption)
        gsub(/\\(cfile|texttt|ref|eqref|cite)\{[^}]*\}/, "", caption)
        look(caption, 3)
        caption = ""
    }' "$@"
}

# The numbers that are not listed, and what is listed and not there.
unlisted() { # LIST FILE...
    list=$1
    shift
    typed "$@" | awk -v list="$list" '
    BEGIN {
        while ((getline line < list) > 0) {
            split(line, word, " ")
            seen[word[1] ": " word[2]] = 0
        }
    }
    {
        key = $0
        sub(/:[0-9]+:/, ":", key)
        if (key in seen)
            seen[key] = 1
        else
            print
    }
    END {
        for (key in seen)
            if (!seen[key])
                print "listed and not there: " key
    }'
}

none 'no result is typed in a figure or its caption' \
    "$(unlisted "$work/list" plots/[0-9]*.gp chapters/*.nw)"

# The test sees them.
cat >"$work/planted.gp" <<'END'
# alt: 3.14159 here is no matter
set label 1 'after 15.3 s' at 0.123456,3
mass = 4.2937219
set xrange [0:1.2345678]
$data << EOD
1.2345678 9.0
EOD
plot 9.0e-17*x ls 9, 0.3*eps*sqrt(x), 8e-15*sqrt(x) ls 9, \
     cos(1.99*x), 20/x, 3e-17*exp(x), file using ($1*2/x):2
END
cat >"$work/planted.nw" <<'END'
Here 2.718 may stand.
\plotfigure[Short]{08-trace}{Up to \result[0 to 1.234]{run}{key}, in
\cfile{plots/data/12.345}, at 1.573 and 2.0.}
END
printf '%s\n' 'plots/none.gp 1.234 gone' >"$work/short"
expected='planted.gp:2: 0.123456
planted.gp:2: 15.3
planted.gp:3: 4.2937219
planted.gp:9: 9.0e-17*
planted.gp:9: 8e-15*
planted.gp:9: 1.99*
planted.gp:9: 20*
planted.gp:9: 3e-17*
planted.nw:3: 1.573
listed and not there: plots/none.gp: 1.234'
found=$(unlisted "$work/short" "$work/planted.gp" "$work/planted.nw" |
    sed "s|^$work/||")
is 'planted ones are seen' "$expected" "$found"
echo 1..2
