# Writes what the search looks through, as a script: the page, place, title and words of
# every section. Code and long formulas are left out.
function put(s) {
    gsub(/<pre.*<\/pre>|<math.*<\/math>/, " ", s)
    gsub(/<[^>]*>/, "", s)
    gsub(/&lt;/, "<", s)
    gsub(/&gt;/, ">", s)
    gsub(/&quot;/, "\"", s)
    gsub(/&amp;/, "\\&", s)
    gsub(/\\/, "\\\\", s)
    gsub(/"/, "\\\"", s)
    gsub(/[ \t]+/, " ", s)
    sub(/^ /, "", s)
    return s
}
function end_of_section() {
    if (title != "" && text != "")
        print (any++ ? "," : "") "[\"" page "\",\"" place "\",\"" title "\",\"" text "\"]"
    text = ""
}
BEGIN { print "window.bonkers_sections=[" }
FNR == 1 {
    end_of_section()
    page = FILENAME
    sub(/.*\//, "", page)
    sub(/\.html$/, "", page)
    within = code = 0
    title = ""
}
/^<main/ { within = 1; next }
/^<\/main/ { within = 0 }
!within { next }
/^<(h[123]|section|dt id=)[^>]*>/ {
    end_of_section()
    match($0, / id="[^"]*"/)
    place = substr($0, RSTART + 5, RLENGTH - 6)
    s = $0
    sub(/<p class="do">.*/, "", s)
    sub(/<small>.*/, "", s)
    sub(/<dd>.*/, ", in the glossary", s)
    title = put(s)
    next
}
/<pre/ { code = 1 }
!code {
    # A formula becomes a blank; a short one its letters.
    s = $0
    gsub(/<a class="number"[^>]*>[^<]*<\/a>/, "", s)
    while ((at = index(s, "<math")) > 0) {
        end = index(s, "</math>")
        if (end < at)
            break
        part = substr(s, at, end - at)
        gsub(/<mspace[^>]*>/, " ", part)
        gsub(/<[^>]*>/, "", part)
        s = substr(s, 1, at - 1) (length(part) < 12 ? part : "…") substr(s, end + 7)
    }
    s = put(s)
    if (s != "")
        text = text (text == "" ? "" : " ") s
}
/<\/pre>/ { code = 0 }
END {
    end_of_section()
    print "];"
}
