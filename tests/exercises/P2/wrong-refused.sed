# mistake: input-refused, stage 1
/strspn(line/,/continue;/d
