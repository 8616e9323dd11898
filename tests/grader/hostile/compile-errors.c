/* does not build: more errors than a report can hold */
#define A(x) x x x x x x x x x x
A(A(A(A(A(A($))))))
