# mistake: input-refused, stage 2
# A remark alone on its line is no three numbers.
/strspn(line/,/continue;/d
