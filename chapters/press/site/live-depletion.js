'use strict';
/* Chapter 6: the force on large disks among small ones, felt by the hand. */
(() => {
  const side = 5, furthest = 3.2;

  function look(run) {
    const n = run.c.look(2)[1], a = run.c.look(10 + 2 * n);
    run.time = a[0];
    run.now = { tries: a[0], n, r: a[2], push: a[3], error: a[4], law: a[5], samples: a[6], at: a.slice(10) };
    if (run.value.hand === 'held' && run.now.samples >= 200) {
      const last = run.points[run.points.length - 1];
      const point = { r: run.now.r, push: run.now.push, error: run.now.error };
      if (last && last.r === point.r) run.points[run.points.length - 1] = point; else run.points.push(point);
      if (run.points.length > 60) run.points.shift();
    }
  }
  function begin(run) {
    const v = run.value, kind = [v.small, v.radius, v.hand].join();
    if (run.kind !== kind) run.points = [];
    run.kind = kind;
    run.c.begin(v.small, v.radius, v.hand === 'held' ? 0 : 0.1, v.seed);
    run.line = Array.from(run.c.line(furthest));
    put(run, 1, 4, 2.5); // out of the way of the first
    put(run, 0, 1.45, 2.5);
    put(run, 1, v.x, v.y);
    look(run);
  }
  function put(run, which, x, y) {
    const number = run.c.numbers();
    number[4] = x;
    number[5] = y;
    run.c.exports.page_make(which);
  }
  const nearest = run => +Math.min(2.9, Math.max(2, run.now.r)).toFixed(2);
  const geometry = run => {
    const w = run.api.canvas.clientWidth, narrow = w < 560, size = narrow ? 0.8 * w : Math.max(260, 0.44 * w) - 12;
    return { left: narrow ? 0.1 * w : 4, size, scale: size / side };
  };

  live.figure('depletion', {
    question: 'Take the red disk and bring it near the other. Nobody pulls; who pushes? How far does it reach, ' +
      'and what if the small ones are smaller? Let go: do the two stay together?',
    about: 'Left: two large disks, with the rims that the centres of small ones cannot pass, among small ones. Right: the ' +
      'force on a large disk against the distance; points are measured, the line is the law.',
    step: 'All once',
    rate: 20000,
    clock: run => `${run.now.tries} tries`,
    controls: [
      { key: 'hand', label: 'The red disk is', usual: 'held', options: { held: 'held', free: 'let go' } },
      { key: 'apart', label: 'Distance', usual: 2.1, range: [2, 2.9, 0.05], digits: 2, unit: 'm',
        when: v => v.hand === 'held' },
      { key: 'small', label: 'Small disks', usual: 72, number: [0, 400] },
      { key: 'radius', label: 'Their radius', usual: 0.2, range: [0.05, 0.4, 0.05], digits: 2, unit: 'm' },
      { key: 'seed', label: 'Seed', usual: 1, number: [1, 9999] },
      { key: 'x', usual: 3.55, hidden: true }, // of the red disk
      { key: 'y', usual: 2.5, hidden: true },
    ],
    prepare(run) {
      const e = run.c.exports;
      run.c.numbers = () => new Float64Array(e.memory.buffer, e.page_number.value, 64);
      run.c.line = most => { const at = e.page_array(most); return new Float64Array(e.memory.buffer, at, 100); };
    },
    height: w => w < 560 ? 0.8 * w + 250 : Math.max(260, 0.44 * w),
    begin,
    changed(run, key) { if (key === 'apart') Object.assign(run.value, { x: 1.45 + run.value.apart, y: 2.5 }); },
    advance(run, until, budget) {
      const end = performance.now() + budget;
      while (run.c.run(until, 2000) >= 2000 && performance.now() < end);
      look(run);
    },
    once(run) { run.c.run(1e15, run.now.n); look(run); },
    grab(run, x, y) {
      const g = geometry(run);
      if (run.value.hand !== 'held') return null;
      const dx = x - (g.left + run.now.at[2] * g.scale), dy = y - (6 + (side - run.now.at[3]) * g.scale);
      return Math.hypot(dx, dy) < g.scale ? { dx, dy } : null;
    },
    pull(run, held, x, y) {
      const g = geometry(run);
      put(run, 1, (x - held.dx - g.left) / g.scale, side - (y - held.dy - 6) / g.scale);
      look(run);
      run.value.apart = nearest(run);
      run.api.show();
      run.api.draw();
    },
    // Where it is let go a run begins, so that its address leads there.
    drop(run) {
      run.value.x = +run.now.at[2].toFixed(3);
      run.api.change('y', +run.now.at[3].toFixed(3));
    },
    say: run => run.value.hand === 'held'
      ? `Distance ${live.number(run.now.r)} m. The small ones push with ${Number.isFinite(run.now.error)
        ? `${live.number(run.now.push, 2)} ± ${live.number(run.now.error, 1)}` : '?'} kT/m; the law says ` +
        `${live.number(run.now.law, 3)}, where minus is together.`
      : `Distance ${live.number(run.now.r)} m. They touch at 2, and lose sight of each other at ` +
        `${live.number(2 + 2 * run.value.radius)}.`,
    draw(run, pen) {
      // All of them jump many times a picture; what is seen are a few of the states.
      const late = performance.now() - (run.shownAt || 0) > 300;
      if (late || !run.api.playing || run.shown?.length !== run.now.at.length) {
        run.shown = run.now.at;
        run.shownAt = performance.now();
      }
      const { w, h, c, g } = pen, { now } = run, { left, size, scale } = geometry(run), narrow = w < 560;
      const X = x => left + x * scale, Y = y => 6 + (side - y) * scale, reach = (1 + run.value.radius) * scale;
      g.strokeStyle = c.hairline;
      g.lineWidth = 1.5;
      g.strokeRect(X(0), Y(side), size, size);
      const images = (x, y, r, draw) => {
        for (const i of [-1, 0, 1]) for (const j of [-1, 0, 1]) {
          const u = X(x + side * i), v = Y(y + side * j);
          if (u > X(0) - r && u < X(side) + r && v > Y(side) - r && v < Y(0) + r) draw(u, v);
        }
      };
      const fold = v => v - side * Math.floor(v / side);
      pen.within(X(0), Y(side), size, size, () => {
        g.globalAlpha = 0.16;
        for (const k of [0, 1]) images(fold(now.at[2 * k]), fold(now.at[2 * k + 1]), reach, (u, v) => pen.disk(u, v, reach, k ? c.red : c.blue));
        g.globalAlpha = 1;
        for (let i = 2; i < now.n; ++i) images(fold(run.shown[2 * i]), fold(run.shown[2 * i + 1]), run.value.radius * scale,
          (u, v) => pen.disk(u, v, run.value.radius * scale, undefined, c.quiet));
        for (const k of [0, 1]) images(fold(now.at[2 * k]), fold(now.at[2 * k + 1]), scale, (u, v) => pen.disk(u, v, scale, k ? c.red : c.blue, c.ink));
      });
      const at = narrow ? 44 : left + size + 62, top = narrow ? size + 50 : 28;
      const deepest = Math.min(-1, ...run.line) * 1.35;
      const f = pen.axes(at, top, w - at - 10, h - top - 42, { from: 2, to: furthest, ticks: 0.2, name: 'distance (m)' },
        { from: deepest, to: -deepest * 0.35, name: 'force (kT/m); minus: together' });
      pen.within(f.left, f.top, f.width, f.height, () => {
        pen.line([[f.X(2), f.Y(0)], [f.X(furthest), f.Y(0)]], c.hairline, 1);
        pen.line(run.line.map((y, k) => [f.X(2 + (furthest - 2) * k / 99), f.Y(y)]), c.red, 2);
        for (const p of run.points) {
          pen.line([[f.X(p.r), f.Y(p.push - p.error)], [f.X(p.r), f.Y(p.push + p.error)]], c.ink, 1.3);
          pen.disk(f.X(p.r), f.Y(p.push), 3, c.ink);
        }
        pen.line([[f.X(now.r), f.top], [f.X(now.r), f.top + f.height]], c.quiet, 1, [3, 4]);
      });
    },
  });
})();
