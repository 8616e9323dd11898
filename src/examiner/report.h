/* The report by which a runner tells the examiner how its test went. */
#ifndef REPORT_H
#define REPORT_H

#include <signal.h>
#include <stdint.h>

/* The report of a test: lines `NONCE WORD TEXT`, written by the runner and
   read by the examiner when the runner has ended. The nonce is a random
   word: it is the first thing in the file, the runner takes it out before
   any of the student's code runs, and each line begins with it. (Arguments
   and environment would stay readable for the whole life of the process.)
   It guards against accidents, such as a program that writes to every
   descriptor that it finds, not against an attack: the student's code
   shares the runner's memory.

   The report is a file, not a pipe. A pipe is at its end only when the
   last process that holds it has ended, so a forgotten child would keep
   the examiner waiting; and it holds no more than 64 KiB, so somebody
   would have to read while the test runs. */
enum { REPORT_FILE = 3, REPORT_NONCE = 32, REPORT_LINE = 1024 };

/* An order to a waiting runner: which test to run, with which seed, and
   whether to look for leaks. It answers with the process number of its
   copy. */
enum { REPORT_ORDERS = 4 };
struct report_order {
    uint64_t seed;
    int number, leaks;
};

#define REPORT_SAYS "says"       /* TEXT: a label and what it says */
#define REPORT_UNDONE "undone"   /* TEXT: FILE:LINE of a NOT_DONE_YET */
#define REPORT_VERDICT "verdict" /* TEXT: passed or failed; comes last */

/* The signal by which a program ends that was found to loop for ever, and
   its judge (examiner/endless.h). */
#define REPORT_ENDLESS SIGVTALRM

#endif
