/* Checksums of files, bytes and numbers. */
#ifndef SUM_H
#define SUM_H

#include <stddef.h>
#include <stdint.h>

/* Add a file, some bytes or a number to a checksum that starts with 0;
   anything but a plain file adds a number that no content has. */
uint64_t sum_file(uint64_t sum, const char *path);
uint64_t sum_bytes(uint64_t sum, const void *bytes, size_t length);
uint64_t sum_number(uint64_t sum, uint64_t number);

#endif
