# The book, from noweb chapters with TeX, and the course that students get.

.PHONY: tangle check-tangle contact book has-tex
tangle:
	$(call need,notangle,noweb)
	@chapters/press/tangle

check-tangle:
	$(call need,notangle,noweb)
	@chapters/press/tangle --check

# Stops if a program is missing, before anything is computed.
has-tex: has-gnuplot
	$(call need,notangle,noweb)
	$(call need,pdflatex,lmodern texlive-latex-extra texlive-fonts-recommended)

# Builds the programs for a debugger, without optimization, in build/debug/build/bin/. For a
# literate file the compiler and the debugger name the chapter and its line.
.PHONY: debug
debug:
	$(call need,notangle,noweb)
	@mkdir -p build/debug
	@cd build/debug && for name in Makefile chapters exercises plots solutions tests; do \
		ln -sfn ../../$$name $$name; done
	@chapters/press/tangle -L build/debug/src
	@for file in $$(grep -L '^/\* From chapters/' src/*/*.[ch]) src/*.mk src/*/*.mk; do \
		cmp -s $$file build/debug/$$file || \
		{ mkdir -p build/debug/$${file%/*} && cp $$file build/debug/$$file; } || exit 1; \
	done
	@for file in build/debug/src/*/*.[ch]; do \
		[ -e $${file#build/debug/} ] || rm $$file; done
	@$(MAKE) -C build/debug programs PORTABLE='-g -O0 -ffp-contract=off'
	@echo 'The programs: build/debug/build/bin/'

# Puts small copies of all figures and slides on a few sheets.
contact: has-tex has-gsl $(FIGURES_PDF)
	@chapters/press/contact
	@echo 'The contact sheets: build/contact.pdf'

# Counts pages, words and lines of code, chapter by chapter.
.PHONY: pages
pages: build/bonkers.pdf
	$(call need,pdftotext,poppler-utils)
	@chapters/press/measure

# EDITION=instructor adds the worked solutions. Goals that draw figures use all processors,
# unless -j says how many.
ifeq ($(MAKELEVEL),0)
ifneq ($(filter book site figures handout dist,$(MAKECMDGOALS)),)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN)
endif
endif
edition := $(if $(filter instructor,$(EDITION)),-instructor)
book: has-tex build/bonkers$(edition).pdf figures
	@echo 'The book: build/bonkers$(edition).pdf'
	@echo 'Next: open it, then try an exercise: make check'

# Makes the slides of a chapter: its lecture figures with their titles, one to a page.
CHAPTER = 9
.PHONY: slides
ifneq ($(filter slides,$(MAKECMDGOALS)),)
chapter_number := $(if $(filter 1 2 3 4 5 6 7 8 9,$(CHAPTER)),0)$(CHAPTER)
$(if $(wildcard plots/$(chapter_number)-*.gp),,$(error slides: CHAPTER: \
	'$(CHAPTER)' is no chapter with figures))
slides: has-tex has-gsl $(patsubst plots/%.gp,slides-%,$(wildcard \
		plots/$(chapter_number)-*.gp))
	@chapters/press/slides $(chapter_number)
	@echo 'The slides: build/slides-$(chapter_number).pdf'
endif

# Makes what both editions are typeset from, so that both can then be typeset at the same
# time. QUOTED lists the files of src/ that chapters quote.
.PHONY: book-parts
book-parts: has-tex $(FIGURES_PDF) $(FIGURES_SVG) $(FIGURES_ALT) build/woven
build/woven: $(RUNS) $(wildcard $(QUOTED) chapters/*.nw \
		solutions/* plots/data/* \
		$(addprefix tests/exercises/*/,hints.txt stub.c suite.c)) \
		$(filter-out %/site %/site.mk,$(wildcard chapters/press/*))
	@chapters/press/make-book woven

build/bonkers.pdf build/bonkers-instructor.pdf: build/woven $(FIGURES_PDF) $(FIGURES_ALT) \
		tests/equations.txt src/toolbox/version.h
	@chapters/press/make-book $(@:build/%.pdf=%)

# ---- the course for students

# The students' book has no solutions. With WITH_CHAPTERS=1 the archive also contains the
# sources of the chapters.
ifneq ($(and $(EDITION),$(filter handout,$(MAKECMDGOALS))),)
$(error handout: EDITION: students get the book without solutions; leave it out)
endif
.PHONY: handout
handout: has-tex build/bonkers.pdf has-site build/site/made
	@chapters/press/handout

# ---- the pages
include chapters/press/site.mk

# ---- what is published

.PHONY: dist
dist: handout site
	@chapters/press/dist
