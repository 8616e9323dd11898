# Writes a page around its text: head, bar, contents, links to the previous and the next
# page. Files: pages, heads, the text.
FNR == 1 { ++which }
which == 1 {
    split($0, part, "\t")
    ++pages
    name_of[pages] = part[1]
    number_of[pages] = part[2]
    title_of[pages] = part[3]
    part_of[pages] = part[4]
    if (part[1] == page)
        here = pages
    next
}
which == 2 {
    split($0, part, "\t")
    if (part[1] == page && part[2] == 1) {
        split(part[5], label, " ")
        ++sections
        section[sections] = "<li><a href=\"#" label[1] "\">" numbered(part[3], part[4]) "</a></li>"
        gsub(/<wbr>/, "", section[sections])
    }
    next
}
which == 3 && FNR == 1 { top() }
{ print }
END { if (here) bottom() }
function plain(s) {
    gsub(/<[^>]*>/, "", s)
    return s
}
function top(    i, last, title) {
    title = plain(numbered(number_of[here], title_of[here]))
    printf "%s", head_of(page == "index" ? "Bonkers: computational physics, one collision at a time" : \
        title " · Bonkers", "", \
        (here > 1 ? "<link rel=\"prev\" href=\"" name_of[here - 1] ".html\">\n" : "") \
        (here < pages ? "<link rel=\"next\" href=\"" name_of[here + 1] ".html\">\n" : ""))
    print "<script src=\"page.js\" defer></script>"
    print "</head>"
    print "<body" (page == "index" ? " class=\"front\"" : "") ">"
    print "<a class=\"skip\" href=\"#text\">To the text</a>"
    print "<header class=\"bar\">"
    print "<button type=\"button\" id=\"menu\" aria-expanded=\"false\" aria-controls=\"contents\">Contents</button>"
    print "<a class=\"home\" href=\"index.html\">Bonkers</a>"
    print "<span class=\"here\">" (page == "index" ? "" : numbered(number_of[here], title_of[here])) "</span>"
    print "<button type=\"button\" id=\"find\">Search</button>"
    print "<button type=\"button\" id=\"theme\">Dark</button>"
    print "</header>"
    print "<nav id=\"contents\" aria-label=\"Contents\">"
    print "<ul>"
    last = ""
    for (i = 1; i <= pages; ++i) {
        if (part_of[i] != last && part_of[i] != "")
            print "<li class=\"part\">" part_of[i] "</li>"
        last = part_of[i]
        if (i != here) {
            print "<li><a href=\"" name_of[i] ".html\">" \
                numbered(number_of[i], title_of[i]) "</a></li>"
            continue
        }
        print "<li><a href=\"#text\" aria-current=\"page\">" \
            numbered(number_of[i], title_of[i]) "</a>"
        if (sections) {
            print "<ul>"
            for (k = 1; k <= sections; ++k)
                print section[k]
            print "</ul>"
        }
        print "</li>"
    }
    print "</ul>"
    print "<p class=\"volume\"><a href=\"src/index.html\">All files of <code>src</code></a></p>"
    print "</nav>"
    print "<main id=\"text\" tabindex=\"-1\">"
}
function bottom() {
    print "</main>"
    print "<nav class=\"turn\" aria-label=\"Previous and next\">"
    if (here > 1)
        print "<a rel=\"prev\" href=\"" name_of[here - 1] ".html\"><span>Previous</span> " \
            numbered(number_of[here - 1], title_of[here - 1]) "</a>"
    if (here < pages)
        print "<a rel=\"next\" href=\"" name_of[here + 1] ".html\"><span>Next</span> " \
            numbered(number_of[here + 1], title_of[here + 1]) "</a>"
    print "</nav>"
    print "<footer><p>" (edition == "instructor" ? \
        "<strong>Instructor’s edition, with the worked solutions: not for students.</strong> " : "") \
        "Text and figures: <a href=\"https://creativecommons.org/licenses/by/4.0/\">CC BY 4.0</a>; code: MIT. " \
        "Keys: <kbd>←</kbd> <kbd>→</kbd> previous and next, <kbd>c</kbd> contents, " \
        "<kbd>/</kbd> search, <kbd>t</kbd> dark or light.</p></footer>"
    n = split(live, part, " ")
    if (n)
        print "<script src=\"live/live.js\"></script>"
    for (i = 1; i <= n; ++i)
        print "<script src=\"live/" part[i] ".js\"></script>"
    print "</body>"
    print "</html>"
}
