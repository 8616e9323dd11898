# mistake: size-for-spread, stage 5
s/sqrt((squares\[i\] - sum\[i\] \* sum\[i\] \/ n) \* n \/ (n - 1))/sqrt(squares[i])/
