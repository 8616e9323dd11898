# See places. Titles are HTML.
function say(kind, label, number, title) {
    if (label != "")
        print label "\t" page "\t" kind "\t" number "\t" title > (out "places.new")
}
FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    volume = FILENAME ~ /^build\/works\// ? "works" : "book"
    woven = file ~ /^[0-9A-Z].*\.tex$/
    sub(/\.tex$/, "", file)
    bibliography = FILENAME ~ /\.bbl$/
    order = FILENAME ~ /press/
    if (woven) {
        code = 0
        if ((volume, file) in part_of)
            part = part_of[volume, file]
    }
    split("", pending)
    bib = 0
}
bibliography && /^\\bibitem/ {
    match($0, /[{][^}]*[}]/)
    page = volume == "works" ? "works-references" : "references"
    cited[volume] = 1
    say("cite", volume "." substr($0, RSTART + 1, RLENGTH - 2), ++bib, "")
    next
}
order && FNR == 1 { part = "" }
order && /^\\part[{]/ { part = argument($0, 6) }
order && /^\\workspart[{]/ { part = argument($0, 11) }
order && /^\\appendix/ { appendix_from[volume_here()] = 1; part = "Appendices" }
order && match($0, /^\\(book|works)chapter[{]/) {
    part_of[FILENAME ~ /works/ ? "works" : "book", argument($0, RLENGTH)] = part
    if (part == "Appendices")
        lettered[argument($0, RLENGTH)] = 1
}
function volume_here() { return FILENAME ~ /works\.tex/ ? "works" : "book" }
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
    if (match($0, /\\nw(indexdefn|indexuse)/)) {
        rest = $0
        while (match(rest, /\\nwindex(defn|use)[{]\\nwixident[{]/)) {
            kind = substr(rest, RSTART + 8, 1)
            rest = substr(rest, RSTART + RLENGTH - 1)
            name = argument(rest, 1)
            rest = substr(rest, after + 1)
            id = argument(rest, 1)
            rest = substr(rest, after)
            place = argument(rest, 1)
            sub(/@@.*/, "", name)
            print escaped(unescaped(name)) "\t" anchor(id) "\t" kind "\t" place \
                > (out "idents.new")
        }
    }
    rest = $0
    while ((at = index(rest, "\\LA{}")) > 0) {
        rest = substr(rest, at + 5)
        match(rest, /\\subpageref[{]NW[^}]*[}]/)
        place = substr(rest, RSTART + 12, RLENGTH - 13)
        print "\t" place "\tu\t" chunk > (out "idents.new")
    }
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
    while (match(s, /^ *\\(label|worksanchor)[{][^}]*[}]/)) {
        label = substr(s, RSTART, RLENGTH)
        sub(/.*[{]/, "", label)
        sub(/[}]/, "", label)
        if (index(" " labels " ", " " label " ") == 0)
            labels = labels (labels == "" ? "" : " ") label
        s = substr(s, RSTART + RLENGTH)
    }
    if (level == 0) {
        page = (volume == "works" ? "works-" : "") file
        files = volume "/" file
        if (volume == "book" && file ~ /^00-/)
            chapter = ""
        else if (volume == "book" && (file in lettered))
            chapter = sprintf("%c", 65 + appendix++)
        else
            chapter = (volume == "works" ? "W" : "") (++chapters[volume])
        sections = subsections = equations = figures = tables = exercises = 0
        number = chapter
        ++pages
        page_line[pages] = volume "\t" page "\t" chapter "\t" title_html(title) "\t" part
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
        index(" " page_files[pages] " ", " " volume "/" file " ") == 0)
        page_files[pages] = page_files[pages] (page_files[pages] == "" ? "" : " ") \
            volume "/" file
    title = title_html(title)
    print page "\t" level "\t" number "\t" title "\t" labels > (out "heads.new")
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
# Pages that no chapter makes: special writes them.
function besides(volume, page, title, part) {
    print volume "\t" page "\t\t" title "\t" part "\t" > (out "pages.new")
    print page "\t0\t\t" title "\t" > (out "heads.new")
}
END {
    besides("book", "index", "Bonkers", "")
    for (i = 1; i <= pages; ++i) {
        if (page_line[i] ~ /^works/ && !works++) {
            besides("book", "references", "References", "Appendices")
            besides("book", "terms", "Index of terms", "Appendices")
            besides("works", "works", "Works", "")
        }
        print page_line[i] "\t" page_files[i] > (out "pages.new")
    }
    if (cited["works"])
        besides("works", "works-references", "References of Works", "Indexes")
    besides("works", "works-chunks", "Index of chunks", "Indexes")
    besides("works", "works-identifiers", "Index of identifiers", "Indexes")
}
