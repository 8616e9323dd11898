# What the book makes of failures.txt: its failures are numbered in their
# order. -v want=keys: lines "key value" for the text; want=tex: two tables,
# of the parts I and II, III and IV, where the failure NAME has the label
# fail:NAME; want=figure: the points of plots/12-failures.gp.
BEGIN {
    FS = " *[|] *"
    zero = 1e-17  # where an energy error of 0 is drawn,
    none = 2e-19  # where there is no energy to look at,
    lost = 30     # and where there is no answer
    # The numbers stand on the right of their points but for these.
    n = split("perfect_lattice:r no_crystal:d bare:d single_ring:u " \
        "stiff_contact:u late_comet:u adaptive_drift:l " \
        "chaos_four:u sign_mended:d " \
        "equal_masses:l memory:d shoved:u " \
        "backward_step:u equal_speeds:u single:d phase:d triple_jump:l stuck:u " \
        "mirrored:l near_miss:d", move, /[ :]/)
    for (k = 1; k < n; k += 2)
        where[move[k]] = move[k + 1]
}

/^# Part / { begin_part(substr($0, 8)) }
/^#/ || !NF { next }
{
    ++rows
    energy = $6
    answer = $7
    if (energy == "-")
        ++without
    else if (energy < 1e-12 && answer > 0.01)
        ++silent
    else if (energy >= answer / 10)
        ++shown
    if (want == "keys") {
        if (energy != "-")
            print $1 "_energy", energy
        if (answer != "-")
            print $1 "_answer", answer
    } else if (want == "figure")
        draw()
    else if (want == "tex")
        print strut() "\\refstepcounter{failure}\\thefailure\\label{fail:" $1 \
            "} & " tex($3) " (" "\\ref{" $9 "}) & " tex($2) ": " tex($4) \
            " & " tex($11) "\\\\"
}
END {
    if (want == "keys") {
        print "rows", rows
        print "silent", silent
        print "without", without
        print "shown", shown
        print "between", rows - silent - without - shown
    } else if (want == "tex")
        end_table()
}

function begin_part(part,    other) {
    ++parts
    if (want == "figure" && parts > 1)
        print "\n"
    if (want != "tex")
        return
    if (parts % 2 == 0) {
        print "\\hline"
        fresh = 1
        return
    }
    other = part == "I" ? "II" : "IV"
    if (parts > 1)
        end_table()
    else
        print "\\newcounter{failure}"
    print "\\begin{table}[tp]\\centering\\scriptsize"
    print "\\setlength{\\tabcolsep}{2.7pt}"
    print "\\caption[Failures of parts " part " and " other \
        "]{Where methods fail, parts " part " and " \
        other "; with the section that tells of it, and numbered as in " \
        "figure~\\ref{fig:12-failures}.}\\label{tab:failures-" \
        (parts + 1) / 2 "}"
    print "\\begin{tabular}{r" p(.255) p(.485) p(.185) "}"
    print "\\hline"
    fresh = 1
    print strut() " & scene & what was deceived & what saw it\\\\"
    print "\\hline"
    fresh = 1
}
function strut(    room) { # below a line
    room = fresh ? "\\rule{0pt}{2.4ex}" : ""
    fresh = 0
    return room
}
function end_table() {
    print "\\hline\n\\end{tabular}\n\\end{table}"
}
function p(width) {
    return ">{\\raggedright\\arraybackslash}p{" width "\\textwidth}"
}
function tex(text) {
    if (match(text, /10\^-?[0-9]+/))
        text = substr(text, 1, RSTART - 1) "$10^{" \
            substr(text, RSTART + 3, RLENGTH - 3) "}$" \
            substr(text, RSTART + RLENGTH)
    gsub(/omega dt/, "$\\omega\\,dt$", text)
    gsub(/n\.n/, "$\\mathbf n\\cdot\\mathbf n$", text)
    sub(/^e = /, "$e$ = ", text)
    sub(/^dt = /, "$dt$ = ", text)
    sub(/to t = /, "to $t$~=~", text)
    gsub(/ AU/, "~AU", text)
    gsub(/ s,/, "~s,", text)
    sub(/ d$/, "~d", text)
    return text
}

# number, x, y, the place of the number in both pictures, 1 if it is in the
# enlarged one
function draw(    x, y, side, small) {
    x = energy == "-" ? none : energy + 0 == 0 ? zero : energy
    y = answer == "-" ? lost : answer
    if (answer == "-") # side by side
        x *= 10 ^ (0.22 * (lost_ones++ - 1))
    side = answer == "-" ? "u" : $1 in where ? where[$1] : "r"
    small = x < 2e-13 && y > 0.012
    print rows, x, y, beside(x, side, small ? 0.17 : 0.75), \
        above(y, side, small ? 0.17 : 0.45), small
}
function beside(x, side, by) {
    return x * 10 ^ (side == "r" ? by : side == "l" ? -by : 0)
}
function above(y, side, by) {
    return y * 10 ^ (side == "u" ? by : side == "d" ? -by : 0)
}
