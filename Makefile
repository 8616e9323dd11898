# Bonkers: a book that is a program. `make help` lists what can be made.
#
# What make produces goes under build/. Only `make tangle` writes into src/ (the files
# whose first line names a chapter), and only `make reset` writes exercises/. The rules
# are in the files included below; src/compile.mk explains what is rebuilt, and when.

all: first

SHELL = /bin/sh
.DELETE_ON_ERROR .SUFFIXES:
.PHONY: all first programs format clean help FORCE

CC ?= cc
STANDARD = -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -pedantic
# -fno-math-errno: without it gcc computes the square roots of a loop one at a time,
# because each of them may have to set errno. It does not change a bit of the results.
PORTABLE = -O2 -ffp-contract=off -fno-math-errno
SANITIZED = -g -O0 -ffp-contract=off $(sanitizers)

# Variables that users set, as in `make check EX=01a'. Recipes read them from the
# environment, as "$$EX", so that neither make nor a shell runs any of a value.
given = EX SUBMISSIONS REPORT JOBS HIDDEN RESULTS SECONDS TEXTS PRESET SCENE \
	KEYS UNTIL EVERY VIEW FPS LIVE DT METHOD KERNEL TOLERANCE OBSERVE X Y \
	EDITION WITH_CHAPTERS COMMANDS SEED FIRST SYSTEMS
$(foreach v,$(given),$(if $(filter-out undefined,$(origin $v)),\
	$(eval override $v := $$(value $v))$(eval export $v)))
# Recipes read SECONDS as "$$seconds": bash has a variable SECONDS that counts by itself.
export seconds := $(value SECONDS)

# `make V=1' prints every command; otherwise a short line stands for it.
Q = $(if $(V),,@)
say = $(if $(V),,@echo '  $(1)')

# $(call need,COMMAND,PACKAGE) stops, naming the package, unless COMMAND is installed.
need = @command -v $(1) >/dev/null 2>&1 || { echo "make: $(1) is missing;\
 install it with: apt-get install --no-install-recommends $(2)" >&2; exit 1; }

# The students' copy of the kit (make handout) lacks some files. $(call only_with,FILE,GOALS)
# makes GOALS fail with a message where FILE is missing; make help leaves them out.
define only_with
ifeq ($(wildcard $(1)),)
absent += $(2)
ifneq ($(filter $(2),$(MAKECMDGOALS)),)
$$(error $(firstword $(filter $(2),$(MAKECMDGOALS))) needs $(1), which is not\
 part of the course as handed out; your lecturer has it)
endif
endif
endef
$(eval $(call only_with,chapters/press/book.tex,tangle check-tangle debug contact pages slides dist))
$(eval $(call only_with,tests/library,book site test memcheck handout mutants \
	grade grade-bench jobs test-cluster test-systems))
$(eval $(call only_with,solutions,solution))
$(eval $(call only_with,tests/fuzz,fuzz fuzz-scenes fuzz-commands hunt))
# $(call help_for,GOAL) TEXT prints a line of the help, unless GOAL cannot be made here.
help_for = @$(if $(filter $(1),$(absent)),: ||) echo

# The files of the second include are not in the students' copy.
include src/compile.mk src/examiner/check.mk plots/plots.mk
include src/studies/bench.mk $(wildcard src/jobs.mk src/examiner/grade.mk \
	chapters/press/book.mk tests/tests.mk)

programs: $(programs:%=build/bin/%)

# `make' alone builds the programs, shows a first result, and says what to try next.
first: programs
	$(if $(gsl),,@echo 'Not built, for want of GSL (apt-get install\
 --no-install-recommends libgsl-dev):' \
		$(notdir $(basename $(filter src/programs/% src/studies/%,\
		$(gsl_files)))))
	@echo 'Two bodies meet: 1 kg at 1 m/s runs into 4 kg at rest.'
	@build/bin/collide --velocities 1,0 --inverse-masses 1,0.25
	@echo 'Next: make check (the exercises),' $(if $(filter book,$(absent)),\
		'the book (bonkers.pdf)','make book (the PDF)'), make help

# Checks that every C file has the layout of .clang-format; changes nothing.
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
	$(call help_for,solution) 'make solution     EX=01a: the worked solution, once yours passes'
	@echo 'make reset        EX=01a: begin afresh; what you had is kept'
	$(call help_for,book) 'make book         the PDF; EDITION=instructor adds the solutions'
	$(call help_for,site) 'make site         the book as pages, to be opened in a browser'
	$(call help_for,handout) 'make handout      the archive for students; WITH_CHAPTERS=1 for more'
	$(call help_for,dist) 'make dist         what is published, and its checksums, in build/dist/'
	$(call help_for,grade) 'make grade        SUBMISSIONS=dir: points for a folder of students'
	@echo 'make figures      the figures; QUALITY=lecture for slides too'
	@echo 'make figure       FIGURE=09-eight: one of them; QUALITY=lecture'
	$(call help_for,contact) 'make contact      all figures and slides, small, to look at'
	$(call help_for,slides) 'make slides       CHAPTER=9: its lecture figures with titles, one a page'
	$(call help_for,pages) 'make pages        the measure of the book: pages, words, code, chapter by chapter'
	$(call help_for,test) 'make test         prove everything: N passed, N failed'
	@echo 'make programs     only build build/bin/'
	@echo 'make inspect      SCENE=membrane X=t Y=z:30: what a scene does, drawn'
	@echo 'make chart        SCENE=figure-eight TOLERANCE=1e-6: what bonk tries'
	@echo 'make atlas        the maps of chapter 12 anew: some minutes'
	@echo 'make movie        a film: SCENE=ring VIEW=tilted or PRESET=cradle; LIVE=1'
	@echo 'make movies       films of all scenes and presets: half an hour'
	@echo 'make bench        the speed tables, measured here'
	$(call help_for,mutants) 'make mutants      how many planted mistakes the exercises notice; OF=library'
	$(call help_for,grade) 'make grade-bench  how long a course of 25 takes to grade; RECORD=1'
	$(call help_for,jobs) 'make jobs         OF=grade, figures, atlas or hunt: lists for more machines than one'
	$(call help_for,memcheck) 'make memcheck     the library tests under sanitizers'
	$(call help_for,fuzz) 'make fuzz         scenes, options and files that are wrong; TEXTS=1e7 COMMANDS=1e4'
	$(call help_for,hunt) 'make hunt         random scenes for bonk, against paths of another kind; REQUESTS=3000'
	$(call help_for,debug) 'make debug        programs for a debugger, in which code has the lines of its chapter'
	$(call help_for,tangle) 'make tangle       write the literate files of src/ from chapters/'
	$(call help_for,check-tangle) 'make check-tangle see that those files are what the chapters say'
	@echo 'make format       see that the C files keep .clang-format'
	@echo 'make compile_commands.json   for editors'
	@echo 'make clean        remove build/'

# Stamps (see src/compile.mk). Each file depends on its stamp through an empty recipe, which
# runs even under make -n (+). If a file is missing, its stamp is deleted: both are rebuilt.
$(kept): build/%: build/made/%
	@+:
lost := $(filter-out $(wildcard $(kept)),$(kept))
lost := $(wildcard $(lost:build/%=build/made/%))
$(if $(lost),$(shell rm -f $(lost)))
-include $(wildcard build/made/*/*.d build/made/*/*/*.d \
	build/made/*/*/*/*.d build/made/*/*/*/*/*.d)
