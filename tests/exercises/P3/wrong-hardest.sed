# mistake: one-spring-alone, stage 5
s/const double limit = stable\[method\] \/ sqrt(fastest(&now))/double most = 0;\
        for (int k = 0; k < springs; ++k)\
            most = fmax(most, spring[k].k * (1 \/ mass[spring[k].a] + 1 \/ mass[spring[k].b]));\
        const double limit = stable[method] \/ sqrt(most)/
