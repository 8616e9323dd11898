# The indexes of chunks and of identifiers, of both volumes.
FNR == 1 { ++which }
{ split($0, part, "\t") }
which == 1 { number_of[part[2]] = part[3]; next }
which == 2 {
    if (part[3] != "chunk")
        next
    page_of[part[1]] = part[2]
    title_of[part[1]] = part[5]
    if (part[4] == part[1]) {
        ++chunks
        first[chunks] = part[1]
    }
    defined[part[4]] = defined[part[4]] " " part[1]
    next
}
which == 3 {
    if (!(part[4] in page_of) || (part[1] == "" && !(part[2] in page_of)))
        next
    if (part[1] == "") {
        used[part[2]] = used[part[2]] " " part[4]
        next
    }
    if (!(part[2] in name_of)) {
        name_of[part[2]] = part[1]
        id[++idents] = part[2]
    }
    where[part[3], part[2]] = where[part[3], part[2]] " " part[4]
}
function links(list, bold,    n, i, part, out, seen) {
    n = split(list, part, " ")
    out = ""
    for (i = 1; i <= n; ++i) {
        if (part[i] in seen)
            continue
        seen[part[i]] = 1
        out = out (out == "" ? "" : ", ") "<a href=\"" page_of[part[i]] ".html#" part[i] "\">" \
            number_of[page_of[part[i]]] " " title_of[part[i]] "</a>"
    }
    return bold ? "<b>" out "</b>" : out
}
function key_of(s) {
    gsub(/<[^>]*>/, "", s)
    return tolower(s)
}
END {
    print page == "works-chunks" ? "<h1 id=\"s1\">Index of chunks</h1>" : \
        "<h1 id=\"s1\">Index of identifiers</h1>"
    print "<p>Of both volumes, with the number of the chapter: in bold where it is defined, behind that where it is used.</p>"
    print "<ul class=\"index\">"
    sort = "sort -t '\t' -k 1,1 | cut -f 2-"
    if (page == "works-chunks")
        for (i = 1; i <= chunks; ++i) {
            s = first[i]
            print key_of(title_of[s]) "\t<li>⟨" title_of[s] "⟩ " links(defined[s], 1) \
                (used[s] == "" ? "" : " · " links(used[s], 0)) "</li>" | sort
        }
    else
        for (i = 1; i <= idents; ++i) {
            s = id[i]
            print tolower(name_of[s]) "\t<li id=\"i." s "\"><code>" escaped(name_of[s]) "</code> " \
                links(where["d", s], 1) \
                (where["u", s] == "" ? "" : " · " links(where["u", s], 0)) "</li>" | sort
        }
    close(sort)
    print "</ul>"
}
