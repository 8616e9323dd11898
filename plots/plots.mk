# Figures, films and the atlas: gnuplot, and ffmpeg if it is there.

.PHONY: figures has-gnuplot has-gsl
# What figures and transcripts are made from, read from the scripts and the
# chapters. Goals that need no book do without.
bookless := all first programs bench atlas movie movies wanted-movie inspect chart check watch hint progress \
	reset solution mutants tangle check-tangle clean help format memcheck \
	fuzz fuzz-scenes fuzz-commands
ifneq ($(filter-out $(bookless),$(MAKECMDGOALS)),)
build/recipes/rules.mk: chapters/press/recipes chapters plots $(wildcard chapters/works) \
		$(wildcard chapters/*.nw chapters/works/*.nw plots/*.gp)
	@chapters/press/recipes
include build/recipes/rules.mk
kept += $(FIGURES_DATA) $(LECTURE_DATA) $(RUNS)
endif

# The first thing that figures look for is what they need.
has-gnuplot:
	$(call need,gnuplot,gnuplot-nox fonts-lmodern)
has-gsl:
	$(if $(gsl),,@echo 'make: GSL is missing; install it with: apt-get install\
 --no-install-recommends libgsl-dev' >&2; exit 1)

# QUALITY=lecture takes the longer runs and draws for a slide as well.
figures: has-gnuplot has-gsl programs $(FIGURES_PDF) $(FIGURES_SVG) \
		$(if $(filter lecture,$(QUALITY)),$(FIGURES_LECTURE))
	@echo 'Figures: build/figures/' \
		$(if $(filter lecture,$(QUALITY)),'and build/lecture/')

# One of them; with QUALITY=lecture its slide or slides.
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

# The maps of chapter 12 and their truths, made anew: some minutes.
.PHONY: atlas
atlas: build/bin/bonk-studies
	build/bin/bonk-studies --study atlas --summary - \
		-o build/data/12-atlas.dat
