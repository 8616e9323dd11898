# What is wrong with the pages given: a link that leads to no page or to no place
# of it, two places of one name, a picture or a script that is not there, TeX
# that nobody has read, a placeholder that nobody has filled. The last line has
# how many links there are.
function say(what) { print file ": " what }
FNR == 1 {
    file = FILENAME
    sub(/.*\//, "", file)
    folder = FILENAME
    sub(/[^\/]*$/, "", folder)
    # The pages of src/ lie in a folder of their own.
    prefix = folder ~ /\/src\/$/ ? "src/" : ""
    file = prefix file
    there[file] = 1
    code = 0
}
{
    rest = $0
    while (match(rest, / id="[^"]*"/)) {
        id = substr(rest, RSTART + 5, RLENGTH - 6)
        rest = substr(rest, RSTART + RLENGTH)
        if (place[file, id]++)
            say("two places are called " id)
    }
    rest = $0
    while (match(rest, / (href|src)="[^"]*"/)) {
        link = substr(rest, RSTART + 1, RLENGTH - 2)
        rest = substr(rest, RSTART + RLENGTH)
        sub(/^[a-z]*="/, "", link)
        if (link ~ /^(https?:|mailto:)/)
            continue
        ++links
        target = link
        sub(/#.*/, "", target)
        if (target == "")
            target = file
        else if (prefix == "" || !sub(/^\.\.\//, "", target))
            target = prefix target
        if (index(link, "#"))
            to[target, substr(link, index(link, "#") + 1)] = file
        else if (target ~ /\.html$/)
            page_to[target] = file
        else if (!(target in checked)) {
            checked[target] = 1
            name = folder
            sub(/\/src\/$/, "/", name)
            name = name target
            if ((getline line < name) < 0)
                say(target " is not there")
            close(name)
        }
    }
    # The words of a page, without code and scripts.
    text = $0
    if (text ~ /<pre/)
        code = 1
    gsub(/<pre.*<\/pre>/, "", text)
    gsub(/<(code|script)[^>]*>[^<]*(<a [^>]*>[^<]*<\/a>[^<]*)*<\/(code|script)>/, "", text)
    if (!code || $0 ~ /<\/pre>/) {
        sub(/^.*<\/pre>/, "", text)
        sub(/<pre.*/, "", text)
        gsub(/<[^>]*>/, "", text)
        if (match(text, /\\[A-Za-z]+/))
            say("TeX is left: " substr(text, RSTART, 40))
        if (match(text, /[$][^ ]*[$]|QZ[0-9]|QB[0-9]|\?\?/))
            say("something is left: " substr(text, RSTART, 40))
    }
    if (/<\/pre>/)
        code = 0
}
END {
    for (key in to) {
        split(key, part, SUBSEP)
        file = to[key]
        if (!(part[1] in there))
            say(part[1] " is not there")
        else if (!(key in place))
            say("no place " part[2] " in " part[1])
    }
    for (key in page_to)
        if (!(key in there)) {
            file = page_to[key]
            say(key " is not there")
        }
    print links " links"
}
