/* A right answer: no clock, only what is left of the tick and of the way
   to the collision. */

void box_run(struct box *box, double tick, size_t samples)
{
    double left = tick, wait = box_next(box);
    size_t done = 0;
    while (done < samples) {
        if (wait <= left) {
            box_fly(box, wait);
            box_collide(box);
            left -= wait;
            wait = box_next(box);
        } else {
            box_fly(box, left);
            wait -= left;
            left = tick;
            done++;
            box_record(box, done * tick);
        }
    }
}
