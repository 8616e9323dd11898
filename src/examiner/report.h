/* Defines the report in which a runner says how its test went. */
#ifndef REPORT_H
#define REPORT_H

#include <signal.h>
#include <stdint.h>

/* The report of a test: lines `NONCE WORD TEXT`, written by the runner and
   read by the examiner when the runner has ended. The first bytes of the
   file are the nonce, which the runner takes out before it calls any code
   of the student's; each record begins with it. The nonce is not given as
   an argument or in the environment, because those stay readable for the
   whole life of a process. It guards against accidents (a program that
   writes to every descriptor it finds), not against somebody who looks for
   it: the student's code shares the runner's memory.

   The report is a file and not a pipe: a pipe is at its end only when the
   last process that holds it has gone, so that a forgotten child would keep
   the examiner waiting, and it holds no more than 64 KiB, so that somebody
   would have to read while the test runs. */
enum { REPORT_FILE = 3, REPORT_NONCE = 32, REPORT_RECORD = 1024 };

/* An order to a runner that waits: which test, with which seed, and whether
   to look for lost memory. It answers with the process number of its
   copy. */
enum { REPORT_ORDERS = 4 };
struct report_order {
    uint64_t seed;
    int number, leaks;
};

#define REPORT_SAYS "says"       /* TEXT: a label and what it says */
#define REPORT_UNDONE "undone"   /* TEXT: FILE:LINE of a NOT_DONE_YET */
#define REPORT_VERDICT "verdict" /* TEXT: passed or failed; comes last */

/* Ends a program in the grader's box, and its judge, that was found to loop
   for ever. */
#define REPORT_ENDLESS SIGVTALRM

#endif
