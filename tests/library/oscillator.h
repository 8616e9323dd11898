/* An oscillator with m = D = 1, let go at 1: from 40 digits of the formula
   (references of the book, section 11). */
#ifndef OSCILLATOR_H
#define OSCILLATOR_H

static const double oscillator_times[3] = {1, 5, 10};

/* The damping over its critical value, and where it is at those times. */
static const double oscillator_known[6][4] = {
    {0.1, 0.5689718909460998, 0.09855066761858596, -0.3368516805904134},
    {0.5, 0.6597001533917017, -0.0745905665950333, -0.002170116739326209},
    {0.999999, 0.7357587597163552, 0.04042740124672117,
     0.0004993840941530791},
    {1, 0.7357588823428846, 0.0404276819945128, 0.0004993992273873334},
    {1.000001, 0.735759004969316, 0.04042796274230443,
     0.0004994143607729208},
    {2, 0.8222634239018095, 0.2821711739751532, 0.07390407190962298}};

#endif
