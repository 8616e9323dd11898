/* From chapters/works/B-examiner.nw: edit there, then run make tangle. */
/* checksum 3599327715 of the lines below */
/* The form of the report that a runner writes of its test. */
#ifndef REPORT_H
#define REPORT_H

/* The report of a test: lines `NONCE WORD TEXT`, written by the runner and
   read by the examiner when the runner has ended. */
enum { REPORT_FILE = 3, REPORT_NONCE = 32, REPORT_RECORD = 1024 };

#define REPORT_SAYS "says"       /* TEXT: a label and what it says */
#define REPORT_UNDONE "undone"   /* TEXT: FILE:LINE of a NOT_DONE_YET */
#define REPORT_VERDICT "verdict" /* TEXT: passed or failed; comes last */

#endif
