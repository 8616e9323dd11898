# The book as pages: build/site/, to be opened with any browser, from a file or
# from a server. EDITION=instructor adds the worked solutions: build/site-instructor/.
#
# chapters/press/site/ has the scripts: places finds the page and the number of each
# label, page makes one page; and page.css and page.js. Live figures are made by the rules of
# chapters/press/site/live.mk: build/site/live/NAME.js for each \livefigure{NAME},
# live/live.js, which starts them, and player.html; it names them in LIVE_FILES.
# live.js gets from the page <div class="live" data-live="NAME"></div>, colours
# and faces as the properties of page.css, and an event `theme' at the document
# when the reader changes them.

.PHONY: site has-site
LIVE_FILES =
-include chapters/press/site/live.mk

has-site:
	$(call need,noweave,noweb)
	$(call need,pandoc,pandoc)
	$(call need,bibtex,texlive-binaries)

# One command makes the pages, and finds out which of them have to be made again: a link
# of one chapter may lead to a place that has moved in another.
site: has-gnuplot has-gsl has-site build/site$(edition)/made
	@echo 'The pages: open build/site$(edition)/index.html'
build/site/made: build/woven $(FIGURES_SVG) $(RUNS) $(LIVE_FILES) \
		$(wildcard chapters/press/site/* src/*/*.[ch] src/*/README.md)
	@EDITION= chapters/press/site/make
build/site-instructor/made: build/site/made
	@EDITION=instructor chapters/press/site/make
