# Makes the remote calls of an exercise (src/examiner/remote.h) out of its call.h.
# That is C: the structures that cross, if any, and the student's functions, each
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
# A function that is declared `extern` is the suite's, and the student's function
# calls it. Its arrays go to the suite; those that are not const come back. In the
# length PRESENT(n), which C does not see, n is that of the student's function under
# way. Where the suite has `extern double uniform(void)` and uniform_ahead, random
# numbers go over in blocks (src/examiner/remote_random.h).
#
#   awk -f tests/remote.awk tests/exercises/02a/call.h >remote.c

# What moves numbers of a type: "doubles" for double.
function plural(type) {
    return type ~ /^(double|int|bool|unsigned)$/ ? type "s" : \
        type == "size_t" ? "sizes" : type ~ /^enum / ? "ints" : ""
}

# Splits "const double x[3]" into the type, the name and the length, which is ""
# for a number, and how long a row is, "" where there are none; and says whether it
# is const.
function split_declaration(text) {
    sub(/^ /, "", text)
    is_const = sub(/^const /, "", text)
    length_of = row_of = ""
    if (match(text, /\]\[[0-9]+\]$/)) {
        row_of = substr(text, RSTART + 2, RLENGTH - 3)
        text = substr(text, 1, RSTART)
    }
    if (match(text, /\[.*\]$/)) {
        length_of = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, 1, RSTART - 1)
    } else if (sub(/\*/, "", text)) {
        length_of = 1
    }
    if (row_of != "")
        length_of = row_of " * (" length_of ")"
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

# Reads the declaration of a function: into its place of function_, returns, passed
# and parameters, and into those of its arguments.
function declare(text,    head, list, depth, i, c, k, is_suites) {
    gsub(/[ \t]+/, " ", text)
    sub(/^ /, "", text)
    is_suites = sub(/^extern /, "", text)
    if (text !~ /^[a-z].*\(.*\);$/) {
        print FILENAME ": no function" > "/dev/stderr"
        exit bad = 1
    }
    head = substr(text, 1, index(text, "(") - 1)
    match(head, /[a-z_0-9]+$/)
    f = ++functions
    function_[f] = substr(head, RSTART)
    suites[f] = is_suites
    returns[f] = substr(head, 1, RSTART - 1)
    sub(/ $/, "", returns[f])
    list = substr(text, index(text, "(") + 1)
    sub(/\);$/, "", list)
    if (list == "void") {
        parameters[f] = list
        list = ""
    }
    k = list != ""
    for (i = 1; i <= length(list); ++i) {
        c = substr(list, i, 1)
        depth += (c ~ /[[(]/) - (c ~ /[])]/)
        if (c == "," && depth == 0)
            ++k
        else
            one[k] = one[k] c
    }
    arguments[f] = k
    for (k = 1; k <= arguments[f]; ++k) {
        sub(/^ /, "", one[k])
        split_declaration(one[k])
        type[f, k] = type_of
        name[f, k] = name_of
        row[f, k] = row_of
        constant[f, k] = is_const
        output[f, k] = length_of != "" && !is_const
        # What it is of the call under way is kept under another name.
        while (match(length_of, /PRESENT\([a-z_]+\)/)) {
            c = substr(length_of, RSTART + 8, RLENGTH - 9)
            present[c]
            length_of = substr(length_of, 1, RSTART - 1) "present_" c \
                substr(length_of, RSTART + RLENGTH)
        }
        length_[f, k] = length_of
        if (length_of !~ /^[0-9]*$/)
            sub(/\[.*\]$/, row_of == "" ? "[]" : "[][" row_of "]", one[k])
        parameters[f] = parameters[f] (k > 1 ? ", " : "") one[k]
        passed[f] = passed[f] (k > 1 ? ", " : "") \
            (row_of == "" ? "" : "(" type_of "(*)[" row_of "])") name_of
        delete one[k]
    }
}

# Moves argument k; `from` is its name where that is not its own.
function move(k, from) {
    if (from == "")
        from = length_[f, k] == "" ? "&" name[f, k] : \
            (row[f, k] == "" ? "" : "(" type[f, k] " *)") name[f, k]
    print "    " (plural(type[f, k]) ? "remote_" plural(type[f, k]) : \
        "move_" substr(type[f, k], 8)) "(" from ", " \
        (length_[f, k] == "" ? 1 : length_[f, k]) ");"
}

function move_outputs(    k) {
    for (k = 1; k <= arguments[f]; ++k)
        if (output[f, k])
            move(k)
}

# Sends all arguments. Sending only reads; structures are copied, for a mover also
# writes.
function send_arguments(    k, copy, its_type, its_name, count) {
    for (k = 1; k <= arguments[f]; ++k)
        if (length_[f, k] == "")
            move(k)
    for (k = 1; k <= arguments[f]; ++k) {
        its_type = type[f, k]
        its_name = name[f, k]
        count = length_[f, k]
        if (constant[f, k] && its_type ~ /struct/) {
            copy = its_name "_copy"
            print "    " its_type " *" copy " = remote_array(" count ", sizeof *" copy ");"
            print "    memcpy(" copy ", " its_name ", (" count ") * sizeof *" copy ");"
            move(k, copy)
            print "    free(" copy ");"
        } else if (constant[f, k]) {
            move(k, "(" its_type " *)" its_name)
        } else if (output[f, k]) {
            move(k)
        }
    }
}

# Receives the arguments into variables of their names. An output has guards around
# it, but not in the suite, which is trusted.
function receive_arguments(guarded,    k, its_type, its_name, count) {
    for (k = 1; k <= arguments[f]; ++k)
        if (length_[f, k] == "") {
            print "    " type[f, k] " " name[f, k] ";"
            move(k)
            if (name[f, k] in present && guarded)
                print "    present_" name[f, k] " = " name[f, k] ";"
        }
    for (k = 1; k <= arguments[f]; ++k) {
        its_type = type[f, k]
        its_name = name[f, k]
        count = length_[f, k]
        if (constant[f, k] || (output[f, k] && !guarded)) {
            print "    " its_type " *" its_name " = remote_array(" count \
                ", sizeof *" its_name ");"
            if (its_type ~ /struct/)
                print "    memset(" its_name ", 0, remote_bytes(" count \
                    ", sizeof *" its_name "));"
            move(k)
        } else if (output[f, k] && plural(its_type)) {
            print "    " its_type " *" its_name " = remote_output_" \
                plural(its_type) "(\"" its_name "\", " count ");"
        } else if (output[f, k]) {
            print "    " its_type " *" its_name " = remote_output(\"" its_name \
                "\", remote_bytes(" count ", sizeof *" its_name "));"
            move(k)
        }
    }
}

# Calls the function itself, and sends back what it makes of its arguments.
function answer(reply, guarded,    k, value) {
    value = returns[f] ~ /^enum / ? "int value = (int)" : returns[f] " value = "
    print "    " (returns[f] == "void" ? "" : value) function_[f] "(" passed[f] ");"
    print "    " reply "();"
    if (returns[f] != "void")
        print "    remote_" plural(returns[f]) "(&value, 1);"
    if (guarded && random)
        print "    remote_sizes(&block.left, 1);"
    move_outputs()
    for (k = 1; k <= arguments[f]; ++k)
        if (constant[f, k] || (output[f, k] && !guarded))
            print "    free(" name[f, k] ");"
}

# A function in place of function f: what it is called with crosses, and the answer
# comes back. `call` begins and `wait` ends the question.
function instead(call, wait, is_students,    k) {
    print returns[f] " " function_[f] "(" parameters[f] ")\n{"
    if (returns[f] != "void")
        print "    " (returns[f] ~ /^enum / ? "int" : returns[f]) " value;"
    print "    " call ";"
    if (is_students && students > 1)
        print "    remote_ints(&(int){" f "}, 1);"
    for (k = 1; k <= arguments[f]; ++k)
        if (name[f, k] in present && is_students)
            print "    present_" name[f, k] " = " name[f, k] ";"
    send_arguments()
    if (is_students && random)
        print "    give_block();"
    print "    " wait ";"
    if (returns[f] != "void")
        print "    remote_" plural(returns[f]) "(&value, 1);"
    if (is_students && random) {
        print "    size_t left;"
        print "    remote_sizes(&left, 1);"
    }
    move_outputs()
    if (is_students && random)
        print "    use_up(left);"
    if (returns[f] != "void")
        print "    return " (returns[f] ~ /^enum / ? "(" returns[f] ")" : "") "value;"
    print "}\n"
}

# remote_serve or remote_serve_callback: whose functions, and how each is answered.
function serve(of_suite,    n) {
    n = of_suite ? asked : students
    if (of_suite)
        print "void remote_serve_callback(int which)\n{\n    (void)which;"
    else
        print "void remote_serve(void)\n{"
    if (!of_suite && n > 1)
        print "    int which;\n    remote_ints(&which, 1);"
    for (f = 1; f <= functions; ++f) {
        if (suites[f] != of_suite)
            continue
        if (n > 1)
            print "    if (which == " f ") {"
        receive_arguments(!of_suite)
        if (!of_suite && random)
            print "    take_block();"
        answer(of_suite ? "remote_callback_reply" : "remote_reply", !of_suite)
        if (n > 1)
            print "    }"
    }
    print "}\n"
}

/^#/ { next }

{
    # A comment on a line of its own is not looked at.
    if (/^\/\*/ || comment) {
        comment = !/\*\/$/
        print
        next
    }
    if (/^static inline / || helper) {
        helper = !/^}/
        helpers = helpers $0 "\n"
        next
    }
    text = text " " $0
    if (/^(enum [a-z_]* ?\{|struct|$)/ || within) {
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
    } else if (/;$/) {
        declare(text)
        text = ""
    }
}

END {
    if (bad)
        exit 1
    for (f = 1; f <= functions; ++f) {
        random = random || function_[f] == "uniform"
        if (function_[f] ~ /^uniform(_ahead)?$/)
            suites[f] = -1 # they are those of remote_random.h
        students += suites[f] == 0
        asked += suites[f] == 1
    }
    if (students == 0) {
        print FILENAME ": no function" > "/dev/stderr"
        exit 1
    }
    print "\n#include \"examiner/remote" (random ? "_random" : "") ".h\""
    print "#include <stdlib.h>\n#include <string.h>"
    printf "%s%s", shown, helpers
    for (f = 1; f <= functions; ++f) {
        print returns[f] " " function_[f] "(" parameters[f] ");"
        for (k = 1; k <= arguments[f] && suites[f] == 0; ++k)
            if (name[f, k] in present)
                print "static " type[f, k] " present_" name[f, k] ";"
    }
    print ""
    for (k = 1; k <= structures; ++k)
        mover(tags[k], fields[k])

    print "#ifdef REMOTE_SERVER\n"
    for (f = 1; f <= functions; ++f)
        if (suites[f] == 1)
            instead("remote_callback(" f ")", "remote_callback_wait()", 0)
    serve(0)
    print "#else\n"
    if (asked)
        serve(1)
    for (f = 1; f <= functions; ++f)
        if (suites[f] == 0)
            instead("remote_call()", "remote_wait()", 1)
    print "#endif"
}
