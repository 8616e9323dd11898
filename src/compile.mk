# How src/ is compiled: when a file is rebuilt, what the compiler can do, and the two
# builds, portable and with sanitizers.

# How make decides what to rebuild
#
# make rebuilds a file when something that it depends on is newer. Taken literally, this
# rebuilds too much: a changed comment in random.c leaves its object the same, byte for
# byte, and yet every program would be linked and every figure drawn again. So most
# files have a stamp, which is an empty file. For the program disks there are
#
#   build/bin/disks          the file itself; its time says when its bytes last changed
#   build/made/bin/disks     its stamp, an empty file; its time says when the rule last ran
#   build/made/bin/disks.d   for what is compiled: the headers that the compiler read
#
# A rule has the stamp as its target and uses the variables $(begin), $(take) and
# $(made), which here is build/bin/disks:
#
#   build/made/bin/disks: build/obj/programs/disks.o build/obj/libbonkers.a
#   	$(begin)                          makes the folders
#   	cc -o $(made).new $^              makes the file under another name
#   	@$(take)                          keeps the old file if the new one equals it
#
# The name of the file is added to $(kept), and the end of the Makefile makes each file
# in $(kept) depend on its stamp. So make compares the stamp with the sources of the
# file, and the file itself with all that is made from it. A rule that compiles passes
# $(reads) to the compiler, which makes the compiler write the .d file, and ends with
# $(take_compiled), which keeps that file.
made = $(@:build/made/%=build/%)
begin = @mkdir -p $(@D) $(dir $(made))
reads = -MMD -MP -MT $@ -MF $@.new
take = if cmp -s $(made).new $(made); then rm $(made).new && touch $@; \
	else mv $(made).new $(made) && touch -r $(made) $@; fi
# Gives each source a rule without a recipe, just as -MP does for headers, so that make
# does not stop if a file that the previous build read has been deleted.
take_compiled = @{ cat $@.new*; printf '%s:\n' $(filter %.c,$^); } >$@.d && \
	rm $@.new* && $(take)

# These goals change files that other goals read. When one of them is asked for, even
# `make -j' runs one recipe at a time.
ifneq ($(filter tangle clean reset,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif

# Under -n, -q and -t make still runs recipe lines that contain $(MAKE), so that the
# inner make can print what it would do. If such a line does other things, too, it begins
# with $(unless_dry), which skips the rest of the line under these options.
unless_dry = $(if $(strip $(foreach f,n q t,$(findstring $f,$(filter-out -%,\
	$(firstword $(MAKEFLAGS)))))),exit; )

# Tests of the compiler. build/compiler/key records the compiler, its version and the
# flags. Every object depends on it, so that everything is recompiled when one of them
# changes. build/compiler.mk records whether a program with GSL and one with OpenMP
# could be compiled, linked and run.
FLAGS = $(CPPFLAGS) $(CFLAGS)
GSL_LIBS = -lgsl -lgslcblas
asked = build/compiler
try = $(CC) $(FLAGS) $(1) $(LDFLAGS) $(2) -o $(asked)/try 2>/dev/null && \
	$(asked)/try
build/compiler/key: export key = $(CC) / $(FLAGS) / $(LDFLAGS) / \
	$(foreach v,STANDARD PORTABLE SANITIZED sanitizers,$(value $v))
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
	@{ if $(call try,$(asked)/gsl.c,$(GSL_LIBS) -lm); \
		then echo 'gsl = yes'; fi; \
	if $(call try,-fopenmp $(asked)/main.c $(asked)/other.c); \
		then echo 'OPENMP = -fopenmp'; fi; } >$@.part
	@mv $@.part $@
# The students' goals need neither GSL nor OpenMP, and skip these tests, which take time.
students := check watch hint progress reset solution build/check/% help clean
ifneq ($(filter-out $(students),$(or $(MAKECMDGOALS),first)),)
include build/compiler.mk
endif

# The programs, and the files of the library. A file that includes laws.h or a header of
# GSL, the GNU Scientific Library, is left out where GSL is not installed. A file that
# includes reference.h is linked with GSL if it is installed, and works without it.
gsl_sources = src/*/*.c tests/library/*.c tests/stability/*.c
gsl_files := $(filter-out src/forces/reference.c,$(shell grep -lE \
	'^.include ("line/laws.h"|<gsl/)' $(gsl_sources) 2>/dev/null))
gsl_users := $(shell grep -l '^.include "forces/reference.h"' $(gsl_sources) \
	2>/dev/null)
without = $(if $(gsl),,$(gsl_files))
mains := $(filter-out $(without),$(wildcard src/programs/*.c src/studies/*.c))
programs := $(notdir $(mains:.c=))
library_folders = toolbox line box scenes forces choosing
library := $(filter-out $(without),$(wildcard $(library_folders:%=src/%/*.c)))
# $(call gsl_libs,src/FILE.c) gives the libraries of GSL to link FILE with, if any.
gsl_libs = $(if $(gsl),$(if $(filter $(1),$(gsl_files) $(gsl_users)),\
	$(GSL_LIBS)))

# Files that are compiled with OpenMP, by base name. WITH_GSL tells reference.c
# that GSL is available.
parallel := bonkers springs gravity
flags_of = $(if $(filter $(parallel),$(notdir $*)),$(OPENMP)) \
	$(if $(gsl),$(if $(filter reference,$(notdir $*)),-DWITH_GSL))

# $(call tree,FOLDER/,FLAGS) gives the rules of one build: its objects, its library, its
# programs. The portable build chooses the fastest vector code when it runs
# (src/toolbox/vector.h); the one with sanitizers finds memory errors.
define tree
build/made/$(1)obj/%.o: src/%.c build/compiler/key
	$$(begin)
	$$(call say,cc $$<)
	$$(Q)$$(CC) $$(STANDARD) $$($(2)) $$(flags_of) $$(reads) \
		-DBUILD_FLAGS='"$$(strip $$($(2)))"' -Isrc $$(FLAGS) \
		-c -o $$(made).new $$<
	$$(take_compiled)
# The archive depends on the folders as well, so that a deleted file drops out of it.
build/made/$(1)obj/libbonkers.a: $$(library:src/%.c=build/$(1)obj/%.o) \
		$$(library_folders:%=src/%)
	$$(begin)
	@rm -f $$(made).new
	@ar rcs $$(made).new $$(filter %.o,$$^)
	@$$(take)
$(foreach p,$(mains:src/%.c=%),
build/made/$(1)bin/$(notdir $(p)): build/$(1)obj/$(p).o)
$(programs:%=build/made/$(1)bin/%): build/$(1)obj/libbonkers.a
	$$(begin)
	$$(call say,link $$(made))
	$$(Q)$$(CC) $$($(2)) $$(OPENMP) $$(FLAGS) -o $$(made).new \
		$$(filter %.o,$$^) $$(filter %.a,$$^) $$(LDFLAGS) \
		$$(call gsl_libs,$$(filter %/$$(@F).c,$(mains))) -lm
	@$$(take)
kept += $$(patsubst src/%.c,build/$(1)obj/%.o,$$(wildcard src/*/*.c)) \
	build/$(1)obj/libbonkers.a $$(programs:%=build/$(1)bin/%)
endef
$(eval $(call tree,,PORTABLE))
$(eval $(call tree,sanitized/,SANITIZED))

# Writes the compiler's flags for clangd and many editors.
compile_commands.json: Makefile src/compile.mk $(library)
	@json() { printf '%s' "$$*" | sed 's/["\\]/\\&/g'; }; \
	here=$$(json "$$PWD"); how=$$(json "$(CC) $(STANDARD) $(PORTABLE)"); \
	for file in $(wildcard src/*/*.c); do \
	printf '  {"directory": "%s", "file": "%s",\n   "command": "%s"}\n' \
	"$$here" $$file "$$how -Isrc -c $$file"; \
	done | awk 'BEGIN { print "[" } NR > 1 && /^  {/ { print "," } \
	{ printf "%s%s", /^  {/ ? "" : "\n", $$0 } END { print "\n]" }' >$@.part
	@mv $@.part $@
