# Puts the pieces of read.awk into the HTML that pandoc has made, and removes from its
# formulas what only TeX reads. Files: pieces, then pandoc's HTML.
FNR == 1 { ++which }
which == 1 {
    if ($0 ~ /^\001/)
        number = substr($0, 2)
    else
        piece[number] = ((number in piece) ? piece[number] "\n" : "") $0
    next
}
function math(s,    out, at, one, end) {
    out = ""
    while ((at = index(s, "<math ")) > 0) {
        out = out substr(s, 1, at - 1)
        s = substr(s, at)
        end = index(s, "</math>")
        one = substr(s, 1, end + 6)
        s = substr(s, end + 7)
        sub(/<annotation.*<\/annotation><\/semantics>/, "", one)
        sub(/<semantics>/, "", one)
        sub(/ xmlns="[^"]*"/, "", one)
        gsub(/<mtext mathvariant="normal">/, "<mtext>", one)
        one = low(upright(one))
        # Capital Greek letters stand upright, as in TeX.
        gsub(/<mi>\316[\221-\251]<\/mi>/, "<mi mathvariant=\"normal\"\001&", one)
        gsub(/\001<mi>/, ">", one)
        if (one ~ /display="inline"/) {
            sub(/ display="inline"/, "", one)
            one = breakable(one)
        }
        out = out one
    }
    return out s
}
# Letters in \mathrm: a browser heeds mathvariant only at <mi>.
function upright(s,    out, at, end, part) {
    out = ""
    while ((at = index(s, "<mstyle mathvariant=\"normal\">")) > 0) {
        out = out substr(s, 1, at - 1)
        s = substr(s, at + 29)
        end = index(s, "</mstyle>")
        part = substr(s, 1, end - 1)
        s = substr(s, end + 9)
        gsub(/<mi>/, "<mi mathvariant=\"normal\">", part)
        out = out "<mrow>" part "</mrow>"
    }
    s = out s
    gsub(/<mstyle mathvariant="[a-z-]*">/, "<mrow>", s)
    gsub(/<\/mstyle>/, "</mrow>", s)
    return s
}
# Brackets stretch only around fractions, matrices, roots and the like.
function low(s,    at, end, open, shut) {
    while ((end = index(s, "<mo stretchy=\"true\" form=\"postfix\">")) > 0) {
        open = 0
        while ((at = index(substr(s, open + 1, end - open - 1), \
                           "<mo stretchy=\"true\" form=\"prefix\">")) > 0)
            open += at
        shut = "<mo stretchy=\"" (open && substr(s, open, end - open) !~ \
            /<(mfrac|mtable|munder|mover|msqrt|mroot|munderover)/ ? "false" : "tall") "\""
        s = substr(s, 1, end - 1) shut substr(s, end + 19)
        if (open)
            s = substr(s, 1, open - 1) shut substr(s, open + 19)
    }
    gsub(/ stretchy="true"/, "", s)
    gsub(/ stretchy="tall"/, " stretchy=\"true\"", s)
    return s
}
# Splits a long formula within a line before its relations, so that a browser may break the
# line there, as TeX does.
function breakable(s,    plain, out, depth, tag, at, body) {
    plain = s
    gsub(/<[^>]*>/, "", plain)
    gsub(/[\200-\277]/, "", plain)
    if (length(plain) < 14 || s !~ /^<math><mrow>/)
        return s
    body = substr(s, 13, length(s) - 12 - 14)
    out = ""
    depth = 0
    while (match(body, /<[^>]*>/)) {
        tag = substr(body, RSTART, RLENGTH)
        at = RSTART
        if (depth == 0 && tag == "<mo>" && out != "" && length(body) > 60 && \
            body ~ /^<mo>(=|&lt;|&gt;|\342\211\210|\342\211\244|\342\211\245|\342\206\222|\342\210\235|,|\+|\342\210\222)<\/mo>/) {
            if (body ~ /^<mo>,/) {
                out = out "<mo>,</mo></mrow></math> <math><mrow>"
                body = substr(body, 11)
                continue
            }
            out = out "</mrow></math><wbr><math><mrow>"
        }
        out = out substr(body, 1, at + length(tag) - 1)
        body = substr(body, at + length(tag))
        if (tag ~ /^<\//)
            --depth
        else
            ++depth
    }
    return "<math><mrow>" out body "</mrow></math>"
}
function fill(s,    out, n, rest) {
    out = ""
    while (match(s, /Q[ZB][0-9]+[ZB]Q/)) {
        n = substr(s, RSTART + 2, RLENGTH - 4)
        rest = substr(s, RSTART + RLENGTH)
        out = out substr(s, 1, RSTART - 1) fill(piece[n])
        s = rest
        filled[n] = 1
    }
    return out s
}
{ html = html $0 "\n" }
END {
    n = split(html, line, "\n")
    for (i = 1; i < n; ++i) {
        s = math(line[i])
        gsub(/<p>QB[0-9]+BQ<\/p>/, "\001&\001", s)
        gsub(/\001<p>/, "", s)
        gsub(/<\/p>\001/, "", s)
        print fill(s)
    }
    for (n in piece)
        if (!(n in filled)) {
            print "site: " FILENAME ": lost: " substr(piece[n], 1, 100) > "/dev/stderr"
            bad = 1
        }
    exit bad
}
