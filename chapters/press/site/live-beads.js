'use strict';
/* Chapter 2: beads on a wire, and below it where each of them has been. */
(() => {
  const kinds = { wave: 9, equal: 9, four: 0, mixed: 1, cradle: 2, random: 7 };
  const window_of = 6; // s of world lines
  const list = text => text ? String(text).split(',').map(Number) : [];

  function look(run) {
    const n = run.c.look(4)[3], a = run.c.look(4 + 3 * n);
    run.time = a[0];
    return { t: a[0], hits: a[1], energy: a[2], x: a.slice(4, 4 + n),
      v: a.slice(4 + n, 4 + 2 * n), mass: a.slice(4 + 2 * n, 4 + 3 * n) };
  }
  function note(run) {
    run.now = look(run);
    run.past.push(run.now);
    if (run.past.length > 30000) run.past.splice(0, 10000);
  }
  function begin(run) {
    const v = run.value;
    const given = v.masses ? list(v.masses) : v.start === 'equal' ? Array(10).fill(1) : [];
    run.c.begin(kinds[v.start], v.seed, given.length, ...given);
    run.past = [];
    note(run);
    run.energy = run.now.energy;
    v.bead = Math.min(v.bead, run.now.x.length - 2);
    v.mass = run.now.mass[v.bead];
  }
  function advance(run, until) {
    for (let k = 0; k < 20000 && run.c.run(until, 1) > 0; ++k) note(run);
    note(run);
  }
  function weigh(run, i, mass) {
    const masses = [...run.now.mass].slice(1, -1);
    masses[i - 1] = mass;
    run.value.bead = i;
    run.value.masses = masses.join();
  }
  const place = (run, w) => {
    const x = run.now.x, from = x[0], to = x[x.length - 1];
    return v => 38 + (v - from) / (to - from) * (w - 48);
  };
  const size = (run, mass, w) =>
    Math.min(0.024 * w + 3, Math.max(2.5, 0.011 * w * Math.cbrt(mass)));

  live.figure('beads', {
    question: 'Make the first bead ten times as heavy: what does the wave do? And what if all weigh the same?',
    about: 'Beads on a wire between two stops; below them their world lines, the past lower down.',
    step: 'Next collision',
    again: true,
    cursor: 'ns-resize',
    controls: [
      { key: 'start', label: 'Beads', usual: 'wave', options: { wave: 'ten, as in the figure',
        equal: 'ten of 1 kg', four: 'four of 11 to 41 kg', mixed: 'four heavy, four light',
        cradle: 'two heavy at six light', random: 'ten at random' } },
      { key: 'seed', label: 'Seed', usual: 1, number: [1, 9999], when: v => v.start === 'random' },
      { key: 'bead', label: 'Bead', usual: 1, number: [1, 10], look: true,
        bounds: run => [1, run.now.x.length - 2] },
      { key: 'mass', label: 'Its mass', usual: 9.3, log: [0.1, 100], unit: 'kg' },
      { key: 'masses', usual: '', hidden: true },
    ],
    height: w => Math.max(260, 0.55 * w),
    begin, advance,
    once(run) { run.c.run(run.time + 60, 1); note(run); },
    changed(run, key) {
      if (key === 'start' || key === 'seed') run.value.masses = '';
      if (key === 'bead') run.value.mass = run.now.mass[run.value.bead];
      if (key === 'mass') weigh(run, run.value.bead, run.value.mass);
    },
    grab(run, x, y) {
      if (y > 62) return null;
      const X = place(run, run.api.canvas.clientWidth);
      let best = null;
      run.now.mass.forEach((mass, i) => {
        const off = Math.abs(X(run.now.x[i]) - x);
        if (i > 0 && i < run.now.x.length - 1 && off < 22 && (!best || off < best.off))
          best = { i, off, y, mass };
      });
      return best;
    },
    pull(run, held, x, y) {
      const mass = +Math.min(100, Math.max(0.1, held.mass * 10 ** ((held.y - y) / 70))).toPrecision(3);
      weigh(run, held.i, mass);
      run.api.change('masses', run.value.masses);
    },
    say: run => `${run.now.hits} collisions. Bead ${run.value.bead}: ${live.number(run.value.mass)} kg, ` +
      `${live.number(run.now.v[run.value.bead])} m/s. Energy ${live.number(run.now.energy, 4)} J; it has changed ` +
      `by ${live.number(Math.abs(run.now.energy / run.energy - 1), 1)} of itself.`,
    draw(run, pen) {
      const { w, h, c } = pen, X = place(run, w), wire = 34, top = wire;
      const Y = t => top + (run.time - t) / window_of * (h - top - 4);
      const n = run.now.x.length, colour = i => run.now.mass[i] > 3 ? c.blue : c.red;
      for (let s = 1; s <= window_of; ++s) {
        const t = Math.floor(run.time) - s + 1;
        if (t < 0 || Y(t) > h - 8 || Y(t) < wire + 20) continue;
        pen.line([[38, Y(t)], [w - 10, Y(t)]], c.hairline, 1);
        pen.text(`${t} s`, 31, Y(t), 'right', c.quiet, 12);
      }
      pen.within(0, top, w, h - top, () => {
        const first = Math.max(0, run.past.findLastIndex(p => p.t < run.time - window_of));
        const past = run.past.slice(first);
        for (let i = 1; i < n - 1; ++i)
          pen.line(past.map(p => [X(p.x[i]), Y(p.t)]), colour(i),
            Math.min(6, 0.7 + 0.33 * run.now.mass[i]));
      });
      pen.line([[38, wire], [w - 10, wire]], c.quiet, 1.5);
      for (const i of [0, n - 1]) pen.line([[X(run.now.x[i]), wire - 22], [X(run.now.x[i]), h - 4]], c.ink, 3);
      for (let i = 1; i < n - 1; ++i)
        pen.disk(X(run.now.x[i]), wire, size(run, run.now.mass[i], w), colour(i),
          i === run.value.bead ? c.ink : c.paper);
      pen.text(`bead ${run.value.bead}`, X(run.now.x[run.value.bead]), 9, 'center', c.quiet, 12);
    },
  });
})();
