'use strict';
/* Chapter 8: one swing by two methods, and what each of them keeps. */
(() => {
  const kept = 400, OWN = 8;

  function look(run) {
    const a = run.c.look(1 + 2 * OWN);
    run.time = a[0];
    run.now = [0, 1].map(k => {
      const [x, v, energy, over, a1, b, c, d] = a.slice(1 + k * OWN, 1 + (k + 1) * OWN);
      return { t: a[0], x, v, energy, over, M: [a1, b, c, d] };
    });
    run.now.forEach((p, k) => {
      if (p.over) return;
      run.past[k].push(p);
      if (run.past[k].length > 2 * kept) run.past[k].splice(0, kept);
    });
  }
  function begin(run) {
    const names = run.methods, v = run.value;
    run.past = [[], []];
    run.steps = 0;
    run.c.begin(v.dt, v.damping, Math.max(0, names.indexOf(v.first)), Math.max(0, names.indexOf(v.second)));
    look(run);
  }
  function advance(run, until, budget) {
    for (const end = performance.now() + budget; performance.now() < end && run.c.run(until, 1) > 0; ++run.steps)
      look(run);
  }
  // Through (1, 0): where the form c x^2 - (a - d) x v - b v^2 stays as it is,
  // which it does if the determinant is 1; an ellipse if the trace is small.
  function ellipse([a, b, c, d]) {
    if (Math.abs(a * d - b * c - 1) > 1e-9 || Math.abs(a + d) >= 2) return null;
    const points = [], q = [c, d - a, -b], of = (x, v) => q[0] * x * x + q[1] * x * v + q[2] * v * v;
    for (let k = 0; k <= 120; ++k) {
      const x = Math.cos(k * Math.PI / 60), v = Math.sin(k * Math.PI / 60);
      const r = Math.sqrt(q[0] / of(x, v));
      points.push([r * x, r * v]);
    }
    return points;
  }

  live.figure('swing', {
    question: 'Make the step longer: what becomes of the ellipse that leapfrog stays on, and at which step does it burst? ' +
      'Is there a step that is short enough for Euler?',
    about: 'Left: velocity against displacement of one swing; a circle is the truth, ellipses are what methods keep, ' +
      'points are their steps. Right: the energy against time.',
    rate: 4,
    clock: run => `t = ${run.time.toFixed(2)}`,
    longest: run => run.value.dt,
    controls: [
      { key: 'first', label: 'Blue', usual: 'leapfrog', options: run => run.methods },
      { key: 'second', label: 'Red', usual: 'euler', options: run => run.methods },
      { key: 'dt', label: 'Step h', usual: 0.5, range: [0.01, 3, 0.01], digits: 2 },
      { key: 'damping', label: 'Friction', usual: 0, range: [0, 1, 0.05], digits: 2 },
    ],
    prepare(run) {
      // The ones that choose their steps themselves, or want orbits, stay out.
      run.methods = [];
      for (let k = 0, name; (name = run.c.word(k)); ++k) run.methods.push(name);
    },
    height: w => w < 560 ? 0.8 * w + 230 : Math.max(280, 0.47 * w),
    begin, advance,
    once(run) { run.c.run(1e15, 1); ++run.steps; look(run); },
    say: run => [0, 1].map(k => {
      const p = run.now[k], [a, b, c, d] = p.M, name = k ? run.value.second : run.value.first;
      return `${name}: ${p.over || !Number.isFinite(p.energy) ? 'beyond all numbers' :
        'energy ' + live.number(2 * p.energy, 4) + ' of what it was'}, a step has trace ${live.number(a + d, 4)} and ` +
        `multiplies areas by ${live.number(a * d - b * c, 6)}.`;
    }).join(' '),
    draw(run, pen) {
      const { w, h, c } = pen, narrow = w < 560, colours = [c.blue, c.red];
      const side = narrow ? 0.8 * w - 48 : h - 72, left = narrow ? 0.1 * w + 20 : 44;
      const f = pen.axes(left, 26, side, side, { from: -2, to: 2, ticks: 1, name: 'displacement' },
        { from: -2, to: 2, ticks: 1, name: 'velocity' });
      const round = points => points.map(([x, v]) => [f.X(x), f.Y(v)]);
      pen.within(f.left, f.top, side, side, () => {
        pen.line(round(ellipse([0, 1, -1, 0])), c.quiet, 1, [4, 4]);
        [1, 0].forEach(k => {
          const points = ellipse(run.now[k].M);
          if (points && run.value.damping === 0) pen.line(round(points), colours[k], 1.2);
          const past = run.past[k].slice(-kept);
          pen.g.globalAlpha = 0.25;
          pen.line(past.slice(-60).map(p => [f.X(p.x), f.Y(p.v)]), colours[k], 1);
          pen.g.globalAlpha = 1;
          past.forEach((p, i) => pen.disk(f.X(p.x), f.Y(p.v), i === past.length - 1 ? 6 : 2.2, colours[k]));
        });
      });
      const at = narrow ? 44 : left + side + 58, top = narrow ? side + 100 : 26;
      const span = 40, to = Math.max(span, run.time);
      const e = pen.axes(at, top, w - at - 10, h - top - 46, { from: to - span, to, ticks: 10, name: 'time' },
        { from: 0, to: 2, ticks: 0.5, name: 'energy, as a share of the first' });
      pen.within(e.left, e.top, e.width, e.height, () => {
        pen.line([[e.X(to - span), e.Y(1)], [e.X(to), e.Y(1)]], c.quiet, 1, [4, 4]);
        [1, 0].forEach(k => pen.line(run.past[k].filter(p => p.t > to - span - 4)
          .map(p => [e.X(p.t), e.Y(Math.min(1e3, 2 * p.energy))]), colours[k], 1.8));
      });
    },
  });
})();
