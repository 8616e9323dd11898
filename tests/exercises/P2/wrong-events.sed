# mistake: all-events, stage 1
s/^    printf("# pairs %ld/    pairs += walls;\
&/
