# mistake: no-number-passes, stage 4, given 7 5 6 2
s/if (!(fabs(v/if (fabs(v/
s/if (!(fabs(m/if (fabs(m/
s/<= 1e-10 \* size))/> 1e-10 * size)/
s/<=$/>/
s/1e-10 \* e))/1e-10 * e)/
s/<= 1e-9 \* speeds))/> 1e-9 * speeds)/
