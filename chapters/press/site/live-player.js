'use strict';
/* The scene player: the text of a scene, its motion, and observables of it. */
(async () => {
  const { make } = live, $ = id => document.getElementById(id);
  const word = { SCENES: 0, ABOUT: 1, KEYS: 2, HELP: 3, METHODS: 4, NAMES: 5, MESSAGE: 6, WRITTEN: 7 };
  const array = { PLACES: 0, RADII: 1, COLOURS: 2, MASSES: 3, FREE: 4, SPRINGS: 5, OBSERVED: 6 };
  const change = { METHOD: 0, DT: 1, GRAVITY: 2, DAMPING: 5, RESTITUTION: 6, K2: 7 };
  let c;
  try {
    c = await live.open('player');
  } catch (error) {
    $('motion').append(make('p', { textContent: `This browser cannot run the player: ${error.message}.` }));
    return;
  }

  // Light or dark, as the pages of the book remember it.
  const root = document.documentElement, night = matchMedia('(prefers-color-scheme: dark)');
  const dark = () => root.dataset.theme ? root.dataset.theme === 'dark' : night.matches;
  const named = () => { $('theme').textContent = dark() ? 'Light' : 'Dark'; };
  $('theme').addEventListener('click', () => {
    root.dataset.theme = dark() ? 'light' : 'dark';
    try { localStorage.setItem('bonkers-theme', root.dataset.theme); } catch { /* not kept */ }
    named();
  });
  night.addEventListener('change', named);
  named();

  // ---- the program

  const e = c.exports;
  const say = (kind, k = 0) => c.word(1000 * word[kind] + k);
  const list = kind => {
    const all = [];
    for (let k = 0, name; (name = say(kind, k)); ++k) all.push(name);
    return all;
  };
  function give(text) {
    const bytes = new TextEncoder().encode(text);
    const at = e.page_text(bytes.length);
    new Uint8Array(e.memory.buffer, at, bytes.length).set(bytes);
  }
  // An address first, and then the memory, which the call may have moved.
  const floats = (kind, n) => {
    const at = e.page_array(array[kind]);
    return new Float64Array(e.memory.buffer, at, n);
  };
  function look() {
    const a = c.look(29);
    return { t: a[0], steps: a[1], n: a[2], springs: a[3], stopped: a[4], hits: a[5], line: a[6], dt: a[7],
      gravity: [a[8], a[9], a[10]], damping: a[11], restitution: a[12], k2: a[13], contact: a[14] === 1,
      wall: [a[15], a[16], a[17]], low: [a[18], a[19], a[20]], high: [a[21], a[22], a[23]], columns: a[24],
      sudden: a[25] === 1, passed: a[26], through: `bodies ${a[27]} and ${a[28]}` };
  }
  const scenes = list('SCENES'), about = list('ABOUT'), methods = list('METHODS');
  function keysOf(name) {
    say('SCENES', scenes.indexOf(name));
    return list('KEYS').map((text, k) => {
      const [key, usual, low, high, whole] = text.split(' ');
      return { key, usual: +usual, low: +low, high: +high, whole: whole === '1', help: say('HELP', k) };
    });
  }

  // ---- what is on the page

  const s = { name: '', keys: {}, own: false, now: null, playing: false, wanted: false, view: 'xy', past: [],
    points: [], x: 't', y: 'energy', trails: true, zoom: 1, goal: 0 };
  const button = (text, act) => {
    const b = make('button', { type: 'button', textContent: text });
    b.addEventListener('click', act);
    return b;
  };
  const bar = (...inside) => make('div', { className: 'live-bar' }, ...inside);
  const fields = (...inside) => make('div', { className: 'live-fields' }, ...inside);

  const choice = live.control({ label: 'Scene', options: { '': 'my own', ...Object.fromEntries(scenes.map((name, k) =>
    [name, `${name}: ${about[k]}`])) } }, name => {
    s.method = 'leapfrog';
    if (name) choose(name);
  });
  const keys = make('div', { className: 'live-fields' });
  const more = make('details', {}, make('summary', { textContent: 'Keys of this scene' }), keys);
  const lines = make('div', { className: 'player-lines', 'aria-hidden': 'true' });
  const text = make('textarea', { spellcheck: false, autocapitalize: 'off', 'aria-label': 'The scene, a .plist',
    'aria-describedby': 'wrong' });
  const wrong = make('p', { id: 'wrong', className: 'player-wrong', role: 'status' });
  const file = make('input', { type: 'file', accept: '.plist,text/plain', hidden: true });
  const left = make('div', { className: 'live-figure' }, fields(choice.label), more,
    make('div', { className: 'player-text' }, lines, text), wrong,
    bar(button('Begin anew', () => begin()), button('Open a file', () => file.click()), button('Save the scene', saveScene)), file);
  $('scene').append(left);

  const canvas = make('canvas', { role: 'img', 'aria-label': 'The bodies of the scene in motion' });
  const play = button('Play', () => go(!s.wanted));
  const step = button('One step', () => { go(false); advance(Infinity, 1); show(); });
  const anew = button('Reset', () => begin());
  const speed = live.control({ label: 'Speed', options: { 0.125: '⅛ ×', 0.25: '¼ ×', 0.5: '½ ×', 1: '1 ×', 2: '2 ×',
    4: '4 ×', 8: '8 ×' } }, () => {});
  const view = live.control({ label: 'View', options: { xy: 'x, y', xz: 'x, z', tilted: 'tilted' } },
    v => { s.view = v; measure(); show(); });
  const trails = live.control({ label: 'Ways', check: true }, on => { s.trails = on === 1; draw(); });
  const clock = make('span', { className: 'live-clock' });
  const method = live.control({ label: 'Method', options: methods }, name => alter(change.METHOD, methods.indexOf(name)));
  const number = (label, what, low, high) => {
    const one = live.control({ label, number: [low, high, 'any'] }, v => alter(what, v));
    return one;
  };
  const dt = number('dt', change.DT, 1e-12, 1e12);
  const gravity = ['x', 'y', 'z'].map((axis, k) => number(`Gravity ${axis}`, change.GRAVITY + k, -1e9, 1e9));
  const damping = number('Friction', change.DAMPING, 0, 1e9);
  const restitution = number('Restitution', change.RESTITUTION, 0, 1);
  const k2 = number('Attraction k²', change.K2, 0, 1e12);
  const told = make('p', { className: 'live-numbers' });
  const spoken = make('p', { className: 'live-spoken', 'aria-live': 'polite' });
  const plot = make('canvas', { role: 'img', 'aria-label': 'One observable against another' });
  const known = make('datalist', { id: 'known' }, ...list('NAMES').map(value => make('option', { value })));
  const asks = which => {
    const input = make('input', { type: 'text', value: s[which], spellcheck: false });
    input.setAttribute('list', 'known');
    input.addEventListener('change', () => { s[which] = input.value.trim(); observe(); show(); write(); });
    return input;
  };
  const askY = asks('y'), askX = asks('x'), refused = make('p', { className: 'player-wrong', role: 'status' });
  const command = make('p', { className: 'player-command' });
  const link = button('Link', copyLink);
  $('motion').append(
    make('div', { className: 'live-figure' }, canvas,
      bar(play, step, anew, speed.label, clock, link),
      fields(view.label, trails.label, method.label, dt.label, damping.label, restitution.label, k2.label, ...gravity.map(g => g.label)), told, spoken),
    make('div', { className: 'live-figure' }, fields(make('label', { className: 'live-control' }, make('span', { textContent: 'Draw' }), askY),
      make('label', { className: 'live-control' }, make('span', { textContent: 'against' }), askX), known,
      button('Save the table', saveTable)), refused, plot, command));
  speed.set(1);
  trails.set(1);

  // ---- the text

  function number_lines() {
    const count = text.value.split('\n').length, bad = s.badLine;
    const parts = [];
    if (bad > 0 && bad <= count) {
      const before = Array.from({ length: bad - 1 }, (_, k) => k + 1).join('\n');
      parts.push(before + (bad > 1 ? '\n' : ''), make('b', { textContent: bad }),
        '\n' + Array.from({ length: count - bad }, (_, k) => bad + k + 1).join('\n'));
    } else parts.push(Array.from({ length: count }, (_, k) => k + 1).join('\n'));
    lines.replaceChildren(...parts, '\n\n');
    lines.scrollTop = text.scrollTop;
  }
  text.addEventListener('scroll', () => { lines.scrollTop = text.scrollTop; });
  let soon;
  text.addEventListener('input', () => {
    s.own = true;
    choice.set('');
    more.hidden = true;
    clearTimeout(soon);
    soon = setTimeout(() => begin(), 400);
  });
  file.addEventListener('change', async () => {
    if (!file.files[0]) return;
    put(await file.files[0].text(), true);
    s.file = file.files[0].name.replace(/\.plist$/, '');
    file.value = '';
    begin();
  });
  function put(words, own) {
    text.value = words;
    s.own = own;
    if (own) { choice.set(''); more.hidden = true; }
    s.badLine = 0;
    number_lines();
  }
  function complain(what, at) {
    s.badLine = at;
    wrong.textContent = what ? (at > 0 ? `Line ${at}: ` : '') + what : '';
    text.setAttribute('aria-invalid', what ? 'true' : 'false');
    number_lines();
    if (at > 0) text.scrollTop = Math.max(0, (at - 5) * 19.5);
  }
  const fault = () => say('MESSAGE') || c.said.text.trim().replace(/^page: /, '') || 'it cannot be stepped';

  // ---- choosing, beginning, changing

  // What a page cannot move as fast as a film begins smaller here.
  const lighter = { ring: { particles: 400 } };
  function choose(name, values = lighter[name] || {}) {
    s.name = s.file = name;
    const all = keysOf(name);
    s.keys = Object.fromEntries(all.map(k => [k.key, values[k.key] ?? k.usual]));
    s.usual = Object.fromEntries(all.map(k => [k.key, k.usual]));
    keys.replaceChildren(...all.map(k => {
      const one = live.control({ label: k.key, number: [k.low, k.high, k.whole ? 1 : 'any'] }, v => {
        s.keys[k.key] = v;
        build();
        begin();
      });
      one.label.title = k.help;
      one.set(s.keys[k.key]);
      return one.label;
    }));
    more.hidden = all.length === 0;
    choice.set(name);
    build();
    return begin(true);
  }
  function build() {
    const at = new Float64Array(e.memory.buffer, e.page_number.value, 64);
    Object.values(s.keys).forEach((v, k) => { at[k] = v; });
    if (!e.page_make(scenes.indexOf(s.name))) {
      complain(`${s.name}: ${say('MESSAGE')}`, 0);
      return;
    }
    put(say('WRITTEN'), false);
  }
  function begin(fresh = false) {
    clearTimeout(soon);
    give(text.value);
    c.said.text = '';
    const good = c.begin(Math.max(0, methods.indexOf(s.method || 'leapfrog')));
    s.now = look();
    s.past = [];
    if (!good) {
      go(false);
      complain(fault(), s.now.line);
      command.textContent = '';
      return false;
    }
    complain('', 0);
    s.method ||= 'leapfrog';
    s.changed = false;
    s.goal = s.now.t;
    const film = live.films[s.own ? '' : s.name];
    s.rate = film ? 25 * film[0] : 60 * s.now.dt;
    s.unit = film ? film[1] : '';
    dress();
    if (fresh) pickView();
    measure();
    observe();
    show();
    write();
    return true;
  }
  // The run goes on from where it is, under another law.
  function alter(what, value) {
    const method_was = s.method;
    if (what === change.METHOD) s.method = methods[value];
    if (what === change.METHOD && s.now.stopped !== 0) { begin(); return; } // another may be able to
    c.said.text = '';
    const good = s.now.stopped === 0 && e.page_change(what, value);
    if (!good) {
      complain(fault(), 0);
      if (what === change.METHOD) { s.method = method_was; e.page_change(what, methods.indexOf(method_was)); }
      show();
      return;
    }
    complain('', 0);
    observe(true);
    s.now = look();
    s.goal = s.now.t;
    if (e.page_save(0, 0)) put(say('WRITTEN'), true);
    show();
    write();
  }
  function observe(keep = false) {
    refused.textContent = '';
    if (!keep) s.points = [];
    s.widths = null;
    if (!s.x || !s.y) { give(''); e.page_observe(); drawPlot(); return; }
    s.widths = [];
    for (const name of [s.x, s.y]) {
      give(name);
      if (!e.page_observe()) { refused.textContent = say('MESSAGE'); s.widths = null; return; }
      s.widths.push(look().columns);
    }
    give(`${s.x},${s.y}`);
    if (!e.page_observe()) { refused.textContent = say('MESSAGE'); s.widths = null; return; }
    sample();
  }
  function sample() {
    if (!s.widths || s.now.stopped < 0) return;
    const start = performance.now();
    s.points.push(Array.from(floats('OBSERVED', s.widths[0] + s.widths[1])));
    s.dear = performance.now() - start;
    if (s.points.length > 6000) s.points = s.points.filter((_, k) => k % 2 === 0);
  }

  // ---- time

  function advance(until, events = Infinity) {
    const end = performance.now() + 12;
    let steps = 0;
    while (steps < events && performance.now() < end && c.run(until, 1) > 0) ++steps;
    s.now = look();
    if (steps > 0) {
      s.past.push({ t: s.now.t, x: Float64Array.from(floats('PLACES', 3 * s.now.n)).slice() });
      if (s.past.length > 500 || s.past.length * s.now.n > 60000) s.past.shift();
      s.idle = (s.idle || 0) + 1;
      if (!(s.dear > 3) || s.idle % 10 === 0) sample();
    }
    return steps;
  }
  let last = 0, shownAt = 0;
  const costs = [];
  function frame(now) {
    if (!s.playing) return;
    const passed = last ? Math.min(0.05, (now - last) / 1000) : 0;
    last = now;
    const start = performance.now();
    s.goal = Math.max(s.now.t, Math.min(s.goal, s.now.t + 2 * s.now.dt)) + passed * s.rate * speed.input.value;
    // A few looks on the way, so that what is drawn is not too coarse.
    const from = s.now.t;
    for (let k = 1; k <= 3; ++k) advance(from + (s.goal - from) * k / 3);
    draw();
    if (now - shownAt > 200) { shownAt = now; show(); }
    costs.push(performance.now() - start);
    if (costs.length > 600) costs.shift();
    if (s.now.stopped !== 0) go(false);
    else requestAnimationFrame(frame);
  }
  function go(on) {
    if (on && (!s.now || s.now.stopped !== 0)) { if (!begin()) return; }
    s.wanted = on;
    turn();
    if (!on && s.now) { show(); spoken.textContent = told.textContent; write(); }
  }
  function turn() {
    const now = s.wanted && !document.hidden;
    if (now && !s.playing) { last = 0; requestAnimationFrame(frame); }
    s.playing = now;
    play.textContent = s.wanted ? 'Pause' : 'Play';
  }
  document.addEventListener('visibilitychange', turn);

  // ---- what is seen

  const hues = ['blue', 'red', 'green', 'orange', 'purple', '#56b4e9', '#999933', '#777777'];
  function dress() { // colours as the films have them
    const n = s.now.n, colour = floats('COLOURS', 3 * n).slice(), mass = floats('MASSES', n).slice();
    const free = floats('FREE', n).slice(), some = mass.filter((_, i) => free[i]);
    const least = Math.min(...some.slice(0, 1e5)), most = Math.max(...some.slice(0, 1e5)), springs = s.now.springs;
    s.radius = floats('RADII', n).slice();
    s.traced = [];
    s.colour = Array.from({ length: n }, (_, i) => {
      const [r, g, b] = [colour[i], colour[n + i], colour[2 * n + i]];
      if (r + g + b > 0) return `rgb(${[r, g, b].map(v => Math.round(255 * v)).join()})`;
      if (!free[i]) return '#888888';
      if (n - springs <= 8 && springs < 5) return hues[i % 8];
      return most > 1.5 * least && mass[i] >= Math.sqrt(least * most) ? 'red' : 'blue';
    });
    if (n <= 16 && springs < 5) for (let i = 0; i < n; ++i) if (free[i]) s.traced.push(i);
    const list = floats('SPRINGS', 5 * springs).slice();
    s.bonds = Array.from({ length: springs }, (_, k) => ({ a: list[5 * k], b: list[5 * k + 1],
      colour: list[5 * k + 2] + list[5 * k + 3] + list[5 * k + 4] > 0
        ? `rgb(${[2, 3, 4].map(j => Math.round(255 * list[5 * k + j])).join()})` : '' }));
  }
  const project = (x, n, i) => {
    const a = x[i], b = x[n + i], d = x[2 * n + i];
    if (s.view === 'xz') return [a, d, -b];
    if (s.view !== 'tilted') return [a, b, d];
    const depth = -(Math.sin(Math.PI / 6) * a + Math.cos(Math.PI / 6) * b);
    return [Math.cos(Math.PI / 6) * a - Math.sin(Math.PI / 6) * b,
      Math.cos(Math.PI / 7) * d * s.tall - Math.sin(Math.PI / 7) * depth, depth];
  };
  const extent = (x, n, k) => {
    let low = Infinity, high = -Infinity;
    for (let i = k * n; i < (k + 1) * n; ++i) { low = Math.min(low, x[i]); high = Math.max(high, x[i]); }
    return [low, high];
  };
  function pickView() {
    const n = s.now.n, x = floats('PLACES', 3 * n).slice();
    e.page_run(Infinity, 20); // what moves shows where it moves; then back to the start
    const y = floats('PLACES', 3 * n).slice();
    give(text.value);
    c.begin(Math.max(0, methods.indexOf(s.method)));
    s.now = look();
    const span = [0, 1, 2].map(k => { const [a, b] = extent(x, n, k), [d, f] = extent(y, n, k);
      return Math.max(b, f) - Math.min(a, d); });
    const most = Math.max(...span);
    s.view = span[2] <= 0.04 * most ? 'xy' : span[1] <= 0.04 * most ? 'xz' : 'tilted';
    view.set(s.view);
  }
  // The field that is seen: the scene's walls, or what its bodies have needed,
  // but not more than four times, of many bodies one and a half times its size.
  function measure() {
    const n = s.now.n, x = floats('PLACES', 3 * n);
    const span = [0, 1, 2].map(k => { const [a, b] = extent(x, n, k); return b - a; });
    s.tall = span[2] < 0.15 * Math.max(...span) ? 3 : 1;
    s.field = null;
    grow();
    const half = Math.max(s.field[1] - s.field[0], s.field[3] - s.field[2]) / 2, reach = (n > 30 ? 1.5 : 4) * half;
    const mid = [(s.field[0] + s.field[1]) / 2, (s.field[2] + s.field[3]) / 2];
    s.most = [mid[0] - reach, mid[0] + reach, mid[1] - reach, mid[1] + reach];
    if (half === 0) s.most = [-Infinity, Infinity, -Infinity, Infinity];
  }
  function grow() {
    const n = s.now.n, x = floats('PLACES', 3 * n), f = s.field || [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < n; ++i) {
      const [u, v] = project(x, n, i), r = s.now.contact ? s.radius[i] : 0;
      if (!Number.isFinite(u) || !Number.isFinite(v)) continue;
      f[0] = Math.min(f[0], u - r); f[1] = Math.max(f[1], u + r);
      f[2] = Math.min(f[2], v - r); f[3] = Math.max(f[3], v + r);
    }
    if (s.most) [0, 1, 2, 3].forEach(k => { f[k] = k % 2 ? Math.min(f[k], s.most[k]) : Math.max(f[k], s.most[k]); });
    if (s.view !== 'tilted') [[0, 0], [2, s.view === 'xz' ? 2 : 1]].forEach(([at, k]) => {
      if (s.now.wall[k]) { f[at] = s.now.low[k]; f[at + 1] = s.now.high[k]; }
    });
    s.field = f;
  }
  function draw() {
    if (!s.now || !s.field || s.now.stopped < 0) return;
    const w = Math.max(200, canvas.clientWidth || 640), h = Math.round(Math.min(0.62 * w, 560));
    canvas.style.height = h + 'px';
    const pen = live.pen(canvas, w, h), { g } = pen, col = pen.c;
    const colour = i => col[s.colour[i]] || s.colour[i]; // the page's blue, or one of the scene
    grow();
    const n = s.now.n, x = floats('PLACES', 3 * n), [a, b, d, f] = s.field;
    const flat = s.view !== 'tilted' && f - d <= 1e-9 * (b - a) + 2 * Math.max(0, ...s.radius.slice(0, 1000));
    const scale = Math.min((w - 28) / ((b - a) || 1), flat ? Infinity : (h - 28) / ((f - d) || 1));
    const U = u => w / 2 + (u - (a + b) / 2) * scale;
    const top = flat ? 14 + scale * (f - d) / 2 : h / 2, V = v => top - (v - (d + f) / 2) * scale;
    g.strokeStyle = col.ink;
    if (s.view !== 'tilted') {
      const k = s.view === 'xz' ? 2 : 1, low = flat ? h - 6 : V(d), high = flat ? 4 : V(f);
      if (s.now.wall[0] === 1) for (const u of [a, b]) pen.line([[U(u), low], [U(u), high]], col.ink, 2);
      if (s.now.wall[k] === 1) for (const v of [d, f]) pen.line([[U(a), V(v)], [U(b), V(v)]], col.ink, 2);
    }
    if (s.trails && s.past.length > 1) {
      const which = flat ? Array.from({ length: Math.min(n, 60) }, (_, i) => i) : s.traced;
      g.globalAlpha = 0.55;
      const fall = (h - top - 8) / Math.max(1e-300, s.rate * 6);
      for (const i of which)
        pen.line(s.past.map(p => { const [u, v] = project(p.x, n, i);
          return [U(u), V(v) + (flat ? (s.now.t - p.t) * fall : 0)]; }), colour(i), 1.3);
      g.globalAlpha = 1;
    }
    const at = Array.from({ length: n }, (_, i) => project(x, n, i));
    const bonds = new Map();
    for (const { a: from, b: to, colour: hue } of s.bonds) {
      if (!bonds.has(hue)) bonds.set(hue, new Path2D());
      const path = bonds.get(hue);
      path.moveTo(U(at[from][0]), V(at[from][1]));
      path.lineTo(U(at[to][0]), V(at[to][1]));
    }
    g.lineWidth = 1.2;
    for (const [hue, path] of bonds) { g.strokeStyle = hue || col.quiet; g.stroke(path); }
    const order = at.map((_, i) => i), least = n > 300 ? 1.4 : n > 30 ? 2.4 : 4;
    if (s.view === 'tilted') order.sort((i, j) => at[i][2] - at[j][2]);
    if (n > 300 && s.view !== 'tilted') { // as few paths as there are colours
      const paths = new Map();
      for (const i of order) {
        if (!paths.has(colour(i))) paths.set(colour(i), new Path2D());
        const r = Math.max(least, s.radius[i] * scale), path = paths.get(colour(i)), u = U(at[i][0]), v = V(at[i][1]);
        path.moveTo(u + r, v);
        path.arc(u, v, r, 0, 7);
      }
      for (const [hue, path] of paths) { g.fillStyle = hue; g.fill(path); }
    } else for (const i of order) {
      const r = s.now.contact && s.radius[i] > 0 ? Math.max(1.5, s.radius[i] * scale) : Math.max(least, Math.min(40, s.radius[i] * scale));
      pen.disk(U(at[i][0]), V(at[i][1]), r, colour(i), r > 3 ? col.quiet : undefined);
    }
    drawPlot();
  }
  function drawPlot() {
    const w = Math.max(200, plot.clientWidth || 640), h = Math.round(Math.min(260, 0.5 * w));
    plot.style.height = h + 'px';
    const pen = live.pen(plot, w, h), wx = s.widths ? s.widths[0] : 0, points = s.points;
    if (!wx || points.length === 0) return;
    const range = which => {
      let low = Infinity, high = -Infinity;
      for (const p of points) for (const k of which) if (Number.isFinite(p[k])) { low = Math.min(low, p[k]); high = Math.max(high, p[k]); }
      return [low, high];
    };
    const ys = Array.from({ length: s.widths[1] }, (_, k) => wx + k);
    const [xl, xh] = range([0]), [yl, yh] = range(ys);
    // What hardly changes is drawn as its change.
    const base = ys.length === 1 && yh - yl < 2e-3 * Math.max(Math.abs(yl), Math.abs(yh)) ? points[0][ys[0]] : 0;
    const wide = (l, h2) => { const pad = (h2 - l) * 0.05 || Math.abs(h2) * 1e-15 || 1e-15; return [l - pad, h2 + pad]; };
    const [x0, x1] = wide(xl, xh), [y0, y1] = wide(yl - base, yh - base);
    const f = pen.axes(86, 26, w - 100, h - 66, { from: x0, to: x1, name: s.x },
      { from: y0, to: y1, name: base ? `${s.y}, less ${live.number(base, 6)} at the start` : s.y });
    const colours = [pen.c.blue, pen.c.red, pen.c.green, pen.c.purple];
    pen.within(f.left, f.top, f.width, f.height, () => ys.forEach((k, j) => {
      pen.line(points.filter(p => Number.isFinite(p[k])).map(p => [f.X(p[0]), f.Y(p[k] - base)]), colours[j % 4], 1.6);
      const p = points[points.length - 1];
      pen.disk(f.X(p[0]), f.Y(p[k] - base), 3, colours[j % 4]);
    }));
  }
  function show() {
    const { now } = s;
    if (!now) return;
    clock.textContent = `t = ${live.number(now.t, 5)}${s.unit && s.unit !== '-' ? ' ' + s.unit : ''}`;
    method.set(s.method || 'leapfrog');
    for (const [field, value] of [[dt, now.dt], [damping, now.damping], [restitution, now.restitution],
      [k2, now.k2], ...gravity.map((g, k) => [g, now.gravity[k]])])
      if (document.activeElement !== field.input) field.set(value);
    restitution.label.hidden = !now.sudden;
    k2.label.hidden = now.n < 2;
    const why = now.stopped === 1 ? ' A coordinate is no longer finite: try a smaller dt.'
      : now.stopped === 2 ? ' The method found no solution: try a smaller dt.'
      : !now.passed ? '' : ' Two bodies passed through each other within a step, ' + // as step says it
        `${now.passed < 1000 ? '' : 'at least '}${now.passed} time${now.passed === 1 ? '' : 's'} (${now.through} for ` +
        'one): the step took them further than the sum of their radii; try a smaller dt.';
    told.textContent = now.stopped < 0 ? '' : `${now.n} bodies, ${now.springs} springs, ${now.steps} steps` +
      (now.contact ? `, ${now.hits} collisions` : '') + `, ${s.method}.${why}`;
    command.textContent = now.stopped < 0 ? '' : '$ ' + told_command();
    draw();
  }

  // ---- keeping

  const name = () => (s.file || 'scene') + '.plist';
  function told_command() {
    const rest = s.y && s.widths && s.points.length ? ` --observe ${s.x === 't' ? s.y : s.x + ',' + s.y}` : '';
    return `step ${name()} --method ${s.method} --until ${s.now.t}${rest}`;
  }
  function download(words, as) {
    const a = make('a', { href: URL.createObjectURL(new Blob([words], { type: 'text/plain' })), download: as });
    a.click();
    setTimeout(() => URL.revokeObjectURL(a.href), 10000);
  }
  const saved = () => s.now.stopped >= 0 && e.page_save(0, 0) ? say('WRITTEN') : text.value;
  function saveScene() { download(saved(), name()); }
  function table() {
    const rows = s.widths ? 1000 : 100, every = Math.max(1, Math.floor(s.now.steps / rows));
    give(s.x === 't' && s.widths ? s.y : s.widths ? `${s.x},${s.y}` : '');
    e.page_observe();
    give(told_command());
    const good = e.page_save(1, every);
    observe(true);
    return good ? say('WRITTEN') : '';
  }
  function saveTable() { download(table(), (s.file || 'scene') + '.dat'); }

  // ---- the address

  const pack = async (words, stream) => new Uint8Array(await new Response(new Blob([words]).stream()
    .pipeThrough(new stream('gzip'))).arrayBuffer());
  const letters = bytes => btoa(Array.from(bytes, b => String.fromCharCode(b)).join(''))
    .replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
  const unletters = words => Uint8Array.from(atob(words.replace(/-/g, '+').replace(/_/g, '/')), ch => ch.charCodeAt(0));
  let writing = 0;
  async function write() {
    const mine = ++writing, words = new URLSearchParams();
    if (s.own) {
      const packed = letters(await pack(text.value, CompressionStream));
      if (mine !== writing) return false;
      if (packed.length > 60000) return false;
      words.set('text', packed);
    } else {
      words.set('scene', s.name);
      for (const [k, v] of Object.entries(s.keys)) if (v !== s.usual[k]) words.set(k, v);
    }
    if (s.method !== 'leapfrog') words.set('method', s.method);
    if (s.x !== 't') words.set('x', s.x);
    if (s.y !== 'energy') words.set('y', s.y);
    if (s.now.steps > 0 && s.now.stopped === 0) words.set('steps', s.now.steps);
    s.written = '#' + words;
    try { history.replaceState(null, '', s.written); } catch { return false; }
    return true;
  }
  async function copyLink() {
    const good = await write();
    spoken.textContent = good ? 'The address of this page now leads to this scene.'
      : 'This scene is too long for an address; save it instead.';
    try { if (good) await navigator.clipboard.writeText(location.href); } catch { /* it stands in the address */ }
    link.textContent = good ? 'Copied' : 'Too long';
    setTimeout(() => { link.textContent = 'Link'; }, 1500);
  }
  async function recall() {
    const words = new URLSearchParams(location.hash.slice(1));
    s.method = methods.includes(words.get('method')) ? words.get('method') : 'leapfrog';
    s.x = askX.value = words.get('x') || 't';
    s.y = askY.value = words.get('y') ?? 'energy';
    const steps = Math.min(1e6, +words.get('steps') || 0);
    let good;
    if (words.has('text')) {
      try {
        put(new TextDecoder().decode(await pack(unletters(words.get('text')), DecompressionStream)), true);
        s.file = 'scene';
        good = begin(true);
      } catch { complain('The address holds no scene.', 0); }
    } else {
      const wish = scenes.includes(words.get('scene')) ? words.get('scene') : 'figure-eight';
      const values = { ...lighter[wish] };
      for (const [k, v] of words) if (Number.isFinite(+v) && v !== '') values[k] = +v;
      good = choose(wish, values);
    }
    for (const end = performance.now() + 4000; good && s.now.steps < steps && performance.now() < end;)
      if (advance(Infinity, steps - s.now.steps) === 0) break;
    if (good) { s.goal = s.now.t; show(); }
    return good && steps === 0;
  }
  addEventListener('hashchange', () => { if (location.hash !== s.written && live.player) { go(false); recall(); } });
  addEventListener('keydown', key => {
    if (key.ctrlKey || key.altKey || key.metaKey || /^(INPUT|SELECT|TEXTAREA|BUTTON)$/.test(key.target.tagName)) return;
    if (key.key === 'p' || key.key === ' ') go(!s.wanted);
    else if (key.key === '.') step.click();
    else if (key.key === 'r') anew.click();
    else return;
    key.preventDefault();
  });
  new ResizeObserver(draw).observe(canvas);
  new MutationObserver(draw).observe(document.documentElement, { attributes: true });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);

  live.player = { s, costs, table, saved };
  const fresh = await recall();
  if (fresh && !matchMedia('(prefers-reduced-motion: reduce)').matches) go(true);
  live.player.ready = true;
})();
