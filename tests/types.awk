# The functions that an exercise gives, with their types, for the compiler to
# compare with those of a student's file: of each stub in 01a/ a header to
# 01a.types.h in a folder, which is included before the first line of his file.
# The header defines no name that his file may define: structures and
# enumerations are declared without their members, and what comes with a header
# of the C library (size_t, bool) is written without it. Each function stands
# once more as the exercise gives it, in a comment, for messages.
#
# So does each structure and enumeration that has a tag. Whether those of his
# file have the same members is checked behind it, where EXAMINER_AFTER is
# defined: the compiler asserts that they agree, and defines each once more, so
# that it shows where his file defines it. A member may have another name.
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
    print plain(pointers(text)) ";" > header
}

# The text with the types that come with a header of the C library written
# without it.
function plain(text) {
    return replaced(replaced(text, "size_t", "__SIZE_TYPE__"), "bool", "_Bool")
}
function compare(condition) {
    print "_Static_assert(" condition ", \"" tag "\");" > header
}

# A structure or enumeration with its members.
function define(text,    kind, list, part, n, i, own, given, name) {
    while (match(text, /\/\*[^*]*\*\//))
        text = substr(text, 1, RSTART - 1) substr(text, RSTART + RLENGTH)
    gsub(/[ \t]+/, " ", text)
    kind = text
    sub(/ .*/, "", kind)
    tag = substr(text, length(kind) + 2)
    sub(/ .*/, "", tag)
    list = text
    sub(/^[^{]*\{ */, "", list)
    sub(/ *\}$/, "", list)
    print "/* given: " text " */" > header
    print "#ifdef EXAMINER_AFTER" > header
    if (kind == "enum") {
        n = split(list, part, / *, */)
        for (i = 1; i <= n; ++i)
            compare(part[i] " == " i - 1)
    } else {
        own = "struct " tag
        given = "struct given_" tag
        print given " { " plain(list) " };" > header
        compare("sizeof(" own ") == sizeof(" given ")")
        n = split(list, part, / *[;,] */)
        for (i = 1; i < n; ++i) {
            name = part[i]
            gsub(/.* |\[.*/, "", name)
            compare("__builtin_offsetof(" own ", " name ") == " \
                "__builtin_offsetof(" given ", " name ") && " \
                "__builtin_types_compatible_p(" \
                "__typeof__(((" own " *)0)->" name "), " \
                "__typeof__(((" given " *)0)->" name "))")
        }
    }
    print kind " " tag " { " (kind == "enum" ? "given_" tag : "int given;") \
        " };\n#endif" > header
}

FNR == 1 {
    if (header)
        close(header)
    header = FILENAME
    sub(/\/[^\/]*$/, "", header)
    sub(/.*\//, into "/", header)
    header = header ".types.h"
    split("", declared)
    head = members = ""
    print "/* What the exercise gives: made from " FILENAME ". */" > header
    print "#pragma GCC system_header" > header
}

members == "" && /^(struct|enum) [a-z_]+ \{/ { members = " " }
members != "" {
    members = members " " $0
    if (/\};$/) {
        sub(/^ +/, "", members)
        sub(/;$/, "", members)
        define(members)
        members = ""
    }
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
