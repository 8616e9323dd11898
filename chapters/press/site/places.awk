# See places. Titles are HTML.
function say(kind, label, number, title) {
    if (label != "")
        print label "\t" page "\t" kind "\t" number "\t" title > (out "places.new")
}
FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    woven = file ~ /^[0-9A-Z].*\.tex$/
    sub(/\.tex$/, "", file)
    bibliography = FILENAME ~ /\.bbl$/
    order = FILENAME ~ /press/
    if (woven) {
        code = 0
        if (file in part_of)
            part = part_of[file]
    }
    split("", pending)
    bib = 0
}
bibliography && /^\\bibitem/ {
    match($0, /[{][^}]*[}]/)
    page = "references"
    say("cite", "cite." substr($0, RSTART + 1, RLENGTH - 2), ++bib, "")
    next
}
order && FNR == 1 { part = "" }
order && /^\\part[{]/ { part = argument($0, 6) }
order && /^\\appendix/ { part = "Appendices" }
order && match($0, /^\\bookchapter[{]/) {
    part_of[argument($0, RLENGTH)] = part
    if (part == "Appendices")
        lettered[argument($0, RLENGTH)] = 1
}
!woven { next }

# ---- code
/\\nwbegincode[{]/ {
    code = 1
    match($0, /\\sublabel[{]NW[^}]*[}]/)
    chunk = substr($0, RSTART + 10, RLENGTH - 11)
    at = index($0, "\\moddef{")
    name = argument($0, at + 7)
    sub(/~[{]\\nwtagstyle[{][}].*/, "", name)
    match($0, /\\moddef.*\\subpageref[{]NW[^}]*[}]/)
    first = substr($0, RSTART, RLENGTH)
    sub(/.*\\subpageref[{]/, "", first)
    sub(/[}].*/, "", first)
    if (!index($0, "\\plusendmoddef"))
        first = chunk
    say("chunk", chunk, first, title_html(name))
    next
}
code {
    if (!(at = index($0, "\\nwendcode{}")))
        next
    code = 0
    $0 = substr($0, at + 12)
}
{
    sub(/^(\\nwfilename[{][^}]*[}])?(\\nwbegindocs[{][0-9]*[}])?(\\nwdocspar)?/, "")
}

# ---- headings and what has a number
/\\termmark[{]/ {
    rest = $0
    while (match(rest, /\\termmark[{][0-9]+[}]/)) {
        say("term", "term." substr(rest, RSTART + 10, RLENGTH - 11), heading, "")
        rest = substr(rest, RSTART + RLENGTH)
    }
}
/^%/ { next }
/^\\begin[{]verbatim[}]/ { verbatim = 1 }
/^\\end[{]verbatim[}]/ { verbatim = 0 }
verbatim { next }
/^\\chapter[{]/ { head(0, $0) }
/^\\section[{*[]/ { head(1, $0) }
/^\\subsection[{*[]/ { head(2, $0) }
/^\\begin[{]labsheet[}]/ {
    title = "Lab sheet"
    if (match($0, /\[.*\]/))
        title = title ": " substr($0, RSTART + 1, RLENGTH - 2)
    head(1, "\\section{" title "}")
}
function head(level, s,    star, title, labels, number, n, part_of_label) {
    star = s ~ /^\\[a-z]*[*]/
    sub(/^\\[a-z]+[*]?\[([^][{}]|[{][^{}]*[}])*\]/, "\\head", s)
    # A title may go on in the next line.
    at = index(s, "{")
    while (gsub(/[{]/, "{", s) > gsub(/[}]/, "}", s) && (getline more) > 0)
        s = s " " more
    title = argument(s, at)
    s = substr(s, after)
    labels = ""
    while (match(s, /^ *\\label[{][^}]*[}]/)) {
        label = argument(s, index(s, "{"))
        if (index(" " labels " ", " " label " ") == 0)
            labels = labels (labels == "" ? "" : " ") label
        s = substr(s, after)
    }
    if (level == 0) {
        page = file
        unnamed = 0
        if (file ~ /^00-/)
            chapter = ""
        else if (file in lettered)
            chapter = sprintf("%c", 65 + appendix++)
        else
            chapter = ++chapters
        sections = subsections = equations = figures = tables = exercises = 0
        number = chapter
        ++pages
        page_line[pages] = page "\t" chapter "\t" title_html(title) "\t" part
        exercise_chapter = chapter ~ /^[0-9]$/ ? "0" chapter : chapter
    } else if (star || chapter == "")
        number = ""
    else if (level == 1) {
        number = chapter "." (++sections)
        subsections = 0
    } else
        number = chapter "." sections "." (++subsections)
    heading = number
    if (level == 0 || !(pages in page_files) || \
        index(" " page_files[pages] " ", " book/" file " ") == 0)
        page_files[pages] = page_files[pages] (page_files[pages] == "" ? "" : " ") \
            "book/" file
    title = title_html(title)
    print page "\t" level "\t" number "\t" title "\t" \
        (labels == "" ? "s" ++unnamed : labels) > (out "heads.new")
    n = split(labels, part_of_label, " ")
    for (at = 1; at <= n; ++at)
        say(level == 0 ? (chapter ~ /^[A-Z]$/ ? "appendix" : "chapter") : "section",
            part_of_label[at], number, title)
}
/\\begin[{]equation[}]/ {
    ++equations
}
/^\\plotfigure/ {
    ++figures
    s = $0
    sub(/^\\plotfigure(\[[^]]*\])?[{]/, "", s)
    while (index(s, "}") == 0 && (getline more) > 0)
        s = s more
    sub(/[}].*/, "", s)
    sub(/.*[{]/, "", s)
    say("figure", "fig:" s, chapter "." figures, "")
}
/^\\begin[{]table[}]/ { ++tables }
/^\\input[{]\\projectroot / {
    name = argument($0, 7)
    sub(/^\\projectroot /, "", name)
    while ((getline rest < name) > 0)
        made_by_a_run(rest)
    close(name)
}
# Tables that a run has written, with their own numbers.
function made_by_a_run(s) {
    if (s ~ /^\\begin[{]table[}]/)
        ++tables
    if (s ~ /\\refstepcounter[{]failure[}]/)
        ++failures
    if (match(s, /\\label[{]tab:[^}]*[}]/))
        say("table", substr(s, RSTART + 7, RLENGTH - 8), chapter "." tables, "")
    if (match(s, /\\label[{]fail:[^}]*[}]/))
        say("failure", substr(s, RSTART + 7, RLENGTH - 8), failures, "")
}
/^\\begin[{]exercise[}]/ {
    argument($0, 17)
    title = argument($0, after)
    say("exercise", "ex:" argument($0, 17),
        exercise_chapter sprintf("%c", 97 + exercises++), title_html(title))
}
/\\label[{](eq|tab):/ {
    rest = $0
    while (match(rest, /\\label[{](eq|tab):[^}]*[}]/)) {
        label = substr(rest, RSTART + 7, RLENGTH - 8)
        rest = substr(rest, RSTART + RLENGTH)
        if (label ~ /^eq:/)
            say("equation", label, chapter "." equations, "")
        else
            say("table", label, chapter "." tables, "")
    }
}
# Pages that no chapter makes.
function besides(page, title, part) {
    print page "\t\t" title "\t" part "\t" > (out "pages.new")
    print page "\t0\t\t" title "\ts1" > (out "heads.new")
}
END {
    besides("index", "Bonkers", "")
    for (i = 1; i <= pages; ++i)
        print page_line[i] "\t" page_files[i] > (out "pages.new")
    besides("references", "References", "Appendices")
    besides("terms", "Index of terms", "Appendices")
}
