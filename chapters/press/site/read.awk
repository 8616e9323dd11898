# Makes plain LaTeX for pandoc from a woven chapter. What pandoc does not know (code,
# references, figures, exercises) becomes a word: QZ12ZQ within a line, QB12BQ for a
# paragraph of its own. The HTML for this word goes to the file `pieces', under a line
# \001 12; fill.awk puts it in place of the word.
#
# Variables: page, pieces, uses, edition; files before the chapters: places,
# results.tex, files.tex, terms.tex, D-glossary.nw.

function fail(message) {
    print "site: " file ": " message > "/dev/stderr"
    if (++failed == 20)
        exit 1
}
# ---- what is known before the chapter is read
FNR == 1 {
    ++which
    file = FILENAME
    if (which > 1)
        read_too[file] = 1
}
which == 1 {
    split($0, part, "\t")
    page_of[part[1]] = part[2]
    kind_of[part[1]] = part[3]
    number_of[part[1]] = part[4]
    title_of[part[1]] = part[5]
    next
}
which == 2 && match($0, /^\\setresult[{]/) {
    name = argument($0, RLENGTH)
    result[name] = argument($0, after)
    next
}
which == 3 && match($0, /^\\exercisefile[{]/) {
    name = argument($0, RLENGTH)
    file_of[name] = argument($0, after)
    next
}
which == 4 && match($0, /^\\termhome[{]/) {
    name = argument($0, RLENGTH)
    home[name] = argument($0, after)
    next
}
which == 4 && match($0, /^\\termline[{]/) {
    name = argument($0, RLENGTH)
    rest = argument($0, after)
    while (match(rest, /\\term(def|use)[{][0-9]+[}]/)) {
        term_at[substr(rest, RSTART + 9, RLENGTH - 10)] = name
        rest = substr(rest, RSTART + RLENGTH)
    }
    next
}
which == 5 && match($0, /^\\term(\[[^]]*\])?[{]/) {
    line = substr($0, 1, RLENGTH)
    name = argument($0, RLENGTH)
    words = ""
    if (match(line, /\[.*\]/))
        words = substr(line, RSTART + 1, RLENGTH - 2)
    glossed[name] = 1
    phrases[name] = ""
    if (words !~ /^=/)
        phrases[name] = name "," name "s"
    sub(/^=/, "", words)
    n = split(words, part, ",")
    for (i = 1; i <= n; ++i) {
        sub(/^[0-9A-Z]+:/, "", part[i])
        sub(/^!/, "", part[i])
        phrases[name] = phrases[name] "," part[i]
    }
    phrases[name] = phrases[name] "," name
    next
}
which < 6 { next }

# ---- pieces
function piece(html) {
    print "\001" ++count "\n" html > pieces
    return count
}
function inline(html) { return "QZ" piece(html) "ZQ" }
function block(html) { return "\n\nQB" piece(html) "BQ\n\n" }
function known(label) {
    if (!(label in page_of)) {
        fail("nothing is labelled " label)
        return 0
    }
    return 1
}
function href(label) {
    if (kind_of[label] == "source")
        return page_of[label] ".html#" substr(label, 5)
    return (page_of[label] == page ? "" : page_of[label] ".html") "#" anchor(label)
}
function link(label, words) {
    return known(label) ? "<a href=\"" href(label) "\">" words "</a>" : words
}

# ---- code
# Returns code, without comments and strings, as HTML in which names that src/ defines lead
# to their page there: functions where they are called, structs behind that word.
function names_linked(s, before,    out, name, label) {
    out = ""
    while (match(s, /[A-Za-z_][A-Za-z_0-9]*/)) {
        name = substr(s, RSTART, RLENGTH)
        out = out escaped(substr(s, 1, RSTART - 1))
        s = substr(s, RSTART + RLENGTH)
        label = "src:" name
        if ((label in page_of) && (out == "" ? before : out) !~ /(\.|-&gt;|[0-9])$/ && \
            (number_of[label] == "function" ? s ~ /^\(/ : \
            number_of[label] != "struct" || (before out) ~ /<b>(struct|union|enum)<\/b> $/))
            name = link(label, name)
        out = out name
    }
    return out escaped(s)
}
# Returns a line of code, as noweb writes it for TeX, as HTML. A comment or string that is
# continued in the next line is closed, and opened again there.
function code_html(s,    out, c, words, label, n) {
    out = ""
    n = 0
    while (match(s, /[\\{}]/)) {
        out = out (n > 0 ? escaped(substr(s, 1, RSTART - 1)) : \
            names_linked(substr(s, 1, RSTART - 1), out))
        s = substr(s, RSTART)
        if (s ~ /^\\[\\{}]/) {
            out = out escaped(substr(s, 2, 1))
            s = substr(s, 3)
        } else if (s ~ /^[{]\\nw(keyword|comment|string)[{][}]/) {
            c = substr(s, 5, 1)
            c = (c == "k" ? "b" : c == "c" ? "i" : "s") ">"
            out = out "<" c
            closing[++n] = "</" c
            s = substr(s, index(s, "{}") + 2)
        } else if (s ~ /^[}]/) {
            if (n > 0)
                out = out closing[n--]
            s = substr(s, 2)
        } else if (s ~ /^\\nwlinkedidentc[{]/) {
            words = argument(s, 16)
            label = argument(s, after)
            s = substr(s, after)
            words = escaped(unescaped(words))
            out = out (label == chunk ? words : link(label, words))
        } else if (s ~ /^\\LA[{][}]/) {
            match(s, /~[{]\\nwtagstyle[{][}]\\subpageref[{]NW[^}]*[}][}]\\RA[{][}]/)
            words = title_html(substr(s, 6, RSTART - 6))
            match(s, /\\subpageref[{]NW[^}]*[}]/)
            label = substr(s, RSTART + 12, RLENGTH - 13)
            s = substr(s, index(s, "\\RA{}") + 5)
            out = out "<span class=\"ref\">\342\237\250" link(label, words) "\342\237\251</span>"
        } else if (s ~ /^\\edoc|^\\nwendquote/) {
            sub(/^\\[a-z]+([{][}])?/, "", s)
        } else {
            out = out escaped(substr(s, 1, 1))
            s = substr(s, 2)
        }
    }
    out = out (n > 0 ? escaped(s) : names_linked(s, out))
    while (n > 0)
        out = out closing[n--]
    gsub(/<\/i><i>/, "", out)
    gsub(/<\/s><s>/, "", out)
    return out
}
function list_of(s, macro,    at) {
    at = index(s, macro "{")
    return at ? argument(s, at + length(macro)) : ""
}
function begin_chunk(s,    name, first, prev, next_, rest) {
    chunk = ""
    if (match(s, /\\sublabel[{]NW[^}]*[}]/))
        chunk = substr(s, RSTART + 10, RLENGTH - 11)
    name = argument(s, index(s, "\\moddef{") + 7)
    sub(/~[{]\\nwtagstyle[{][}].*/, "", name)
    name = title_html(name)
    prev = next_ = ""
    if (rest = index(s, "\\nwprevnextdefs")) {
        prev = argument(s, rest + 15)
        next_ = argument(s, after)
    }
    chunk_head = chunk == "" ? "<span>" name "</span>" : \
        "<a href=\"#" anchor(chunk) "\">\342\237\250" name "\342\237\251</a>" \
        (index(s, "\\plusendmoddef") ? "+" : "") \
        (index(s, "\\endquotedef") ? "" : "\342\211\241")
    chunk_name = name
    chunk_nav = ""
    if (prev ~ /^NW/)
        chunk_nav = chunk_nav " " link_named(prev, "\342\206\221", "where it was before")
    if (next_ ~ /^NW/)
        chunk_nav = chunk_nav " " link_named(next_, "\342\206\223", "where it goes on")
    lines = 0
}
function link_named(label, sign, words) {
    return known(label) ? "<a href=\"" href(label) "\" title=\"" words \
        "\" aria-label=\"" words "\">" sign "</a>" : ""
}
function end_chunk(s,    notes, rest, label, n, i, part, sep, out, name, id, words) {
    notes = ""
    rest = list_of(s, "\\nwused")
    if (rest != "") {
        sep = "Used in "
        while (match(rest, /NW[^}]*/)) {
            label = substr(rest, RSTART, RLENGTH)
            rest = substr(rest, RSTART + RLENGTH)
            if (known(label) && !((chunk, label) in said_used)) {
                notes = notes sep "<a href=\"" href(label) "\">" title_of[label] "</a>"
                sep = ", "
            }
        }
        notes = notes (notes == "" ? "" : ". ")
    } else if (index(s, "\\nwnotused"))
        notes = "The file <code>src/" \
            escaped(unescaped(list_of(s, "\\nwnotused"))) "</code>. "
    rest = list_of(s, "\\nwidentdefs")
    sep = "Defines "
    while (match(rest, /\\nwixident[{]/)) {
        rest = substr(rest, RSTART + RLENGTH - 1)
        name = argument(rest, 1)
        rest = substr(rest, after + 1)
        id = argument(rest, 1)
        sub(/@@.*/, "", name)
        name = unescaped(name)
        words = "<code>" escaped(name) "</code>"
        notes = notes sep (("src:" name) in page_of ? link("src:" name, words) : words)
        sep = ", "
    }
    if (sep == ", ")
        notes = notes ". "
    out = "<div class=\"chunk\"" (chunk == "" ? "" : " id=\"" anchor(chunk) "\"") ">" \
        "<div class=\"name\">" chunk_head \
        (chunk_nav == "" ? "" : "<span class=\"go\">" chunk_nav "</span>") "</div>" \
        (notes == "" ? "" : "<p class=\"note\">" notes "</p>") \
        "<pre tabindex=\"0\"><code>"
    while (lines > 0 && code[lines] == "")
        --lines
    for (i = 1; i <= lines; ++i)
        out = out code[i] "\n"
    return block(out "</code></pre></div>")
}

# ---- words of the glossary, at the marks that terms has set
function mark_terms(s,    from, n, name, at, word, m) {
    from = 1
    while (match(substr(s, from), /\\termmark[{][0-9]+[}]/)) {
        at = from + RSTART - 1
        m = RLENGTH
        n = substr(s, at + 10, m - 11)
        name = term_at[n]
        s = substr(s, 1, at - 1) "\\termmark{" n "}" substr(s, at + m)
        from = at + m
        if (name in glossed) {
            word = word_before(s, at, name)
            if (word > 0) {
                s = substr(s, 1, word - 1) "\\glossary{" name "}{" \
                    substr(s, word, word_length) "}" substr(s, word + word_length)
                from += length("\\glossary{" name "}{}")
            }
        }
    }
    return s
}
# Returns the place in s before `at', and nearest to it, of a phrase of the term, outside
# formulas and outside braces other than those of \textbf and \emph; 0 if there is none.
function word_before(s, at, name,    low, n, part, i, p, best, k, from, w, before) {
    low = tolower(substr(s, 1, at - 1))
    gsub(/[\n~]/, " ", low)
    n = split(phrases[name], part, ",")
    best = 0
    for (i = 1; i <= n; ++i) {
        w = tolower(part[i])
        if (w == "" || w ~ /[$\\]/)
            continue
        from = 1
        while ((p = index(substr(low, from), w)) > 0) {
            p += from - 1
            from = p + 1
            if (substr(low, p + length(w), 1) ~ /[a-z]/ || \
                (p > 1 && substr(low, p - 1, 1) ~ /[a-z\\]/))
                continue
            if (p < best || (p == best && length(w) <= word_length))
                continue
            before = substr(s, 1, p - 1)
            if (plain_at(before)) {
                best = p
                word_length = length(w)
            }
        }
    }
    return best
}
function plain_at(before,    open, shut, dollars, tail) {
    sub(/^.*\n\n/, "", before)
    gsub(/\\[${}\\&%_#]/, "", before)
    dollars = gsub(/[$]/, "$", before)
    open = gsub(/[{]/, "{", before)
    shut = gsub(/[}]/, "}", before)
    if (dollars % 2)
        return 0
    tail = before
    sub(/.*[{]/, "", tail)
    if (open == shut)
        return before !~ /\\[a-z]*(\[[^]]*)?$/
    return open == shut + 1 && \
        before ~ /\\(textbf|emph)[{][^{}\\]*$/
}

# ---- TeX
# Returns a formula for pandoc, with the numbers of the runs, and with references as text.
function math_tex(s,    out, name, opt, a, b, label) {
    out = ""
    while (match(s, /\\(result|datum|ref|eqref|mbox|termmark|phantom)[^A-Za-z]/)) {
        name = substr(s, RSTART + 1, RLENGTH - 2)
        out = out substr(s, 1, RSTART - 1)
        s = substr(s, RSTART + RLENGTH - 1)
        if (name == "result" || name == "datum") {
            out = out "{" value(name, s) "}"
            s = substr(s, after)
            continue
        }
        label = argument(s, 1)
        s = substr(s, after)
        if (name == "mbox")
            out = out "\\text{" math_tex(label) "}"
        else if (name ~ /ref$/)
            out = out "\\text{" (name == "eqref" ? "(" : "") \
                (known(label) ? number_of[label] : "") (name == "eqref" ? ")" : "") "}"
    }
    out = out s
    gsub(/\n/, " ", out)
    gsub(/\\(big|Big|bigg|Bigg)[lrm]?[^A-Za-z]/, "\001&", out)
    gsub(/\001\\(big|Big|bigg|Bigg)[lrm]?/, "", out)
    gsub(/\\allowbreak/, "", out)
    gsub(/\\lg /, "\\operatorname{lg} ", out)
    gsub(/\\lg\\/, "\\operatorname{lg}\\", out)
    gsub(/\\lg([^a-z])/, "\\operatorname{lg}&", out)
    gsub(/[{]lg[}]\\lg/, "{lg}", out)
    gsub(/\\varpi/, "{\\text{\317\226}}", out)
    gsub(/\\begin[{]smallmatrix[}]/, "\\begin{matrix}", out)
    gsub(/\\end[{]smallmatrix[}]/, "\\end{matrix}", out)
    return out
}
# Returns the number of \result[options]{run}{key} or \datum[options]{table}{row}{column};
# s begins behind the name of the macro.
function value(name, s,    option, at, key) {
    at = 1
    while (substr(s, at, 1) ~ /[ \n]/)
        ++at
    option = ""
    if (substr(s, at, 1) == "[") {
        option = substr(s, at + 1, index(s, "]") - at - 1)
        at = index(s, "]") + 1
    }
    gsub(/[ \n]+/, " ", option)
    key = name ":" argument(s, at)
    key = key ":" argument(s, after)
    if (name == "datum")
        key = key ":" argument(s, after)
    key = key ":" option
    gsub(/\n/, " ", key)
    if (!(key in result)) {
        fail(key " is not in results.tex")
        return "?"
    }
    return result[key]
}
function cites(option, keys,    n, part, i, out, key) {
    n = split(keys, part, / *, */)
    out = "["
    for (i = 1; i <= n; ++i) {
        key = "cite." part[i]
        gsub(/[ \n]/, "", key)
        out = out (i > 1 ? ", " : "") link(key, number_of[key])
    }
    return inline(out) (option == "" ? "" : ", " option) "]"
}
# Returns quoted code as HTML, with links from the names that it has.
function quoted_code(s,    out, at, words, label) {
    out = ""
    gsub(/\n/, " ", s)
    while ((at = index(s, "\\nwlinkedidentq{")) > 0) {
        out = out escaped(unescaped(substr(s, 1, at - 1)))
        s = substr(s, at + 15)
        words = escaped(unescaped(argument(s, 1)))
        label = argument(s, after)
        s = substr(s, after)
        out = out link(label, words)
    }
    out = out escaped(unescaped(s))
    gsub(/~/, " ", out)
    return out
}
# Sets the arguments of macros: m is one in braces; t one in braces that is typeset; o an
# optional one in brackets; * an optional star; _ an optional blank behind the name.
function takes(kinds, names,    n, name) {
    n = split(names, name, " ")
    while (n > 0)
        taken_by[name[n--]] = kinds
}
BEGIN {
    takes("m", "ref eqref nameref cfile prog opt texttt nolinkurl termmark label noalign " \
        "refstepcounter doi arxiv url livefigure transcript solutions input begin end bibitem")
    takes("t", "mbox centerline symbolpart answer")
    takes("o", "suppressfloats pagebreak")
    takes("_", "jewel noindent small allowbreak raggedright centering scriptsize " \
        "footnotesize arraybackslash begingroup endgroup endhead")
    takes("om", "cite indexed")
    takes("mt", "glossary")
    takes("tm", "texorpdfstring")
    takes("mm", "setlength rule boxline projectrubric")
    takes("omt", "plotfigure term")
    takes("ot", "caption")
    takes("*om", "chapter section subsection")
    takes("mom", "newcommand")
    # The HTML for environments that pandoc does not know.
    opening["chapterbox"] = "<dl class=\"box\">"
    opening["terms"] = "<dl class=\"terms\">"
    closing_of["chapterbox"] = closing_of["terms"] = "</dl>"
    closing_of["exercise"] = "</section>"
    closing_of["question"] = closing_of["labsheet"] = closing_of["reading"] = "</div>"
    closing_of["table"] = "</figure>"
}
# Puts the arguments of a macro, which s begins with, into arg[]; returns the rest of s.
function take(kinds, s, arg,    i, n, kind, words) {
    split("", arg)
    for (i = 1; i <= length(kinds); ++i) {
        kind = substr(kinds, i, 1)
        if (kind == "*")
            sub(/^[*]/, "", s)
        else if (kind == "_")
            sub(/^ /, "", s)
        else if (kind == "o") {
            if (s ~ /^\[/) {
                words = close_of(s)
                arg["o"] = substr(s, 2, words - 2)
                s = substr(s, words + 1)
            }
        } else {
            words = argument(s, 1)
            s = substr(s, after)
            arg[++n] = kind == "t" ? tex(words) : words
        }
    }
    return s
}
function tex(s,    out, name, at, words, label, arg) {
    out = ""
    while (match(s, /[\\$]/)) {
        out = out substr(s, 1, RSTART - 1)
        s = substr(s, RSTART)
        if (substr(s, 1, 1) == "$") {
            s = substr(s, 2)
            # Dollars within \mbox{} would be formulas of their own.
            at = index(s, "$")
            if (at == 0)
                fail("a formula that does not end: $" substr(s, 1, 60))
            out = out "$" math_tex(substr(s, 1, at - 1)) "$"
            s = substr(s, at + 1)
            continue
        }
        if (substr(s, 1, 2) == "\\[") {
            at = index(s, "\\]")
            while (at && substr(s, at - 1, 1) == "\\") # \\[2pt]
                at += index(substr(s, at + 2), "\\]") + 1
            out = out block("<div class=\"formula\">") "\\[" \
                math_tex(substr(s, 3, at - 3)) "\\]" block("</div>")
            s = substr(s, at + 2)
            continue
        }
        if (!match(s, /^\\[A-Za-z]+/)) {
            if (substr(s, 2, 1) == "/") { # between letters that touch
                s = substr(s, 3)
                continue
            }
            if (s ~ /^\\\\\*/)
                s = "\\\\" substr(s, 4)
            out = out substr(s, 1, 2)
            s = substr(s, 3)
            if (substr(out, length(out)) == "\\" && match(s, /^\[[0-9.a-z\\]*\]/))
                s = substr(s, RLENGTH + 1)
            continue
        }
        name = substr(s, 2, RLENGTH - 1)
        s = take(taken_by[name], substr(s, RLENGTH + 1), arg)
        label = words = arg[1]
        if (name == "Tt") {
            at = index(s, "\\nwendquote}")
            words = substr(s, 3, at - 3)
            s = substr(s, at + 12)
            out = substr(out, 1, length(out) - 1) \
                inline("<code>" quoted_code(words) "</code>")
        } else if (name == "ref")
            out = out inline(link(label, number_of[label] != "" ? number_of[label] : title_of[label]))
        else if (name == "eqref")
            out = out inline(link(label, "(" number_of[label] ")"))
        else if (name == "nameref")
            out = out inline(link(label, title_of[label]))
        else if (name == "cite")
            out = out cites(tex(arg["o"]), words)
        else if (name == "result" || name == "datum") {
            out = out "$" value(name, s) "$"
            s = substr(s, after)
        } else if (name ~ /^(cfile|prog|opt|texttt|nolinkurl)$/)
            out = out (words ~ /[$]|\\(textbf|emph)/ ? "\\texttt{" tex(words) "}" : \
                inline("<code>" quoted_code(words) "</code>"))
        else if (name == "termmark") {
            if (seen_mark[words]++ == 0)
                out = out inline("<a id=\"term." words "\"></a>")
        } else if (name == "glossary")
            out = out inline("<a class=\"term\" href=\"" \
                (page == "D-glossary" ? "" : "D-glossary.html") "#gloss." \
                anchor(words) "\">") arg[2] inline("</a>")
        else if (name == "label")
            out = out inline("<a id=\"" anchor(label) "\"></a>")
        else if (name == "allowbreak")
            out = out inline("<wbr>")
        else if (name == "smallskip" || name == "par")
            out = out "\n\n"
        else if (name ~ /^(mbox|centerline|texorpdfstring)$/)
            out = out words
        else if (name == "tabularnewline")
            out = out "\\\\"
        else if (name == "refstepcounter")
            ++failures
        else if (name == "thefailure")
            out = out failures
        else if (name == "symbolpart")
            out = out "\\multicolumn{5}{l}{\\textbf{" words "}}\\\\"
        else if (name == "doi" || name == "arxiv" || name == "url")
            out = out inline("<a href=\"" (name == "doi" ? "https://doi.org/" : name == "url" ? \
                "" : "https://arxiv.org/abs/") attribute(unescaped(words)) "\">" (name == "doi" ? \
                "doi:" : name == "url" ? "" : "arXiv:") escaped(unescaped(words)) "</a>")
        else if (name == "plotfigure")
            out = out figure(label, arg[2])
        else if (name == "livefigure")
            out = out block("<div class=\"live\" data-live=\"" attribute(words) "\"></div>")
        else if (name == "transcript")
            out = out transcript(words)
        else if (name == "boxline") {
            words = tex(words)
            out = out block("<div><dt>") words block("</dt><dd>")
            out = out tex(arg[2]) block("</dd></div>")
        } else if (name == "term")
            out = out glossary_entry(label, arg[2])
        else if (name == "solutions") {
            wants_solutions = words
            out = out "\n\n"
        } else if (name == "projectrubric")
            out = out project_rubric(words, arg[2])
        else if (name == "answer")
            out = out block("<div class=\"question\">") "\\textbf{Question~" \
                ++answers "} " words block("</div>")
        else if (name ~ /^(chapter|section|subsection)$/) {
            # The labels of the heading are in `heads'.
            while (match(s, /^ *\\label[{][^}]*[}]/))
                s = substr(s, RLENGTH + 1)
            out = out heading_piece(name == "chapter" ? 0 : name == "section" ? 1 : 2)
        } else if (name == "caption") {
            label = ""
            if (match(s, /^[ \n]*\\label[{][^}]*[}]/)) {
                label = argument(s, index(s, "{"))
                s = substr(s, after)
            }
            out = out block("<figure class=\"table\" id=\"" anchor(label) \
                "\"><figcaption>") "\\textbf{Table~" \
                (known(label) ? number_of[label] : "") ".} " words block("</figcaption>")
        } else if (name == "input") {
            sub(/^\\projectroot */, "", words)
            words = all_of(words)
            gsub(/\\newcounter[{][a-z]*[}]/, "", words)
            out = out tex(words)
        } else if (name == "begin") {
            if (words ~ /^(equation|gather|align)[*]?$|^(tabular|longtable)$/) {
                at = index(s, "\\end{" words "}")
                if (!at)
                    fail(words " does not end")
                label = substr(s, 1, at - 1)
                s = substr(s, at + length("\\end{" words "}"))
                if (words ~ /^(tabular|longtable)$/) {
                    label = take("om", label, arg)
                    out = out table(arg[1], label)
                } else
                    out = out equation(label, words)
            } else if (words == "exercise") {
                s = take("mmmm", s, arg)
                out = out exercise(arg[1], title_html(arg[2]), arg[3], arg[4])
            } else if (words == "labsheet") {
                s = take("o", s, arg)
                out = out block("<div class=\"labsheet\">") heading_piece(1)
                questions = 0
            } else if (words == "question")
                out = out block("<div class=\"question\">") "\\textbf{Question~" \
                    ++questions "} "
            else if (words == "reading")
                out = out block("<div class=\"reading\">") "\\begin{itemize}"
            else if (words in opening)
                out = out block(opening[words])
            else if (words == "rubric")
                out = out "\\emph{Ten points.}\n\n\\begin{description}"
            else if (words ~ /^(center|picture|table)$/) {
                s = take("o", s, arg)
                out = out "\n\n"
            } else if (words == "thebibliography") {
                s = take("m", s, arg)
                out = out block("<ol class=\"references\">")
            } else
                out = out "\\begin{" words "}"
        } else if (name == "end") {
            if (words == "thebibliography")
                out = out bibitem_end() block("</ol>")
            else if (words in closing_of)
                out = out (words == "reading" ? "\\end{itemize}" : "") \
                    block(closing_of[words]) (words == "labsheet" ? lab_answers() : "")
            else if (words == "rubric")
                out = out "\\end{description}"
            else if (words == "center")
                out = out "\n\n"
            else
                out = out "\\end{" words "}"
        } else if (name == "bibitem") {
            out = out bibitem_end() block("<li id=\"" anchor("cite." label) "\">")
            in_item = 1
        } else if (name == "newblock")
            out = out " "
        else if (name ~ /^(emph|em|textbf|textit|textsf|item|multicolumn|hline)$/)
            out = out "\\" name
        else if (name ~ /^(quad|qquad|ldots|dots|LaTeX|i)$/) {
            # The next word may be one that stands for a piece.
            sub(/^[ \n]+|^[{][}]/, "", s)
            out = out "\\" name "{}"
        } else if (taken_by[name] == "") {
            # pandoc would drop it and its arguments without a message.
            fail("what is \\" name "?")
            out = out name
        }
    }
    return out s
}
# Returns the text of a file, and notes that the page is made from it.
function all_of(path,    text, line) {
    while ((getline line < path) > 0)
        text = text line "\n"
    close(path)
    read_too[path] = 1
    if (text == "")
        fail("cannot read " path)
    return text
}
function bibitem_end() {
    if (!in_item)
        return ""
    in_item = 0
    return block("</li>")
}
# Returns where an argument in brackets ends, which may contain braces; 0 if nowhere.
function close_of(s,    i, depth, c) {
    for (i = 2; i <= length(s); ++i) {
        c = substr(s, i, 1)
        if (c == "{")
            ++depth
        else if (c == "}")
            --depth
        else if (c == "]" && depth == 0)
            return i
    }
    return 0
}
function figure(name, caption,    line, width, height, alt, svg) {
    svg = "build/figures/" name ".svg"
    while ((getline line < svg) > 0) {
        if (match(line, /width="[0-9.]+" height="[0-9.]+"/))
            width = substr(line, RSTART, RLENGTH)
        if (line ~ /<desc>/) {
            alt = line
            while (line !~ /<\/desc>/ && (getline line < svg) > 0)
                alt = alt " " line
            sub(/.*<desc>/, "", alt)
            sub(/<\/desc>.*/, "", alt)
            gsub(/"/, "\\&quot;", alt)
        }
        if (alt != "" && width != "")
            break
    }
    close(svg)
    read_too[svg] = 1
    if (alt == "" || width == "")
        fail(svg " has no size or no description")
    return block("<figure id=\"fig:" name "\"><figcaption>") "\\textbf{Figure~" \
        (known("fig:" name) ? number_of["fig:" name] : "") ".} " caption \
        block("<span class=\"file\">" name "</span></figcaption>" \
        "<img src=\"figures/" name ".svg\" " width " alt=\"" alt \
        "\" loading=\"lazy\"></figure>")
}
function equation(s, env,    label, number) {
    label = ""
    if (match(s, /\\label[{][^}]*[}]/)) {
        label = substr(s, RSTART + 7, RLENGTH - 8)
        s = substr(s, 1, RSTART - 1) substr(s, RSTART + RLENGTH)
    }
    gsub(/^[ \n%]+/, "", s)
    if (env ~ /^(gather|align)/)
        s = "\\begin{" (env ~ /^g/ ? "gathered" : "aligned") "}" s "\\end{" \
            (env ~ /^g/ ? "gathered" : "aligned") "}"
    if (label == "")
        return block("<div class=\"formula\">") "\\[" math_tex(s) "\\]" block("</div>")
    number = known(label) ? number_of[label] : ""
    return block("<div class=\"formula\" id=\"" anchor(label) "\">") "\\[" math_tex(s) \
        "\\]" block("<a class=\"number\" href=\"#" anchor(label) "\">(" number ")</a></div>")
}
# Returns a table with the kinds of columns that pandoc knows.
function table(columns, body,    out, c, at, n, row, i, head, last) {
    out = ""
    while (columns != "") {
        c = substr(columns, 1, 1)
        if (c ~ /[lcr]/) {
            out = out c
            columns = substr(columns, 2)
        } else if (c == "p" || c == "@" || c == ">" || c == "<" || c == "!") {
            argument(columns, 2)
            columns = substr(columns, after)
            if (c == "p")
                out = out "l"
        } else
            columns = substr(columns, 2)
    }
    gsub(/%\n/, "\n", body)
    gsub(/\\endhead/, "", body)
    while (match(body, /\\multicolumn[{][0-9]+[}][{]/)) {
        at = RSTART
        head = RLENGTH
        c = substr(body, at + 13, RLENGTH - 15)
        sub(/[}].*/, "", c)
        row = argument(body, at + head - 1)
        i = row ~ /r/ ? "r" : row ~ /c/ ? "c" : "l"
        body = substr(body, 1, at - 1) "\001{" c "}{" i "}" substr(body, after)
    }
    gsub(/\001/, "\\multicolumn", body)
    return "\n\n" block("<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"table\">") \
        "\\begin{tabular}{" out "}" tex(body) "\\end{tabular}" block("</div>") 
}
function transcript(name,    line, n, part, out) {
    n = split(all_of("build/runs/" name ".txt"), part, "\n")
    for (line = 1; line < n; ++line)
        out = out (part[line] ~ /^\$/ ? "<b>" escaped(part[line]) "</b>" : escaped(part[line])) "\n"
    return block("<pre class=\"run\" tabindex=\"0\">" out "</pre>")
}
function exercise(name, title, kind, minutes,    label) {
    label = "ex:" name
    return block("<section class=\"exercise\" id=\"" label "\"><h3><a href=\"#" label \
        "\"><span class=\"number\">Exercise " (known(label) ? number_of[label] : "") \
        "</span> " title "</a> <small>" kind ", " minutes " minutes</small></h3><p class=\"do\"><code>" \
        ((name in file_of) ? file_of[name] : "exercises/" name) \
        "</code> <code>make check EX=" name "</code></p>")
}
function glossary_entry(name, words,    where) {
    where = ""
    if (name in home && known("term." home[name]))
        where = " <small>(" link("term." home[name], number_of["term." home[name]] != "" ? \
            "section " number_of["term." home[name]] : "where") ")</small>"
    return block("<dt id=\"gloss." anchor(name) "\">" title_html(name) "</dt><dd>") words \
        inline(where) block("</dd>")
}
# Returns the next heading of this page, which is read from `heads'.
function heading_piece(level,    line, part, n, label, i, out, id, tag) {
    while ((n = (getline line < heads)) > 0) {
        split(line, part, "\t")
        if (part[1] == page)
            break
    }
    if (n <= 0 || part[2] != level) {
        fail("a heading is not where it was: " line)
        return ""
    }
    n = split(part[5], label, " ")
    id = anchor(label[1])
    out = ""
    for (i = 2; i <= n; ++i)
        out = out "<a id=\"" anchor(label[i]) "\"></a>"
    tag = "h" (level + 1)
    section = part[3]
    return block("<" tag " id=\"" id "\">" out "<a href=\"#" id "\">" \
        (part[3] == "" ? "" : "<span class=\"number\">" part[3] "</span> ") part[4] \
        "</a></" tag ">")
}
function lab_answers(    name) {
    if (edition != "instructor")
        return ""
    name = page
    sub(/-.*/, "", name)
    answers = 0
    return block("<div class=\"labsheet\"><h2 id=\"to-the-lab-sheet\">To the lab sheet</h2>") \
        tex(all_of("build/book-instructor/lab-" name ".tex")) block("</div>")
}
function project_rubric(project, title) {
    if (edition != "instructor")
        return ""
    return block("<h3 id=\"rubric-" project "\">" project ". " title "</h3>") \
        tex(all_of("build/book-instructor/rubric-" project ".tex"))
}

# ---- the chapter, line by line
function flush(    number) {
    if (text ~ /[^ \n]/)
        print tex(mark_terms(text)) "\n"
    text = ""
    number = wants_solutions
    wants_solutions = ""
    if (number != "" && edition == "instructor")
        solutions(number)
}
function solutions(number,    name, line) {
    name = "build/book-instructor/solutions-" number ".tex"
    print block("<h2 id=\"solutions" (solved++ ? "-" solved : "") "\">Solutions</h2>")
    while ((getline line < name) > 0)
        line_of(line)
    close(name)
    read_too[name] = 1
    flush()
}
function line_of(s,    at) {
    if (in_code) {
        at = index(s, "\\nwendcode{}")
        if (!at) {
            if (s ~ /\\eatline$/)
                ender = ender s
            else
                code[++lines] = code_html(s)
            return
        }
        ender = ender substr(s, 1, at - 1)
        in_code = 0
        print end_chunk(ender)
        s = substr(s, at + 12)
        if (s == "")
            return
    }
    if (verbatim) {
        if (s ~ /^\\end[{]verbatim[}]/) {
            text = text block(verbatim "</pre>")
            verbatim = ""
        } else
            verbatim = verbatim escaped(s) "\n"
        return
    }
    sub(/\\nwfilename[{][^}]*[}]/, "", s)
    sub(/\\nwbegindocs[{][0-9]*[}]/, "", s)
    sub(/\\nwdocspar/, "", s)
    if ((at = index(s, "\\nwbegincode{")) > 0) {
        if ((chunk = index(s, "\\nwenddocs{}")) > 1)
            text = text substr(s, 1, chunk - 1)
        flush()
        begin_chunk(substr(s, at))
        in_code = 1
        ender = ""
        return
    }
    sub(/\\nwenddocs[{][}]/, "", s)
    if (s ~ /^\\begin[{]verbatim[}]/) {
        flush()
        verbatim = "<pre class=\"run\" tabindex=\"0\">"
        return
    }
    if (s ~ /^%/)
        return
    if (match(s, /(^|[^\\])%/)) {
        s = substr(s, 1, RSTART + RLENGTH - 2)
        text = text s
        return
    }
    if (s ~ /^[ \t]*$/) {
        # A blank line within a list or a table does not end the paragraph.
        depth = gsub(/\\begin[{](itemize|enumerate|description|reading|quote|question|tabular|longtable|table|equation)[}]/, "&", text) - \
            gsub(/\\end[{](itemize|enumerate|description|reading|quote|question|tabular|longtable|table|equation)[}]/, "&", text)
        if (depth > 0)
            text = text "\n\n"
        else
            flush()
        return
    }
    text = text s "\n"
}
{ line_of($0) }
END {
    if (in_code)
        print end_chunk(ender)
    flush()
    printf "" > uses
    for (name in read_too)
        print name > uses
    if (failed)
        exit 1
}
