# Functions for several filters: the arguments of macros, and short texts of TeX (titles,
# names of chunks and files) as HTML.

# Returns a heading's number and title.
function numbered(number, title) {
    return (number == "" ? "" : "<span class=\"number\">" number "</span> ") title
}
# Returns the head of a page, without its end; up is the path to the folder of page.css.
function head_of(title, up, lines) {
    return "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n" \
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" title \
        "</title>\n<link rel=\"stylesheet\" href=\"" up "page.css\">\n" lines \
        "<script>try{var t=localStorage.getItem(\"bonkers-theme\");if(t)document." \
        "documentElement.dataset.theme=t}catch(e){}</script>\n"
}
# Returns the argument in braces that begins at s[at], behind blanks, and sets after to the
# place behind it. Without an argument the program ends.
function argument(s, at,    depth, c, start, n) {
    while (substr(s, at, 1) ~ /^[ \n]$/)
        ++at
    if (substr(s, at, 1) != "{") {
        print "site: " FILENAME ": an argument is missing: " substr(s, 1, 80) \
            > "/dev/stderr"
        exit failed = 1
    }
    start = at + 1
    n = length(s)
    for (depth = 0; at <= n; ++at) {
        c = substr(s, at, 1)
        if (c == "\\")
            ++at
        else if (c == "{")
            ++depth
        else if (c == "}" && --depth == 0)
            break
    }
    after = at + 1
    return substr(s, start, at - start)
}
function escaped(s) {
    gsub(/&/, "\\&amp;", s)
    gsub(/</, "\\&lt;", s)
    gsub(/>/, "\\&gt;", s)
    return s
}
function attribute(s) {
    s = escaped(s)
    gsub(/"/, "\\&quot;", s)
    return s
}
# Returns a text without the backslashes and braces that TeX needs around characters.
function unescaped(s) {
    gsub(/[{]\\textbackslash[{][}][}]|\\textbackslash[{][}]/, "\001", s)
    while (match(s, /[{]\\[_#$%&{}][}]/))
        s = substr(s, 1, RSTART - 1) substr(s, RSTART + 2, 1) \
            substr(s, RSTART + 4)
    while (match(s, /\\[_#$%&{}]/))
        s = substr(s, 1, RSTART - 1) "\002" substr(s, RSTART + 1, 1) \
            substr(s, RSTART + 2)
    gsub(/\\allowbreak ?([{][}])?/, "", s)
    gsub(/\\slash ?([{][}])?/, "/", s)
    gsub(/\002/, "", s)
    gsub(/\001/, "\\", s)
    return s
}
function simple_math(s) {
    gsub(/\\,|\\;|\\!/, "", s)
    gsub(/\\times/, "\303\227", s)
    gsub(/\\mathbf ?/, "", s)
    gsub(/\\pi/, "\317\200", s)
    gsub(/\\chi/, "\317\207", s)
    gsub(/\^2/, "\302\262", s)
    gsub(/[{}]/, "", s)
    return "<i>" escaped(s) "</i>"
}
# Returns a title as HTML: quoted code, \prog, \emph, formulas of a letter or two, quotes.
function title_html(s,    out, name, words, word, before) {
    gsub(/\n/, " ", s)
    gsub(/~/, " ", s)
    gsub(/``/, "\342\200\234", s)
    gsub(/\047\047/, "\342\200\235", s)
    gsub(/\047/, "\342\200\231", s)
    gsub(/---/, "\342\200\224", s)
    gsub(/--/, "\342\200\223", s)
    gsub(/\\termmark[{][0-9]*[}]/, "", s)
    while (match(s, /\\texorpdfstring/)) {
        name = RSTART
        out = argument(s, RSTART + RLENGTH)
        words = after
        argument(s, words)
        s = substr(s, 1, name - 1) out substr(s, after)
    }
    out = ""
    while (match(s, /[{]\\Tt[{][}]|\\[a-z]+|[$]/)) {
        before = substr(s, 1, RSTART - 1)
        name = substr(s, RSTART, RLENGTH)
        s = substr(s, RSTART + RLENGTH)
        out = out escaped(unescaped(before))
        if (name == "$") {
            after = index(s, "$")
            out = out simple_math(substr(s, 1, after - 1))
            s = substr(s, after + 1)
        } else if (name ~ /Tt/) {
            after = index(s, "\\nwendquote}")
            words = substr(s, 1, after - 1)
            s = substr(s, after + 12)
            while ((name = index(words, "\\nwlinkedidentq")) > 0) {
                word = argument(words, name + 15)
                argument(words, after)
                words = substr(words, 1, name - 1) word substr(words, after)
            }
            out = out "<code>" escaped(unescaped(words)) "</code>"
        } else if (name ~ /^\\(prog|opt|cfile|texttt)$/) {
            out = out "<code>" escaped(unescaped(argument(s, 1))) "</code>"
            s = substr(s, after)
        } else if (name ~ /^\\(emph|textit)$/) {
            out = out "<em>" title_html_again(s) "</em>"
            s = substr(s, after)
        } else
            out = out name
    }
    return out escaped(unescaped(s))
}
function title_html_again(s,    words, end) {
    words = argument(s, 1)
    end = after
    words = title_html(words)
    after = end
    return words
}
# Returns a name as an anchor of the page.
function anchor(s) {
    gsub(/@@/, ".", s)
    gsub(/[^A-Za-z0-9:._-]/, "-", s)
    return s
}
