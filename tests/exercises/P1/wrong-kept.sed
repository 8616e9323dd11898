# mistake: velocity-kept, stage 5
/v\[i\] -= g \* t;/d
