/* The report of a runner to the examiner on its test. */
#ifndef REPORT_H
#define REPORT_H

#include <signal.h>
#include <stdint.h>

/* The report of a test: lines `NONCE WORD TEXT`, written by the runner and
   read by the examiner when the runner has ended. The nonce is a random
   word: at first the file has only the nonce, the runner removes it before
   any of the student's code runs, and each line begins with it. (Arguments
   and environment would stay readable for the whole life of the process.)
   It guards against accidents, such as a program that writes to every
   descriptor that it finds, not against an attack: the student's code
   shares the runner's memory.

   The report is a file, not a pipe. A pipe ends only when the last process
   that has it open ends, so a forgotten child would keep the examiner
   waiting; and a pipe has room for 64 KiB only, so the examiner would have
   to read while the test runs. */
enum { REPORT_FILE = 3, REPORT_NONCE = 32, REPORT_LINE = 1024 };

/* An order to a waiting runner: the number of the test, its seed, and
   whether to search for leaks. It answers with the process number of its
   copy. */
enum { REPORT_ORDERS = 4 };
struct report_order {
    uint64_t seed;
    int number, leaks;
};

#define REPORT_SAYS "says"       /* TEXT: a label and a sentence */
#define REPORT_UNDONE "undone"   /* TEXT: FILE:LINE of a NOT_DONE_YET */
#define REPORT_VERDICT "verdict" /* TEXT: passed or failed; comes last */

/* The signal by which a program that was found to loop for ever is ended,
   and after it the process that judged it (examiner/endless.h). */
#define REPORT_ENDLESS SIGVTALRM

#endif
