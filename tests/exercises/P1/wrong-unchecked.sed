# mistake: check-missing, stage 4
/^static void broken/,/^}/s/exit(1);/return;/
