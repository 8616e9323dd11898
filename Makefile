# Bonkers: a book that is a program. `make help` lists what can be made.
#
# Everything made goes under build/. Only `make tangle` writes into src/ (the files
# whose first line names a chapter), and only `make reset` writes exercises/. How a
# thing is made is said beside it, in the files that are included below.

all: first

SHELL = /bin/sh
.DELETE_ON_ERROR .SUFFIXES:
.PHONY: all first programs format clean help FORCE

CC ?= cc
STANDARD = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -pedantic
# A root need not tell errno that its number was negative: with that, gcc
# would take the roots of a loop one by one. It changes no bit.
PORTABLE = -O2 -ffp-contract=off -fno-math-errno
SANITIZED = -g -O0 -ffp-contract=off $(sanitizers)

# What is given on the command line is a value, not text for make or a shell:
# recipes read it from the environment, as in "$$EX".
given = EX SUBMISSIONS REPORT JOBS HIDDEN RESULTS SECONDS TEXTS PRESET SCENE \
	KEYS UNTIL EVERY VIEW FPS LIVE DT METHOD KERNEL TOLERANCE OBSERVE X Y \
	EDITION WITH_CHAPTERS COMMANDS SEED FIRST SYSTEMS
$(foreach v,$(given),$(if $(filter-out undefined,$(origin $v)),\
	$(eval override $v := $$(value $v))$(eval export $v)))
# bash counts in the other; a comment behind it would leave its blank in it.
export seconds := $(value SECONDS)

# V=1 shows the commands.
Q = $(if $(V),,@)
say = $(if $(V),,@echo '  $(1)')

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
$(eval $(call only_with,chapters/press/book.tex,tangle check-tangle contact pages slides dist))
$(eval $(call only_with,tests/library,book works site test memcheck handout mutants \
	grade grade-bench jobs test-cluster test-systems))
$(eval $(call only_with,solutions,solution))
$(eval $(call only_with,tests/fuzz,fuzz fuzz-scenes fuzz-commands hunt))
# $(call offer,GOAL): echo, but for a goal that is absent.
offer = @$(if $(filter $(1),$(absent)),: ||) echo

# What students get; and what they do not: grading, the book, the tests, jobs.
include src/compile.mk src/examiner/check.mk plots/plots.mk
include src/studies/bench.mk $(wildcard src/jobs.mk src/examiner/grade.mk \
	chapters/press/book.mk tests/tests.mk)

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

# Every C file in the one layout: nothing is written, only compared.
c_files = $(wildcard tests/*.h tests/*/*.[ch] tests/exercises/*/*.c solutions/*.c \
	src/*/*.[ch])
format:
	$(call need,clang-format,clang-format)
	@clang-format --dry-run -Werror $(c_files)

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
	$(call offer,site) 'make site         the book as pages, to be opened in a browser'
	$(call offer,handout) 'make handout      the archive for students; WITH_CHAPTERS=1 for more'
	$(call offer,dist) 'make dist         what is published, and its checksums, in build/dist/'
	$(call offer,grade) 'make grade        SUBMISSIONS=dir: points for a folder of students'
	@echo 'make figures      the figures; QUALITY=lecture for slides too'
	@echo 'make figure       FIGURE=09-eight: one of them; QUALITY=lecture'
	$(call offer,contact) 'make contact      all figures and slides, small, to look at'
	$(call offer,slides) 'make slides       CHAPTER=9: its lecture figures with titles, one a page'
	$(call offer,pages) 'make pages        the measure of the book: pages, words, code, chapter by chapter'
	$(call offer,test) 'make test         prove everything: N passed, N failed'
	@echo 'make programs     only build build/bin/'
	@echo 'make inspect      SCENE=membrane X=t Y=z:30: what a scene does, drawn'
	@echo 'make chart        SCENE=figure-eight TOLERANCE=1e-6: what bonk tries'
	@echo 'make atlas        the maps of chapter 12 anew: some minutes'
	@echo 'make movie        a film: SCENE=ring VIEW=tilted or PRESET=cradle; LIVE=1'
	@echo 'make movies       films of all scenes and presets: half an hour'
	@echo 'make bench        the speed tables, measured here'
	$(call offer,mutants) 'make mutants      how many planted mistakes the exercises notice; OF=library'
	$(call offer,grade) 'make grade-bench  how long a course of 25 takes to grade; RECORD=1'
	$(call offer,jobs) 'make jobs         OF=grade, figures, atlas or hunt: lists for more machines than one'
	$(call offer,memcheck) 'make memcheck     the library tests under sanitizers'
	$(call offer,fuzz) 'make fuzz         scenes, options and files that are wrong; TEXTS=1e7 COMMANDS=1e4'
	$(call offer,hunt) 'make hunt         random scenes for bonk, against paths of another kind; REQUESTS=3000'
	$(call offer,tangle) 'make tangle       write the literate files of src/ from chapters/'
	$(call offer,check-tangle) 'make check-tangle see that those files are what the chapters say'
	@echo 'make format       see that the C files keep .clang-format'
	@echo 'make compile_commands.json   for editors'
	@echo 'make clean        remove build/'

# What is kept hangs on the day when it was made (`+:' is to do nothing, and
# to see whether it is as it was). What is lost is made again.
$(kept): build/%: build/made/%
	@+:
lost := $(filter-out $(wildcard $(kept)),$(kept))
lost := $(wildcard $(lost:build/%=build/made/%))
$(if $(lost),$(shell rm -f $(lost)))
-include $(wildcard build/made/*/*.d build/made/*/*/*.d \
	build/made/*/*/*/*.d build/made/*/*/*/*/*.d)
