#!/bin/sh
# More machines than one, with the engines that README names: a cluster of two
# nodes on this host, one of which is lost while it works. Every job is counted
# once, and what is collected has the bytes of one machine; a job that is past
# its limit or finds a full disk is named, and it alone is run again.
#
# Not one of make test: `sh .ci/install cluster && make test-cluster`, as root.
# With RECORD=1 it keeps what an engine costs, and what two nodes do for a course.
# shellcheck disable=SC2086 # lists are words on purpose
. tests/programs/common
root=$(pwd) host=$(hostname)
[ "$(id -u)" -eq 0 ] || {
    echo "not ok $suite: a node is made by root - run it as root"
    exit 1
}

# ---- a cluster ------------------------------------------------------------

# Keys, sockets and logs are our own, so that a cluster that is here already
# is not met. A node has its processes to itself, so that the loss of one takes
# all of them at once; and both have the same small numbers of processes.
s=$work/slurm
nodes=
down() {
    kill -KILL $nodes 2>/dev/null # unshare ignores a TERM
    for pid in "$s"/slurmctld.pid "$s"/munged.pid "$s"/sshd.pid; do
        [ ! -e "$pid" ] || kill "$(cat "$pid")" 2>/dev/null
    done
    umount "$work/kit/build/small" 2>/dev/null
    wait
    rm -rf "$work"
}
trap down EXIT
port() { # N: one of four that nobody else is likely to have
    echo $((20000 + $$ % 10000 * 4 + $1))
}
mkdir -p "$s/state" "$s/n1" "$s/n2"
chmod 755 "$work" "$s"
head -c 128 /dev/urandom >"$s/key"
chmod 400 "$s/key"
cat >"$s/slurm.conf" <<END
ClusterName=proof
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$s/munge.socket
SlurmctldPort=$(port 0)
SlurmctldPidFile=$s/slurmctld.pid
SlurmctldLogFile=$s/slurmctld.log
SlurmdPidFile=$s/%n.pid
SlurmdLogFile=$s/%n.log
SlurmdSpoolDir=$s/%n
SlurmdParameters=config_overrides
SlurmdTimeout=10
StateSaveLocation=$s/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
KillWait=2
ReturnToService=2
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(port 1) CPUs=1
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(port 2) CPUs=1
PartitionName=all Nodes=n1,n2 Default=YES State=UP
END
export SLURM_CONF="$s/slurm.conf"
node() { # NAME: starts it
    unshare --pid --fork --mount-proc --kill-child=KILL \
        slurmd -D -N "$1" >>"$s/$1.out" 2>&1 &
    eval "$1=$!"
    nodes="$nodes $!"
}
both_idle() {
    for second in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        [ "$(sinfo -h -N -o %T 2>/dev/null | grep -c idle)" -lt 2 ] || return 0
        sleep 1
    done
    cat "$s"/*.log "$s"/*.out | tail -5
    return 1
}

# ---- a kit that both share ------------------------------------------------

kit=$work/kit
mkdir -p "$kit/build" "$work/one"
cp -a Makefile src chapters plots tests exercises solutions "$kit"
for name in bin obj compiler compiler.mk made check tests recipes data runs; do
    cp -a "build/$name" "$kit/build"
done
mkdir "$kit/build/grade"
cp -a build/grade/grade build/grade/flags build/grade/obj build/grade/libjudge.a \
    build/grade/*.judge build/grade/*.inside.o build/grade/*.list \
    build/grade/*.names build/grade/*.types.h "$kit/build/grade"
cd "$kit" || exit 1
mkdir build/small
mount -t tmpfs -o size=48k none build/small || exit 1
munged --key-file="$s/key" --socket="$s/munge.socket" --force \
    --pid-file="$s/munged.pid" --log-file="$s/munged.log" \
    --seed-file="$s/munged.seed"
slurmctld -D -c >"$s/slurmctld.out" 2>&1 &
node n1
node n2
both_idle >"$work/why" || {
    not_ok 'there is a cluster of two nodes' "$(cat "$work/why")"
    exit 1
}
ok 'there is a cluster of two nodes'

# A class of twelve, with what comes back from a course.
class=$work/class
n=0
for name in ada ben cai dora eva finn gil hana ida jon kim lea; do
    mkdir -p "$class/$name"
    for solution in solutions/01a-*.c solutions/02a-*.c solutions/08a-*.c; do
        file=$class/$name/${solution##*/}
        case $n in
        3 | 19) sed 's/;$//' "$solution" >"$file" ;;
        5 | 22) sed -e '1i #include <unistd.h>' \
            -e 's/^{$/{ for (volatile int i = 0; i == 0;) pause();/' \
            "$solution" >"$file" ;;
        11 | 30) cp "exercises/${solution##*/}" "$file" ;;
        17) ;;
        *) { cat "$solution"; echo "/* $name */"; } >"$file" ;;
        esac
        n=$((n + 1))
    done
done
make=${MAKE:-make} load=$(cut -d " " -f 1 /proc/loadavg)
unset MAKEFLAGS MFLAGS KIND SEED
hunted="REQUESTS=320 KIND=graze SEED=3"
graded="SUBMISSIONS=$class EX=01a,02a,08a HIDDEN=11 SECONDS=1 REPORT=gradescope"
# reports FOLDER: without the day and the seconds of the run.
reports() {
    for file in "$1"/grades.csv "$1"/gradescope/*.json; do
        echo "${file#"$1"}"
        sed -e 's/20..-..-..T..:..:..Z//' \
            -e 's/"execution_time": *[0-9.e+-]*//' "$file"
    done
}

# What is compiled is said here, and no more below.
$make -s programs grade-parts build/tests/hunt/generate build/tests/hunt/truth \
    build/tests/hunt/truth-fast >/dev/null 2>&1

# One machine.
{
    $make -s hunt $hunted >"$work/one/hunt"
    $make -s grade $graded RESULTS=build/one >"$work/one/said" 2>&1
    $make -s atlas >/dev/null 2>&1
}
mv build/hunt "$work/one/hunt-files"
reports build/one >"$work/one/reports"
cp build/data/12-atlas.dat "$work/one"
rm -rf build/atlas
lost=
for figure in 01 02 04; do
    for data in build/data/$figure-*.dat; do
        mv "$data" "$work/one" && lost="$lost ${data##*/}"
    done
done
# ---- all four, and a node is lost -----------------------------------------

# array LIST [TASKS [LIMIT]]: as README says, and waits for it.
array() {
    rm -f build/jobs/task-*.log
    LIMIT=${3:-600} sbatch --wait -Q --array=1-"${2:-8}" tests/cluster/array "$1"
}
listed() {
    $make -s jobs OF=hunt $hunted
    $make -s jobs OF=grade $graded
    $make -s jobs OF=figures
    $make -s jobs OF=atlas
}
listed >"$work/listed" 2>&1
cat build/jobs/hunt build/jobs/grade build/jobs/figures build/jobs/atlas >build/jobs/all
jobs=$(wc -l <build/jobs/all)
holds 'there are jobs of all four' test \
    "$(grep -c '^Jobs: [1-9]' "$work/listed")" -eq 4 -a "$jobs" -gt 80
array build/jobs/all &
sleep 12
busy=$(squeue -h -t R -o %N | tr '\n' ' ')
kill -KILL "$n2" # the node's first process, with which all others go
wait $!
ended=$?
holds 'both nodes were at work' test "$busy" = 'n1 n2 '
holds 'the list was done to its end' test "$ended" -eq 0
holds 'what the lost node had begun was begun again' \
    sh -c "scontrol show job -o | grep -q 'Restarts=[1-9]'"
holds 'the other one is alone' test "$(sinfo -h -N -n n2 -o %T)" = 'down*'
node n2
listed >"$work/listed" 2>&1
holds 'of all that is left what was late' test "$(cat build/jobs/hunt \
    build/jobs/figures build/jobs/atlas | wc -l) $(wc -l <build/jobs/grade)" = '0 2'
holds 'there are two nodes again' both_idle
array build/jobs/grade 2
listed >"$work/listed" 2>&1
holds 'and then nothing is' test "$(grep -c '^Jobs: 0 ' "$work/listed")" -eq 4

# What is collected: nothing is done again.
find build/grade/results/marks -name '*.json' -exec ls -i {} + >"$work/marks"
{
    $make -s hunt $hunted >"$work/hunt"
    $make -s grade $graded >"$work/said" 2>&1
    $make -s atlas >/dev/null 2>&1
}
holds 'the report of the hunt is that of one machine' \
    cmp "$work/one/hunt" "$work/hunt"
holds 'with every request once' \
    test "$(awk '{ n += $1 } END { print n }' "$work/hunt")" -eq 320
holds 'and from the same files' diff -r "$work/one/hunt-files" build/hunt
reports build/grade/results >"$work/reports"
holds 'the reports of the course are those of one machine' \
    diff "$work/one/reports" "$work/reports"
holds 'with every exercise once' test "$(find build/grade/results/marks \
    -name '0*.json' | wc -l)" -eq 36
find build/grade/results/marks -name '*.json' -exec ls -i {} + >"$work/again"
holds 'and none graded anew' cmp "$work/marks" "$work/again"
holds 'the maps are those of one machine' \
    cmp "$work/one/12-atlas.dat" build/data/12-atlas.dat
for data in $lost; do
    cmp "$work/one/$data" "build/data/$data" || echo "$data"
done >"$work/others" 2>&1
holds 'so are the data of figures' test ! -s "$work/others" -a "$(echo $lost |
    wc -w)" -gt 20

# ---- a limit of time, a full disk -----------------------------------------

# Two commands of eight take longer than they may.
quick='cradle|break|thermal|four-late|comet|galperin|piston|oscillator'
rm -rf build/atlas
$make -s jobs OF=atlas >/dev/null 2>&1
grep -E "scene ($quick) " \
    build/jobs/atlas | sed 's/^.*scene \([a-z-]*\) .*$/[ \1 != break ] || sleep 40; &/
    s/^.*scene comet .*$/sleep 40; &/' >build/jobs/short
array build/jobs/short 4 10
holds 'a job past its limit fails the list' test $? -ne 0
grep -h 'not done after 10 seconds' build/jobs/task-*.log >"$work/late"
holds 'and is named' test "$(grep -o 'scene [a-z]* ' "$work/late" | sort |
    tr -d '\n')" = 'scene break scene comet '
$make -s jobs OF=atlas >/dev/null 2>&1
holds 'it alone is in the next list' test "$(grep -oE "scene ($quick) " \
    build/jobs/atlas | sort | tr -d '\n')" = 'scene break scene comet '

# A folder of results that has room for some of them.
small="SUBMISSIONS=$class EX=01a HIDDEN=11 SECONDS=1 RESULTS=build/small"
$make -s jobs OF=grade $small >/dev/null 2>&1
cp build/jobs/grade build/jobs/small
array build/jobs/small 2
holds 'a full disk fails the list' test $? -ne 0
cat build/jobs/task-*.log | sed -n 's/^failed with status [0-9]*: //p' | sort \
    >"$work/full"
holds 'and is named, a command each' test "$(wc -l <"$work/full")" -gt 0 -a \
    "$(wc -l <"$work/full")" -lt "$(wc -l <build/jobs/small)"
mount -o remount,size=8m build/small
find build/small -name '*.json' -size +0 -exec ls -i {} + | sort >"$work/whole"
$make -s jobs OF=grade $small >/dev/null 2>&1
grep -v 'job late' build/jobs/grade | sort >"$work/next"
holds 'these alone are in the next list' diff "$work/full" "$work/next"
array build/jobs/grade 2
find build/small -name '*.json' -size +0 -exec ls -i {} + | sort >"$work/more"
holds 'and alone are run' test -z "$(comm -23 "$work/whole" "$work/more")"
$make -s jobs OF=grade $small >/dev/null 2>&1
holds 'until none is left' test ! -s build/jobs/grade

# ---- GNU parallel over ssh, to two names of this host ---------------------

ssh=$work/ssh
mkdir -m 700 "$ssh" && mkdir -p /run/sshd
ssh-keygen -q -t ed25519 -N '' -f "$ssh/host"
ssh-keygen -q -t ed25519 -N '' -f "$ssh/ours"
cat >"$ssh/server" <<END
ListenAddress 127.0.0.1
Port $(port 3)
HostKey $ssh/host
AuthorizedKeysFile $ssh/ours.pub
StrictModes no
PermitRootLogin prohibit-password
UsePAM no
PidFile $s/sshd.pid
END
cat >"$ssh/client" <<END
Host anna berta
    HostName 127.0.0.1
    Port $(port 3)
    User root
    IdentityFile $ssh/ours
    StrictHostKeyChecking no
    UserKnownHostsFile $ssh/known
    LogLevel ERROR
END
/usr/sbin/sshd -f "$ssh/server" -E "$ssh/log"
# README's line, whose names are those of machines.
line=$(sed -n 's/^\(parallel -S .*\) <build\/jobs\/grade$/\1/p' "$root/README.md")
holds 'README has a line for parallel' test -n "$line"
rm -r build/hunt
$make -s jobs OF=hunt $hunted >/dev/null 2>&1
PARALLEL="--will-cite --joblog $work/where" PARALLEL_SSH="ssh -F $ssh/client"
export PARALLEL PARALLEL_SSH
holds 'which runs a list' sh -c "$line"' <build/jobs/hunt'
holds 'on either machine' test "$(sed 1d "$work/where" | cut -f 2 | sort -u |
    tr '\n' ' ')" = 'anna berta '
$make -s jobs OF=hunt $hunted >/dev/null 2>&1
holds 'until none of its jobs is left' test ! -s build/jobs/hunt
$make -s hunt $hunted >"$work/hunt"
holds 'with the same report' cmp "$work/one/hunt" "$work/hunt"
unset PARALLEL PARALLEL_SSH
echo 1..30

# ---- what it costs --------------------------------------------------------

[ "${RECORD-}" ] || exit 0
# spent COMMAND...: processor seconds of all that it waits for, per thousand.
spent() {
    sh -c '"$@" >/dev/null 2>&1; times' sh "$@" | awk 'NR == 2 {
        gsub(/m/, " "); gsub(/s/, ""); print 60 * ($1 + $3) + $2 + $4 }'
}
# ticks: what the processes of Slurm, and those they waited for, have had.
ticks() {
    for pid in $(cat "$s/slurmctld.pid") $(pgrep -f "^slurmd -D -N n[12]\$") \
        $(pgrep -f "^slurmstepd"); do
        sed 's/.*) //' "/proc/$pid/stat" 2>/dev/null
    done | awk -v hz="$(getconf CLK_TCK)" '
        { n += $12 + $13 + $14 + $15 } END { print n / hz }'
}
# Two words, for which make, too, needs a shell.
awk 'BEGIN { for (k = 0; k < 1000; ++k) print ":;:" }' >build/jobs/empty
by_make=$(spent sh -c 'awk '\''{ gsub(/\$/, "$$"); print "all: " NR "\n" NR ":; @" $0 }'\'' \
    build/jobs/empty | make -kj 1 -f -')
by_parallel=$(spent sh -c 'parallel --will-cite -j 1 <build/jobs/empty')
by_array=$(spent env SLURM_ARRAY_TASK_COUNT=1 SLURM_ARRAY_TASK_ID=1 \
    tests/cluster/array build/jobs/empty)
sed 40q build/jobs/empty >build/jobs/tasks
before=$(ticks)
array build/jobs/tasks 40
by_task=$(echo "$before $(ticks)" | awk '{ print ($2 - $1) / 40 * 1000 }')

# A course of five, the exercises of two chapters: as a batch of one
# machine, as a list on one machine, on one node, on two; seconds on the wall,
# medians of three rounds.
class=$work/course
for name in a b c d e; do
    mkdir -p "$class/$name"
    for solution in solutions/0[12]*.c; do
        { cat "$solution"; echo "/* $name */"; } >"$class/$name/${solution##*/}"
    done
done
options="HIDDEN=11 EX=01,02"
clock() { date +%s.%N; }
last() { find "$1/marks" -name '*.json' -printf '%T@\n' | sort -n | tail -n 1; }
timed() { # FOLDER FROM: until the last result
    echo "$2 $(last "$1")" | awk '{ print $2 - $1 }'
}
for round in 1 2 3; do
    for way in batch list one two; do
        out=build/$way$round
        given="SUBMISSIONS=$class RESULTS=$out $options"
        from=$(clock)
        case $way in
        batch) $make -s grade $given JOBS=1 >/dev/null 2>&1 ;;
        *) $make -s jobs OF=grade $given >/dev/null 2>&1 ;;
        esac
        [ $way = batch ] || number=$(wc -l <build/jobs/grade) from=$(clock)
        case $way in
        list) sh build/jobs/grade >/dev/null 2>&1 ;;
        one)
            scontrol update nodename=n2 state=drain reason=measured
            array build/jobs/grade 8
            scontrol update nodename=n2 state=resume ;;
        two) array build/jobs/grade 8 ;;
        esac
        echo "$way $(timed "$out" "$from")" >>"$work/rounds"
    done
done
median() { sed -n "s/^$1 //p" "$work/rounds" | sort -n | sed -n 2p; }
# What make jobs and make grade take where all is done, for a result.
all=$(spent $make -s grade SUBMISSIONS="$class" RESULTS=build/two3 HIDDEN=11 EX=01,02)
{
    echo '# lists of jobs on two nodes: RECORD=1 make test-cluster'
    echo "# date $(date -u +%Y-%m-%d)"
    echo "# machine $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | sed 1q), $(nproc) cores"
    echo "# load before it began $load"
    echo '# column 1: what; 2: processor ms of an engine for an empty command (make,'
    echo '# parallel, array) or the start of a task (task), and of collecting a'
    echo '# result; wall s of a course as a batch of one process, as a list on one'
    echo '# machine, on one node, on two; their ratios; and on paper, hours on 50'
    echo '# machines of two cores for 10000 students and 40 exercises'
    echo "make $by_make"
    echo "parallel $by_parallel"
    echo "array $by_array"
    echo "task $by_task"
    echo "jobs $number"
    echo "$all $number" | awk '{ printf "collect %.2f\n", $1 / $2 * 1000 }'
    for way in batch list one two; do echo "$way $(median $way)"; done
} | awk '{ value[$1] = $2; print }
    END {
        printf "list_batch %.2f\n", value["list"] / value["batch"]
        printf "one_two %.2f\n", value["one"] / value["two"]
        printf "job %.3f\n", value["one"] / value["jobs"]
        printf "paper %.2f\n", 400000 * value["one"] / value["jobs"] / 100 / 3600
    }' >"$work/table" && cp "$work/table" "$root/plots/data/B-cluster.dat"
cat "$work/table"
