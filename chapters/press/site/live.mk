# Live figures: each file of src/page/ is compiled to WebAssembly. The script of a figure
# contains that, compressed and in base64, since a page that was opened as a file can fetch
# nothing, and chapters/press/site/live-NAME.js. `make site' makes them with the pages;
# `make live' makes nothing else.
.PHONY: live has-wasm
live_names := $(filter-out table,$(patsubst src/page/%.c,%,$(wildcard \
	src/page/*.c)))
plays := $(shell sed -n 's/^\(play-[a-z]*\) .*/\1/p' \
	chapters/press/site/live-scenes)
LIVE_FILES := build/site/live/live.js $(live_names:%=build/site/live/%.js) \
	build/site/player.html build/site/live/player.css \
	$(plays:%=build/site/live/%.js)
live: $(LIVE_FILES)

has-wasm:
	$(call need,clang,clang)
	$(call need,wasm-ld,lld)
	@[ -e /usr/lib/wasm32-wasi/libc.a ] || { echo 'make: wasi-libc is\
 missing; install it with: apt-get install --no-install-recommends wasi-libc\
 libclang-rt-dev-wasm32' >&2; exit 1; }

# The kit's own flags. Without NDEBUG the texts of asserts would double a file's size;
# the tests run with all asserts.
wasm = clang --target=wasm32-wasi --sysroot=/usr $(STANDARD) $(PORTABLE) \
	-DNDEBUG -Isrc
# Files that need a file system, signals, GSL or OpenCL are left out.
wasm_tools := $(patsubst %,src/toolbox/%.c,digits lines random aligned)
wasm_sources := src/page/table.c $(wasm_tools) $(filter-out %/laws.c %/states.c %/checkpoint.c \
	%/reference.c %/opencl.c,$(wildcard $(patsubst %,src/%/*.c,line box scenes forces)))
wasm_objects := $(wasm_sources:src/%.c=build/wasm/%.o)
# -Os where speed does not matter; results keep every bit.
$(filter-out %/gravity.o %/tree.o %/springs.o %/spheres.o,$(filter build/wasm/scenes/% \
	build/wasm/forces/%,$(wasm_objects))): small = -Os
build/wasm/%.o: src/%.c chapters/press/site/live.mk | has-wasm
	@mkdir -p $(@D)
	$(call say,wasm $<)
	$(Q)$(wasm) $(small) -MMD -MP -c -o $@ $<
exports := number begin run look
more := word text make observe change save array
build/wasm/%.wasm: build/wasm/page/%.o $(wasm_objects)
	$(call say,wasm $@)
	$(Q)$(wasm) -mexec-model=reactor -Wl,--gc-sections,--strip-all \
		$(exports:%=-Wl$(comma)--export=page_%) \
		$(more:%=-Wl$(comma)--export-if-defined=page_%) -o $@ $^
comma := ,
.SECONDARY: $(live_names:%=build/wasm/%.wasm) \
	$(live_names:%=build/wasm/page/%.o)
-include $(wildcard build/wasm/*/*.d)

site_scripts = chapters/press/site
build/site/live/live.js: $(site_scripts)/live.js
	@mkdir -p $(@D)
	@cp $< $@
build/site/player.html: $(site_scripts)/player.html
	@mkdir -p $(@D)
	@cp $< $@
build/site/live/player.css: $(site_scripts)/live-player.css
	@mkdir -p $(@D)
	@cp $< $@

# Figures that open the player with one of its scenes.
build/site/live/play-%.js: $(site_scripts)/live-scenes
	@mkdir -p $(@D)
	@sed -n "s/^play-$* \([^ ]*\) \(.*\)/live.opens('play-$*', '\1', \"\2\");/p" \
		$< >$@.part
	@mv $@.part $@

# Numbers that a figure's script gets from a table: for the clock the right density of a
# coordinate of four disks; for the player the speed of each scene and its unit of time.
live_numbers =
build/site/live/player.js: plots/films
build/site/live/player.js: live_numbers = { echo 'live.films = {' && awk \
	'$$1 == "scene" { printf "\"%s\": [%s, \"%s\"],\n", $$2, $$3, $$6 }' \
	plots/films && echo '};'; } &&
build/site/live/clock.js: truth = plots/data/disks4_r0.15_unitbox.dat
build/site/live/clock.js: plots/data/disks4_r0.15_unitbox.dat
build/site/live/clock.js: live_numbers = { printf 'live.numbers.disks4 = [' && \
	awk '!/^\#/ && $$1 >= 0.15 && $$1 < 0.5 { printf "%s,", $$3 }' $(truth) && \
	echo '];'; } &&
build/site/live/%.js: build/wasm/%.wasm $(site_scripts)/live-%.js \
		$(site_scripts)/live.mk
	@mkdir -p $(@D)
	@{ printf "live.programs['%s'] = '" $* && gzip -9nc $< | base64 -w 0 && \
		echo "';" && $(live_numbers) cat $(site_scripts)/live-$*.js; } \
		>$@.part
	@mv $@.part $@
