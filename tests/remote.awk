# Makes the remote calls of an exercise (src/examiner/remote.h) out of its call.h.
# That is C: the structures that cross, if any, and the student's function, each
# array with its length, which may depend on other arguments:
#
#   /* output: next_meeting left 1 */
#   double next_meeting(size_t n, double length, const double x[n],
#                       const double v[n], size_t *left);
#
# Numbers go to the function first, in their order, and then the arrays; a pointer
# is an array of one. What is const it only reads, in memory of just this length;
# the rest are outputs, which go there and come back behind the value.
#
#   awk -f tests/remote.awk tests/exercises/02a/call.h >remote.c

# What moves numbers of a type: "doubles" for double.
function plural(type) {
    return type ~ /^(double|int|bool|unsigned)$/ ? type "s" : \
        type == "size_t" ? "sizes" : ""
}

# Splits "const double x[3]" into the type, the name and the length, which is ""
# for a number; and says whether it is const.
function split_declaration(text) {
    sub(/^ /, "", text)
    is_const = sub(/^const /, "", text)
    length_of = ""
    if (match(text, /\[.*\]$/)) {
        length_of = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, 1, RSTART - 1)
    } else if (sub(/\*/, "", text)) {
        length_of = 1
    }
    match(text, / *[A-Za-z_0-9]+$/)
    name_of = substr(text, RSTART)
    type_of = substr(text, 1, RSTART - 1)
    sub(/^ */, "", name_of)
}

# A function that moves structures, a field after the other.
function mover(tag, fields,    n, f, field, m, k, part, type) {
    print "static void move_" tag "(struct " tag " s[], size_t count)\n{"
    print "    for (size_t i = 0; i < count; ++i) {"
    n = split(fields, field, ";")
    for (f = 1; f < n; ++f) {
        m = split(field[f], part, ",")
        for (k = 1; k <= m; ++k) {
            split_declaration((k == 1 ? "" : type) part[k])
            type = type_of
            if (type ~ /^enum /) {
                print "        int " name_of " = (int)s[i]." name_of ";"
                print "        remote_ints(&" name_of ", 1);"
                print "        s[i]." name_of " = (" type ")" name_of ";"
            } else if (length_of == "") {
                print "        remote_" plural(type) "(&s[i]." name_of ", 1);"
            } else {
                print "        remote_" plural(type) "(s[i]." name_of ", " length_of ");"
            }
        }
    }
    print "    }\n}\n"
}

# Moves argument k; `from` is its name where that is not its own.
function move(k, from) {
    if (from == "")
        from = length_[k] == "" ? "&" name[k] : name[k]
    print "    " (plural(type[k]) ? "remote_" plural(type[k]) : \
        "move_" substr(type[k], 8)) "(" from ", " (length_[k] == "" ? 1 : length_[k]) ");"
}

function move_outputs(    k) {
    for (k = 1; k <= arguments; ++k)
        if (output[k])
            move(k)
}

{
    # A comment on a line of its own is not looked at.
    if (/^\/\*/ || comment) {
        comment = !/\*\/$/
        print
        next
    }
    text = text " " $0
    if (/^(enum|struct|$)/ || within) {
        within = /^struct/ || (within && !/^};$/)
        shown = shown $0 "\n"
        if (/^enum/ || /^$/ || !within)
            text = /^};$/ ? text : ""
        if (!within && text != "") {
            gsub(/[ \t]+/, " ", text)
            match(text, /struct [a-z_0-9]+ \{/)
            tags[++structures] = substr(text, RSTART + 7, RLENGTH - 9)
            fields[structures] = substr(text, RSTART + RLENGTH)
            sub(/\};.*/, "", fields[structures])
            text = ""
        }
    }
}

END {
    gsub(/[ \t]+/, " ", text)
    sub(/^ /, "", text)
    if (text !~ /^[a-z].*\(.*\);$/) {
        print FILENAME ": no function" > "/dev/stderr"
        exit 1
    }
    head = substr(text, 1, index(text, "(") - 1)
    match(head, /[a-z_0-9]+$/)
    function_ = substr(head, RSTART)
    returns = substr(head, 1, RSTART - 1)
    sub(/ $/, "", returns)
    list = substr(text, index(text, "(") + 1)
    sub(/\);$/, "", list)
    arguments = split(list, one, /, */)
    for (k = 1; k <= arguments; ++k) {
        sub(/^ /, "", one[k])
        split_declaration(one[k])
        type[k] = type_of
        name[k] = name_of
        length_[k] = length_of
        constant[k] = is_const
        output[k] = length_of != "" && !is_const
        if (length_of !~ /^[0-9]*$/)
            sub(/\[.*\]$/, "[]", one[k])
        parameters = parameters (k > 1 ? ", " : "") one[k]
        passed = passed (k > 1 ? ", " : "") name[k]
    }
    print "\n#include \"examiner/remote.h\"\n#include <stdlib.h>\n#include <string.h>"
    printf "%s", shown
    print returns " " function_ "(" parameters ");\n"
    for (k = 1; k <= structures; ++k)
        mover(tags[k], fields[k])

    print "#ifdef REMOTE_SERVER\n\nvoid remote_serve(void)\n{"
    for (k = 1; k <= arguments; ++k)
        if (length_[k] == "") {
            print "    " type[k] " " name[k] ";"
            move(k)
        }
    for (k = 1; k <= arguments; ++k)
        if (constant[k]) {
            print "    " type[k] " *" name[k] " = remote_array(" length_[k] \
                ", sizeof *" name[k] ");"
            if (type[k] ~ /struct/)
                print "    memset(" name[k] ", 0, remote_bytes(" length_[k] \
                    ", sizeof *" name[k] "));"
            move(k)
        } else if (output[k] && plural(type[k])) {
            print "    " type[k] " *" name[k] " = remote_output_" \
                plural(type[k]) "(\"" name[k] "\", " length_[k] ");"
        } else if (output[k]) {
            print "    " type[k] " *" name[k] " = remote_output(\"" name[k] \
                "\", remote_bytes(" length_[k] ", sizeof *" name[k] "));"
            move(k)
        }
    print "    " (returns == "void" ? "" : returns " value = ") function_ \
        "(" passed ");"
    print "    remote_reply();"
    if (returns != "void")
        print "    remote_" plural(returns) "(&value, 1);"
    move_outputs()
    for (k = 1; k <= arguments; ++k)
        if (constant[k])
            print "    free(" name[k] ");"
    print "}\n\n#else\n"

    print returns " " function_ "(" parameters ")\n{"
    if (returns != "void")
        print "    " returns " value;"
    print "    remote_call();"
    for (k = 1; k <= arguments; ++k)
        if (length_[k] == "")
            move(k)
    # Sending only reads; structures are copied, for a mover also writes.
    for (k = 1; k <= arguments; ++k)
        if (constant[k] && type[k] ~ /struct/) {
            copy = name[k] "_copy"
            print "    " type[k] " *" copy " = remote_array(" length_[k] ", sizeof *" copy ");"
            print "    memcpy(" copy ", " name[k] ", (" length_[k] ") * sizeof *" copy ");"
            move(k, copy)
            print "    free(" copy ");"
        } else if (constant[k]) {
            move(k, "(" type[k] " *)" name[k])
        } else if (output[k]) {
            move(k)
        }
    print "    remote_wait();"
    if (returns != "void")
        print "    remote_" plural(returns) "(&value, 1);"
    move_outputs()
    if (returns != "void")
        print "    return value;"
    print "}\n\n#endif"
}
