/* Makes a temporary folder. */
#ifndef WORK_H
#define WORK_H

/* Returns the path of a temporary folder, which is made at the first call
   and removed when the program ends. */
const char *work_folder(void);

#endif
