'use strict';
/* Chapter 11: Newton's cradle by events, by steps, and by springs. */
(() => {
  const ways = ['events', 'steps', 'springs'], span = 6;

  function look(run) {
    const n = run.c.look(2)[1], a = run.c.look(2 + 3 * (2 + 2 * n));
    run.time = a[0];
    const now = { t: a[0], n, way: ways.map((_, k) => {
      const at = 2 + k * (2 + 2 * n);
      return { hits: a[at], energy: a[at + 1], x: a.slice(at + 2, at + 2 + n), v: a.slice(at + 2 + n, at + 2 + 2 * n) };
    }) };
    run.now = now;
    run.past.push(now);
    if (run.past.length > 3000) run.past.splice(0, 1000);
  }
  function begin(run) {
    const v = run.value;
    run.past = [];
    // A fiftieth of the time that two balls of 1 kg touch, pi sqrt(m/(2 D)).
    const dt = Math.min(v.dt, +(Math.PI / Math.sqrt(2 * v.stiffness) / 50).toPrecision(2));
    v.left = Math.min(v.left, v.balls - 1);
    run.c.begin(v.balls, v.left, v.gap, v.dt, v.kind === 'hertz' ? 1 : 0, v.stiffness, dt);
    look(run);
  }

  live.figure('cradle', {
    question: 'Let the balls touch (no gap): which of the three ways lets only the last one fly? Make the step so long ' +
      'that a ball flies into the next by half of its width: what does that spoil, and what not?',
    about: 'Newton\'s cradle between two walls three times: by events, by steps and with springs at the contacts; below ' +
      'each the world lines, the past lower down.',
    rate: 0.7,
    longest: run => run.value.dt,
    clock: run => `t = ${run.time.toFixed(3)} s`,
    controls: [
      { key: 'balls', label: 'Balls', usual: 5, number: [2, 10] },
      { key: 'left', label: 'Fly in', usual: 1, number: [1, 9] },
      { key: 'gap', label: 'Gap', usual: 0.01, range: [0, 0.1, 0.005], digits: 3, unit: 'm' },
      { key: 'dt', label: 'Step', usual: 0.001, log: [0.0001, 0.3], unit: 's' },
      { key: 'kind', label: 'Springs', usual: 'linear', options: { linear: 'linear', hertz: "Hertz's" } },
      { key: 'stiffness', label: 'Stiffness', usual: 10000, log: [100, 1e6] },
    ],
    height: w => Math.max(360, 0.66 * w),
    begin,
    advance(run, until, budget) {
      const end = performance.now() + budget, by = Math.max(0.004, (until - run.time) / 300);
      for (let t = run.time + by; t < until && performance.now() < end; t += by) { run.c.run(t); look(run); }
      if (performance.now() < end) { run.c.run(until); look(run); }
    },
    once(run) { run.c.run(1e9, 1); look(run); },
    say: run => ways.map((name, k) => `${name}: last ball ${live.number(run.now.way[k].v[run.now.n - 1], 4)} m/s, last but one ` +
      `${live.number(run.now.way[k].v[run.now.n - 2], 3)}, energy off by ` +
      `${live.number(Math.abs(run.now.way[k].energy / run.past[0].way[k].energy - 1), 1)}`).join('; ') + '.',
    draw(run, pen) {
      const { w, h, c } = pen, { now } = run, band = h / 3, hues = [c.blue, c.red, c.green, c.orange, c.purple];
      // The walls stand 0.5 m from where the balls begin, and a radius.
      const x0 = run.past[0].way[0].x, low = x0[0] - 0.6, high = x0[now.n - 1] + 1.1;
      const left = 66, X = x => left + (x - low) / (high - low) * (w - left - 8), r = 0.1 * (w - left - 8) / (high - low);
      ways.forEach((name, k) => {
        const top = k * band + 6, wire = top + Math.min(r, 20) + 2, fall = (band - 2 * Math.min(r, 20) - 14) / span;
        pen.text(name, 4, wire, 'left', c.ink);
        pen.line([[X(low), top], [X(low), top + band - 12]], c.ink, 2);
        pen.line([[X(high), top], [X(high), top + band - 12]], c.ink, 2);
        const past = run.past.filter(p => p.t > now.t - span);
        pen.within(left, wire, w - left, band - (wire - top) - 8, () => {
          for (let i = 0; i < now.n; ++i)
            pen.line(past.map(p => [X(p.way[k].x[i]), wire + Math.min(r, 20) + (now.t - p.t) * fall]), hues[i % 5], 1.6);
        });
        now.way[k].x.forEach((x, i) => pen.disk(X(x), wire, Math.min(r, 20), hues[i % 5], c.ink));
      });
    },
  });
})();
