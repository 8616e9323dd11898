'use strict';
/* Chapter 5: four disks, sampled by the article's clock, wrong and mended. */
(() => {
  const DISKS = 4, BINS = 35, slip = { ours: 0, article: -1, mended: 1 };
  const truth = live.numbers.disks4; // density in hundredths from 0.15 on

  function look(run) {
    const a = run.c.look(7 + 2 * DISKS + 2 * BINS);
    run.time = a[0];
    run.now = { t: a[0], samples: a[1], hits: a[2], walls: a[3], Z: a[4], overlap: a[5], energy: a[6],
      place: a.slice(7, 7 + 2 * DISKS), bins: a.slice(7 + 2 * DISKS) };
  }
  function begin(run) {
    run.c.begin(slip[run.value.clock], run.value.every, run.value.seed);
    look(run);
    run.energy = run.now.energy;
    run.way = [];
  }
  const deep = (run, i) => { // is it in a wall or in another disk?
    const p = run.now.place, x = p[2 * i], y = p[2 * i + 1];
    if (Math.min(x, y, 1 - x, 1 - y) < 0.15 - 1e-6) return true;
    for (let j = 0; j < DISKS; ++j)
      if (j !== i && Math.hypot(p[2 * j] - x, p[2 * j + 1] - y) < 0.3 - 1e-6) return true;
    return false;
  };

  live.figure('clock', {
    question: 'One of these clocks is wrong in a way that the energy cannot see. Run it fast: which numbers show it? ' +
      'Does a shorter step help?',
    about: 'Left: four disks in a box. Right: by how many per cent the density of their places differs from the ' +
      'truth, against the distance from the wall, with error bars.',
    step: 'Next record',
    speeds: { 0.1: '1/10', 1: '1', 10: '10', 100: '100', 1000: '1000' },
    controls: [
      { key: 'clock', label: 'Clock', usual: 'article', options: { article: "the article's", mended: 'its sign mended',
        ours: 'ours' } },
      { key: 'every', label: 'Step', usual: 0.01, log: [0.001, 0.1], unit: 's' },
      { key: 'seed', label: 'Seed', usual: 1, number: [1, 9999] },
    ],
    height: w => w < 560 ? 0.62 * w + 250 : Math.max(260, 0.44 * w),
    begin,
    longest: run => run.value.every,
    // A record may end before the time at which it was due, by nearly a whole step.
    early: run => (1 - 1e-9) * run.value.every,
    advance(run, until, budget) {
      const end = performance.now() + budget;
      while (run.c.run(until, 1000) === 1000 && performance.now() < end);
      look(run);
      run.way.push(run.now.place);
      if (run.way.length > 40) run.way.shift();
    },
    once(run) { run.c.run(1e15, 1); look(run); run.way.push(run.now.place); },
    say: run => `${run.now.samples} records. Pressure PV/NkT ${live.number(run.now.Z)}; direct sampling says 2.70. ` +
      `Deepest overlap ${run.now.overlap < 1e-12 ? 'none' : live.number(run.now.overlap, 2) + ' m'}. The energy has ` +
      `changed by ${live.number(Math.abs(run.now.energy / run.energy - 1), 1)} of itself.`,
    draw(run, pen) {
      const { w, h, c } = pen, narrow = w < 560;
      const side = narrow ? 0.6 * w : h - 12, left = narrow ? 0.2 * w : 4;
      const X = x => left + x * side, Y = y => 6 + (1 - y) * side;
      pen.g.strokeStyle = c.ink;
      pen.g.lineWidth = 2;
      pen.g.strokeRect(X(0), Y(1), side, side);
      if (run.api.speed < 5) for (let i = 0; i < DISKS; ++i)
        pen.line(run.way.map(p => [X(p[2 * i]), Y(p[2 * i + 1])]), c.hairline, 2);
      for (let i = 0; i < DISKS; ++i) {
        const x = X(run.now.place[2 * i]), y = Y(run.now.place[2 * i + 1]);
        pen.g.globalAlpha = 0.82;
        pen.disk(x, y, 0.15 * side, deep(run, i) ? c.red : c.blue, c.ink);
        pen.g.globalAlpha = 1;
        pen.text(i + 1, x, y, 'center', c.paper, 15);
      }
      const top = narrow ? side + 44 : 28, at = narrow ? 40 : side + 62;
      const f = pen.axes(at, top, w - at - 8, h - top - 38, { from: 0.15, to: 0.5, ticks: 0.1,
        name: 'distance from the wall (m)' }, { from: -50, to: 20, ticks: 10, name: 'density, off by (%)' });
      pen.line([[f.X(0.15), f.Y(0)], [f.X(0.5), f.Y(0)]], c.quiet, 1.2);
      pen.within(f.left, f.top, f.width, f.height, () => {
        for (let b = 0; b < BINS; ++b) {
          const x = f.X(0.155 + 0.01 * b), mean = run.now.bins[2 * b], error = run.now.bins[2 * b + 1];
          const off = v => f.Y(100 * (v / truth[b] - 1));
          if (!Number.isFinite(error) || error === 0) continue;
          pen.line([[x, off(mean - error)], [x, off(mean + error)]], c.red, 1.2);
          pen.disk(x, off(mean), 2.6, c.red);
        }
      });
    },
  });
})();
