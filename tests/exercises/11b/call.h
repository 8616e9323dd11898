/* How the function of exercise 11b is called: see tests/remote.awk. With
 * the balls comes one behind the last: the suite has put something there.
 */
/* output: cradle v n suite */

size_t cradle(size_t n, const double mass[n + 1], double v[n + 1]);
