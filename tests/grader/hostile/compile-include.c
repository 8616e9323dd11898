/* does not build: it includes itself for ever */
#include __FILE__
