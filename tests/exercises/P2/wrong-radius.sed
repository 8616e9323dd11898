# mistake: radius-for-diameter, stage 1
s/4 \* radius \* radius - beside/radius * radius - beside/
