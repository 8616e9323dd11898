# Rules to check exercises; they need a C compiler, make and CUnit.

.PHONY: check watch hint progress reset solution
exercises := $(patsubst tests/exercises/%/suite.c,%,\
	$(wildcard tests/exercises/[0-9][0-9][a-z]/suite.c \
	tests/exercises/P[0-9]/suite.c))
# Projects are exercises that are whole programs. YEAR=2027 changes the numbers in projects.
projects := $(filter P%,$(exercises))
year = $(if $(filter P%,$*),$(YEAR:%=-DPROJECT_YEAR=%))
build/made/check/year: FORCE
	@mkdir -p $(@D)
	@echo '$(YEAR)' | cmp -s - $@ || echo '$(YEAR)' >$@

# The commands that compile exercises. examine reads build/check/flags: the compiler with
# its flags on the first line, the libraries on the second. _XOPEN_SOURCE defines M_PI for
# students; the kit itself does not use M_PI. The warnings in `errors' are errors with every
# compiler: a function without its return, for example, does not compile.
check_base = $(CC) -std=c11 -D_XOPEN_SOURCE=700 -ffp-contract=off -g -O1 \
	$(errors:%=-Werror=%) $(CPPFLAGS)
errors = return-type implicit-function-declaration int-conversion
sanitizers = -fsanitize=address,undefined -fno-sanitize=object-size \
	-fno-sanitize-recover=undefined
check_cc = $$(sed -n 1p build/check/flags)
runner = build/check/flags build/check/libcheck.a
lists := $(exercises:%=build/check/%.list)
CHECK_BUILT = $(runner) $(exercises:%=build/check/%.suite.o) $(lists) \
	$(projects:%=build/check/%.given.o)

# make check checks the exercises in EX (01a,02b or '01a 02b'). Without EX it checks all
# exercises whose file differs from the stub. Only their suites are built. If a student
# begins another exercise while make watch is running, examine calls make to build the
# suite of that exercise.
comma = ,
named := $(subst $(comma), ,$(EX))
asked_for = $(filter $(named:=%),$(exercises))
ifneq ($(filter check watch hint progress solution,$(MAKECMDGOALS)),)
begun := $(filter $(exercises),$(shell cksum tests/exercises/*/stub.c \
	exercises/[0-9][0-9][a-z]*.c exercises/P[0-9]-*.c 2>/dev/null | awk ' \
	{ n = split($$3, part, "/"); sum = $$1 " " $$2 } \
	/stub.c$$/ { stub[part[n - 1]] = sum; next } \
	{ ex = substr(part[n], 1, part[n] ~ /^P/ ? 2 : 3) } \
	stub[ex] != sum { print ex }'))
endif
suites_of = $(if $(1),$(runner) $(1:%=build/check/%.suite.o) \
	$(patsubst %,build/check/%.given.o,$(filter P%,$(1))))
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

# Finds out whether the compiler has sanitizers, and stops if CUnit is missing.
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
	$(patsubst %,src/examiner/%.c,check no_hidden no_callback local guards remote run run_server \
	project) \
	src/toolbox/random.c)
	$(begin)
	@rm -f $(made).new
	@ar rcs $(made).new $^
	@$(take)
build/made/check/examine: $(patsubst %,build/obj/examiner/%.o,\
	examine watch hint reset solution round verdict cache work folder course sum \
	build message trial process text) \
	$(patsubst %,build/obj/toolbox/%.o,options replace)
	$(begin)
	$(call say,link $(made))
	$(Q)$(CC) $(PORTABLE) $(FLAGS) -o $(made).new $^ $(LDFLAGS)
	@$(take)
kept += build/check/flags build/check/libcheck.a build/check/examine \
	$(patsubst src/%.c,build/check/obj/%.o,$(wildcard src/examiner/*.c \
	src/toolbox/*.c)) $(exercises:%=build/check/%.suite.o) \
	$(projects:%=build/check/%.given.o)

# The suite of an exercise and both sides of its remote calls, in one object. If the
# exercise has a call.h, tests/remote.awk makes remote.c. remote.c is compiled twice: for
# the suite and, with -DREMOTE_SERVER, for the student's function (src/examiner/remote.h).
# Both objects define functions with the same names, so the suite's functions are renamed
# suite_NAME. The students' copy of the kit has calls.c instead, which is remote.c without
# comments. Nothing here is optimized: compiling then takes a third of the time, and checks
# take 5 % longer. The grader's judge is optimized, because some warnings need an optimizer.
remote_file = $(or $(wildcard $(addprefix tests/exercises/$(1)/,remote.c calls.c)),\
	$(patsubst tests/exercises/%/call.h,build/check/remote/%/remote.c,\
	$(wildcard tests/exercises/$(1)/call.h)))
remote_of = $(call remote_file,$*)
build/check/remote/%/remote.c: tests/exercises/%/call.h tests/remote.awk
	@mkdir -p $(@D) && awk -f tests/remote.awk $< >$@.new && mv $@.new $@
crossing = $$(sed -n '/^static/d; s/^[a-z][a-z_ *]*[ *]\([a-z0-9_]*\)(.*/\1/p' \
	/dev/null $(remote_of) | grep -v '^remote_' | sed 's/.*/-D&=suite_&/')
check_part = $(check_cc) $(year) -O0 -Wall -Wextra -pedantic -Isrc -c \
	-o build/check/obj/suite/$*
build/made/check/%.suite.o: tests/exercises/%/suite.c build/check/flags
	$(begin)
	$(call say,cc $<)
	@mkdir -p build/check/obj/suite
	$(Q)$(check_part).o $(reads) $(crossing) $<
	$(if $(remote_of),$(Q)$(check_part).outside.o $(reads).outside \
		$(crossing) $(remote_of))
	$(if $(remote_of),$(Q)$(check_part).inside.o $(reads).inside \
		-DREMOTE_SERVER $(remote_of))
	@ld -r -o $(made).new build/check/obj/suite/$*.o $(if $(remote_of),\
		build/check/obj/suite/$*.outside.o build/check/obj/suite/$*.inside.o)
	$(take_compiled)
$(foreach e,$(exercises),$(eval build/made/check/$(e).suite.o: $(call remote_file,$(e))))
# Right and wrong versions of the function that the header of a project declares. The
# student's program is linked with one version at a time. The versions are built without
# sanitizers and can be linked with programs that are built with or without sanitizers.
build/made/check/%.given.o: $(addprefix tests/exercises/%/,suite.c) \
		build/check/flags
	$(begin)
	$(Q)$(check_base) -Wall -Wextra -pedantic -Isrc -DREMOTE_GIVEN -c \
		-o $(made).new $(remote_of)
	@$(take)
$(projects:%=build/made/check/%.suite.o): build/made/check/year
$(foreach e,$(projects),$(eval build/made/check/$(e).given.o: \
	$(wildcard $(addprefix tests/exercises/$(e)/,remote.c calls.c))))

# Two runs of awk make two files for each exercise: NAME.list has the title, points and
# tests of the suite. NAME.types.h has the types of the functions that the stub declares
# (see tests/types.awk).
stubs := $(patsubst %,tests/exercises/%/stub.c,$(filter-out P%,$(exercises)))
types := $(patsubst %,build/check/%.types.h,$(filter-out P%,$(exercises)))
build/made/check/lists: tests/lists.awk tests/types.awk $(stubs) \
		$(exercises:%=tests/exercises/%/suite.c)
	@rm -rf build/check/lists && mkdir -p $(@D) build/check/lists
	@awk -v into=build/check/lists -f tests/lists.awk \
		$(filter %/suite.c,$^)
	@awk -v into=build/check/lists -f tests/types.awk $(filter %/stub.c,$^)
	@mv build/check/lists/* build/check && touch $@
$(lists) $(types): build/made/check/lists
	@+:
$(if $(filter-out $(wildcard $(lists) $(types)),$(lists) $(types)),\
	$(shell rm -f build/made/check/lists))
