/* A right answer: asks anew after each flight, and remembers nothing but
   the time of the disks. */

static void go_to(struct box *box, double from, double to)
{
    double wait;
    for (wait = box_next(box); from + wait <= to; wait = box_next(box)) {
        box_fly(box, wait);
        from += wait;
        box_collide(box);
    }
    box_fly(box, to - from);
}

void box_run(struct box *box, double tick, size_t samples)
{
    size_t k;
    for (k = 0; k < samples; k++) {
        go_to(box, k * tick, (k + 1) * tick);
        box_record(box, (k + 1) * tick);
    }
}
