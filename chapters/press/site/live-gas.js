'use strict';
/* Chapter 7: a gas whose disks begin with one speed, and the law that comes. */
(() => {
  const BINS = 30, head = 9 + 2 * BINS, classes = 9;

  function look(run) {
    const n = run.value.disks, a = run.c.look(head + 3 * n);
    run.time = a[0];
    run.now = { hits: a[1], walls: a[2], kT: a[3], energy: a[4], ratio: a[5], n, radius: a[7],
      share: a.slice(9, 9 + BINS), law: a.slice(9 + BINS, head), disk: a.subarray(head) };
  }
  function begin(run) {
    const v = run.value;
    v.disks = +v.disks;
    run.c.begin(v.disks, v.packing, v.seed, v.box === 'periodic' ? 1 : 0);
    look(run);
    run.energy = run.now.energy;
  }
  // From blue, slow, to red, fast, by way of grey.
  function colours(c) {
    const part = (hex, k) => parseInt(hex.slice(1 + 2 * k, 3 + 2 * k), 16);
    const mix = (a, b, s) => `rgb(${[0, 1, 2].map(k => Math.round(part(a, k) * (1 - s) + part(b, k) * s))})`;
    return Array.from({ length: classes }, (_, k) => k < 4 ? mix(c.blue, c.quiet, k / 4) : mix(c.quiet, c.red, (k - 4) / 4));
  }

  live.figure('gas', {
    question: 'All disks begin with one speed. After how many collisions of each has the gas forgotten it? ' +
      'Does a dense gas forget sooner? And what do ten disks do?',
    about: 'Left: disks in a box, slow ones blue, fast ones red. Right: how many have which speed, as bars, ' +
      'and the law of so many disks with the scatter that it allows.',
    step: 'Next collision',
    rate: 0.25,
    clock: run => `t = ${run.time.toFixed(3)} s`,
    controls: [
      { key: 'disks', label: 'Disks', usual: 1000, options: { 10: '10', 100: '100', 250: '250', 1000: '1000', 2000: '2000' } },
      { key: 'packing', label: 'They fill', usual: 0.2, range: [0.02, 0.65, 0.01], digits: 2 },
      { key: 'box', label: 'Box', usual: 'walls', options: { walls: 'walls', periodic: 'periodic' } },
      { key: 'seed', label: 'Seed', usual: 1, number: [1, 9999] },
    ],
    height: w => w < 560 ? 0.67 * w + 240 : Math.max(250, 0.4 * w),
    begin,
    advance(run, until, budget) {
      const end = performance.now() + budget;
      while (run.c.run(until, 500) >= 500 && performance.now() < end);
      look(run);
    },
    once(run) { run.c.run(1e15, 1); look(run); },
    say: run => `${run.now.hits} collisions of disks, ${live.number(2 * run.now.hits / run.now.n)} of each. ` +
      `Mean of v⁴ over the square of that of v²: ${live.number(run.now.ratio, 4)}; 1 at the start, 2 for Maxwell. ` +
      `The energy has changed by ${live.number(Math.abs(run.now.energy / run.energy - 1), 1)} of itself.`,
    draw(run, pen) {
      const { w, h, c, g } = pen, { now } = run, narrow = w < 560;
      const wide = narrow ? w - 8 : Math.min(0.56 * w, 1.5 * (h - 12)), scale = wide / 7.5;
      const X = x => 4 + x * scale, Y = y => 6 + (5 - y) * scale, r = Math.max(1, now.radius * scale);
      const usual = Math.sqrt(2 * now.kT);
      const paths = Array.from({ length: classes }, () => new Path2D());
      for (let i = 0; i < 3 * now.n; i += 3) {
        const x = X(now.disk[i]), y = Y(now.disk[i + 1]);
        const path = paths[Math.min(classes - 1, Math.floor(now.disk[i + 2] / usual * 4.5))];
        path.moveTo(x + r, y);
        path.arc(x, y, r, 0, 7);
      }
      pen.within(X(0), Y(5), 7.5 * scale, 5 * scale, () =>
        colours(c).forEach((colour, k) => { g.fillStyle = colour; g.fill(paths[k]); }));
      g.strokeStyle = run.value.box === 'walls' ? c.ink : c.hairline;
      g.lineWidth = 2;
      g.strokeRect(X(0), Y(5), 7.5 * scale, 5 * scale);

      const at = narrow ? 36 : wide + 54, top = narrow ? 5 * scale + 46 : 28;
      const f = pen.axes(at, top, w - at - 8, h - top - 44, { from: 0, to: 3, ticks: 1, name: 'speed, in √(2kT/m)' },
        { from: 0, to: 1.2, ticks: 0.5, name: 'density' });
      pen.within(f.left, f.top, f.width, f.height, () => {
        g.fillStyle = c.blue;
        g.globalAlpha = 0.55;
        now.share.forEach((p, b) => g.fillRect(f.X(0.1 * b) + 0.5, f.Y(p), f.width / 30 - 1, f.Y(0) - f.Y(p)));
        g.fillStyle = c.red;
        g.globalAlpha = 0.22;
        g.beginPath();
        const scatter = p => Math.sqrt(p / (0.1 * now.n));
        now.law.forEach((p, b) => g.lineTo(f.X(0.1 * b + 0.05), f.Y(p + scatter(p))));
        [...now.law].reverse().forEach((p, k) => g.lineTo(f.X(2.95 - 0.1 * k), f.Y(p - scatter(p))));
        g.fill();
        g.globalAlpha = 1;
        pen.line(Array.from(now.law, (p, b) => [f.X(0.1 * b + 0.05), f.Y(p)]), c.red, 2);
      });
    },
  });
})();
