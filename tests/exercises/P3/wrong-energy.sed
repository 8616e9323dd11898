# mistake: error-of-the-energy, stage 4
s/^    print_row(&now, 0);/    const double first = energy(\&now);\n&/
s/error \/ (1 - pow(0.5, order\[method\]))/fabs(energy(\&now) \/ first - 1)/
