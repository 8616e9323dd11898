#!/bin/sh
# The recipes of figures and runs: remade when their command changes and only
# then; one command for one file; a run that ends otherwise than said fails.
. tests/programs/common
root=$(pwd)
mkdir -p "$work/chapters/press" "$work/plots" "$work/build/bin"
cp chapters/press/recipes chapters/press/lines "$work/chapters/press/"
cd "$work" || exit 1
cat >build/bin/walk <<'END'
#!/bin/sh
while [ $# -gt 0 ]; do
    case $1 in
    -o) echo "1 2" >"$2"; shift ;;
    --summary) echo "steps 3" >"$2"; shift ;;
    --fail) echo 'walk: no' >&2; exit 2 ;;
    esac
    shift
done
echo walked
END
chmod +x build/bin/walk
figure() { # number command
    cat >"plots/$1.gp" <<END
# data: build/data/walk.dat
# command: $2
# lecture: $2 --long
# alt: A line that is 50 % <straight> & rising.
plot 'build/data/walk.dat'
END
}
chapter() { printf '%s\n' '\chapter{X}' "$@" >chapters/01-x.nw; }
has() { # name needle haystack
    case $3 in
    *"$2"*) ok "$1" ;;
    *) not_ok "$1" "no '$2' in '$3'" ;;
    esac
}

figure 01-a 'build/bin/walk -o build/data/walk.dat'
figure 01-b 'build/bin/walk -o build/data/walk.dat'
sed "s/^# alt/# slides: 2\n&/; s/^plot/load 'plots\/panels.gp'\n&/" \
    plots/01-b.gp >plots/01-c.gp
chapter '%run walk: build/bin/walk --seed 1 | cat' '\result[1 to 2]{walk}{steps}' \
    '%run no !2: build/bin/walk --fail' '%run bad: build/bin/walk --fail' \
    '\transcript{walk}'
chapters/press/recipes || echo 'not ok recipes: they are extracted - status 1'
rules=$(cat build/recipes/rules.mk)
has 'data need recipe and program' \
    'build/made/data/walk.dat: build/recipes/data-walk.dat build/bin/walk' \
    "$rules"
has 'figures need script, style and data' \
    'build/figures/01-a.pdf: plots/01-a.gp plots/style.gp build/data/walk.dat' \
    "$rules"
has 'lecture data stand apart' 'build/lecture/01-a.pdf: plots/01-a.gp plots/style.gp build/lecture/data/walk.dat' "$rules"
has 'a figure of two slides is two files, and needs what it loads' \
    'build/lecture/01-c-1.pdf build/lecture/01-c-2.pdf: plots/01-c.gp '\
'plots/style.gp plots/panels.gp build/lecture/data/walk.dat' "$rules"
has 'one figure has a goal of its own' \
    'slides-01-c: build/lecture/01-c-1.pdf build/lecture/01-c-2.pdf' "$rules"
is 'the names of slides are told' '01-b 01-c-1 01-c-2' "$(echo \
    $(chapters/press/recipes --slides plots/01-b.gp) \
    $(chapters/press/recipes --slides plots/01-c.gp))"
# A figure reads the summary of a run that the text does not quote.
printf '%s\n' '# data: build/runs/bad.summary' \
    '# command: build/bin/walk --fail --summary build/runs/bad.summary' \
    '# alt: a number' 'plot 1' >plots/01-d.gp
chapters/press/recipes
has 'a figure waits for the run whose summary it reads' \
    'build/figures/01-d.pdf: plots/01-d.gp plots/style.gp build/runs/bad.summary' \
    "$(cat build/recipes/rules.mk)"
is 'and the run writes one' \
    'build/bin/walk --fail --summary build/runs/bad.summary' \
    "$(sed -n '$p' build/recipes/run-bad)"
has 'and nobody else makes it' 1 \
    "$(grep -c '^build/made/runs/bad.summary:' build/recipes/rules.mk)"
mv chapters/01-x.nw chapter
chapters/press/recipes
has 'where there are no chapters the figure has it made' \
    'build/made/runs/bad.summary: build/recipes/runs-bad.summary build/bin/walk' \
    "$(cat build/recipes/rules.mk)"
mv chapter chapters/01-x.nw
sed -i s/--fail/--other/ plots/01-d.gp
is 'another command than that of the run is refused' \
    'recipes: build/runs/bad.summary: the command in plots/01-d.gp is not that '\
'of run bad in chapters/01-x.nw:5' "$(chapters/press/recipes 2>&1)"
rm plots/01-c.gp plots/01-d.gp
chapters/press/recipes
is 'data of two figures have one rule' 1 \
    "$(grep -c '^build/made/data/walk.dat:' build/recipes/rules.mk)"
is 'the lecture command writes there' \
    'build/bin/walk -o build/lecture/data/walk.dat --long' \
    "$(sed -n '$p' build/recipes/lecture-data-walk.dat)"
is 'a run that is quoted gets a summary' \
    'build/bin/walk --seed 1 --summary build/runs/walk.summary | cat' \
    "$(sed -n '$p' build/recipes/run-walk)"

touch -t 202001010000 build/recipes/*
echo '# new colours' >>plots/01-a.gp
chapter '' '%run walk: build/bin/walk --seed 1 | cat' \
    '\result[1 to 2]{walk}{steps}' '%run no !2: build/bin/walk --fail' \
    '%run bad: build/bin/walk --fail -v' \
    '%run long: build/bin/walk --first 1,2,3,4 --second 1,2,3,4 --third \' \
    '%   1,2,3,4,5 --fourth -1 --fifth -o - --file x/y --empty --tests 3000 --seed 18 | cat'
chapters/press/recipes
is 'an unchanged recipe keeps its time' '' \
    "$(find build/recipes -name data-walk.dat -newer build/bin/walk)"
is 'an unchanged run keeps its time though its line moved' '' \
    "$(find build/recipes -name run-walk -newer build/bin/walk)"
is 'a changed run is new' build/recipes/run-bad \
    "$(find build/recipes -name run-bad -newer build/bin/walk)"

chapters/press/recipes --data build/data/walk.dat >/dev/null
is 'the data are made' '1 2' "$(cat build/data/walk.dat)"
chapters/press/recipes --run walk
is 'a transcript shows command and output' '$ build/bin/walk --seed 1 | cat
walked' "$(cat build/runs/walk.txt)"
is 'and the summary is there' 'steps 3' "$(cat build/runs/walk.summary)"
chapters/press/recipes --run long
is 'a long command folds between options' \
    '$ build/bin/walk --first 1,2,3,4 --second 1,2,3,4 --third 1,2,3,4,5 \
    --fourth -1 --fifth -o - --file x/y --empty --tests 3000 --seed 18 \
    | cat
walked' "$(cat build/runs/long.txt)"
chapters/press/recipes --run no
is 'a run that is to fail' "0 $(printf '$ build/bin/walk --fail\nwalk: no')" \
    "$? $(cat build/runs/no.txt)"
said=$(chapters/press/recipes --run bad 2>&1)
is 'a run that fails unasked ends the build' 1 $?
has 'and says where it comes from' \
    'recipes: chapters/01-x.nw:6: run bad ended with status 2, not 0:' "$said"
is 'and leaves nothing behind' '' "$(ls build/runs | grep bad)"

# A run that throws away the table of a figure makes it; another reads both.
chapter '%run same: build/bin/walk -o /dev/null' '\result[1 to 4]{same}{steps}' \
    '%run reads: cat build/runs/same.summary build/data/walk.dat' \
    '%run other: build/bin/walk --seed 1 -o /dev/null' \
    '%run twice: build/bin/walk --seed 1 -o /dev/null'
chapters/press/recipes
rules=$(cat build/recipes/rules.mk)
is 'a run and a figure with one command are made once' \
    'build/bin/walk -o build/data/walk.dat --summary build/runs/same.summary' \
    "$(sed -n '$p' build/recipes/run-same)"
has 'the figure waits for the run' \
    'build/made/data/walk.dat: build/made/runs/same.txt' "$rules"
has 'the run does not wait for the figure' \
    'build/made/runs/same.txt: build/recipes/run-same build/bin/walk
' "$rules"
has 'a second run of the same command waits as well' \
    'build/made/runs/twice.txt: build/recipes/run-twice build/bin/walk' "$rules"
is 'another command is another run' 'build/bin/walk --seed 1 -o /dev/null' \
    "$(sed -n '$p' build/recipes/run-other)"
has 'a run waits for what it reads' 'build/made/runs/reads.txt: '\
'build/recipes/run-reads build/runs/same.summary build/data/walk.dat' "$rules"
rm -f build/data/walk.dat
# The end of the stamps in the Makefile, and a figure that is drawn from them.
{
    echo 'include build/recipes/rules.mk'
    echo 'kept = $(FIGURES_DATA) $(RUNS)'
    sed -n '/^$(kept): /,/^$/p' "$root/Makefile"
    echo 'drawn: build/data/walk.dat build/runs/same.txt ; @echo drawn | tee $@'
} >Makefile
make -s build/runs/reads.txt >/dev/null
is 'made once, all is there' '$ cat build/runs/same.summary build/data/walk.dat
steps 3
1 2' "$(cat build/runs/reads.txt)"
is 'and the transcript shows what the chapter says' \
    '$ build/bin/walk -o /dev/null
walked' "$(cat build/runs/same.txt)"
rm build/data/walk.dat
make -s build/data/walk.dat >/dev/null
is 'a table that is lost is made again' '1 2' "$(cat build/data/walk.dat)"
rm build/runs/same.summary
make -s build/runs/same.summary >/dev/null
is 'and a summary' 'steps 3' "$(cat build/runs/same.summary)"

# A table whose bytes are as before keeps its time, and nothing is made from it again.
is 'a figure is drawn' drawn "$(make -s drawn)"
is 'and once' '' "$(make -s drawn)"
walk() { # PROGRAM...: another program that walks, in a while
    sleep 0.01
    printf '%s\n' "$@" >>build/bin/walk
}
walk 'echo "$$" >>ran'
is 'a program that does as it did draws nothing anew' '' \
    "$(make -s drawn build/runs/reads.txt build/runs/other.txt)"
is 'though each of its runs was made' 2 "$(wc -l <ran | tr -d ' ')"
is 'once' "$(cat ran)" "$(make -s drawn build/runs/other.txt; cat ran)"
walk 'echo further'
is 'one that does something else does' drawn "$(make -s drawn)"
is 'and its transcript is new' further "$(tail -n 1 build/runs/same.txt)"
walk 'exit 1'
make -s build/runs/same.txt >out 2>&1
is 'a run that fails leaves nothing that it made' '' \
    "$(ls build/runs/same.* build/data/* | grep -v 'was$')"
sed -i '/^exit 1/d' build/bin/walk
is 'and is made when it is mended' further \
    "$(make -s build/runs/same.txt && tail -n 1 build/runs/same.txt)"
is 'as it was' '' "$(make -s drawn; ls build/runs/*.was build/data/*.was 2>&1 |
    grep -v 'No such file')"
figure 01-b 'build/bin/walk --seed 2 -o build/data/walk.dat'
said=$(chapters/press/recipes 2>&1)
is 'two commands for one file are refused' 1 $?
has 'naming both' "two commands make it, one in plots/01-a.gp and another in plots/01-b.gp" "$said"
figure 01-b 'build/bin/walk -o build/data/other.dat'
has 'a command that writes another file is refused' \
    'recipes: plots/01-b.gp: the command does not write build/data/walk.dat' \
    "$(chapters/press/recipes 2>&1)"
figure 01-b 'build/bin/walk -o build/data/walk.dat'
sed -i 's/ --long$//' plots/01-b.gp
has 'a lecture of the same data is refused' \
    'recipes: plots/01-b.gp:3: a lecture makes the same data again' \
    "$(chapters/press/recipes 2>&1)"
rm plots/01-b.gp
chapter '\result[1 to 2]{lost}{steps}'
is 'a number of a run that is not there is refused' \
    'recipes: chapters/01-x.nw:2: no %run line makes run lost' \
    "$(chapters/press/recipes 2>&1)"
chapter '%run pipe: build/bin/walk --seed 4 | build/bin/walk -o /dev/null | cat' \
    '\result[1 to 2]{pipe}{steps}'
chapters/press/recipes
is 'of a pipe, who writes the table writes the summary' \
    'build/bin/walk --seed 4 | build/bin/walk -o /dev/null --summary '\
'build/runs/pipe.summary | cat' "$(sed -n '$p' build/recipes/run-pipe)"
chapter '%run says: build/bin/walk --summary - -o /dev/null' \
    '%run hears: sed 1d build/runs/says.txt >build/runs/hears.summary'
chapters/press/recipes
is 'who says his summary makes the table, too' \
    'build/bin/walk --summary - -o build/data/walk.dat' \
    "$(sed -n '$p' build/recipes/run-says)"
has 'and what he says may be read' \
    'build/made/runs/hears.txt: build/recipes/run-hears build/runs/says.txt' \
    "$(cat build/recipes/rules.mk)"
printf '%s\n' '# alt: planted' 'set terminal svg' 'set output output' \
    "plot x, 'build/data/lost.dat' with lines" >plots/00-planted.gp
has 'a figure without its data is none' 'not everything' \
    "$(chapters/press/recipes --figure svg build/figures/00-planted.svg \
        plots/00-planted.gp 2>&1)"
rm plots/00-planted.gp
chapter '%run a: build/bin/walk' '%run a: build/bin/walk --seed 2'
is 'two commands for one run are refused' \
    'recipes: chapters/01-x.nw:3: run a is another command in chapters/01-x.nw:2' \
    "$(chapters/press/recipes 2>&1)"
chapter '%run a: build/bin/walk'
find build -type f -exec cksum {} + >before
sed 's/$/\r/' chapters/01-x.nw >wide && mv wide chapters/01-x.nw
is 'Windows line ends in a chapter are refused' \
    'recipes: chapters/01-x.nw: Windows line ends' \
    "$(chapters/press/recipes 2>&1 | sed 's/ (.*//')"
is 'and nothing is written' "$(cat before)" "$(find build -type f -exec cksum {} +)"
echo 1..57
