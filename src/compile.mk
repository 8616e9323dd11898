# How all of src/ is compiled: what the compiler can do, what is made again and
# what is not, and the two builds, portable and sanitized.
# `make tangle', which writes the C of this folder, leaves files like this one
# alone.

# make -n, -q and -t run the lines that name $(MAKE) all the same, so that
# another make can say what it would do. Such a line that does more than to
# call make begins with this.
unless_dry = $(if $(strip $(foreach f,n q t,$(findstring $f,$(filter-out -%,\
	$(firstword $(MAKEFLAGS)))))),exit; )

# What the compiler can do: GSL, OpenMP for the programs that can use all
# cores. The key is what was asked, and what everything compiled depends on.
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
rooms = toolbox line box scenes forces choosing
library := $(filter-out $(without),$(wildcard $(rooms:%=src/%/*.c)))
# $(call gsl_libs,src/FILE.c): what to link it with.
gsl_libs = $(if $(gsl),$(if $(filter $(1),$(gsl_files) $(gsl_users)),\
	$(GSL_LIBS)))

# Nothing is made twice. What is compiled hangs on the headers that it read,
# which the compiler writes down; and what comes out as it was keeps its time,
# so that nothing that hangs on it is made again. For that build/FILE is made
# aside, build/made/FILE says when it was last made, and build/made/FILE.d
# what was read for it. A rule names what it makes by its build/made/FILE, and
# `kept' all such files; what is done with them stands last in the Makefile.
made = $(@:build/made/%=build/%)
begin = @mkdir -p $(@D) $(dir $(made))
reads = -MMD -MP -MT $@ -MF $@.new
take = if cmp -s $(made).new $(made); then rm $(made).new && touch $@; \
	else mv $(made).new $(made) && touch -r $(made) $@; fi
# A source that is gone, like a header, is nothing to wait for.
take_compiled = @{ cat $@.new*; printf '%s:\n' $(filter %.c,$^); } >$@.d && \
	rm $@.new* && $(take)

parallel := bonkers springs gravity
flags_of = $(if $(filter $(parallel),$(notdir $*)),$(OPENMP)) \
	$(if $(gsl),$(if $(filter reference,$(notdir $*)),-DWITH_GSL))

# The portable build, which finds out when it runs what this machine can do
# (src/toolbox/vector.h), and the sanitized one.
define tree
build/made/$(1)obj/%.o: src/%.c build/compiler/key
	$$(begin)
	$$(call say,cc $$<)
	$$(Q)$$(CC) $$(STANDARD) $$($(2)) $$(flags_of) $$(reads) \
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
$(eval $(call tree,sanitized/,SANITIZED))

# For editors and clangd.
compile_commands.json: Makefile src/compile.mk $(library)
	@json() { printf '%s' "$$*" | sed 's/["\\]/\\&/g'; }; \
	here=$$(json "$$PWD"); how=$$(json "$(CC) $(STANDARD) $(PORTABLE)"); \
	for file in $(wildcard src/*/*.c); do \
	printf '  {"directory": "%s", "file": "%s",\n   "command": "%s"}\n' \
	"$$here" $$file "$$how -Isrc -c $$file"; \
	done | awk 'BEGIN { print "[" } NR > 1 && /^  {/ { print "," } \
	{ printf "%s%s", /^  {/ ? "" : "\n", $$0 } END { print "\n]" }' >$@.part
	@mv $@.part $@
