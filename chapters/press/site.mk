# The book as web pages in build/site/, which any browser can open from a file or from a
# server. EDITION=instructor adds the worked solutions, in build/site-instructor/.
#
# In chapters/press/site/ the script `places' finds the page and the number of each
# label, and `page' makes one page. The rules of live.mk make the live figures: NAME.js
# for each \livefigure{NAME}, live.js, which starts them, and player.html, all listed in
# LIVE_FILES. On a page <div class="live" data-live="NAME"></div> becomes a live figure,
# with the colours and fonts of page.css; when the reader changes the colours, page.js
# sends an event `theme' to the document.

.PHONY: site has-site
LIVE_FILES =
-include chapters/press/site/live.mk

has-site:
	$(call need,noweave,noweb)
	$(call need,pandoc,pandoc)
	$(call need,bibtex,texlive-binaries)

# A single command finds the pages that have to be rebuilt and builds them all, because
# a link in one chapter may lead to a place that has moved in another.
site: has-gnuplot has-gsl has-site build/site$(edition)/made
	@echo 'The pages: open build/site$(edition)/index.html'
build/site/made: build/woven $(FIGURES_SVG) $(RUNS) $(LIVE_FILES) \
		$(wildcard chapters/press/site/* src/*/*.[ch] src/*/README.md)
	@EDITION= chapters/press/site/make
build/site-instructor/made: build/site/made
	@EDITION=instructor chapters/press/site/make
