/* The orbits of two bodies in closed form. */
#ifndef KEPLER_H
#define KEPLER_H

/* pi, which standard C does not define. */
#define KEPLER_PI 3.14159265358979323846

/* An ellipse and a position on it. Angles are in rad. */
struct kepler_elements {
    double axis;         /* semi-major axis, m */
    double eccentricity; /* at least 0, less than 1 */
    double inclination;
    double node;       /* longitude of the ascending node */
    double perihelion; /* argument of the perihelion: angle from the node */
    double mean_anomaly;
};

/* Computes the semi-major axis (in m) and the eccentricity of the orbit
   through x[3] with the velocity v[3]: (9.3, eq:vis-viva). The axis of an
   open orbit is INFINITY or negative. */
void kepler_shape(double mu, const double x[], const double v[],
                  double *axis, double *eccentricity);

/* Moves x[3] and v[3] along their ellipse by the time t (in s), which may
   be negative. Uses a closed form: (9.6, eq:gauss). If the orbit is open,
   x[0] becomes NaN. */
void kepler_move(double mu, double t, double x[], double v[]);

/* Computes the cosine and the sine of an angle from -1e5 to 1e5 rad. The
   error is below 2e-16, and the bits are the same on every machine. */
void kepler_turn(double angle, double *cosine, double *sine);

/* Returns the eccentric anomaly E (in rad), which solves E - e sin E = M
   for 0 <= e < 1: (9.4, eq:kepler). The mean anomaly M is from -1e5 to
   1e5. */
double kepler_anomaly(double eccentricity, double mean_anomaly);

/* Computes the position x[3] (in m) and the velocity v[3] (in m/s) of one
   of two bodies relative to the other: (9.5, eq:kepler-place). mu is k2
   times the sum of the two masses. */
void kepler_place(double mu, const struct kepler_elements *o, double x[],
                  double v[]);

#endif
