'use strict';
/* Chapter 3: a histogram that grows against its law, with honest errors. */
(() => {
  const BINS = 40, BEADS = 10, most = 200000;

  function look(run) {
    const a = run.c.look(8 + 3 * BINS + BEADS + 2);
    run.time = a[0];
    run.now = { samples: a[1], g: a[2], low: a[3], high: a[4], energy: a[7], density: a.slice(8, 8 + BINS),
      error: a.slice(8 + BINS, 8 + 2 * BINS), law: a.slice(8 + 2 * BINS, 8 + 3 * BINS), x: a.slice(8 + 3 * BINS) };
  }
  function begin(run) {
    const v = run.value;
    run.c.begin(v.bead, v.of === 'position' ? 1 : 0, v.every, v.seed);
    look(run);
  }
  const naive = run => run.value.bars === 'naive' ? 1 / Math.sqrt(Math.max(1, run.now.g)) : 1;
  // How many bins lie more than two errors off, of those that should have five
  // samples at least. The errors are those that the law gives, with its
  // density instead of the bin's, which is small where a bin is too low.
  function far(run) {
    const { now } = run, width = (now.high - now.low) / BINS, g = run.value.bars === 'naive' ? 1 : now.g;
    let count = 0, of = 0;
    now.law.forEach((p, b) => {
      if (p * width * now.samples < 5) return;
      ++of;
      if (Math.abs(now.density[b] - p) > 2 * Math.sqrt(p * (1 / width - p) * g / now.samples)) ++count;
    });
    return `${count} of ${of}`;
  }

  live.figure('histogram', {
    question: 'Not more than one bin in twenty should lie two errors off its law. Is that so? And with samples taken ' +
      'faster, or with errors that take all samples for independent?',
    about: 'Above: ten beads between two walls. Below: a histogram of what one of them does, with error bars, ' +
      'and its law in equilibrium as a line.',
    step: 'Next sample',
    speeds: { 1: '1', 10: '10', 100: '100', 1000: '1000', 10000: '10 000' }, speed: 100,
    longest: run => run.value.every,
    controls: [
      { key: 'bead', label: 'Bead', usual: 4, number: [1, BEADS] },
      { key: 'of', label: 'Its', usual: 'velocity', options: ['velocity', 'position'] },
      { key: 'every', label: 'A sample each', usual: 2.4, log: [0.02, 10], unit: 's' },
      { key: 'bars', label: 'Errors', usual: 'honest', look: true, options: { honest: 'honest',
        naive: 'as if independent' } },
      { key: 'seed', label: 'Seed', usual: 1, number: [1, 9999] },
    ],
    height: w => Math.max(280, 0.5 * w),
    begin,
    advance(run, until, budget) {
      const end = performance.now() + budget;
      while (run.c.run(until, 500) >= 500 && performance.now() < end);
      look(run);
    },
    once(run) { run.c.run(1e15, 1); look(run); },
    say: run => `${run.now.samples} samples${run.now.samples >= most ? ', which is all that there is room for' : ''}; ` +
      `it takes ${live.number(run.now.g)} of them to make one independent one. ` +
      (run.now.samples < 100 ? '' : `${far(run)} bins lie more than two errors off.`),
    draw(run, pen) {
      const { w, h, c } = pen, { now } = run, places = run.value.of === 'position';
      const left = 44, width = w - left - 10, W = x => left + (x - now.x[0]) / (now.x[BEADS + 1] - now.x[0]) * width;
      pen.line([[left, 20], [left + width, 20]], c.quiet, 1.5);
      for (const x of [now.x[0], now.x[BEADS + 1]]) pen.line([[W(x), 6], [W(x), 34]], c.ink, 3);
      for (let i = 1; i <= BEADS; ++i)
        pen.disk(W(now.x[i]), 20, i <= BEADS / 2 ? 5 : 8, i === run.value.bead ? c.red : c.blue, c.paper);
      const top = Math.max(...now.law) * 1.6;
      const f = pen.axes(left, 64, width, h - 64 - 42, { from: now.low, to: now.high,
        name: places ? 'position (m)' : 'velocity (m/s)' }, { from: 0, to: top, name: places ? 'density (1/m)' : 'density (s/m)' });
      const at = b => now.low + (b + 0.5) / BINS * (now.high - now.low), bar = f.width / BINS;
      pen.within(f.left, f.top, f.width, f.height, () => {
        pen.g.globalAlpha = 0.35;
        now.density.forEach((p, b) => pen.box(f.X(at(b)) - bar / 2 + 0.5, f.Y(p), bar - 1, f.Y(0) - f.Y(p), c.blue));
        pen.g.globalAlpha = 1;
        pen.line(Array.from(now.law, (p, b) => [f.X(at(b)), f.Y(p)]), c.red, 2);
        if (now.samples > 0) now.density.forEach((p, b) => {
          const error = now.error[b] * naive(run);
          pen.line([[f.X(at(b)), f.Y(p - error)], [f.X(at(b)), f.Y(p + error)]], c.ink, 1.3);
          pen.disk(f.X(at(b)), f.Y(p), 2.2, c.ink);
        });
      });
    },
  });
})();
