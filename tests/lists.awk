# What a suite says about itself, read from its text, so that nothing has to
# be compiled to know which exercises there are, what they are called and what
# they are worth: the lines that its runner prints for --list, less those of
# hidden tests, of the suite in 01a/ to 01a.list in a folder. A suite in which
# one of them is not written out is refused.
#
#   awk -v into=FOLDER -f tests/lists.awk tests/exercises/*/suite.c

# One line without its comments; in_comment remembers one that is open.
function bare(line,    out, at) {
    out = ""
    while (line != "") {
        if (in_comment) {
            at = index(line, "*/")
            if (!at)
                return out
            line = substr(line, at + 2)
            in_comment = 0
        } else if (match(line, /^("([^"\\]|\\.)*"|\/[^*"]|[^"\/])/)) {
            out = out substr(line, 1, RLENGTH)
            line = substr(line, RLENGTH + 1)
        } else {
            in_comment = 1
            line = substr(line, 3)
        }
    }
    return out
}

function refuse(expected) {
    printf "lists: %s: check_suite: %s expected, and not '%.40s'\n",
        file, expected, text > "/dev/stderr"
    refused = 1
    exit 1
}

# Takes what matches off the front of the text.
function take(pattern, expected,    token) {
    sub(/^[ \t]+/, "", text)
    if (!match(text, "^" pattern))
        refuse(expected)
    token = substr(text, 1, RLENGTH)
    text = substr(text, RLENGTH + 1)
    sub(/^[ \t]+/, "", text)
    return token
}

function sentence(    out, piece) {
    do {
        piece = take("\"([^\"\\\\]|\\\\.)*\"", "a text between quotes")
        out = out substr(piece, 2, length(piece) - 2)
    } while (substr(text, 1, 1) == "\"")
    gsub(/\\"/, "\"", out)
    gsub(/\\\\/, "\\", out)
    return out
}

function number() { return take("[0-9]+", "a number") }
function name() { return take("[A-Za-z_][A-Za-z_0-9]*", "a function") }
function sign(what) { return take("[" what "]", "'" what "'") }

# {"a sentence", function, points, hidden points}, and so on to {0}.
function tests() {
    sign("{")
    for (count = 0; sign("{") && substr(text, 1, 1) != "0"; sign(",")) {
        title_of[++count] = sentence()
        sign(",")
        run[count] = name()
        sign(",")
        points[count] = number()
        sign(",")
        hidden[count] = number()
        sign("}")
    }
    number()
    sign("}")
    sign("}")
}

function idles() {
    sign("{")
    do
        idle[name()]
    while (sign(",}") == ",")
}

function finish(    wanted, i, list) {
    if (file == "" || refused)
        return
    if (!count)
        refuse("a test")
    split("file title minutes", wanted, " ")
    list = file
    sub(/\/[^\/]*$/, "", list)
    sub(/.*\//, into "/", list)
    list = list ".list"
    for (i = 1; i <= 3; ++i) {
        if (!((wanted[i]) in said))
            refuse("." wanted[i])
        print wanted[i], said[wanted[i]] > list
    }
    for (i = 1; i <= count; ++i)
        print "test", points[i], hidden[i], (run[i] in idle) + 0,
            title_of[i] > list
    close(list)
}

FNR == 1 {
    finish()
    file = FILENAME
    text = ""
    count = in_comment = inside = 0
    split("", said)
    split("", idle)
}

/^const struct check_suite check_suite = \{/ { inside = 1 }
inside { text = text " " bare($0) }
inside && /^};/ {
    inside = 0
    sub(/^[^{]*\{/, "", text)
    do {
        field = take("\\.[a-z]+", "the name of a field")
        sign("=")
        if (field == ".tests")
            tests()
        else if (field == ".idle")
            idles()
        else if (field == ".minutes")
            said["minutes"] = number()
        else
            said[substr(field, 2)] = sentence()
        if (text ~ /^,/)
            sign(",")
    } while (text !~ /^}/)
}

END {
    finish()
    exit refused
}
