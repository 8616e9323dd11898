# The functions that an exercise gives, with their types, for the compiler to
# compare with those of a student's file: of each stub in 01a/ a header to
# 01a.types.h in a folder, which is included before the first line of his file.
# The header defines no name that his file may define: structures and
# enumerations are declared without their members, and what comes with a header
# of the C library (size_t, bool) is written without it. Each function stands
# once more as the exercise gives it, in a comment, for messages.
#
#   awk -v into=FOLDER -f tests/types.awk tests/exercises/*/stub.c

# The text with each array of structures written as a pointer: the element of
# an array must not be incomplete.
function pointers(text,    out, piece) {
    out = ""
    while (match(text, /struct [a-z_0-9]+ [a-z_0-9]+\[[^]]*\]/)) {
        piece = substr(text, RSTART, RLENGTH)
        sub(/\[.*/, "", piece)
        sub(/ [a-z_0-9]+$/, " *&", piece)
        sub(/\* /, "*", piece)
        out = out substr(text, 1, RSTART - 1) piece
        text = substr(text, RSTART + RLENGTH)
    }
    return out text
}

# The text with each word in place of another, where it stands alone.
function replaced(text, word, by,    out, before, after) {
    out = ""
    while (match(text, word)) {
        before = RSTART == 1 ? " " : substr(text, RSTART - 1, 1)
        after = substr(text, RSTART + RLENGTH, 1)
        out = out substr(text, 1, RSTART - 1) \
            ((before after) ~ /[A-Za-z_0-9]/ ? word : by)
        text = substr(text, RSTART + RLENGTH)
    }
    return out text
}

# Declares each structure and enumeration that the text names, once.
function declare_tags(text,    tag) {
    while (match(text, /(struct|enum) [a-z_0-9]+/)) {
        tag = substr(text, RSTART, RLENGTH)
        if (!(tag in declared))
            print tag ";" > header
        declared[tag]
        text = substr(text, RSTART + RLENGTH)
    }
}

function give(text) {
    gsub(/[ \t]+/, " ", text)
    declare_tags(text)
    print "/* given: " text " */" > header
    text = pointers(text)
    text = replaced(text, "size_t", "__SIZE_TYPE__")
    text = replaced(text, "bool", "_Bool")
    print text ";" > header
}

FNR == 1 {
    if (header)
        close(header)
    header = FILENAME
    sub(/\/[^\/]*$/, "", header)
    sub(/.*\//, into "/", header)
    header = header ".types.h"
    split("", declared)
    head = ""
    print "/* What the exercise gives: made from " FILENAME ". */" > header
    print "#pragma GCC system_header" > header
}

# A function's head begins a line, and ends before a brace or with a semicolon.
head == "" && /^[a-z].*\(/ && !/^(static|typedef)/ { head = " " }
head != "" {
    if (/^\{/ || /;$/) {
        if (/;$/)
            head = head " " $0
        sub(/^ +/, "", head)
        sub(/;$/, "", head)
        give(head)
        head = ""
    } else {
        head = head " " $0
    }
}
