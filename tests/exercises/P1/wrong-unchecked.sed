# mistake: check-missing, stage 4, given 7 5
/^static void broken/,/^}/s/exit(1);/return;/
