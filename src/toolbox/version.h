/* The version that all programs print. */
#ifndef TOOLBOX_VERSION_H
#define TOOLBOX_VERSION_H

/* The kit's version, for --version and the heads of tables. CITATION.cff
   and CHANGELOG.md contain the same version, and a test compares them. */
#define TOOLBOX_VERSION "0.2"

#endif
