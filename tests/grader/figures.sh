#!/bin/sh
# The figure of a project: drawn in a sandbox from the student's own tables, or a
# line that says why there is none. Scripts that would rather do something
# else get no further than anybody's program; what leaves the sandbox is a picture.
topic=figures
. tests/grader/hostile/kit
left_behind=bonkers-drawn # other tests may run beside this one
project_kit
result() { echo "$out/marks/$1/P1.json"; }
mounts >"$scratch/mounts"
if ! command -v gnuplot >/dev/null 2>&1; then
    echo 'ok figures: # SKIP there is no gnuplot'
    echo 1..1
    exit
fi


# hand_in NAME: a script from standard input, and a program that has a row.
hand_in() {
    mkdir -p "$scratch/in/$1" && cat >"$scratch/in/$1/P1.gp"
    cat >"$scratch/in/$1/P1-bonkers.c" <<'END'
#include <stdio.h>
int main(void)
{
    return puts("0 1 0.5 0.25") < 0;
}
END
}
draws='set terminal pngcairo
set output "P1.png"
plot "< ./P1 beads.txt 1 0 0.1 0" using 3:4'
hand_in draws <<END
$draws
END
rm "$scratch/in/draws/P1-bonkers.c"
cp solutions/P1-bonkers.c "$scratch/in/draws/P1-bonkers.c"
cp solutions/P1.gp "$scratch/in/draws/P1.gp"
echo 'A page.' >"$scratch/in/draws/P1.txt"
hand_in none </dev/null
rm "$scratch/in/none/P1.gp"
hand_in link </dev/null
rm "$scratch/in/link/P1.gp"
ln -s "$root/solutions/P1.gp" "$scratch/in/link/P1.gp"
hand_in wrong <<'END'
plot "tables.txt" using 1:
END
# What it finds that is not its own, and where it can write, it tells instead
# of drawing.
hand_in curious <<END
system("touch hostile-was-here /hostile-was-here /tmp/hostile-was-here \
/kit/hostile-was-here $scratch/hostile-was-here 2>/dev/null")
system("find / -name hostile-was-here -not -path '/proc/*' \
-not -path '/work/desk/*' >found 2>/dev/null")
system("ls -d /etc/passwd $root $scratch /kit/P1.judge >>found 2>/dev/null")
system("cat /proc/*/environ /proc/*/cmdline 2>/dev/null | tr '\\\\0' ' ' | \
grep -a -o -e 'SECRE[T]=' -e '--hidde[n]' >>found")
system("cat /kit/* /exercises/* 2>/dev/null | grep -a -o check_suite >>found")
!ls /home/* /root/* 2>/dev/null >>found
found = system("cat found")
if (strlen(found) > 0) { print "BROKEN: ", found; exit }
$draws
END
hand_in murder <<'END'
system("kill -9 -1; (setsid sh -c 'while :; do :; done' &) ; kill -9 $PPID")
END
hand_in children <<'END'
bomb = "f() { f | f & f; }; f"
plot "< " . bomb
system("cp /usr/bin/sleep bonkers-drawn; setsid ./bonkers-drawn 1000 &")
END
hand_in flood <<'END'
set print "-"
do for [i=1:3] { system("yes passed | head -c 100000000 >P1.png; yes >x; yes >&2") }
END
hand_in memory <<'END'
a = "x"
while (1) { a = a . a }
END
hand_in sleeps <<'END'
set terminal pngcairo
set output "P1.png"
plot x
pause 1000
END
hand_in forged <<'END'
set print "P1.png"
print "<html><script>alert(1)</script>"
END
hand_in borrowed <<'END'
system("ln -s /kit/sandbox.suite.o P1.png")
END
hand_in pipe <<'END'
system("mkfifo P1.png; exec cat >P1.png </dev/zero &")
END
hand_in vast <<'END'
system("printf '\\211PNG\\r\\n\\032\\n\\0\\0\\0\\rIHDR\\0\\1\\0\\0\\0\\1\\0\\0' >P1.png; \
printf '01234567890123456789\\0\\0\\0\\0IEND\\256B\\140\\202' >>P1.png")
END

graded "$scratch/in"
verdict 'a batch ends well' ended 0
verdict 'the lecturer is told where the figures are' \
    grep -q 'Figures and texts of projects.*/by-hand/$' "$scratch/said"
notes() { # NAME TEXT: the note is all of this
    grep -q -x " \"note\": \"$2\"," "$(result "$1")" ||
        why "$(grep '"note"' "$(result "$1")")"
}
verdict 'a right script draws' notes draws 'figure: by-hand/draws/P1.png'
picture() {
    head -c 8 "$out/by-hand/draws/P1.png" | od -An -tx1 |
        grep -q '89 50 4e 47 0d 0a 1a 0a' &&
        [ "$(wc -c <"$out/by-hand/draws/P1.png")" -gt 9000 ] ||
        why "$(ls -l "$out/by-hand/draws")"
}
verdict 'a picture that has something in it' picture
verdict 'its points are those of its program' judged draws passed 30
beside() {
    cmp -s solutions/P1.gp "$out/by-hand/draws/P1.gp" &&
        cmp -s "$scratch/in/draws/P1.txt" "$out/by-hand/draws/P1.txt" ||
        why "$(ls "$out/by-hand/draws")"
}
verdict 'its script and its page lie beside it' beside
verdict 'the table for the lecturer names it' \
    grep -q 'draws *P1 *figure: by-hand/draws/P1.png' "$scratch/said"
verdict 'who has no script is told of' \
    notes none 'no figure: no script was handed in'
verdict 'a link to one is none' \
    notes link 'no figure: refused, since it is no regular file: P1.gp'
verdict 'a mistake is told with what gnuplot said' notes wrong \
    'no figure: its script has left none; at last it said: .*line 1: .*'
verdict 'a curious one has found nothing that is not its own' notes curious 'figure: by-hand/curious/P1.png'
harmless() { # NAME TEXT: nothing has worked, and there is no figure
    ! grep -q BROKEN "$(result "$1")" && [ ! -e "$out/by-hand/$1/P1.png" ] &&
        notes "$1" "no figure: $2.*"
}
verdict 'murder' harmless murder 'its script has left none'
verdict 'children' harmless children ''
verdict 'a flood' harmless flood ''
verdict 'memory' harmless memory 'its script has left none'
verdict 'a page that is no picture' \
    harmless forged 'what its script has left is no whole PNG'
verdict 'a link to what is in the sandbox' \
    harmless borrowed 'its script has left none'
verdict 'a pipe that never ends' harmless pipe 'its script has left none'
verdict 'a picture too large to look at' \
    harmless vast 'it has more than 4000 points a side'
verdict 'a script that sleeps' \
    harmless sleeps 'its script did not end in half a minute'
verdict 'nothing is left behind' clean

# What is graded again, and what is not.
stamp() { ls -i --time-style=full-iso -l "$(result "$1")"; }
mkdir "$scratch/again" && mv "$scratch/in/wrong" "$scratch/in/none" \
    "$scratch/again"
before=$(stamp none)
echo "$draws" >"$scratch/again/wrong/P1.gp"
graded "$scratch/again"
verdict 'a script that was mended is run again' \
    notes wrong 'figure: by-hand/wrong/P1.png'
verdict 'and nothing else is' [ "$before" = "$(stamp none)" ]
echo 'rubbish' >"$scratch/again/wrong/P1.gp"
graded "$scratch/again"
verdict 'one that was spoilt leaves no figure of before' \
    harmless wrong 'its script has left none'

# The files lie loose, as a platform has named them.
mkdir "$scratch/flat"
for file in P1.gp P1-bonkers.c; do
    cp "$scratch/in/curious/$file" \
        "$scratch/flat/Ada Lovelace_17_assignsubmission_file_$file"
done
graded "$scratch/flat"
verdict 'a platform may put the name before' \
    [ -s "$out/by-hand/Ada%20Lovelace_17/P1.png" ]

# A sandbox without gnuplot.
mkdir "$scratch/bare" && cat >"$scratch/bare/bwrap" <<END
#!/bin/sh
for word; do
    shift
    [ "\$word" != --proc ] || set -- "\$@" --ro-bind /dev/null \
        $(readlink -f "$(command -v gnuplot)")
    set -- "\$@" "\$word"
done
exec $(command -v bwrap) "\$@"
END
chmod 755 "$scratch/bare/bwrap"
user="env PATH=$scratch/bare:$PATH"
echo '# mended' >>"$scratch/again/wrong/P1.gp"
graded "$scratch/again"
verdict 'where gnuplot is missing it is said' \
    harmless wrong 'gnuplot is missing in the sandbox'
mkdir "$scratch/tools" && for tool in env sh setpriv rm prlimit; do
    ln -s "$(command -v $tool)" "$scratch/tools/$tool"
done
user="env PATH=$scratch/tools"
graded "$scratch/again" --unsafe
verdict 'and without a sandbox no script is run' \
    harmless wrong 'its script is not run without a sandbox'
verdict 'nothing is left behind in the end' clean
echo 1..28
