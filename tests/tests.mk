# The tests, and goals that look for mistakes in the tests and the programs: mutants,
# memcheck, fuzz, hunt.

.PHONY: test test-parts memcheck
TEST_SECONDS = 600
unit_tests := $(patsubst tests/%.c,build/tests/%,$(filter-out $(without),\
	$(wildcard tests/library/*.c tests/stability/*.c)))
tools := $(patsubst tests/tools/%.c,build/tests/%,$(wildcard tests/tools/*.c))
scripts := $(wildcard tests/exercises/*.sh tests/stability/*.sh \
	tests/programs/*.sh tests/grader/*.sh tests/examiner/*.sh \
	tests/kit/*.sh tests/site/*.sh)

# Unit tests are compiled without optimization, since optimizing one takes longer than
# running it. Only gravity_tree is optimized: it sums the forces of many bodies itself.
quickly = $(if $(filter library/% stability/%,$(filter-out %/gravity_tree,$*)),-O0)
build/made/tests/%: tests/%.c build/obj/libbonkers.a build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(quickly) $(OPENMP) $(reads) -Isrc -Itests \
		$(FLAGS) -o $(made).new $< build/obj/libbonkers.a $(LDFLAGS) \
		-lcunit $(call gsl_libs,tests/$*.c) -lm
	$(take_compiled)
build/made/tests/%: tests/tools/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) $(FLAGS) -o $(made).new $< \
		$(LDFLAGS)
	$(take_compiled)
# The one unit test of the examiner: how it removes folders.
build/made/tests/examiner/folder: build/obj/examiner/folder.o
build/made/tests/examiner/%: tests/examiner/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc -Itests $(FLAGS) \
		-o $(made).new $(filter %.c %.o,$^) $(LDFLAGS) -lcunit -lm
	$(take_compiled)
examiner_tests = build/tests/examiner/folder
kept += $(unit_tests) $(examiner_tests) $(tools) build/tests/grader/reports \
	build/tests/grader/schema build/tests/mutants/outlive \
	$(unit_tests:build/tests/%=build/memcheck/%)

# The book is made first. Scripts that need neither the book nor make ($(beside)) run at
# the same time; the others wait until it is made. The longest tests begin first, so
# that no processor is idle at the end while one long test runs.
longest = $(addprefix tests/,exercises/all.sh examiner/projects.sh \
	programs/bytes.sh grader/hostile.sh site/browser.sh kit/handout.sh \
	kit/movie.sh site/live.sh exercises/nothing.sh grader/figures.sh)
longest_first = $(foreach l,$(longest),$(filter $(l),$(1))) \
	$(filter-out $(longest),$(1))
beside = $(filter-out $(shell grep -lF '{MAKE' $(scripts)),$(filter \
	$(foreach f,stability programs grader exercises examiner,tests/$(f)/%),\
	$(scripts)))
test: has-tex has-site has-test-tools
	@$(MAKE) -s -j2 programs test-parts
	@$(unless_dry)MAKE='$(MAKE)' tests/run -t $(TEST_SECONDS) -j 2 tests/book/book.sh \
		$(call longest_first,$(beside)) $(unit_tests) $(examiner_tests) -- \
		$(call longest_first,$(filter-out $(beside),$(scripts))) \
		$(filter-out tests/book/book.sh,$(wildcard tests/book/*.sh))

.PHONY: has-test-tools
has-test-tools:
	$(call need,clang,clang)
	$(call need,clang-format,clang-format)
	$(call need,pdftotext,poppler-utils)
	$(call need,xmllint,libxml2-utils)
	$(call need,bwrap,bubblewrap)
	$(call need,ps,procps)
	$(call need,git,git)
	$(call need,chromium,chromium)
	$(call need,node,nodejs)
	$(call need,npm,npm)

test-parts: grade-parts build/check/examine $(CHECK_BUILT) $(unit_tests) $(tools) \
	$(examiner_tests) \
	build/tests/mutants/outlive build/tests/grader/reports \
	build/tests/grader/schema build/tests/mutants/library-flags

# Programs for tests/grader/reports.sh: one writes the reports of an invented course, the
# other validates JSON.
build/made/tests/grader/reports: $(patsubst %,build/grade/obj/grade/%.o,\
	publish marks trial process text) build/obj/toolbox/replace.o
build/made/tests/grader/%: tests/grader/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc $(xml_flags) $(FLAGS) \
		-o $(made).new $(filter %.c %.o,$^) $(LDFLAGS) -ljansson -lxml2
	$(take_compiled)

# Mutation testing: plants small mistakes in the solutions and counts how many the
# suites detect. EX=01a tries one exercise; RECORD=1 keeps the table for the book.
.PHONY: mutants mutants-exercises mutants-library
mutants: $(if $(filter library,$(value OF)),mutants-library,mutants-exercises)
mutants-exercises: build/check/examine $(CHECK_BUILT) build/tests/mutate \
		build/tests/mutants/outlive
	@export RECORD='$(if $(RECORD),1)'; $(split) tests/mutants/run $$EX

# Mutation testing of the library: make mutants OF=library COUNT=100. The mistakes are
# drawn at random, with the hash of the commit as the seed; SEED=text draws others.
mutants-library: $(unit_tests) $(unit_tests:build/tests/%=build/memcheck/%) \
		programs build/tests/mutate build/tests/mutants/library-flags
	@tests/mutants/library
build/tests/mutants/library-flags: build/compiler/key tests/tests.mk $(library_folders:%=src/%)
	@mkdir -p $(@D)
	@printf '%s\n' '$(CC) $(STANDARD) $(FLAGS) -Isrc' '$(PORTABLE)' \
		'$(SANITIZED)' '$(OPENMP)' '$(parallel)' '$(gsl)' \
		'$(if $(gsl),$(GSL_LIBS))' '$(strip $(library))' >$@
build/made/tests/mutants/outlive: tests/mutants/outlive.c \
		$(patsubst %,build/obj/examiner/%.o,trial process text)
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc $(FLAGS) \
		-o $(made).new $(filter %.c %.o,$^) $(LDFLAGS)
	$(take_compiled)

# The library's tests under the sanitizers, with which they take up to ten times as
# long. A test that asks for too much memory gets NULL, as it does without sanitizers.
# make test runs some of these tests (tests/kit/memcheck.sh).
memcheck: $(patsubst build/tests/%,build/memcheck/%,$(unit_tests))
	@mkdir -p build/tests
	@ASAN_OPTIONS=allocator_may_return_null=1 tests/run -t 3600 -j 2 $^
build/made/memcheck/%: tests/%.c build/sanitized/obj/libbonkers.a
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(SANITIZED) $(OPENMP) $(reads) -Isrc -Itests \
		$(FLAGS) -o $(made).new $< build/sanitized/obj/libbonkers.a \
		$(LDFLAGS) -lcunit $(if $(gsl),$(GSL_LIBS)) -lm
	$(take_compiled)

# Fuzzes the parser of scenes, which must accept or refuse any text. TEXTS=1e7 tries
# more texts. libFuzzer generates them if the compiler is clang, and tests/fuzz/alone.c
# otherwise.
TEXTS = 200000
export TEXTS
.PHONY: fuzz fuzz-scenes fuzz-commands
fuzz: fuzz-scenes fuzz-commands
FUZZ = -std=c11 -D_POSIX_C_SOURCE=200809L -g -O2 -ffp-contract=off \
	$(sanitizers) $(FLAGS)
fuzz-scenes: build/fuzz/scene
	@mkdir -p build/fuzz/corpus
	@build/fuzz/scene -seed=1 -runs=$$(printf '%.0f' "$$TEXTS") -max_len=512 \
		-verbosity=0 -artifact_prefix=build/fuzz/ \
		-dict=tests/fuzz/scene.dict build/fuzz/corpus tests/fuzz/seeds \
		2>build/fuzz/log || { cat build/fuzz/log; exit 1; }
	@echo "Fuzzed: $$TEXTS texts, all of them read or refused"
# With clang the parser is compiled separately: libFuzzer follows only code that is
# compiled with -fsanitize=fuzzer.
scene_files = tests/fuzz/scene.c tests/fuzz/alone.c src/scenes/scene.c \
	src/scenes/decimal.c src/toolbox/random.c src/toolbox/aligned.c
build/made/fuzz/scene: $(scene_files) build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(FUZZ) -MM -MP -MT $@ -Isrc $(scene_files) >$@.new
	$(Q)clang $(FUZZ) -fsanitize=fuzzer -Isrc -o $(made).new \
		$(filter-out %/alone.c %/random.c,$(scene_files)) -lm \
		2>/dev/null || $(CC) $(FUZZ) -Isrc -o $(made).new $(scene_files) -lm
	$(take_compiled)
kept += build/fuzz/scene build/fuzz/commands

# Runs all programs, under the sanitizers, with wrong command lines and files:
# COMMANDS=1e4 for more of them, SEED=2 for others, FIRST=123 COMMANDS=1 to repeat one.
COMMANDS = 2000
SEED = 1
FIRST = 0
export COMMANDS SEED FIRST
fuzz-commands: build/fuzz/commands $(programs:%=build/sanitized/bin/%)
	@mkdir -p build/fuzz/work
	@build/fuzz/commands "$$PWD/build/sanitized/bin" \
		"$$PWD/build/fuzz/work" tests/fuzz/commands.txt \
		"$$SEED" "$$FIRST" "$$COMMANDS" 2
build/made/fuzz/commands: tests/fuzz/commands.c build/obj/toolbox/random.o \
		build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc $(FLAGS) \
		-o $(made).new $(filter %.c %.o,$^) $(LDFLAGS) -lm
	$(take_compiled)

# Compares bonk's results for random scenes with paths computed by extrapolation, a
# method that bonk does not use. REQUESTS=3000 tries more scenes, SEED=7 others,
# KIND=springs one kind; KIND=floor asks for tolerances near the smallest that bonk
# grants. The results are kept in build/hunt/.
REQUESTS = 100
export REQUESTS
.PHONY: hunt jobs-hunt
hunt_with = -n "$$(printf %.0f "$$REQUESTS")" -s "$$SEED" $$KIND
hunt jobs-hunt: build/bin/bonk build/tests/hunt/generate \
		build/tests/hunt/truth build/tests/hunt/truth-fast
hunt:
	@tests/hunt/run $(hunt_with)
jobs-hunt:
	$(call list,tests/hunt/run -l $(hunt_with))
build/made/tests/hunt/truth-fast: tests/hunt/truth.c build/obj/libbonkers.a \
		build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc -DHUNT_FAST $(FLAGS) \
		-o $(made).new $(filter %.c %.a,$^) $(LDFLAGS) -lm
	$(take_compiled)
kept += build/tests/hunt/generate build/tests/hunt/truth \
	build/tests/hunt/truth-fast

# Runs the lists of make jobs on a cluster of two nodes, one of which fails.
.PHONY: test-cluster
test-cluster: has-gsl programs grade-parts build/check/examine $(CHECK_BUILT) \
		$(FIGURES_DATA) build/tests/hunt/generate build/tests/hunt/truth \
		build/tests/hunt/truth-fast
	$(call need,slurmctld,slurm-wlm)
	$(call need,munged,munge)
	$(call need,parallel,parallel)
	$(call need,/usr/sbin/sshd,openssh-server)
	@$(unless_dry)RECORD='$(RECORD)' MAKE='$(MAKE)' tests/run -t 3600 tests/cluster/cluster.sh

# Runs the two commands of README.md, that for the book and that for the tests, in
# minimal Debian systems (made by debootstrap; see tests/systems/run). SYSTEMS=trixie
# runs them in one.
SYSTEMS = bookworm trixie
export SYSTEMS
.PHONY: test-systems
test-systems:
	@tests/systems/run $$SYSTEMS
