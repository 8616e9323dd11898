/* Computes checksums of files, bytes and numbers. */
#ifndef SUM_H
#define SUM_H

#include <stddef.h>
#include <stdint.h>

/* Return the checksum `sum` after adding a file, bytes or a number; begin
   with 0. For anything but a plain file, sum_file adds UINT64_MAX. */
uint64_t sum_file(uint64_t sum, const char *path);
uint64_t sum_bytes(uint64_t sum, const void *bytes, size_t length);
uint64_t sum_number(uint64_t sum, uint64_t number);

#endif
