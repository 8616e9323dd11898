# mistake: wall-turns-both, stage 1
s/^\( *\)\*turned = -\*turned;/\1for (struct disk *d = disk; d < disk + disks; ++d)\
            if (turned == d->v || turned == d->v + 1) {\
                d->v[0] = -d->v[0];\
                d->v[1] = -d->v[1];\
            }/
