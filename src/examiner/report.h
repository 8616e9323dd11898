/* Defines the report on a test, written by the runner for the examiner. */
#ifndef REPORT_H
#define REPORT_H

#include <signal.h>
#include <stdint.h>

/* The report on a test consists of lines `NONCE WORD TEXT`. The runner
   writes them; the examiner reads them after the runner has ended. The
   nonce is a random word. At first, the file contains only the nonce. The
   runner removes the nonce before any of the student's code runs, and then
   begins each line with it. (If the nonce were an argument or an
   environment variable, it could be read for the whole life of the
   process.) The nonce guards against accidents, such as a program that
   writes to every descriptor. It does not guard against attacks, because
   the student's code shares the runner's memory.

   The report is a file, not a pipe. A reader sees the end of a pipe only
   when every process that has it open has ended, so a forgotten child would
   keep the examiner waiting. A pipe also holds only 64 KiB, so the examiner
   would have to read while the test runs. */
enum { REPORT_FILE = 3, REPORT_NONCE = 32, REPORT_LINE = 1024 };

/* An order to a waiting runner: the number of the test, its seed, and
   whether to search for leaks. The runner answers with the process ID of
   its forked copy. */
enum { REPORT_ORDERS = 4 };
struct report_order {
    uint64_t seed;
    int number, leaks;
};

#define REPORT_SAYS "says"       /* TEXT: a label and a sentence */
#define REPORT_UNDONE "undone"   /* TEXT: FILE:LINE of a NOT_DONE_YET */
#define REPORT_VERDICT "verdict" /* TEXT: passed or failed; comes last */

/* The signal that ends a program in an endless loop (examiner/endless.h),
   and then the judge of that test. */
#define REPORT_ENDLESS SIGVTALRM

#endif
