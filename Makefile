# Bonkers: a book that is a program. `make help` lists what can be made.
#
# Everything made goes under build/. Only `make tangle` writes src/, and
# only `make reset` writes exercises/.

all: first

SHELL = /bin/sh
.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: all first programs native bench tangle check-tangle figures book \
	test test-parts check watch hint progress reset solution memcheck format \
	clean help

CC ?= cc
STANDARD = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -pedantic
# A root need not tell errno that its number was negative: with that, gcc
# would take the roots of a loop one by one. It changes no bit.
PORTABLE = -O2 -ffp-contract=off -fno-math-errno
NATIVE = -O3 -march=native $(LTO) -ffp-contract=off -fno-math-errno
SANITIZED = -g -O1 -ffp-contract=off $(sanitizers)

# What is given on the command line is a value, not text for make or a shell:
# recipes read it from the environment, as in "$$EX".
given = EX SUBMISSIONS REPORT JOBS HIDDEN RESULTS SECONDS TEXTS PRESET SCENE \
	KEYS UNTIL EVERY VIEW FPS LIVE DT METHOD TOLERANCE OBSERVE X Y \
	EDITION WITH_CHAPTERS COMMANDS SEED FIRST
$(foreach v,$(given),$(if $(filter-out undefined,$(origin $v)),\
	$(eval override $v := $$(value $v))$(eval export $v)))
# bash counts in the other; a comment behind it would leave its blank in it.
export seconds := $(value SECONDS)

# V=1 shows the commands.
Q = $(if $(V),,@)
say = $(if $(V),,@echo '  $(1)')

# What the compiler can do: GSL, OpenMP for the programs that can use all
# cores, optimization across files for the native build. The key is what was
# asked, and what everything compiled depends on.
FLAGS = $(CPPFLAGS) $(CFLAGS)
GSL_LIBS = -lgsl -lgslcblas
asked = build/compiler
try = $(CC) $(FLAGS) $(1) $(LDFLAGS) $(2) -o $(asked)/try 2>/dev/null && \
	$(asked)/try
build/compiler/key: export key = $(CC) / $(FLAGS) / $(LDFLAGS) / \
	$(foreach v,STANDARD PORTABLE NATIVE SANITIZED sanitizers,$(value $v))
build/compiler/key: FORCE
	@mkdir -p $(@D)
	@{ printf '%s\n' "$$key"; $(CC) --version 2>&1 | head -n 1; \
		printf '\043include <gsl/gsl_cdf.h>\n' | $(CC) $(FLAGS) -E - \
		2>/dev/null | grep -c gsl_cdf_ugaussian_P; } >$@.$$$$; \
	if cmp -s $@.$$$$ $@; then rm $@.$$$$; else mv $@.$$$$ $@; fi
build/compiler.mk: build/compiler/key
	@printf '\043include <gsl/gsl_cdf.h>\nint main(void)\n%s\n' \
		'{ return gsl_cdf_ugaussian_P(0) != 0.5; }' >$(asked)/gsl.c
	@printf '%s\n' 'int other(void);' 'int main(void)' '{' 'int n = 0;' \
		'_Pragma("omp parallel reduction(+ : n)") ++n;' \
		'return n + other() < 2;' '}' >$(asked)/main.c
	@echo 'int other(void) { return 1; }' >$(asked)/other.c
	@rm -f $(asked)/lib.a
	@{ if $(call try,$(asked)/gsl.c,$(GSL_LIBS) -lm); \
		then echo 'gsl = yes'; fi; \
	if $(call try,-fopenmp $(asked)/main.c $(asked)/other.c); \
		then echo 'OPENMP = -fopenmp'; fi; \
	if $(CC) $(FLAGS) -O3 -flto=auto -c $(asked)/other.c \
		-o $(asked)/other.o 2>/dev/null && \
		ar rcs $(asked)/lib.a $(asked)/other.o 2>/dev/null && \
		$(call try,-O3 -flto=auto $(asked)/main.c $(asked)/lib.a); \
		then echo 'LTO = -flto=auto'; fi; } >$@.part
	@mv $@.part $@
# Who works at the exercises needs no answer.
students := check watch hint progress reset solution build/check/% help clean
ifneq ($(filter-out $(students),$(or $(MAKECMDGOALS),first)),)
include build/compiler.mk
endif

# What is there. What needs the GNU Scientific Library includes laws.h or
# gsl/; without the library it is left out, and bare make says so.
# What includes reference.h can do without: it asks whether it is there.
gsl_sources = src/*/*.c tests/library/*.c tests/stability/*.c
gsl_files := $(filter-out src/forces/reference.c,$(shell grep -lE \
	'^.include ("line/laws.h"|<gsl/)' $(gsl_sources) 2>/dev/null))
gsl_users := $(shell grep -l '^.include "forces/reference.h"' $(gsl_sources) \
	2>/dev/null)
without = $(if $(gsl),,$(gsl_files))
roofs := $(filter-out $(without),$(wildcard src/programs/*.c src/studies/*.c))
programs := $(notdir $(roofs:.c=))
rooms = toolbox line box scenes forces enough
library := $(filter-out $(without),$(wildcard $(rooms:%=src/%/*.c)))
# $(call gsl_libs,src/FILE.c): what to link it with.
gsl_libs = $(if $(gsl),$(if $(filter $(1),$(gsl_files) $(gsl_users)),\
	$(GSL_LIBS)))
exercises := $(patsubst tests/exercises/%/suite.c,%,\
	$(wildcard tests/exercises/[0-9][0-9][a-z]/suite.c))

# $(call need,COMMAND,PACKAGE): stop unless the command is there.
need = @command -v $(1) >/dev/null 2>&1 || { echo "make: $(1) is missing;\
 install it with: apt-get install --no-install-recommends $(2)" >&2; exit 1; }

# A course that was handed out (make handout) is the kit without what only its
# author needs: goals that need that say so, and make help leaves them out.
define only_with
ifeq ($(wildcard $(1)),)
absent += $(2)
ifneq ($(filter $(2),$(MAKECMDGOALS)),)
$$(error $(firstword $(filter $(2),$(MAKECMDGOALS))) needs $(1), which is not\
 part of the course as handed out; your lecturer has it)
endif
endif
endef
$(eval $(call only_with,chapters/press/book.tex,tangle check-tangle contact))
$(eval $(call only_with,tests/library,book works test memcheck handout mutants \
	grade grade-bench))
$(eval $(call only_with,solutions,solution))
$(eval $(call only_with,tests/fuzz,fuzz fuzz-scenes fuzz-commands))
# $(call offer,GOAL): echo, but for a goal that is absent.
offer = @$(if $(filter $(1),$(absent)),: ||) echo

## ---- programs: cc and make are enough -------------------------------------

programs: $(programs:%=build/bin/%)

# A first result in seconds, and the next thing to try.
first: programs
	$(if $(gsl),,@echo 'Not built, for want of GSL (apt-get install\
 --no-install-recommends libgsl-dev):' \
		$(notdir $(basename $(filter src/programs/% src/studies/%,\
		$(gsl_files)))))
	@echo 'Two bodies meet: 1 kg at 1 m/s runs into 4 kg at rest.'
	@build/bin/collide --velocities 1,0 --inverse-masses 1,0.25
	@echo 'Next: make check (the exercises),' $(if $(filter book,$(absent)),\
		'the book (bonkers.pdf)','make book (the PDF)'), make help

# Nothing is made twice. What is compiled hangs on the headers that it read,
# which the compiler writes down; and what comes out as it was keeps its time,
# so that nothing that hangs on it is made again. For that build/FILE is made
# aside, build/made/FILE says when it was last made, and build/made/FILE.d
# what was read for it. A rule names what it makes by its build/made/FILE, and
# `kept' all such files.
made = $(@:build/made/%=build/%)
begin = @mkdir -p $(@D) $(dir $(made))
reads = -MMD -MP -MT $@ -MF $@.new
take = if cmp -s $(made).new $(made); then rm $(made).new && touch $@; \
	else mv $(made).new $(made) && touch -r $(made) $@; fi
# A source that is gone, like a header, is nothing to wait for.
take_compiled = @{ cat $@.new*; printf '%s:\n' $(filter %.c,$^); } >$@.d && \
	rm $@.new* && $(take)

# Else optimization across files would make other names each time.
seed = -frandom-seed=$<
parallel := bonkers springs gravity
flags_of = $(if $(filter $(parallel),$(notdir $*)),$(OPENMP)) \
	$(if $(gsl),$(if $(filter reference,$(notdir $*)),-DWITH_GSL))

# The portable build, and the same for this machine alone.
define tree
build/made/$(1)obj/%.o: src/%.c build/compiler/key
	$$(begin)
	$$(call say,cc $$<)
	$$(Q)$$(CC) $$(STANDARD) $$($(2)) $$(flags_of) $$(reads) \
		$(if $(filter NATIVE,$(2)),$$(LTO:%=$$(seed))) \
		-DBUILD_FLAGS='"$$(strip $$($(2)))"' -Isrc $$(FLAGS) \
		-c -o $$(made).new $$<
	$$(take_compiled)
# The folders, too: a file may be gone.
build/made/$(1)obj/libbonkers.a: $$(library:src/%.c=build/$(1)obj/%.o) \
		$$(rooms:%=src/%)
	$$(begin)
	@rm -f $$(made).new
	@ar rcs $$(made).new $$(filter %.o,$$^)
	@$$(take)
$(foreach p,$(roofs:src/%.c=%),
build/made/$(1)bin/$(notdir $(p)): build/$(1)obj/$(p).o)
$(programs:%=build/made/$(1)bin/%): build/$(1)obj/libbonkers.a
	$$(begin)
	$$(call say,link $$(made))
	$$(Q)$$(CC) $$($(2)) $$(OPENMP) $$(FLAGS) -o $$(made).new \
		$$(filter %.o,$$^) $$(filter %.a,$$^) $$(LDFLAGS) \
		$$(call gsl_libs,$$(filter %/$$(@F).c,$(roofs))) -lm
	@$$(take)
kept += $$(patsubst src/%.c,build/$(1)obj/%.o,$$(wildcard src/*/*.c)) \
	build/$(1)obj/libbonkers.a $$(programs:%=build/$(1)bin/%)
endef
$(eval $(call tree,,PORTABLE))
$(eval $(call tree,native/,NATIVE))
$(eval $(call tree,sanitized/,SANITIZED))

native: $(programs:%=build/native/bin/%)

# The speed tables of the chapters, on this machine.
bench: native build/bin/disks-speed build/bin/gravity-studies
	build/native/bin/collide-forms --study cost --collisions 10000000
	build/native/bin/bonkers-studies --study speed --summary build/ratios
	@cat build/ratios
	build/native/bin/bonkers-studies --study steps
	$(if $(gsl),build/native/bin/bonkers --preset thermal --every 0.24 \
		--samples 400000 -o - | build/native/bin/histogram --skip 1 \
		--column v9 --table cost -)
	build/native/bin/piston --study cost --velocity 0.1
	build/native/bin/disks-studies --study speed
	build/native/bin/disks-studies --study pressure --samples 330000
	for radius in '.05 --step .4' '.15 --step .2' '.2 --step .15'; do \
		build/native/bin/sample-studies --study cost --samples 4e7 \
			--radii $$radius || exit 1; done
	for packing in .3 .7; do \
		build/native/bin/disks-speed --packing $$packing || exit 1; done
	for packing in .30 .49; do build/native/bin/disks-speed \
		--dimensions 3 --packing $$packing || exit 1; done
	build/native/bin/step-studies --study cost
	build/native/bin/scene-speed
	for bin in build/bin build/native/bin; do $$bin/disks-speed --steps \
		--particles 1e4 --dimensions 3 --packing .49 || exit 1; done
	build/native/bin/springs-studies --study speed
	build/native/bin/springs-studies --study threads
	build/native/bin/springs-studies --study work -o - | tail -n +7
	build/native/bin/spheres-studies --study cost --runs 4
	build/bin/gravity-studies --study speed
	build/bin/gravity-studies --study threads
	build/bin/gravity-studies --study tree
	build/bin/bonk-studies --study prices
	build/native/bin/scene sun-earth | build/native/bin/step - \
		--until 90000 --every 9000 --summary - -o build/bench.dat | \
		grep steps_per_second

## ---- exercises: cc, make and CUnit ----------------------------------------

# What the exercises are compiled with; build/check/flags keeps it for examine:
# the compiler's command on the first line, the libraries on the second.
# XOPEN_SOURCE, more than the kit itself asks for, gives students M_PI. What
# newer compilers take for errors, and a missing return, are errors in all.
check_base = $(CC) -std=c11 -D_XOPEN_SOURCE=700 -ffp-contract=off -g -O1 \
	$(errors:%=-Werror=%) $(CPPFLAGS)
errors = return-type implicit-function-declaration int-conversion
sanitizers = -fsanitize=address,undefined -fno-sanitize=object-size \
	-fno-sanitize-recover=undefined
check_cc = $$(sed -n 1p build/check/flags)
runner = build/check/flags build/check/libcheck.a
lists := $(exercises:%=build/check/%.list)
CHECK_BUILT = $(runner) $(exercises:%=build/check/%.suite.o) $(lists)

# EX=01a,02b or '01a 02b'. What is checked are the exercises that it names, or
# else those that are begun, whose file is not the stub; no other suite is
# needed. What somebody begins while we watch, examine asks for.
comma = ,
named := $(subst $(comma), ,$(EX))
asked_for = $(filter $(named:=%),$(exercises))
ifneq ($(filter check watch hint progress solution,$(MAKECMDGOALS)),)
begun := $(filter $(exercises),$(shell cksum tests/exercises/*/stub.c \
	exercises/[0-9][0-9][a-z]*.c 2>/dev/null | awk ' \
	{ n = split($$3, part, "/"); sum = $$1 " " $$2 } \
	/stub.c$$/ { stub[part[n - 1]] = sum; next } \
	stub[substr(part[n], 1, 3)] != sum { print substr(part[n], 1, 3) }'))
endif
suites_of = $(if $(1),$(runner) $(1:%=build/check/%.suite.o))
export MAKE
check watch: $(runner) $(call suites_of,$(if $(named),$(asked_for),$(begun)))
solution: $(call suites_of,$(asked_for))
hint: $(if $(named),,$(call suites_of,$(begun)))
progress: $(call suites_of,$(begun))

split = set -f; IFS=', ';
check: build/check/examine $(lists)
	@$(split) build/check/examine $$EX
watch hint progress reset solution: build/check/examine $(lists)
	@$(split) build/check/examine --$@ $$EX

.PHONY: FORCE

# Sanitizers where the compiler has them; CUnit must be there.
build/made/check/flags: build/made/check/compiler build/compiler/key
	$(begin)
	@echo '#include <CUnit/CUnit.h>' >build/check/probe.c
	@echo 'int main(void) { return CU_get_error(); }' >>build/check/probe.c
	@$(check_base) -o build/check/probe build/check/probe.c $(LDFLAGS) -lcunit \
		2>/dev/null || { echo 'make: check needs CUnit; install it with:\
 apt-get install --no-install-recommends libcunit1-dev' >&2; exit 1; }
	@san='$(sanitizers)'; $(check_base) $$san -o build/check/probe \
		build/check/probe.c $(LDFLAGS) -lcunit 2>/dev/null && \
		build/check/probe >/dev/null 2>&1 || san=; \
	printf '%s\n%s\n' "$(check_base) $$san" \
		'build/check/libcheck.a $(LDFLAGS) -lcunit -lm' >$(made).new
	@$(take)
build/made/check/compiler: FORCE
	@mkdir -p $(@D)
	@echo '$(check_base) $(LDFLAGS)' | cmp -s - $@ || \
		echo '$(check_base) $(LDFLAGS)' >$@

build/made/check/obj/%.o: src/%.c build/check/flags
	$(begin)
	$(call say,cc $(made))
	$(Q)$(check_cc) $(reads) -Wall -Wextra -pedantic -Isrc \
		-c -o $(made).new $<
	$(take_compiled)
build/made/check/libcheck.a: $(patsubst src/%.c,build/check/obj/%.o,\
	$(patsubst %,src/examiner/%.c,check hidden heed home place border) \
	src/toolbox/random.c)
	$(begin)
	@rm -f $(made).new
	@ar rcs $(made).new $^
	@$(take)
build/made/check/examine: $(patsubst %,build/obj/examiner/%.o,\
	examine watch hint reset solution round verdict memory work course sum \
	build message trial process text)
	$(begin)
	$(call say,link $(made))
	$(Q)$(CC) $(PORTABLE) $(FLAGS) -o $(made).new $^ $(LDFLAGS)
	@$(take)
kept += build/check/flags build/check/libcheck.a build/check/examine \
	$(patsubst src/%.c,build/check/obj/%.o,$(wildcard src/examiner/*.c \
	src/toolbox/*.c)) $(exercises:%=build/check/%.suite.o)

# A suite and the two halves of its border, where it has one, in one object.
# In a course that was handed out crossing.c is the border without comments.
# On the suite's side the functions that cross are called suite_..., so that
# the student's can keep their names.
border_of = $(wildcard $(addprefix tests/exercises/$*/,border.c crossing.c))
crossing = $$(sed -n '/^static/d; s/^[a-z][a-z_ *]*[ *]\([a-z0-9_]*\)(.*/\1/p' \
	/dev/null $(border_of) | grep -v '^border_' | sed 's/.*/-D&=suite_&/')
check_part = $(check_cc) -Wall -Wextra -pedantic -Isrc -c \
	-o build/check/obj/suite/$*
build/made/check/%.suite.o: tests/exercises/%/suite.c build/check/flags
	$(begin)
	$(call say,cc $<)
	@mkdir -p build/check/obj/suite
	$(Q)$(check_part).o $(reads) $(crossing) $<
	$(if $(border_of),$(Q)$(check_part).outside.o $(reads).outside \
		$(crossing) $(border_of))
	$(if $(border_of),$(Q)$(check_part).inside.o $(reads).inside \
		-DBORDER_INSIDE $(border_of))
	@ld -r -o $(made).new build/check/obj/suite/$*.o $(if $(border_of),\
		build/check/obj/suite/$*.outside.o build/check/obj/suite/$*.inside.o)
	$(take_compiled)
$(foreach e,$(exercises),$(eval build/made/check/$(e).suite.o: \
	$(wildcard $(addprefix tests/exercises/$(e)/,border.c crossing.c))))
# What it says about itself, for all of them at once.
build/made/check/lists: tests/lists.awk \
		$(exercises:%=tests/exercises/%/suite.c)
	@rm -rf build/check/lists && mkdir -p $(@D) build/check/lists
	@awk -v into=build/check/lists -f $^
	@mv build/check/lists/* build/check && touch $@
$(lists): build/made/check/lists
	@+:
$(if $(filter-out $(wildcard $(lists)),$(lists)),\
	$(shell rm -f build/made/check/lists))

## ---- grading: cc, make, CUnit, jansson, libxml2, bubblewrap ---------------

# make grade SUBMISSIONS=dir [REPORT=gradescope,...] [JOBS=n] [HIDDEN=seed]
# [EX=01a,02] [SECONDS=5] [RESULTS=dir] [UNSAFE=1]
SUBMISSIONS =
grade_options = $${REPORT:+--report "$$REPORT"} $${JOBS:+--jobs "$$JOBS"} \
	$${HIDDEN:+--hidden "$$HIDDEN"} $${EX:+--exercises "$$EX"} \
	$${seconds:+--seconds "$$seconds"} $(if $(UNSAFE),--unsafe) \
	$${RESULTS:+--output "$$RESULTS"}
graded := $(foreach e,$(exercises),\
	$(if $(wildcard tests/exercises/$(e)/border.c),$(e)))
GRADE_BUILT = build/grade/grade build/grade/flags \
	$(graded:%=build/grade/%.list) $(graded:%=build/grade/%.names)

.PHONY: grade grade-parts grade-bench has-submissions
grade-bench: grade-parts
	@tests/grader/bench 25 $(if $(RECORD),plots/data/B-grade.dat)
has-submissions:
	@[ -n "$$SUBMISSIONS" ] || { echo 'make: grade: which submissions?' \
		'make grade SUBMISSIONS=dir (a folder with one for each student)' \
		>&2; exit 2; }
grade: has-submissions grade-parts
	$(if $(filter-out $(graded),$(exercises)),@echo 'Not graded (there is' \
		'no border.c in its folder):' $(filter-out $(graded),$(exercises)))
	@build/grade/grade $(grade_options) "$$SUBMISSIONS"
grade-parts: has-grade-parts $(GRADE_BUILT)

.PHONY: has-grade-parts
has-grade-parts:
	@printf '#include <jansson.h>\n#include <libxml/xmlwriter.h>\n' | \
		$(CC) $(xml_flags) $(FLAGS) -E - >/dev/null 2>&1 || { \
		echo 'make: grade needs jansson and libxml2; install them with:' \
		'apt-get install --no-install-recommends libjansson-dev' \
		'libxml2-dev bubblewrap' >&2; exit 1; }

# jansson and libxml2, in the grader alone; asked only when it is built.
xml_flags = $$(pkg-config --cflags libxml-2.0 2>/dev/null || \
	echo -I/usr/include/libxml2)
build/made/grade/obj/grade/%.o: src/examiner/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) -D_XOPEN_SOURCE=700 $(PORTABLE) -Isrc $(reads) \
		$(xml_flags) $(FLAGS) -c -o $(made).new $<
	$(take_compiled)
build/made/grade/grade: $(patsubst %,build/grade/obj/grade/%.o,grade grading \
	box marks submissions publish build message sum trial process text)
	$(begin)
	$(call say,link $(made))
	$(Q)$(CC) $(PORTABLE) $(FLAGS) -o $(made).new $^ $(LDFLAGS) \
		-ljansson -lxml2
	@$(take)

# The compiler for students' files, without sanitizers and with, and how gcc,
# or else clang, is told to quote no lines.
build/made/grade/flags: build/check/flags
	$(begin)
	@terse=-fno-diagnostics-show-caret; $(CC) $$terse -E -x c /dev/null \
		>/dev/null 2>&1 || terse=-fno-caret-diagnostics; \
	printf '%s %s\n' '$(check_base)' -fmax-errors=20 \
		"$$(sed -n 1p build/check/flags)" -fmax-errors=20 $$terse '' \
		>$(made).new
	@$(take)

# What judges and boxes are linked with.
build/made/grade/obj/%.o: src/%.c build/check/flags
	$(begin)
	$(call say,cc $(made))
	$(Q)$(check_base) $(reads) -Wall -Wextra -pedantic -Isrc \
		-c -o $(made).new $<
	$(take_compiled)
build/made/grade/libjudge.a: $(patsubst src/%.c,build/grade/obj/%.o,\
	$(patsubst %,src/examiner/%.c,check hidden heed judge wire border) \
	src/toolbox/random.c)
	$(begin)
	@rm -f $(made).new
	@ar rcs $(made).new $^
	@$(take)
kept += build/grade/grade build/grade/flags build/grade/libjudge.a \
	$(patsubst src/%.c,build/grade/obj/%.o,$(wildcard src/examiner/*.c \
	src/toolbox/*.c)) \
	$(patsubst src/examiner/%.c,build/grade/obj/grade/%.o,\
	$(wildcard src/examiner/*.c)) \
	$(graded:%=build/grade/%.judge) $(graded:%=build/grade/%.inside.o)

# One exercise: its judge, what goes into a box with the student's file, the
# list of its tests, and the names that the student's file may show.
judge_part = build/grade/obj/judge/$*
judge_of = $(wildcard $(addprefix tests/exercises/$*/,suite.c border.c hidden.c))
build/made/grade/%.judge: tests/exercises/%/suite.c tests/exercises/%/border.c \
		build/grade/libjudge.a
	$(begin)
	@mkdir -p build/grade/obj/judge
	$(call say,cc $(made))
	$(Q)for file in $(judge_of); do \
		part=$${file##*/} && part=$${part%.c} && \
		$(check_base) $(reads).$$part -Wall -Wextra -pedantic -Isrc \
		-c -o $(judge_part).$$part.o $$file || exit 1; done
	$(Q)$(check_base) -o $(made).new \
		$(patsubst %.c,$(judge_part).%.o,$(notdir $(judge_of))) \
		build/grade/libjudge.a $(LDFLAGS) -lcunit -lm
	$(take_compiled)
$(foreach e,$(graded),$(eval build/made/grade/$(e).judge: \
	$(wildcard tests/exercises/$(e)/hidden.c)))
build/made/grade/%.inside.o: tests/exercises/%/border.c $(patsubst %,\
		build/grade/obj/examiner/%.o,boxed wire border place)
	$(begin)
	@mkdir -p build/grade/obj/border
	$(Q)$(check_base) $(reads) -Wall -Wextra -pedantic -DBORDER_INSIDE -Isrc \
		-c -o build/grade/obj/border/$*.o $<
	@ld -r -o $(made).new build/grade/obj/border/$*.o $(filter %.o,$^)
	$(take_compiled)
build/grade/%.list: build/grade/%.judge
	@build/grade/$*.judge --list >$@
build/grade/%.names: build/grade/%.inside.o tests/exercises/%/stub.c
	@$(check_base) -Isrc/examiner -c -o build/grade/obj/border/$*.stub.o \
		tests/exercises/$*/stub.c
	@nm -P -g build/grade/$*.inside.o | awk '$$2 == "U" { print $$1 }' \
		>build/grade/obj/border/$*.wanted
	@nm -P -g build/grade/obj/border/$*.stub.o | awk '$$2 != "U" \
		{ print $$1 }' | grep -x -F -f build/grade/obj/border/$*.wanted | \
		sed 's/^/--keep-global-symbol=/' | tr '\n' ' ' >$@

## ---- the book: noweb, gnuplot, TeX ---------------------------------------

tangle:
	$(call need,notangle,noweb)
	@chapters/press/tangle

check-tangle:
	$(call need,notangle,noweb)
	@chapters/press/tangle --check

# What figures and transcripts are made from, read from the scripts and the
# chapters. Goals that need no book do without.
bookless := all first programs native bench atlas movie movies wanted-movie inspect chart check watch hint progress \
	reset solution mutants tangle check-tangle clean help format memcheck \
	fuzz fuzz-scenes fuzz-commands
ifneq ($(filter-out $(bookless),$(MAKECMDGOALS)),)
build/recipes/rules.mk: chapters/press/recipes chapters plots $(wildcard chapters/works) \
		$(wildcard chapters/*.nw chapters/works/*.nw plots/*.gp)
	@chapters/press/recipes
include build/recipes/rules.mk
kept += $(FIGURES_DATA) $(LECTURE_DATA) $(RUNS)
endif

# The first thing that book and figures look for is what they need.
.PHONY: has-gnuplot has-gsl has-tex
has-gnuplot:
	$(call need,gnuplot,gnuplot-nox fonts-lmodern)
has-gsl:
	$(if $(gsl),,@echo 'make: GSL is missing; install it with: apt-get install\
 --no-install-recommends libgsl-dev' >&2; exit 1)
has-tex: has-gnuplot
	$(call need,notangle,noweb)
	$(call need,latexmk,latexmk lmodern texlive-latex-extra \
		texlive-fonts-recommended)
	$(call need,pdflatex,texlive-latex-extra texlive-fonts-recommended)

# QUALITY=lecture takes the longer runs and draws for a slide as well.
figures: has-gnuplot has-gsl programs $(FIGURES_PDF) $(FIGURES_SVG) \
		$(if $(filter lecture,$(QUALITY)),$(FIGURES_LECTURE))
	@echo 'Figures: build/figures/' \
		$(if $(filter lecture,$(QUALITY)),'and build/lecture/')

# One of them; with QUALITY=lecture its slide or slides.
FIGURE = 09-eight
.PHONY: figure contact
ifneq ($(filter figure,$(MAKECMDGOALS)),)
ifneq ($(filter $(basename $(notdir $(wildcard plots/[0-9]*.gp))),$\
	$(value FIGURE)),$(or $(value FIGURE),one))
$(error figure: FIGURE: '$(value FIGURE)' is no figure of plots/)
endif
figure: has-gnuplot has-gsl $(FIGURE:%=$(if $(filter \
		lecture,$(QUALITY)),slides,figure)-%)
	@echo 'In build/$(if $(filter lecture,$(QUALITY)),lecture,figures)/:' \
		$(FIGURE)
endif

# All figures and slides on a few sheets, to be looked at.
contact: has-tex has-gsl $(FIGURES_PDF)
	@chapters/press/contact
	@echo 'The contact sheets: build/contact.pdf'

# EDITION=instructor adds the worked solutions.
.PHONY: works
edition := $(if $(filter instructor,$(EDITION)),-instructor)
book: has-tex build/bonkers$(edition).pdf figures
	@echo 'The book: build/bonkers$(edition).pdf'
	@echo 'Next: open it, then try an exercise: make check'
works: has-tex build/works.pdf
	@echo 'The second volume: build/works.pdf, beside build/bonkers.pdf'

# What all volumes are set from; then they can be made side by side.
.PHONY: book-parts
book-parts: has-tex $(FIGURES_PDF) $(FIGURES_SVG) $(FIGURES_ALT) build/woven
build/woven: $(RUNS) $(wildcard chapters/*.nw chapters/works/*.nw \
		chapters/press/* solutions/* plots/data/* \
		$(addprefix tests/exercises/*/,hints.txt stub.c suite.c))
	@chapters/press/make-book woven

build/bonkers.pdf build/bonkers-instructor.pdf build/works.pdf \
		build/works-course.pdf: build/woven $(FIGURES_PDF) $(FIGURES_ALT) \
		tests/equations.txt
	@chapters/press/make-book $(@:build/%.pdf=%)
# Works quotes the numbers of the book.
build/works.pdf build/works-course.pdf: build/bonkers.pdf

## ---- the course for students -----------------------------------------------

# Its book has no solutions, its Works neither examiner nor grader.
# WITH_CHAPTERS=1 adds the chapters.
ifneq ($(and $(EDITION),$(filter handout,$(MAKECMDGOALS))),)
$(error handout: EDITION: students get the book without solutions; leave it out)
endif
.PHONY: handout
handout: has-tex build/bonkers.pdf build/works-course.pdf
	@chapters/press/handout

## ---- films and pictures of runs: gnuplot, and ffmpeg if it is there --------

# plots/show reads what is given from the environment.
.PHONY: movie movies inspect chart wanted-movie
wanted-movie:
	@plots/show movie --wanted
movie: has-gnuplot wanted-movie $(patsubst %,build/bin/%,bonkers disks scene \
		step bonk)
	@plots/show movie
movies: has-gnuplot $(patsubst %,build/bin/%,bonkers disks scene step)
	@plots/show movies
inspect: has-gnuplot build/bin/step build/bin/scene
	@plots/show inspect
chart: has-gnuplot build/bin/bonk build/bin/scene
	@plots/show chart

## ---- the atlas -------------------------------------------------------------

# The maps of chapter 12 and their truths, made anew: some minutes.
.PHONY: atlas
atlas: build/bin/bonk-studies
	build/bin/bonk-studies --study atlas --summary - \
		-o plots/data/12-atlas.dat

## ---- proof ---------------------------------------------------------------

TEST_SECONDS = 600
unit_tests := $(patsubst tests/%.c,build/tests/%,$(filter-out $(without),\
	$(wildcard tests/library/*.c tests/stability/*.c)))
tools := $(patsubst tests/tools/%.c,build/tests/%,$(wildcard tests/tools/*.c))
scripts := $(wildcard tests/stability/*.sh tests/programs/*.sh \
	tests/examiner/*.sh tests/exercises/*.sh tests/grader/*.sh \
	tests/kit/*.sh)

build/made/tests/%: tests/%.c build/obj/libbonkers.a build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(OPENMP) $(reads) -Isrc -Itests \
		$(FLAGS) -o $(made).new $< build/obj/libbonkers.a $(LDFLAGS) \
		-lcunit $(call gsl_libs,tests/$*.c) -lm
	$(take_compiled)
build/made/tests/%: tests/tools/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) $(FLAGS) -o $(made).new $< \
		$(LDFLAGS)
	$(take_compiled)
kept += $(unit_tests) $(tools) build/tests/grader/reports \
	build/tests/grader/schema build/tests/mutants/outlive \
	$(unit_tests:build/tests/%=build/memcheck/%)

# The book is the first of the tests: the others look at what it made.
test: has-tex has-test-tools
	@$(MAKE) -s -j2 programs native test-parts
	@MAKE='$(MAKE)' tests/run -t $(TEST_SECONDS) -j 2 tests/book/book.sh $(unit_tests) \
		$(scripts) $(filter-out tests/book/book.sh,$(wildcard tests/book/*.sh))

.PHONY: has-test-tools
has-test-tools:
	$(call need,clang,clang)
	$(call need,clang-format,clang-format)
	$(call need,pdftotext,poppler-utils)
	$(call need,xmllint,libxml2-utils)
	$(call need,bwrap,bubblewrap)
	$(call need,ps,procps)
	$(call need,git,git)

test-parts: grade-parts build/check/examine $(CHECK_BUILT) $(unit_tests) $(tools) \
	build/tests/mutants/outlive build/tests/grader/reports \
	build/tests/grader/schema

# What the reports are tested with: a course made up, a validator of JSON.
build/made/tests/grader/reports: $(patsubst %,build/grade/obj/grade/%.o,\
	publish marks trial process text)
build/made/tests/grader/%: tests/grader/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc $(xml_flags) $(FLAGS) \
		-o $(made).new $(filter %.c %.o,$^) $(LDFLAGS) -ljansson -lxml2
	$(take_compiled)

# How many small mistakes in the solutions the suites notice; EX=01a for one,
# RECORD=1 keeps the table for the book.
.PHONY: mutants
mutants: build/check/examine $(CHECK_BUILT) build/tests/mutate \
		build/tests/mutants/outlive
	@export RECORD='$(if $(RECORD),1)'; $(split) tests/mutants/run $$EX
build/made/tests/mutants/outlive: tests/mutants/outlive.c \
		$(patsubst %,build/obj/examiner/%.o,trial process text)
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(PORTABLE) $(reads) -Isrc $(FLAGS) \
		-o $(made).new $(filter %.c %.o,$^) $(LDFLAGS)
	$(take_compiled)

# The library's tests under the sanitizers.
memcheck: $(patsubst build/tests/%,build/memcheck/%,$(unit_tests))
	@tests/run $^
build/made/memcheck/%: tests/%.c build/sanitized/obj/libbonkers.a
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) $(SANITIZED) $(OPENMP) $(reads) -Isrc -Itests \
		$(FLAGS) -o $(made).new $< build/sanitized/obj/libbonkers.a \
		$(LDFLAGS) -lcunit $(if $(gsl),$(GSL_LIBS)) -lm
	$(take_compiled)

# The reader of scenes, fed with what is no scene, TEXTS=1e7 for longer. With
# clang libFuzzer chooses the texts; with others, tests/fuzz/alone.c does.
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
# With clang, what libFuzzer follows is what is compiled with its option.
scene_files = tests/fuzz/scene.c tests/fuzz/alone.c src/scenes/scene.c \
	src/scenes/decimal.c src/toolbox/random.c src/toolbox/room.c
build/made/fuzz/scene: $(scene_files) build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(FUZZ) -MM -MP -MT $@ -Isrc $(scene_files) >$@.new
	$(Q)clang $(FUZZ) -fsanitize=fuzzer -Isrc -o $(made).new \
		$(filter-out %/alone.c %/random.c,$(scene_files)) -lm \
		2>/dev/null || $(CC) $(FUZZ) -Isrc -o $(made).new $(scene_files) -lm
	$(take_compiled)
kept += build/fuzz/scene build/fuzz/commands

# All programs, under the sanitizers, with command lines and files that are
# wrong: COMMANDS=1e4 for longer, SEED=2 for others, FIRST=123 COMMANDS=1 for
# one of them again.
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

# Every C file in the one layout; src/ is only compared, see the chapters.
c_files = $(wildcard tests/*.h tests/*/*.[ch] tests/exercises/*/*.c solutions/*.c \
	src/*/*.[ch])
format:
	$(call need,clang-format,clang-format)
	@clang-format --dry-run -Werror $(c_files)

# For editors and clangd.
compile_commands.json: Makefile $(library)
	@for file in $(wildcard src/*/*.c); do \
	printf '  {"directory": "%s", "file": "%s",\n   "command": "%s"}\n' \
	"$$PWD" $$file "$(CC) $(STANDARD) $(PORTABLE) -Isrc -c $$file"; \
	done | awk 'BEGIN { print "[" } NR > 1 && /^  {/ { print "," } \
	{ printf "%s%s", /^  {/ ? "" : "\n", $$0 } END { print "\n]" }' >$@.part
	@mv $@.part $@

# What is kept hangs on the day when it was made (`+:' is to do nothing, and
# to see whether it is as it was). What is lost is made again.
$(kept): build/%: build/made/%
	@+:
lost := $(filter-out $(wildcard $(kept)),$(kept))
lost := $(wildcard $(lost:build/%=build/made/%))
$(if $(lost),$(shell rm -f $(lost)))
-include $(wildcard build/made/*/*.d build/made/*/*/*.d \
	build/made/*/*/*/*.d build/made/*/*/*/*/*.d)

clean:
	rm -rf build compile_commands.json

help:
	@echo 'make              build the programs; show a first result'
	@echo 'make check        check your exercises; EX=01a for one'
	@echo 'make watch        check whatever you save, until Ctrl-C'
	@echo 'make hint         the next hint; EX=01a for that exercise'
	@echo 'make progress     a bar for each chapter, and what comes next'
	$(call offer,solution) 'make solution     EX=01a: the worked solution, once yours passes'
	@echo 'make reset        EX=01a: begin afresh; what you had is kept'
	$(call offer,book) 'make book         the PDF; EDITION=instructor adds the solutions'
	$(call offer,works) 'make works        the second volume: how the rest is made'
	$(call offer,handout) 'make handout      the archive for students; WITH_CHAPTERS=1 for more'
	$(call offer,grade) 'make grade        SUBMISSIONS=dir: points for a folder of students'
	@echo 'make figures      the figures; QUALITY=lecture for slides too'
	@echo 'make figure       FIGURE=09-eight: one of them; QUALITY=lecture'
	$(call offer,contact) 'make contact      all figures and slides, small, to look at'
	$(call offer,test) 'make test         prove everything: N passed, N failed'
	@echo 'make programs     only build build/bin/'
	@echo 'make inspect      SCENE=membrane X=t Y=z:30: what a scene does, drawn'
	@echo 'make chart        SCENE=figure-eight TOLERANCE=1e-6: what bonk tries'
	@echo 'make atlas        the maps of chapter 12 anew: some minutes'
	@echo 'make movie        a film: SCENE=ring VIEW=tilted or PRESET=cradle; LIVE=1'
	@echo 'make movies       films of all scenes and presets: half an hour'
	@echo 'make native       the fastest build for this machine, build/native/'
	@echo 'make bench        the speed tables, measured here'
	$(call offer,mutants) 'make mutants      how many planted mistakes the exercises notice'
	$(call offer,grade) 'make grade-bench  how long a course of 25 takes to grade; RECORD=1'
	$(call offer,memcheck) 'make memcheck     the library tests under sanitizers'
	$(call offer,fuzz) 'make fuzz         scenes, options and files that are wrong; TEXTS=1e7 COMMANDS=1e4'
	$(call offer,tangle) 'make tangle       write src/ from chapters/'
	$(call offer,check-tangle) 'make check-tangle see that src/ is what the chapters say'
	@echo 'make format       see that the C files keep .clang-format'
	@echo 'make compile_commands.json   for editors'
	@echo 'make clean        remove build/'
