# mistake: agreed-by-chance, stage 2, given 0 1 2 3
# Two runs that agree are enough.
s/gap <= tolerance \/ 4 && before <= 8 \* tolerance &&/gap <= tolerance \/ 4 \&\&/
s/^            (gap < before \/ 4 || before < tolerance \/ 100))/            (before >= 0))/
