# Rules for the grader, which needs a C compiler, make, CUnit, jansson, libxml2 and
# bubblewrap.

# make grade SUBMISSIONS=dir [REPORT=gradescope,...] [JOBS=n] [HIDDEN=seed]
# [EX=01a,02] [SECONDS=5] [RESULTS=dir] [UNSAFE=1] [YEAR=2027]
SUBMISSIONS =
grade_options = $${REPORT:+--report "$$REPORT"} $${JOBS:+--jobs "$$JOBS"} \
	$${HIDDEN:+--hidden "$$HIDDEN"} $${EX:+--exercises "$$EX"} \
	$${seconds:+--seconds "$$seconds"} $(if $(UNSAFE),--unsafe) \
	$${RESULTS:+--output "$$RESULTS"}
graded := $(foreach e,$(exercises),\
	$(if $(call remote_file,$(e)),$(e)))
GRADE_BUILT = build/grade/grade build/grade/flags \
	$(graded:%=build/grade/%.list) $(graded:%=build/grade/%.names) \
	$(patsubst %,build/grade/%.types.h,$(filter-out P%,$(graded)))

.PHONY: grade grade-parts grade-bench has-submissions hostile-programs jobs-grade
# Also makes a project of each hostile submission in the tests, and runs it: the main
# function of a correct solution calls the hostile code.
hostile-programs: grade-parts
	@ALL=1 tests/grader/programs.sh
grade-bench: grade-parts
	@tests/grader/bench 25 $(if $(RECORD),plots/data/B-grade.dat)
has-submissions:
	@[ -n "$$SUBMISSIONS" ] || { echo 'make: grade: which submissions?' \
		'make grade SUBMISSIONS=dir (a folder with one for each student)' \
		>&2; exit 2; }
grade: has-submissions grade-parts
	$(if $(filter-out $(graded),$(exercises)),@echo 'Not graded (there is' \
		'no call.h or remote.c in its folder):' $(filter-out $(graded),$(exercises)))
	@build/grade/grade $(grade_options) "$$SUBMISSIONS"
jobs-grade: has-submissions grade-parts
	$(call list,build/grade/grade --list $(grade_options) "$$SUBMISSIONS")
grade-parts: has-grade-parts $(GRADE_BUILT)

.PHONY: has-grade-parts
has-grade-parts:
	@printf '#include <jansson.h>\n#include <libxml/xmlwriter.h>\n' | \
		$(CC) $(xml_flags) $(FLAGS) -E - >/dev/null 2>&1 || { \
		echo 'make: grade needs jansson and libxml2; install them with:' \
		'apt-get install --no-install-recommends libjansson-dev' \
		'libxml2-dev bubblewrap' >&2; exit 1; }

# The flags of libxml2, from pkg-config, which runs only when the grader is built.
xml_flags = $$(pkg-config --cflags libxml-2.0 2>/dev/null || \
	echo -I/usr/include/libxml2)
build/made/grade/obj/grade/%.o: src/examiner/%.c build/compiler/key
	$(begin)
	$(call say,cc $<)
	$(Q)$(CC) $(STANDARD) -D_XOPEN_SOURCE=700 $(PORTABLE) -Isrc $(reads) \
		$(xml_flags) $(FLAGS) -c -o $(made).new $<
	$(take_compiled)
build/made/grade/grade: $(patsubst %,build/grade/obj/grade/%.o,grade grading \
	sandbox folder marks submissions publish build message sum trial process text) \
	$(patsubst %,build/obj/toolbox/%.o,options replace)
	$(begin)
	$(call say,link $(made))
	$(Q)$(CC) $(PORTABLE) $(FLAGS) -o $(made).new $^ $(LDFLAGS) \
		-ljansson -lxml2
	@$(take)

# build/grade/flags has six lines: 1. the compiler for students' files, without
# sanitizers; 2. the compiler with sanitizers; 3. its flag that omits source lines from
# messages; 4. the command that links without sanitizers; 5. the flag for debugging
# information with line numbers but no variables; 6. the command that links with
# sanitizers.
#
# Linkers are tried before they are used, and rejected if they print anything. gold
# links with sanitizers in a third of the usual linker's time; a flag keeps it from
# mapping whole libraries. Debian 13 has LLVM's linker instead. If neither works, lines
# 4 and 6 are empty, and the compiler links as usual.
build/made/grade/flags: build/check/flags src/examiner/grade.mk
	$(begin)
	@echo 'int main(void) { return 0; }' >build/grade/probe.c; \
	works() { said=$$("$$@" -o build/grade/probe build/grade/probe.c -lm 2>&1) && \
		[ -z "$$said" ] && build/grade/probe; }; \
	linker() { for how in '-fuse-ld=gold -Wl,--no-map-whole-files' -fuse-ld=lld; do \
		! works "$$@" $$how || { echo "$$*" $$how -o program answer.o \
			../kit/sandbox.suite.o -lm; return; }; done; echo; }; \
	terse=-fno-diagnostics-show-caret; \
	works $(check_base) $$terse || terse=-fno-caret-diagnostics; \
	lean=-g1; works $(check_cc) $$lean || lean=; \
	printf '%s\n' '$(check_base) -fmax-errors=20' \
		"$$(sed -n 1p build/check/flags) -fmax-errors=20" "$$terse" \
		"$$(linker $(check_base))" "$$lean" "$$(linker $(check_cc))" >$(made).new
	@$(take)

# Objects that are linked with each judge, or with a student's file in its sandbox.
build/made/grade/obj/%.o: src/%.c build/check/flags
	$(begin)
	$(call say,cc $(made))
	$(Q)$(check_base) -O3 $(reads) -Wall -Wextra -pedantic -Isrc \
		-c -o $(made).new $<
	$(take_compiled)
build/made/grade/libjudge.a: $(patsubst src/%.c,build/grade/obj/%.o,\
	$(patsubst %,src/examiner/%.c,check no_hidden no_callback judge transport remote run project) \
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

# Four files are made for each exercise: EX.judge, the program with the suite;
# EX.inside.o, which is copied into the sandbox and linked with the student's file there;
# EX.list, its tests; and EX.names, the symbols that the student's file may export, as
# options of objcopy. The judge is compiled with -g1, which is faster than -g, and
# EX.inside.o is stripped of its symbols, so that only a sixth of it is copied.
judge_part = build/grade/obj/judge/$*
judge_of = $(wildcard $(addprefix tests/exercises/$*/,suite.c hidden.c)) $(remote_of)
build/made/grade/%.judge: tests/exercises/%/suite.c build/grade/libjudge.a
	$(begin)
	@mkdir -p build/grade/obj/judge
	$(call say,cc $(made))
	$(Q)for file in $(judge_of); do \
		part=$${file##*/} && part=$${part%.c} && \
		$(check_base) -g1 $(year) $(reads).$$part -Wall -Wextra -pedantic \
		-Isrc \
		-c -o $(judge_part).$$part.o $$file || exit 1; done
	$(Q)$(check_base) -o $(made).new \
		$(patsubst %.c,$(judge_part).%.o,$(notdir $(judge_of))) \
		build/grade/libjudge.a $(LDFLAGS) -lcunit -lm
	$(take_compiled)
$(foreach e,$(graded),$(eval build/made/grade/$(e).judge: \
	$(wildcard tests/exercises/$(e)/hidden.c) $(call remote_file,$(e))))
$(foreach e,$(graded),$(eval build/made/grade/$(e).inside.o: $(call remote_file,$(e))))
build/made/grade/%.inside.o: $(patsubst %,build/grade/obj/examiner/%.o,sandboxed endless transport remote guards)
	$(begin)
	@mkdir -p build/grade/obj/remote
	$(Q)$(check_base) $(reads) -Wall -Wextra -pedantic -DREMOTE_SERVER -Isrc \
		-c -o build/grade/obj/remote/$*.o $(remote_of)
	@ld -r -S -o $(made).new build/grade/obj/remote/$*.o $(filter %.o,$^)
	$(take_compiled)
$(projects:%=build/made/grade/%.judge): build/made/check/year
# For a project EX.inside.o is an archive. It contains the driver, which runs the
# student's program in the sandbox, and the functions that the student's program is
# linked with. The driver's main is renamed, because the student's program has its own.
# The driver's time() (see endless.c) is made local, so that it replaces no other.
$(foreach e,$(projects),$(eval build/made/grade/$(e).inside.o: \
	build/check/$(e).given.o))
build/made/grade/P%.inside.o: tests/exercises/P%/remote.c $(patsubst %,\
		build/grade/obj/examiner/%.o,run_server sandboxed endless transport remote guards)
	$(begin)
	@mkdir -p build/grade/obj/remote
	$(Q)$(check_base) $(reads) -Wall -Wextra -pedantic -DREMOTE_SERVER -Isrc \
		-c -o build/grade/obj/remote/P$*.law.o $<
	@ld -r -o build/grade/obj/remote/P$*.o build/grade/obj/remote/P$*.law.o \
		$(filter build/grade/%.o,$^) && \
		objcopy --redefine-sym main=sandbox_main \
		--localize-symbol=time build/grade/obj/remote/P$*.o
	@rm -f $(made).new && \
		ar rcsD $(made).new build/grade/obj/remote/P$*.o \
		build/check/P$*.given.o
	$(take_compiled)
build/grade/%.types.h: build/check/%.types.h
	@cp $< $@
build/grade/P%.names: build/grade/P%.inside.o
	@echo program >$@
build/grade/%.list: build/grade/%.judge
	@build/grade/$*.judge --list >$@
build/grade/%.names: build/grade/%.inside.o tests/exercises/%/stub.c
	@$(check_base) -Isrc/examiner -c -o build/grade/obj/remote/$*.stub.o \
		tests/exercises/$*/stub.c
	@nm -A -P -g build/grade/$*.inside.o build/grade/obj/remote/$*.stub.o | \
		awk '$$3 == "U" && /inside.o: / { wanted[$$2] } \
		$$3 != "U" && $$2 in wanted && /stub.o: / \
		{ printf "--keep-global-symbol=%s ", $$2 }' >$@
