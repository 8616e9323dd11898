# Writes a page for each file of src/, with numbered lines and links from names to their
# definitions; index.html, which lists the files; and names.txt, the place of each name that
# other files can use (see places).
#
# Variables: out, the folder of the pages. Input: the items of all files, as
# chapters/press/quote --items writes them, then the README of each room and the files.

# ---- what is defined where
FNR == 1 { file = FILENAME }
file == "-" {
    ++items
    item_file[items] = $1
    from[items] = $2
    to[items] = $3
    kind[items] = $4
    names[items] = $0
    sub(/^[^ ]+ [^ ]+ [^ ]+ [^ ]+ /, "", names[items])
    next
}
file ~ /README\.md$/ {
    room = file
    sub(/^src\//, "", room)
    sub(/\/.*/, "", room)
    if (FNR == 1) {
        about[room] = $0
        sub(/^#+ /, "", about[room])
        sub(/^src\/[a-z]+: /, "", about[room])
    }
    next
}
FNR == 1 { list[++files] = file }
{ line[file, FNR] = $0; lines[file] = FNR }
# Returns the line of an item that has its name, outside comments; 0 if none has.
function line_of(k, name,    i, s, comment) {
    for (i = from[k]; i <= to[k]; ++i) {
        s = line[item_file[k], i]
        if (comment) {
            if (!index(s, "*/"))
                continue
            comment = 0
            sub(/^.*\*\//, "", s)
        }
        gsub(/\/\*([^*]|\*[^\/])*\*\//, "", s)
        if (index(s, "/*")) {
            comment = 1
            sub(/\/\*.*/, "", s)
        }
        if (match(s, "(^|[^A-Za-z_0-9])" name "([^A-Za-z_0-9]|$)"))
            return i
    }
    return 0
}
function find_definitions(    k, n, i, part, at, own, is_tag) {
    for (k = 1; k <= items; ++k) {
        if (kind[k] == "prototype" || kind[k] == "doubtful")
            continue
        n = split(names[k], part, " ")
        for (i = 1; i <= n; ++i) {
            is_tag = sub(/^(struct|union|enum):/, "", part[i])
            if (part[i] !~ /^[A-Za-z_][A-Za-z_0-9]*$/ || !(at = line_of(k, part[i])))
                continue
            own = item_file[k] SUBSEP part[i]
            if (own in defined)
                continue
            defined[own] = at
            name_at[item_file[k], at] = name_at[item_file[k], at] " " part[i]
            sort_of[own] = is_tag ? "struct" : kind[k]
            # A name without external linkage is linked in its own file only.
            if (item_file[k] ~ /\.c$/ && (kind[k] !~ /^(function|object)$/ ||
                line[item_file[k], at] ~ /^static / ||
                line[item_file[k], at - 1] ~ /^static [a-z_ *]*$/))
                continue
            if (part[i] in home)
                home[part[i]] = ""
            else
                home[part[i]] = item_file[k]
        }
    }
}

# ---- C as HTML
BEGIN {
    n = split("auto break case char const continue default do double else enum extern " \
        "float for goto if inline int long register restrict return short signed sizeof " \
        "static struct switch typedef union unsigned void volatile while _Alignas _Alignof " \
        "_Atomic _Bool _Complex _Generic _Noreturn _Static_assert _Thread_local bool true " \
        "false", word, " ")
    while (n > 0)
        keyword[word[n--]] = 1
}
function page_of(file) {
    sub(/^src\//, "", file)
    gsub(/\//, "-", file)
    return file
}
# Returns an identifier as HTML, with a link if it is defined; before and behind are the
# rest of its line.
function named(name, before, behind,    where, own, s) {
    if (name in keyword)
        return "<b>" name "</b>"
    where = (file, name) in defined ? file : home[name]
    own = where SUBSEP name
    if (where == "" || !(own in defined) || before ~ /(\.|->) *$/)
        return name
    s = sort_of[own]
    if ((s == "function" && behind !~ /^ *\(/) ||
        (s == "struct" && before !~ /(struct|union|enum) +$/))
        return name
    if (where == file && defined[own] == at)
        return name
    return "<a href=\"" (where == file ? "" : page_of(where) ".html") "#" name "\">" name "</a>"
}
function code(s,    out, before, rest) {
    out = before = ""
    while (s != "") {
        if (comment) {
            n = index(s, "*/")
            rest = n ? substr(s, 1, n + 1) : s
            comment = !n
            out = out "<i>" escaped(rest) "</i>"
        } else if (s ~ /^\/\*/) {
            comment = 1
            rest = ""
            n = index(substr(s, 3), "*/")
            rest = n ? substr(s, 1, n + 3) : s
            comment = !n
            out = out "<i>" escaped(rest) "</i>"
        } else if (match(s, /^("([^"\\]|\\.)*"|\047([^\047\\]|\\.)*\047)/) ||
            (before ~ /^#include *$/ && match(s, /^<[^>]*>/))) {
            rest = substr(s, 1, RLENGTH)
            n = substr(rest, 2, length(rest) - 2)
            out = out "<s>" (before ~ /^#include *$/ && (("src/" n) in lines) ? \
                "<a href=\"" page_of("src/" n) ".html\">" escaped(rest) "</a>" : escaped(rest)) "</s>"
        } else if (match(s, /^[A-Za-z_][A-Za-z_0-9]*/)) {
            rest = substr(s, 1, RLENGTH)
            out = out named(rest, before, substr(s, RLENGTH + 1))
        } else {
            match(s, /^([0-9][A-Za-z_0-9.]*|[^A-Za-z_0-9"\047\/]+|.)/)
            rest = substr(s, 1, RLENGTH)
            if (before ~ /^#include *$/ || (before == "" && rest ~ /^#include/))
                match(s, /^./)
            rest = substr(s, 1, RLENGTH)
            out = out escaped(rest)
        }
        before = before rest
        s = substr(s, length(rest) + 1)
    }
    return out
}

# ---- pages
function top(to, title, up) {
    print head_of(title " · Bonkers", "../", "") "</head>\n<body class=\"source\">\n" \
        "<header class=\"bar\"><a class=\"home\" href=\"../index.html\">Bonkers</a>" \
        "<span class=\"here\">" up "</span></header>\n<main>" > to
}
function sentence(file,    s, i) {
    for (i = 1; i <= 8; ++i)
        if (line[file, i] ~ /^\/\*/ && line[file, i] !~ /^\/\* (From|checksum) /) {
            s = line[file, i]
            while (!index(s, "*/") && i < lines[file])
                s = s " " line[file, ++i]
            gsub(/^\/\* *| *\*\/.*$/, "", s)
            gsub(/  +/, " ", s)
            sub(/\. .*/, ".", s)
            return escaped(s)
        }
    return ""
}
function write_file(    to, n, i, part, chapter, room) {
    to = out "/" page_of(file) ".html"
    top(to, file, "<a href=\"index.html\">src</a>")
    print "<h1><code>" file "</code></h1>" > to
    if (match(line[file, 1], /chapters\/[0-9A-Z][A-Za-z0-9-]*\.nw/)) {
        chapter = substr(line[file, 1], RSTART + 9, RLENGTH - 12)
        print "<p>Its lines stand in the book, where they are explained: <code>chapters/" \
            chapter ".nw</code>.</p>" > to
    }
    printf "<pre class=\"source\" tabindex=\"0\"><code>" > to
    comment = 0
    for (at = 1; at <= lines[file]; ++at) {
        printf "<span id=\"L%d\">", at > to
        n = split(name_at[file, at], part, " ")
        for (i = 1; i <= n; ++i)
            printf "<span id=\"%s\"></span>", part[i] > to
        print code(line[file, at]) "</span>" > to
    }
    print "</code></pre>\n</main>\n</body>\n</html>" > to
    close(to)
}
END {
    find_definitions()
    list_page = out "/index.html"
    top(list_page, "The files of src", "")
    print "<h1>The files of <code>src</code></h1>" > list_page
    for (k = 1; k <= files; ++k) {
        file = list[k]
        split(file, part, "/")
        if (part[2] != last)
            print (last == "" ? "" : "</dl>\n") "<h2><code>" part[2] "</code></h2>\n" \
                (part[2] in about ? "<p>" escaped(about[part[2]]) "</p>\n" : "") "<dl>" > list_page
        last = part[2]
        print "<dt><a href=\"" page_of(file) ".html\"><code>" part[3] "</code></a></dt><dd>" \
            sentence(file) "</dd>" > list_page
    }
    print "</dl>\n</main>\n</body>\n</html>" > list_page
    for (k = 1; k <= files; ++k) {
        file = list[k]
        write_file()
    }
    # The pages of the chapters link names to these places.
    for (name in home)
        if (home[name] != "" && sort_of[home[name], name] ~ /^(function|object|struct)$/)
            print name "\tsrc/" page_of(home[name]) "\tsource\t" sort_of[home[name], name] "\t" \
                > (out "/names.txt")
}
