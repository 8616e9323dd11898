# mistake: velocities-swapped, stage 2
s/^            collide(first, second);/            for (int c = 0; c < 2; ++c) {\
                const double v = first->v[c];\
                first->v[c] = second->v[c];\
                second->v[c] = v;\
            }/
