# What stands on the inspector's axes, of column c of a table of step: say=1
# what, say=2 of whom, say=3 the unit and say=4 what the table calls it; say=0
# how many columns there are. metre and second are the scene's units, "-" for
# none; without them the table's own words stay.
/^# [0-9]+ [^ ]+ \[/ {
    ++columns
    if ($2 != c)
        next
    symbol = $3
    raw = $0
    sub(/^[^[]*\[/, "", raw)
    what = raw
    sub(/\].*/, "", raw)
    sub(/^[^]]*\] */, "", what)
    sub(/,.*/, "", what)
    if (symbol == "kT")
        what = "temperature"
    who = " " symbol
    n = split(symbol, part, ":")
    if (n > 1) {
        what = part[1] == "v" ? "speed" : part[1] == "d" ? "distance" : \
            part[1] ~ /^v/ ? "velocity " part[1] : part[1]
        who = n > 2 ? "bodies " part[2] " and " part[3] : "body " part[2]
    }
    unit = raw
    if (metre == "-" || unit == "1")
        unit = ""
    else if (metre != "") {
        gsub("length", metre, unit)
        gsub("time", second, unit)
        gsub("mass", metre == "m" ? "kg" : "solar mass", unit)
        sub(/^kg m\^2\/s\^2$/, "J", unit)
        gsub(/\^2/, "²", unit)
    }
    said[1] = what
    said[2] = who
    said[3] = unit
    said[4] = raw
}
END { print say ? said[say] : columns + 0 }
