/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 2394442941 of the lines below */
/* The version that all programs tell. */
#ifndef TOOLBOX_VERSION_H
#define TOOLBOX_VERSION_H

/* The kit's version, as --version and the heads of tables give it. */
#define TOOLBOX_VERSION "0.2"

#endif
