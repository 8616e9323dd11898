# The grader: cc, make, CUnit, jansson, libxml2, bubblewrap.

# make grade SUBMISSIONS=dir [REPORT=gradescope,...] [JOBS=n] [HIDDEN=seed]
# [EX=01a,02] [SECONDS=5] [RESULTS=dir] [UNSAFE=1] [YEAR=2027]
SUBMISSIONS =
grade_options = $${REPORT:+--report "$$REPORT"} $${JOBS:+--jobs "$$JOBS"} \
	$${HIDDEN:+--hidden "$$HIDDEN"} $${EX:+--exercises "$$EX"} \
	$${seconds:+--seconds "$$seconds"} $(if $(UNSAFE),--unsafe) \
	$${RESULTS:+--output "$$RESULTS"}
graded := $(foreach e,$(exercises),\
	$(if $(wildcard tests/exercises/$(e)/remote.c),$(e)))
GRADE_BUILT = build/grade/grade build/grade/flags \
	$(graded:%=build/grade/%.list) $(graded:%=build/grade/%.names) \
	$(patsubst %,build/grade/%.types.h,$(filter-out P%,$(graded)))

.PHONY: grade grade-parts grade-bench has-submissions hostile-programs jobs-grade
# Each of the grader's hostile tricks once more, in a whole program.
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
		'no remote.c in its folder):' $(filter-out $(graded),$(exercises)))
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
	box folder marks submissions publish build message sum trial process text) \
	$(patsubst %,build/obj/toolbox/%.o,options replace)
	$(begin)
	$(call say,link $(made))
	$(Q)$(CC) $(PORTABLE) $(FLAGS) -o $(made).new $^ $(LDFLAGS) \
		-ljansson -lxml2
	@$(take)

# The compiler for students' files, without sanitizers and with; how gcc, or
# else clang, is told to quote no lines; how the one program is linked and how
# the other; and how the compiler is told to note lines, and no variables, for
# a debugger that nobody starts.
build/made/grade/flags: build/check/flags src/examiner/grade.mk
	$(begin)
	@$(linking) \
	terse=-fno-diagnostics-show-caret; $(CC) $$terse -E -x c /dev/null \
		>/dev/null 2>&1 || terse=-fno-caret-diagnostics; \
	lean=-g1; compile $(check_cc) $$lean >/dev/null 2>&1 && \
		runs $(check_cc) $$lean $$files || lean=; \
	printf '%s %s\n' '$(check_base)' -fmax-errors=20 \
		"$$(sed -n 1p build/check/flags)" -fmax-errors=20 $$terse '' \
		"$$(link $(check_base))" '' $$lean '' "$$(link $(check_cc))" '' \
		>$(made).new
	@$(take)

# gold is faster than the usual linker, most of all among the names of the
# sanitizers; and it is not to map whole libraries of which it reads a part.
# It is faster again when it is started by nobody but us: the compiler's driver
# starts a second driver, that loads an optimizer, and leaves it to search
# folders. What it is told in the end is noted by an ld.gold of our own; then
# the plugin is left out, each library has its full name (libgcc_s.so is but a
# pointer to libgcc_s.so.1), and no folder is read. All is in /usr or /lib, or a
# box would not have it. Where that does not work, the driver is called with
# gold; and where there is none, as always.
define linking
	rm -rf build/grade/link; \
	mkdir -p build/grade/link/bin build/grade/link/kit build/grade/link/work; \
	files='-o program answer.o ../kit/box.suite.o -lm'; \
	gold='-fuse-ld=gold -Wl,--no-map-whole-files'; \
	printf '%s\n' '#!/bin/sh' 'printf "%s\n" "$$@" >../words' \
		'exec ld.gold "$$@"' >build/grade/link/bin/ld.gold; \
	chmod +x build/grade/link/bin/ld.gold; \
	runs() (cd build/grade/link/work && rm -f program && \
		"$$@" >../said 2>&1 && [ ! -s ../said ] && ./program); \
	compile() (cd build/grade/link/work && \
		echo 'int main(void) { return 0; }' >../probe.c && \
		echo 'extern int box; int box;' >../kit/probe.c && \
		"$$@" -c -o answer.o ../probe.c && \
		"$$@" -c -o ../kit/box.suite.o ../kit/probe.c); \
	library() { first=; [ "$$1" != gcc_s ] || first=so.1; \
		for ending in $$first so a; do \
		for folder in $$(sed -n 's/^-L//p' build/grade/link/words); do \
			[ ! -f "$$folder/lib$$1.$$ending" ] || { \
			echo "$$folder/lib$$1.$$ending"; return; }; done; done; \
		echo ' '; }; \
	words() { while read -r word; do case $$word in \
		-plugin) read -r word ;; \
		-plugin-opt=* | -L*) ;; \
		-l*) library "$${word#-l}" ;; \
		*) printf '%s\n' "$$word" ;; esac; \
		done <build/grade/link/words; }; \
	direct() (PATH=/usr/bin:/bin; \
		! words | grep -q '[^-A-Za-z0-9_.,:=+/]\|^/[^ul]' || exit; \
		command=$$(echo ld.gold -nostdlib --no-map-whole-files $$(words)); \
		runs $$command && echo "$$command"); \
	link() { compile "$$@" >/dev/null 2>&1; \
		runs "$$@" $$gold $$files || return; \
		runs "$$@" -B../bin $$gold $$files && direct || \
		echo "$$*" $$gold $$files; };
endef

# What judges and boxes are linked with.
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

# One exercise: its judge, what goes into a box with the student's file, the
# list of its tests, and the names that the student's file may show. Of a judge
# a debugger knows the lines and no more, which compiles sooner; and nothing of
# what is copied into each box and linked there, which has a sixth of the size.
judge_part = build/grade/obj/judge/$*
judge_of = $(wildcard $(addprefix tests/exercises/$*/,suite.c remote.c hidden.c))
build/made/grade/%.judge: tests/exercises/%/suite.c tests/exercises/%/remote.c \
		build/grade/libjudge.a
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
	$(wildcard tests/exercises/$(e)/hidden.c)))
build/made/grade/%.inside.o: tests/exercises/%/remote.c $(patsubst %,\
		build/grade/obj/examiner/%.o,boxed orbit transport remote guards)
	$(begin)
	@mkdir -p build/grade/obj/remote
	$(Q)$(check_base) $(reads) -Wall -Wextra -pedantic -DREMOTE_SERVER -Isrc \
		-c -o build/grade/obj/remote/$*.o $<
	@ld -r -S -o $(made).new build/grade/obj/remote/$*.o $(filter %.o,$^)
	$(take_compiled)
$(projects:%=build/made/grade/%.judge): build/made/check/year
# Of a project: an archive with the box's program, whose main has another
# name and whose time is its own, and with what the student's program is given.
$(foreach e,$(projects),$(eval build/made/grade/$(e).inside.o: \
	build/check/$(e).given.o))
build/made/grade/P%.inside.o: tests/exercises/P%/remote.c $(patsubst %,\
		build/grade/obj/examiner/%.o,running boxed orbit transport remote guards)
	$(begin)
	@mkdir -p build/grade/obj/remote
	$(Q)$(check_base) $(reads) -Wall -Wextra -pedantic -DREMOTE_SERVER -Isrc \
		-c -o build/grade/obj/remote/P$*.law.o $<
	@ld -r -o build/grade/obj/remote/P$*.o build/grade/obj/remote/P$*.law.o \
		$(filter build/grade/%.o,$^) && \
		objcopy --redefine-sym main=box_main \
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
