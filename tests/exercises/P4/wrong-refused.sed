# mistake: input-refused, stage 1, given 0 1 2 3
# An empty line has no five numbers.
/line\[strspn(line/,/continue;/d
