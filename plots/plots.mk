# Figures, films and the atlas. All need gnuplot; films also need ffmpeg.

.PHONY: figures has-gnuplot has-gsl
# build/recipes/rules.mk has the rules for the data of figures and transcripts, extracted
# from plots/*.gp and the chapters. The goals in $(bookless) do not need it.
bookless := all first programs bench atlas movie movies wanted-movie inspect chart check watch hint progress \
	reset solution mutants tangle check-tangle clean help format memcheck \
	fuzz fuzz-scenes fuzz-commands compile_commands.json
ifneq ($(filter-out $(bookless),$(MAKECMDGOALS)),)
build/recipes/rules.mk: chapters/press/recipes chapters plots \
		$(wildcard chapters/*.nw plots/*.gp)
	@chapters/press/recipes
include build/recipes/rules.mk
kept += $(FIGURES_DATA) $(LECTURE_DATA) $(RUNS)
endif

# Stops if a program is missing, before anything is computed.
has-gnuplot:
	$(call need,gnuplot,gnuplot-nox fonts-lmodern)
has-gsl:
	$(if $(gsl),,@echo 'make: GSL is missing; install it with: apt-get install\
 --no-install-recommends libgsl-dev' >&2; exit 1)

# With QUALITY=lecture, uses the longer runs that the figures' scripts specify, and also
# draws slides.
figures: has-gnuplot has-gsl programs $(FIGURES_PDF) $(FIGURES_SVG) \
		$(if $(filter lecture,$(QUALITY)),$(FIGURES_LECTURE))
	@echo 'Figures: build/figures/' \
		$(if $(filter lecture,$(QUALITY)),'and build/lecture/')

# Lists the commands that make the missing tables, taken from the output of make -n.
.PHONY: jobs-figures
jobs-figures: has-gsl programs build/check/examine $(CHECK_BUILT)
	$(call list,$(MAKE) -n --no-print-directory $(FIGURES_DATA) \
		$(if $(filter lecture,$(QUALITY)),$(LECTURE_DATA)) | sed -n \
		's|^.*\(chapters/press/recipes --[dr][au][tn]\)|\1|p' | sort -u)

# make figure FIGURE=09-eight draws one figure, or with QUALITY=lecture its slides.
FIGURE = 09-eight
.PHONY: figure
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

# plots/show reads SCENE, PRESET, X, Y and the others from the environment.
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

# Makes the maps of chapter 12, with the reference runs behind them; this takes some
# minutes. Each scene's map is a file in a folder named after the checksum of the
# program, so that it is made only once for each version of the program. The maps are
# joined into build/data/12-atlas.dat, which the figures read.
.PHONY: atlas jobs-atlas
maps = at=build/atlas/$$(cksum <build/bin/bonk-studies | tr ' ' -) && \
	mkdir -p $$at && scenes=$$(build/bin/bonk-studies --study scenes | \
	sed '/^\#/d')
# Each job writes to a file with its process ID in the name, and then renames the file.
maps_missing = for scene in $$scenes; do map=$$at/$$scene; [ -e $$map ] || \
	echo "[ -e $$map ] || { build/bin/bonk-studies --study atlas" \
	"--scene $$scene -o $$map.\$$\$$ && mv $$map.\$$\$$ $$map; }"; done
jobs-atlas: build/bin/bonk-studies
	$(call list,$(maps) && $(maps_missing))
atlas: build/bin/bonk-studies
	@$(maps) && { $(maps_missing); } | while read -r job; do \
		echo "$$job" && sh -c "$$job" || exit 1; done && mkdir -p build/data && (cd $$at && \
	awk '/^#= unsure/ { if (!($$3 + 0 < worst + 0)) worst = $$3; next } \
		/^#= / { if (!($$2 in n)) key[++keys] = $$2; n[$$2] += $$3; next } \
		/^#/ && NR > FNR { next } \
		/^# command: / { sub(/ --scene .*/, "") } { print } \
		END { print "#= unsure " worst; for (k = 1; k <= keys; ++k) \
			print "#= " key[k], n[key[k]] }' $$scenes) \
		>build/data/12-atlas.dat.new
	@mv build/data/12-atlas.dat.new build/data/12-atlas.dat
	@mkdir -p build/made/data && touch build/made/data/12-atlas.dat
	@sed -n 's/^#= //p' build/data/12-atlas.dat
