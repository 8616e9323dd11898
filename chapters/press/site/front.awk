# The front page: what the book is, and its contents.
BEGIN { FS = "\t" }
FNR == 1 { ++which }
which == 1 {
    if ($1 != "index") {
        ++pages
        name_of[pages] = $1
        line_of[pages] = numbered($2, $3)
        part_of[pages] = $4
    }
    next
}
$2 == 1 && $4 !~ /^(The module|What the module promises|The program|Speed and accuracy|Where it fails|What we can do now|What we can and still cannot do|Exercises|Further reading|Symbols)$/ {
    split($5, label, " ")
    sections[$1] = sections[$1] "<li><a href=\"" $1 ".html#" label[1] "\">" numbered($3, $4) "</a></li>\n"
}
END {
    print "<div class=\"title\">"
    print "<h1>Bonkers</h1>"
    print "<p class=\"tagline\">Computational physics, one collision at a time</p>"
    print "<svg class=\"beads\" viewBox=\"0 0 418 64\" role=\"img\" aria-label=\"Two bodies on a line\">" \
        "<path d=\"M0 32H418\"/><circle cx=\"96\" cy=\"32\" r=\"31\"/>" \
        "<circle class=\"small\" cx=\"146\" cy=\"32\" r=\"18\"/>" \
        "<circle class=\"end\" cx=\"2\" cy=\"32\" r=\"2\"/><circle class=\"end\" cx=\"416\" cy=\"32\" r=\"2\"/></svg>"
    print "<p>A book that is a program: every line of code in it runs, every figure is drawn from that code’s output, every exercise is checked by machine.</p>"
    print "<p>Some figures live: they run when they come into view. And in <a href=\"player.html\">the scene player</a> you can change what moves while it moves.</p>"
    print "<p>Version " version "</p>"
    if (edition == "instructor")
        print "<p><strong>Instructor’s edition, with the worked solutions: not for students.</strong></p>"
    print "</div>"
    print "<div class=\"contents\">"
    last = ""
    for (i = 1; i <= pages; ++i) {
        if (part_of[i] != last)
            print "<h2>" part_of[i] "</h2>"
        else if (i == 1)
            print "<h2>To begin with</h2>"
        last = part_of[i]
        print "<h3><a href=\"" name_of[i] ".html\">" line_of[i] "</a></h3>"
        if (name_of[i] in sections)
            print "<ul>\n" sections[name_of[i]] "</ul>"
    }
    print "<h2>The code</h2>\n<h3><a href=\"src/index.html\">All files of <code>src</code></a></h3>\n<p>The book prints what a reader should read whole; here is every file, with its lines numbered and its names leading to where they are defined.</p>"
    print "</div>"
}
