/* mistake: one-collision-a-tick */

void box_run(struct box *box, double tick, size_t samples)
{
    double t = 0.0, event = box_next(box);
    for (size_t k = 1; k <= samples; ++k) {
        const double sample = (double)k * tick;
        if (event <= sample) {
            box_fly(box, event - t);
            box_collide(box);
            t = event;
            event = t + box_next(box);
        }
        box_fly(box, sample - t);
        t = sample;
        box_record(box, t);
    }
}
