# mistake: period-for-frequency, stage 5
s/const double limit = stable\[method\]/const double limit = 6.283185307/
