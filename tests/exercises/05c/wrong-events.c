/* mistake: events-as-samples */

void box_run(struct box *box, double tick, size_t samples)
{
    double t = 0.0, event = box_next(box);
    for (size_t k = 0; k < samples; ++k) {
        if (t + tick < event) {
            box_fly(box, tick);
            t += tick;
        } else {
            box_fly(box, event - t);
            box_collide(box);
            t = event;
            event = t + box_next(box);
        }
        box_record(box, t);
    }
}
