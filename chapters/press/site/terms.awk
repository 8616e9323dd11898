# The index of terms: where each is introduced (in bold) and used.
FNR == 1 { ++which }
which == 1 {
    split($0, part, "\t")
    if (part[3] == "term") {
        page_of[part[1]] = part[2]
        number_of[part[1]] = part[4] != "" ? part[4] : "before 1"
    }
    next
}
FNR == 1 { print "<h1 id=\"s1\">Index of terms</h1>\n<p>The numbers are those of sections: in bold where a word is introduced.</p>\n<ul class=\"index\">" }
match($0, /^\\termline[{]/) {
    name = argument($0, RLENGTH)
    rest = argument($0, after)
    line = ""
    while (match(rest, /\\term(def|use)[{][0-9]+[}]/)) {
        kind = substr(rest, RSTART + 5, 3)
        mark = "term." substr(rest, RSTART + 9, RLENGTH - 10)
        rest = substr(rest, RSTART + RLENGTH)
        if (mark in page_of)
            line = line (line == "" ? " " : ", ") (kind == "def" ? "<b>" : "") \
                "<a href=\"" page_of[mark] ".html#" mark "\">" number_of[mark] "</a>" \
                (kind == "def" ? "</b>" : "")
    }
    print "<li>" title_html(name) line "</li>"
}
END { print "</ul>" }
