/* does not build: the list of users, for the compiler to print */
#include "/etc/passwd"
void velocities_after(double, double, double, double, double *);
