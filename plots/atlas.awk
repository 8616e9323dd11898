# What the book makes of the atlas. -v want=tex: the table, scene by
# tolerance; want=keys: lines "key value" for the text; want=wrong,
# want=refused, want=slow: what a test complains about.
# Columns: name-k; plan, error, cost of the pick (2-4), of the cheapest that
# holds (5-7), of the cheapest with another model (8-10), of the finest plain
# way (11-13), of the classic method with its steps halved (14-16); what
# deciding cost (17); the horizon (18).
BEGIN {
    if (want == "tex")
        begin_table()
}
!/^[a-z][-a-z0-9]*-[369] / || NF != 18 { next }
{
    scene = substr($1, 1, length($1) - 2)
    k = substr($1, length($1))
    ++asked
    scenes += !seen[scene]++
    if (want == "tex")
        cell()
    else if (want == "wrong")
        complain()
    if ($2 == "-") {
        ++refused
        key("horizon", $18)
        if (want == "refused")
            print $1
        next
    }
    over = $4 / $7
    if (over > worst) {
        worst = over
        worst_name = $1
    }
    save[++granted] = $13 / $4
    ones += $13 / $4 < 1.05
    costs_more += $17 > $13 - $4
    key("saves", $13 / $4)
    key("error", $3)
    key("cost", $4)
    key("plain", $13)
    key("deciding", $17)
    running += $4
    deciding += $17
    plain += $13
    classic += $16
    if (want == "slow" && $4 < 0.01 && $17 > 0.1)
        print $1 ": " $17 " s of looking, for a run of " $4 " s"
    if ($4 >= 0.01)
        times[++long] = $17 / $4
}
END {
    if (want == "tex") {
        end_row()
        print "\\hline\n\\end{tabular}"
    }
    if (want == "keys") {
        print "scenes", scenes
        print "asked", asked
        print "granted", granted
        print "refused", refused + 0
        print "worst", worst
        print "worst_name", worst_name
        print "median", median(save, granted)
        print "ones", ones
        print "costs_more", costs_more
        print "running", running
        print "deciding", deciding
        print "plain", plain
        print "classic", classic
        print "times", long ? median(times, long) : 0
    }
}

function key(what, value) {
    if (want == "keys")
        print $1 "_" what, value
}
function median(x, n,    i, j, v) {
    for (i = 2; i <= n; ++i) {
        v = x[i]
        for (j = i - 1; j > 0 && x[j] > v; --j)
            x[j + 1] = x[j]
        x[j + 1] = v
    }
    return x[int((n + 1) / 2)]
}
function complain(    e) {
    e = k == 3 ? 1e-3 : k == 6 ? 1e-6 : 1e-9
    if ($2 == "-" && $5 != "-")
        print $1 " is refused; " $5 " would have held"
    else if ($2 != "-" && !($3 <= e))
        print $1 ": " $2 " is off by " $3
    else if ($2 != "-" && !($4 <= 1.13 * $7))
        print $1 ": " $2 " costs " $4 / $7 " times as much as " $5
}
function begin_table(    k, head) {
    head = ">{\\raggedright\\arraybackslash}p{.163\\textwidth}rr"
    print "\\begin{tabular}{l" head head head "}\n\\hline"
    for (k = -3; k >= -9; k -= 3)
        printf "%s & \\multicolumn{3}{l}{$10^{%d}$}", \
            k == -3 ? "\\rule{0pt}{2.4ex}" : "", k
    print "\\\\\nscene & taken & 2nd & plain & taken & 2nd & plain " \
        "& taken & 2nd & plain\\\\\n\\hline"
    row = "\\rule{0pt}{2.4ex}"
}
function end_row() {
    if (last != "")
        print row "\\\\"
}
function cell() {
    if (scene != last) {
        end_row()
        row = (last == "" ? row : "") scene
        last = scene
    }
    if ($2 == "-")
        row = row " & \\textit{to " short($18) "\\,s} & & "
    else
        row = row " & " plan($2) " & " ratio($10, $4) " & " ratio($13, $4)
}
function plan(p) {
    gsub(/,/, ",\\allowbreak ", p)
    sub(/no-light/, "light", p)
    return "\\texttt{" p "}"
}
function ratio(a, b) {
    return a == "nan" ? "--" : short(a / b)
}
# A ratio or a time in two digits.
function short(x) {
    return x < 9.95 ? sprintf("%.1f", x) : x < 99.5 ? sprintf("%.0f", x) : \
        sprintf("%d", int(x / 10 + 0.5) * 10)
}
