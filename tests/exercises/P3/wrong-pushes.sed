# mistake: spring-pushes, stage 1
s/spring\[k\].k \* (1 - spring/-&/
