'use strict';
/* Figures that live: a canvas, its controls, a clock and an address, the same
   for all. A figure is a program of src/page/, compiled to WebAssembly, and a
   script live-NAME.js that calls live.figure. All is embedded in plain scripts,
   since a page that was opened as a file can fetch nothing. Without script or
   WebAssembly nothing is added to the printed figure. */
(() => {
  const live = window.live = { programs: {}, numbers: {}, ready: {} };
  const still = matchMedia('(prefers-reduced-motion: reduce)');

  // ---- the program of a figure

  // What stands in a script is compressed, and written in letters.
  const unpack = text => new Response(new Blob([Uint8Array.from(atob(text), c => c.charCodeAt(0))])
    .stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();

  // What a program writes to its standard error is added to said.text.
  function stubs(module, memory, said) {
    const write = (file, list, count, done) => {
      const view = new DataView(memory());
      let sum = 0;
      for (let i = list; i < list + 8 * count; i += 8) {
        const size = view.getUint32(i + 4, true);
        said.text += new TextDecoder().decode(
          new Uint8Array(memory(), view.getUint32(i, true), size));
        sum += size;
      }
      view.setUint32(done, sum, true);
      return 0;
    };
    const all = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module))
      (all[from] ||= {})[name] = name === 'fd_write' ? write : () => 0;
    return all;
  }

  // Resolves to what page.h declares, with arrays instead of addresses.
  live.open = async name => {
    const module = await WebAssembly.compile(await unpack(live.programs[name]));
    const said = { text: '' };
    const instance = await WebAssembly.instantiate(module,
      stubs(module, () => instance.exports.memory.buffer, said));
    const e = instance.exports;
    const floats = (at, n) => new Float64Array(e.memory.buffer, at, n);
    e._initialize();
    return {
      said, exports: e,
      begin(...numbers) {
        floats(e.page_number.value, numbers.length).set(numbers);
        return e.page_begin() !== 0;
      },
      run: (until, events = 1e15) => e.page_run(until, events),
      look: n => floats(e.page_look(), n),
      word(n) {
        const at = e.page_word(n), all = new Uint8Array(e.memory.buffer);
        return at ? new TextDecoder().decode(all.slice(at, all.indexOf(0, at))) : null;
      },
    };
  };

  // ---- drawing

  const hue = {
    light: { blue: '#0072b2', red: '#c04e00', green: '#00795a', purple: '#98388f', orange: '#b87d00' },
    dark: { blue: '#5cb8ee', red: '#ff8f4d', green: '#3ccaa5', purple: '#e08fd6', orange: '#f0c24b' },
  };

  // The page's colours as they are now, and ours for the series.
  live.colours = canvas => {
    const style = getComputedStyle(canvas), c = {}, pen = canvas.getContext('2d');
    for (const [name, property, otherwise] of [['ink', '--text', '#222'], ['quiet', '--quiet', '#666'],
      ['hairline', '--line', '#ccc'], ['paper', '--paper', '#fff']]) {
      pen.fillStyle = otherwise;
      pen.fillStyle = style.getPropertyValue(property).trim() || otherwise;
      c[name] = pen.fillStyle;
    }
    const grey = parseInt(c.paper.slice(1, 3), 16);
    return Object.assign(c, hue[grey < 128 ? 'dark' : 'light']);
  };

  // The least of 1, 2, 5, 10, ... that is no less than this.
  const nice = least => {
    const power = 10 ** Math.floor(Math.log10(least)), lead = least / power;
    return power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
  };
  live.number = (x, digits = 3) => {
    if (x === 0 || !Number.isFinite(x)) return String(x);
    const size = Math.abs(x);
    return size >= 1e5 || size < 1e-3
      ? String(+x.toPrecision(digits)).replace(/^[^e]*$/, v => (+v).toExponential()).replace('e+', 'e').replace(/e(-?)(\d+)/, ' × 10^$1$2')
          .replace(/\^(-?)(\d+)$/, (_, s, d) => (s ? '⁻' : '') +
            [...d].map(c => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c]).join('')).replace('-', '−')
      : String(+x.toPrecision(digits)).replace('-', '−');
  };

  // A pen for a canvas of w by h pixels, however fine the screen is.
  live.pen = makePen;
  function makePen(canvas, w, h) {
    const scale = devicePixelRatio || 1, g = canvas.getContext('2d');
    if (canvas.width !== Math.round(w * scale) || canvas.height !== Math.round(h * scale)) {
      canvas.width = Math.round(w * scale);
      canvas.height = Math.round(h * scale);
    }
    const c = live.colours(canvas);
    g.setTransform(scale, 0, 0, scale, 0, 0);
    g.clearRect(0, 0, w, h);
    g.lineJoin = g.lineCap = 'round';
    const pen = {
      g, w, h, c,
      text(text, x, y, align = 'left', colour = c.ink, size = 13) {
        g.font = `${size}px system-ui, "DejaVu Sans", sans-serif`;
        g.textAlign = align;
        g.textBaseline = 'middle';
        g.fillStyle = colour;
        g.fillText(text, x, y);
      },
      line(points, colour = c.ink, width = 1.5, dash = []) {
        g.strokeStyle = colour;
        g.lineWidth = width;
        g.setLineDash(dash);
        g.beginPath();
        points.forEach(([x, y], i) => i ? g.lineTo(x, y) : g.moveTo(x, y));
        g.stroke();
        g.setLineDash([]);
      },
      disk(x, y, r, colour, rim) {
        g.beginPath();
        g.arc(x, y, r, 0, 7);
        if (colour) { g.fillStyle = colour; g.fill(); }
        if (rim) { g.strokeStyle = rim; g.lineWidth = 1; g.stroke(); }
      },
      box(x, y, width, height, colour) {
        g.fillStyle = colour;
        g.fillRect(x, y, width, height);
      },
      within(x, y, width, height, draw) {
        g.save();
        g.beginPath();
        g.rect(x, y, width, height);
        g.clip();
        draw();
        g.restore();
      },
      // Axes round a field: x and y are {from, to, name}. Returns how numbers
      // become pixels.
      axes(left, top, width, height, x, y) {
        const X = v => left + (v - x.from) / (x.to - x.from) * width;
        const Y = v => top + height - (v - y.from) / (y.to - y.from) * height;
        g.strokeStyle = c.hairline;
        g.lineWidth = 1;
        g.strokeRect(left, top, width, height);
        for (const [a, P, room] of [[x, X, width / 75], [y, Y, height / 45]]) {
          const by = a.ticks || nice((a.to - a.from) / Math.max(1, room));
          if (!(by > 0)) continue;
          for (let k = Math.ceil(a.from / by - 1e-9); k * by <= a.to + 1e-9 * by; ++k) {
            const at = P(k * by), word = live.number(k * by);
            if (a === x) {
              pen.line([[at, top + height], [at, top + height - 4]], c.quiet, 1);
              pen.text(word, at, top + height + 11, 'center', c.quiet, 12);
            } else {
              pen.line([[left, at], [left + 4, at]], c.quiet, 1);
              pen.text(word, left - 6, at, 'right', c.quiet, 12);
            }
          }
        }
        if (x.name) pen.text(x.name, left + width / 2, top + height + 27, 'center', c.ink);
        if (y.name) pen.text(y.name, left - 2, top - 11, 'left', c.ink);
        return { X, Y, left, top, width, height };
      },
    };
    return pen;
  }

  // ---- controls

  const make = (name, attributes = {}, ...inside) => {
    const e = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
      key in e && key !== 'list' ? e[key] = value : e.setAttribute(key, value);
    e.append(...inside);
    return e;
  };
  live.make = make;

  const shown = (control, value) => control.log
    ? live.number(value) + (control.unit ? ' ' + control.unit : '')
    : (control.digits === undefined ? live.number(value) : value.toFixed(control.digits)) +
      (control.unit ? ' ' + control.unit : '');

  // options: {value: text}, or a list of texts, or a function that has them later.
  function fill(select, options) {
    if (typeof options === 'function') return;
    const pairs = Array.isArray(options) ? options.map(o => [o, o]) : Object.entries(options);
    select.replaceChildren(...pairs.map(([value, text]) => make('option', { value, textContent: text })));
  }

  // A labelled input for a control: range, log (a range of powers of ten),
  // number, or options. set(value) shows a value.
  live.control = (control, changed) => {
    const name = make('span', { textContent: control.label });
    const told = make('output');
    let input;
    if (control.options) {
      input = make('select');
      fill(input, control.options);
      input.addEventListener('change', () => changed(input.value));
    } else if (control.check) {
      input = make('input', { type: 'checkbox' });
      input.addEventListener('change', () => changed(input.checked ? 1 : 0));
    } else {
      const [from, to, by] = control.log || control.range || control.number;
      input = make('input', { type: control.number ? 'number' : 'range' });
      Object.assign(input, control.log
        ? { min: Math.log10(from), max: Math.log10(to), step: 0.02 }
        : { min: from, max: to, step: by || 1 });
      input.addEventListener(control.number ? 'change' : 'input', () => {
        if (input.value === '' || !Number.isFinite(+input.value)) return;
        const clipped = Math.min(+input.max, Math.max(+input.min, +input.value));
        changed(control.log ? +(10 ** clipped).toPrecision(3) : clipped);
      });
    }
    const label = make('label', { className: 'live-control' }, name, input);
    if (control.log || control.range) label.append(told);
    return {
      label, input,
      fill: options => fill(input, options),
      set(value) {
        if (control.check) input.checked = +value !== 0;
        else input.value = control.log ? Math.log10(value) : value;
        if (control.log || control.range) {
          told.textContent = shown(control, value);
          input.setAttribute('aria-valuetext', told.textContent);
        }
      },
    };
  };

  // ---- one figure

  const sentence = text => text.replace(/\s+/g, ' ').trim();
  const speeds = { 0.125: '⅛', 0.25: '¼', 0.5: '½', 1: '1', 2: '2', 4: '4', 8: '8' };

  // What the address says to a figure: #live=NAME&key=value&...
  function asked(name) {
    const words = new URLSearchParams(location.hash.slice(1));
    return words.get('live') === name ? words : null;
  }

  live.figure = (name, figure) => {
    for (const place of document.querySelectorAll(`.live[data-live="${name}"]`))
      if (window.WebAssembly) mount(place, name, figure);
  };

  // A figure that is a scene of the player.
  const here = document.currentScript ? document.currentScript.src : location.href;
  live.opens = (name, scene, question) => {
    for (const place of document.querySelectorAll(`.live[data-live="${name}"]`))
      place.append(make('section', { className: 'live-figure', 'aria-label': 'Try it: ' + question },
        make('p', { className: 'live-question' }, make('strong', { textContent: 'Try it. ' }), question),
        make('p', {}, make('a', { href: new URL('../player.html#' + scene, here), textContent: 'Open the scene in the player' }))));
  };

  function mount(place, name, figure) {
    const controls = figure.controls || [];
    const usual = Object.fromEntries(controls.map(c => [c.key, c.usual]));
    const run = { value: { ...usual }, time: 0, name };
    let playing = false, wanted = false, seen = false, last = 0, owed = 0, started = false;
    let broken = false, told = 0;

    const canvas = make('canvas', { role: 'img', 'aria-label': sentence(figure.about) });
    const button = (text, title) => make('button', { type: 'button', textContent: text, title });
    const play = button('Play', 'play or pause: p'), step = button(figure.step || 'One step', 'go on by one: .');
    const reset = button('Reset', 'begin anew, with the usual numbers: r');
    const link = button('Link', 'put this run into the address, and copy that');
    const speed = make('select', {}, ...Object.entries(figure.speeds || speeds).sort((a, b) => a[0] - b[0])
      .map(([value, text]) => make('option', { value, textContent: text + ' ×' })));
    speed.value = figure.speed || 1;
    const clock = make('span', { className: 'live-clock' });
    const bar = make('div', { className: 'live-bar' }, play, step, reset,
      make('label', { className: 'live-speed' }, make('span', { textContent: 'Speed' }), speed),
      clock, link);
    const inputs = {};
    const fields = make('div', { className: 'live-fields' });
    for (const c of controls.filter(c => !c.hidden)) {
      inputs[c.key] = live.control(c, value => change(c.key, value));
      fields.append(inputs[c.key].label);
    }
    const numbers = make('p', { className: 'live-numbers' });
    const spoken = make('p', { className: 'live-spoken', 'aria-live': 'polite' });
    const all = make('section', { className: 'live-figure', 'aria-label': 'Try it: ' + sentence(figure.question) },
      make('p', { className: 'live-question' }, make('strong', { textContent: 'Try it. ' }),
        sentence(figure.question)),
      canvas, bar, fields, numbers, spoken);
    place.append(all);

    const api = place.liveFigure = run.api = {
      run, canvas, costs: [], play: () => go(true), pause: () => go(false), step: once, reset: begin, change, draw, show,
      get playing() { return playing; },
      get speed() { return +speed.value; },
    };

    function show() {
      for (const c of controls) {
        if (!inputs[c.key]) continue;
        if (c.bounds) {
          const [from, to] = c.bounds(run);
          Object.assign(inputs[c.key].input, { min: from, max: to });
        }
        inputs[c.key].set(run.value[c.key]);
        inputs[c.key].label.hidden = c.when ? !c.when(run.value) : false;
      }
      play.textContent = playing ? 'Pause' : 'Play';
      clock.textContent = figure.clock ? figure.clock(run) : `t = ${run.time.toFixed(2)} s`;
      numbers.textContent = sentence(figure.say(run));
    }
    // Only what somebody did is read out; not what runs by itself.
    const speak = () => { spoken.textContent = clock.textContent + '. ' + numbers.textContent; };

    function draw() {
      const w = Math.max(200, canvas.clientWidth || 640);
      const h = Math.round(figure.height(w));
      canvas.style.height = h + 'px';
      figure.draw(run, makePen(canvas, w, h));
    }

    function write() {
      const words = new URLSearchParams({ live: name });
      for (const c of controls)
        if (String(run.value[c.key]) !== String(usual[c.key])) words.set(c.key, run.value[c.key]);
      if (run.time > 0) words.set('t', run.time);
      try { history.replaceState(null, '', '#' + words); } catch { /* not here */ }
    }

    function begin() {
      figure.begin(run);
      show();
      draw();
    }
    // Until when a figure is to run that shall stop at this time. Half a step is added, since
    // a sum of steps may exceed their number times one by a rounding.
    const reached = time => time + (figure.early ? figure.early(run) : figure.longest ? figure.longest(run) / 2 : 0);
    // Begins with the numbers that there are, or, where they do not go together,
    // with others. Returns whether they do.
    function tries(others) {
      try {
        figure.begin(run);
        return true;
      } catch {
        Object.assign(run.value, others);
        figure.begin(run);
        return false;
      }
    }
    // With other numbers the run begins anew, and comes as far as it was.
    function change(key, value) {
      const time = run.time, old = { ...run.value };
      let fits = true;
      run.value[key] = value;
      figure.changed?.(run, key);
      if (controls.find(c => c.key === key)?.look !== true) {
        fits = tries(old);
        if (figure.again) figure.advance(run, reached(time), 2000);
      }
      show();
      draw();
      if (!fits) spoken.textContent = numbers.textContent = 'These numbers do not go together; they stay as they were.';
      else if (!playing) speak();
      write();
    }
    function once() {
      go(false);
      figure.once(run);
      show();
      draw();
      speak();
      write();
    }
    function go(on) {
      wanted = on;
      turn();
      if (!on && started) { draw(); show(); speak(); write(); }
    }
    function turn() {
      const now = wanted && seen && started && !document.hidden;
      if (now && !playing) { last = owed = 0; requestAnimationFrame(frame); }
      playing = now;
      play.textContent = wanted ? 'Pause' : 'Play';
    }
    function frame(now) {
      if (!playing) return;
      const dt = last ? Math.min(0.05, (now - last) / 1000) : 0;
      last = now;
      const start = performance.now();
      // What a step is too long for waits; what was too much work is dropped.
      const ahead = dt * (figure.rate || 1) * speed.value;
      owed = Math.min(owed + ahead, ahead + (figure.longest ? figure.longest(run) : 0));
      const before = run.time;
      figure.advance(run, run.time + owed, 10);
      owed = Math.max(0, owed - (run.time - before));
      draw();
      if (now - told > 200) { told = now; show(); }
      api.costs.push(performance.now() - start);
      if (api.costs.length > 600) api.costs.shift();
      requestAnimationFrame(frame);
    }
    function recall() {
      const words = asked(name);
      if (!words) return false;
      for (const c of controls) {
        const text = words.has(c.key) ? words.get(c.key) : usual[c.key];
        run.value[c.key] = typeof usual[c.key] === 'number' && Number.isFinite(+text) ? +text : text;
      }
      go(false);
      tries(usual);
      const time = +words.get('t');
      if (time > 0 && time < 1e9) figure.advance(run, reached(time), 5000);
      show();
      draw();
      place.scrollIntoView({ block: 'center' });
      return true;
    }
    async function start() {
      try {
        run.c = await live.open(name);
        const begins = run.c.begin;
        run.c.begin = (...n) => { if (!begins(...n)) throw new Error('these numbers do not go together'); };
      } catch (error) {
        broken = true;
        all.remove();
        console.warn(`live figure ${name}: ${error.message}`);
        return;
      }
      started = true;
      figure.prepare?.(run);
      for (const c of controls)
        if (typeof c.options === 'function') inputs[c.key].fill(c.options(run));
      figure.begin(run);
      show();
      draw();
      api.ready = true;
      if (!recall() && !still.matches) wanted = true;
      turn();
    }

    play.addEventListener('click', () => go(!wanted));
    step.addEventListener('click', once);
    reset.addEventListener('click', () => {
      for (const c of controls) if (c.hidden) run.value[c.key] = usual[c.key];
      Object.assign(run.value, usual);
      begin();
      speak();
      write();
    });
    link.addEventListener('click', async () => {
      write();
      let text = 'The address of this page now leads to this run.';
      try {
        await navigator.clipboard.writeText(location.href);
        text = 'Copied: the address of this run.';
      } catch { /* it stands in the address line */ }
      spoken.textContent = link.title = text;
      link.textContent = 'Copied';
      setTimeout(() => { link.textContent = 'Link'; }, 1500);
    });
    all.addEventListener('keydown', e => {
      if (e.ctrlKey || e.altKey || e.metaKey || /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName)) return;
      if (e.key === 'p') go(!wanted);
      else if (e.key === '.') once();
      else if (e.key === 'r') reset.click();
      else return;
      e.preventDefault();
    });
    if (figure.grab) drag();
    function drag() {
      let held = null;
      const at = e => {
        const r = canvas.getBoundingClientRect();
        return [e.clientX - r.left, e.clientY - r.top];
      };
      canvas.style.touchAction = 'pan-y'; // a page can still be scrolled there
      canvas.addEventListener('pointerdown', e => {
        if (!started) return;
        held = figure.grab(run, ...at(e));
        if (held === null) return;
        canvas.setPointerCapture(e.pointerId);
        e.preventDefault();
      });
      canvas.addEventListener('pointermove', e => {
        if (!started) return;
        if (held !== null) figure.pull(run, held, ...at(e));
        else canvas.style.cursor = figure.grab(run, ...at(e), true) === null ? '' : figure.cursor || 'grab';
      });
      const drop = () => { if (held !== null) { held = null; figure.drop?.(run); speak(); write(); } };
      canvas.addEventListener('pointerup', drop);
      canvas.addEventListener('pointercancel', drop);
    }
    new IntersectionObserver(found => {
      seen = found[found.length - 1].isIntersecting;
      if (seen && !started && !broken && !api.asked) { api.asked = true; start(); }
      else turn();
    }, { rootMargin: '0px' }).observe(all);
    document.addEventListener('visibilitychange', turn);
    addEventListener('hashchange', () => { if (started) recall(); });
    const again = () => { if (started) draw(); };
    new ResizeObserver(again).observe(canvas);
    new MutationObserver(again).observe(document.documentElement, { attributes: true });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again);
    if (asked(name)) place.scrollIntoView({ block: 'center' });
  }

  document.head.append(make('style', { textContent: `
.live-figure { margin: 1.2em 0 1.8em; padding: .9em 1em; border: 1px solid var(--line, #ccc);
  border-radius: 8px; background: var(--paper, #fff); color: var(--text, #222);
  font: 15px/1.45 var(--sans, sans-serif); }
.live-figure p { margin: 0 0 .6em; text-align: left; }
.live-figure canvas { display: block; width: 100%; }
.live-bar, .live-fields { display: flex; flex-wrap: wrap; gap: .5em .8em; align-items: center; margin: .6em 0; }
.live-figure button, .live-figure select, .live-figure input[type=number], .live-figure input[type=text] {
  font: inherit; color: inherit; background: var(--tint, #f4f4f4); border: 1px solid var(--quiet, #666);
  border-radius: 5px; box-sizing: border-box; padding: .2em .65em; height: 2.15em; margin: 0; max-width: 100%; }
.live-figure button { cursor: pointer; min-width: 4.2em; }
.live-figure button:hover { border-color: var(--accent, #a33); color: var(--accent, #a33); }
.live-figure :focus-visible { outline: 2px solid var(--accent, #a33); outline-offset: 2px; }
.live-control, .live-speed { display: inline-flex; align-items: center; gap: .45em; }
.live-control { min-width: 0; max-width: 100%; }
.live-control select { min-width: 0; flex: 0 1 auto; }
.live-control[hidden] { display: none; }
.live-control input[type=range] { width: 9.5em; accent-color: var(--accent, #a33); }
.live-control input[type=number] { width: 5.5em; }
.live-control output { min-width: 4.2em; font-variant-numeric: tabular-nums; color: var(--quiet, #666); }
.live-clock { flex: 1; min-width: 6em; font-variant-numeric: tabular-nums; }
.live-numbers { color: var(--quiet, #666); font-variant-numeric: tabular-nums; min-height: 2.9em; }
.live-figure p.live-numbers { margin: 0; }
.live-spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media print { .live-figure { display: none; } }
` }));
})();
