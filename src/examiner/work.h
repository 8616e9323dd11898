/* Makes a temporary folder. */
#ifndef WORK_H
#define WORK_H

/* Returns the path of a temporary folder, made at the first call and
   removed at the end. */
const char *work_folder(void);

#endif
