/* How the function of exercise 12a is called: see tests/remote.awk. With
 * the choices and the places for the front comes one more of each: the
 * suite has put something there. */
/* output: pareto_front front n suite */

struct choice {
    double cost;
    double error;
};

size_t pareto_front(size_t n, const struct choice choice[n + 1],
                    size_t front[n + 1]);
