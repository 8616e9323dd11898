/* does not build: macros that make a sum of a billion terms */
#define A(x) x + x + x + x + x + x + x + x
#define B(x) A(A(A(A(A(A(A(A(A(A(x))))))))))
int number = B(1);
