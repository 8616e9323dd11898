'use strict';
/* Chapter 4: a piston between two gases of beads, and one between springs. */
(() => {
  const kinds = { few: [4, 11, 30], many: [5, 401, 1200] }; // start, movers, a piston of 40 kg

  function look(run) {
    const n = run.c.look(3)[2], a = run.c.look(9 + 2 * n), x = a.slice(9, 9 + n), middle = (n - 1) / 2;
    run.time = a[0];
    run.now = { t: a[0], hits: a[1], n, left: a[3], right: a[4], piston: a[5], model: a[6], mLeft: a[7], mRight: a[8],
      x, at: x[middle], v: a[9 + n + middle], middle };
  }
  function note(run) {
    look(run);
    run.past.push(run.now);
    if (run.past.length > 4000) run.past.splice(0, 1000);
  }
  function begin(run) {
    const [kind, movers] = kinds[run.value.gas];
    run.past = [];
    run.c.begin(kind, movers, run.value.ratio, run.value.seed);
    note(run);
  }

  live.figure('piston', {
    question: 'How long does the piston follow the springs? Make it heavier, make it lighter: who forgets first? ' +
      'And which gas is the warmer one when it comes back?',
    about: 'Above: a piston between two gases of beads. Below: where it is against the time, with the piston between ' +
      'springs as a broken line, and the energies of both gases.',
    step: 'Next collision',
    rate: 2,
    controls: [
      { key: 'gas', label: 'Gases of', usual: 'many', options: { few: 'five beads each', many: '200 warm beads each' } },
      { key: 'ratio', label: 'Piston to a bead', usual: 1200, log: [1, 30000], unit: 'to 1' },
      { key: 'seed', label: 'Seed', usual: 1, number: [1, 9999] },
    ],
    height: w => Math.max(320, 0.56 * w),
    begin,
    changed(run, key) { if (key === 'gas') run.value.ratio = kinds[run.value.gas][2]; },
    advance(run, until, budget) {
      // A point of the curves each twentieth of a second, however fast it runs.
      const end = performance.now() + budget, by = Math.max(0.05, (until - run.time) / 400);
      for (let t = run.time + by; t < until && performance.now() < end; t += by) { run.c.run(t); note(run); }
      if (performance.now() < end) { run.c.run(until); note(run); }
    },
    once(run) { run.c.run(1e9, 1); note(run); },
    say: run => `${run.now.hits} collisions. The piston is at ${live.number(run.now.at, 4)} m, the one between springs ` +
      `at ${live.number(run.now.model, 4)} m. Energies: left gas ${live.number(run.now.left)} J, right gas ` +
      `${live.number(run.now.right)} J, piston ${live.number(run.now.piston)} J.`,
    draw(run, pen) {
      const { w, h, c } = pen, { now } = run, left = 44, width = w - left - 10, walls = now.x[now.n - 1];
      const X = x => left + x / walls * width;
      pen.line([[left, 26], [left + width, 26]], c.hairline, 1);
      for (const x of [0, walls]) pen.line([[X(x), 6], [X(x), 46]], c.ink, 3);
      const r = now.n > 100 ? 2 : 5;
      for (let i = 1; i < now.n - 1; ++i)
        if (i !== now.middle) pen.disk(X(now.x[i]), 26, r, i < now.middle ? c.blue : c.red, now.n > 100 ? undefined : c.paper);
      pen.box(X(now.at) - 5, 8, 10, 36, c.ink);

      const span = 60, to = Math.max(span, now.t), past = run.past.filter(p => p.t >= to - span - 1);
      const high = (h - 74 - 62 - 44) / 2;
      const f = pen.axes(left, 82, width, high, { from: to - span, to, ticks: 10 },
        { from: 0, to: walls, ticks: 3, name: 'place of the piston (m)' });
      pen.within(f.left, f.top, f.width, f.height, () => {
        pen.line(past.map(p => [f.X(p.t), f.Y(p.model)]), c.quiet, 1.4, [5, 4]);
        pen.line(past.map(p => [f.X(p.t), f.Y(p.at)]), c.ink, 2);
      });
      const first = run.past[0], most = (first.left + first.right + first.piston) * 1.02;
      const e = pen.axes(left, 82 + high + 50, width, high, { from: to - span, to, ticks: 10, name: 'time (s)' },
        { from: 0, to: most, name: w < 500 ? 'energies (J)' : 'energies of the left gas, the right gas and the piston (J)' });
      pen.within(e.left, e.top, e.width, e.height, () => {
        for (const [key, colour] of [['mLeft', c.blue], ['mRight', c.red]])
          pen.line(past.map(p => [e.X(p.t), e.Y(p[key])]), colour, 1.2, [5, 4]);
        for (const [key, colour] of [['left', c.blue], ['right', c.red], ['piston', c.ink]])
          pen.line(past.map(p => [e.X(p.t), e.Y(p[key])]), colour, 1.8);
      });
    },
  });
})();
