'use strict';
/* Figures that live, and the scene player, in a browser, used by keyboard.
     node tests/site/browser/live.js FOLDER SCRATCH
   FOLDER has what make live makes. Prints ok and not ok lines. */
const fs = require('fs');
const path = require('path');
const { execFileSync } = require('child_process');
const { chromium } = require('playwright-core');
const bytes = require('./live-bytes.js');

const [folder, scratch] = process.argv.slice(2).map(p => path.resolve(p));
const names = fs.readdirSync(path.join(folder, 'live')).filter(f => /\.js$/.test(f) && !/^(live|player|play-.*)\.js$/.test(f))
  .map(f => f.slice(0, -3)).sort();
const said = [];
async function holds(what, check) {
  let wrong;
  try { wrong = await check(); } catch (error) { wrong = error.message.split('\n')[0]; }
  console.log(wrong ? `not ok live: ${what} - ${wrong}` : `ok live: ${what}`);
}

// A page with all figures, one below the other.
const sheet = path.join(scratch, 'figures.html');
fs.writeFileSync(sheet, `<!doctype html><html lang="en"><meta charset="utf-8"><title>Figures</title>
<link rel="stylesheet" href="file://${folder}/page.css"><h1>Figures</h1>
${names.map(n => `<p style="height:900px">Before ${n}.</p><div class="live" data-live="${n}"></div>`).join('\n')}
<p style="height:900px">The end.</p><script src="file://${folder}/live/live.js"></script>
${names.map(n => `<script src="file://${folder}/live/${n}.js"></script>`).join('\n')}</html>`);

async function open(browser, address, options = {}) {
  const { init, ...rest } = options;
  const context = await browser.newContext({ viewport: { width: 1000, height: 800 }, reducedMotion: 'reduce', ...rest });
  const page = await context.newPage();
  if (init) await page.addInitScript(init);
  page.on('console', m => { if (m.type() === 'error') said.push(m.text()); });
  page.on('pageerror', e => said.push(e.message));
  await page.goto(address);
  return page;
}
const figure = name => `.live[data-live="${name}"]`;
const state = (page, name) => page.evaluate(n => {
  const l = document.querySelector(n).liveFigure;
  return { t: l.run.time, playing: l.playing, picture: l.canvas.toDataURL(), hash: location.hash };
}, figure(name));
async function show(page, name) {
  await page.locator(figure(name)).scrollIntoViewIfNeeded();
  await page.waitForFunction(n => document.querySelector(n).liveFigure?.ready, figure(name), { timeout: 20000 });
}
const press = async (page, name, text, key = 'Enter') => {
  await page.locator(`${figure(name)} button`, { hasText: text }).focus();
  await page.keyboard.press(key);
};

async function plays(page, name) {
  await show(page, name);
  const before = await state(page, name);
  if (before.playing) return 'it began by itself, though reduced motion is asked for';
  await press(page, name, 'Play');
  await page.waitForFunction(([n, t]) => document.querySelector(n).liveFigure.run.time > t, [figure(name), before.t],
    { timeout: 20000 });
  await press(page, name, 'Pause');
  const after = await state(page, name);
  if (after.picture === before.picture) return 'the picture did not change';
  await page.waitForTimeout(150);
  const later = await state(page, name);
  if (later.playing || later.t !== after.t) return 'it did not stop';
  await page.locator(`${figure(name)} .live-bar button`).nth(1).focus();
  await page.keyboard.press('Space');
  if (!((await state(page, name)).t > later.t)) return 'one step does not go on';
  return '';
}

// The address of a run leads a colleague to the same numbers.
async function leads(browser, page, name) {
  const mine = await state(page, name);
  if (!mine.hash.includes('live=' + name)) return `the address is ${mine.hash}`;
  const other = await open(browser, 'file://' + sheet + mine.hash);
  await other.waitForFunction(n => document.querySelector(n).liveFigure?.ready, figure(name), { timeout: 20000 });
  const theirs = await state(other, name);
  await other.context().close();
  return theirs.t !== mine.t ? `t is ${theirs.t} there, ${mine.t} here` : '';
}

async function inView(browser) {
  const page = await open(browser, 'file://' + sheet, { reducedMotion: 'no-preference' });
  const running = () => page.evaluate(all => all.filter(n => document.querySelector(n).liveFigure?.playing),
    names.map(figure));
  await page.waitForTimeout(200);
  if ((await running()).length) return 'something runs out of view';
  await show(page, names[0]);
  await page.waitForFunction(n => document.querySelector(n).liveFigure.run.time > 0, figure(names[0]));
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForFunction(n => !document.querySelector(n).liveFigure.playing, figure(names[0]), { timeout: 5000 });
  await show(page, names[0]);
  await page.waitForFunction(n => document.querySelector(n).liveFigure.playing, figure(names[0]), { timeout: 5000 });
  await page.context().close();
  return '';
}

async function withoutWasm(browser) {
  const page = await open(browser, 'file://' + sheet, { init: 'delete window.WebAssembly' });
  await page.locator(figure(names[0])).scrollIntoViewIfNeeded();
  const left = await page.locator('.live-figure').count();
  await page.context().close();
  return left ? `${left} figures stand there` : '';
}

// ---- the scene player

const wait = (page, expression) => page.waitForFunction(expression, null, { timeout: 20000 });
async function edit(page, from, to) {
  await page.locator('textarea').focus();
  await page.evaluate(([a, b]) => {
    const text = document.querySelector('textarea');
    const at = text.value.indexOf(a);
    text.setSelectionRange(at, at + a.length);
  }, [from, to]);
  await page.keyboard.type(to);
}
async function player(browser) {
  const page = await open(browser, `file://${folder}/player.html#scene=figure-eight`);
  await wait(page, 'window.live?.player?.ready');
  await holds('the player waits, if motion is to be reduced', async () =>
    await page.evaluate('live.player.s.playing') ? 'it plays' : '');
  await holds('the player plays and stops by keyboard', async () => {
    await page.locator('#motion button', { hasText: 'Play' }).focus();
    await page.keyboard.press('Enter');
    await wait(page, 'live.player.s.now.t > 0.05');
    await page.keyboard.press('Enter');
    return await page.evaluate('live.player.s.playing') ? 'it still plays' : '';
  });
  await holds('a line that is broken is named, and marked', async () => {
    await edit(page, 'k2 1', 'k2 one');
    await wait(page, `document.querySelector('#wrong').textContent`);
    const text = await page.locator('#wrong').textContent(), mark = await page.locator('.player-lines b').textContent();
    return /^Line 9: found .*one.*expected/.test(text) && mark === '9' ? '' : `${text} (${mark})`;
  });
  await holds('once it is mended the scene plays again', async () => {
    await edit(page, 'k2 one', 'k2 2');
    await wait(page, `!document.querySelector('#wrong').textContent && live.player.s.now.k2 === 2`);
    await page.locator('#motion button', { hasText: 'Play' }).focus();
    await page.keyboard.press('Enter');
    await wait(page, 'live.player.s.now.t > 0.05');
    await page.keyboard.press('Enter');
    return '';
  });
  await holds('the address holds the scene as it was written', async () => {
    await wait(page, `location.hash.includes('text=') && location.hash.includes('steps=')`);
    const mine = await page.locator('textarea').inputValue();
    const other = await open(browser, page.url());
    await wait(other, 'window.live?.player?.ready');
    const theirs = await other.locator('textarea').inputValue();
    const t = await Promise.all([page, other].map(p => p.evaluate('live.player.s.now.t')));
    await other.context().close();
    return mine !== theirs ? 'the text there is another' : t[0] !== t[1] ? `t is ${t[1]} there, ${t[0]} here` : '';
  });
  await holds('friction changes while it runs, and the text with it', async () => {
    await page.locator('label', { hasText: 'Friction' }).locator('input').fill('0.5');
    await page.keyboard.press('Enter');
    await wait(page, 'live.player.s.now.damping === 0.5');
    const text = await page.locator('textarea').inputValue();
    return /\ndamp 0.5\n/.test(text) && /\ntime 0\.\d+\n/.test(text) ? '' : 'the text has not';
  });
  await holds('bodies that pass through each other are told, until the step is short', async () => {
    const scene = step => 'pos 0 -1 0 0 1 0 0.013\npos 1 1 0 0 1 0 0.013\nvel 0 1 0 0\nvel 1 -1 0 0\n' +
      `contact\ndt ${step}\n`;
    const note = /passed through each other within a step, 1 time \(bodies 0 and 1 for one\).*try a smaller dt\.$/;
    const told = async step => {
      await page.locator('textarea').fill(scene(step));
      await wait(page, `live.player.s.now.dt === ${step}`);
      await page.locator('#motion button', { hasText: 'One step' }).focus();
      for (let k = 0; k * step < 1.5; ++k) await page.keyboard.press('Enter');
      return await page.locator('.live-numbers').textContent();
    };
    const [long, short] = [await told(0.3), await told(0.012)];
    return !note.test(long) ? long : /passed/.test(short) || !/, 1 collisions/.test(short) ? short : '';
  });
  await holds('an observable that is none is refused', async () => {
    await page.locator('#motion input[type=text]').first().fill('enrgy');
    await page.keyboard.press('Enter');
    await wait(page, `/enrgy.*is no observable/.test(document.querySelectorAll('.player-wrong')[1].textContent)`);
    return '';
  });
  await page.context().close();
}

// Where a figure of the book opens the player there is a scene.
async function opens(browser, name) {
  const file = path.join(scratch, name + '.html');
  fs.writeFileSync(file, `<!doctype html><html lang="en"><title>A scene</title><div class="live" data-live="${name}"></div>
<script src="file://${folder}/live/live.js"></script><script src="file://${folder}/live/${name}.js"></script></html>`);
  const page = await open(browser, 'file://' + file);
  const asked = /scene=([a-z-]*)/.exec(await page.locator('a').getAttribute('href'))[1];
  await page.locator('a').focus();
  await page.keyboard.press('Enter');
  await wait(page, 'window.live?.player?.ready');
  const { wrong, scene, points } = await page.evaluate(() => ({ scene: live.player.s.name, points: live.player.s.points.length,
    wrong: [...document.querySelectorAll('.player-wrong')].map(p => p.textContent).join('') }));
  await page.context().close();
  return wrong || (scene !== asked ? `the scene is ${scene}, not ${asked}` : points === 0 ? 'nothing is drawn' : '');
}

// What the player saves is what step writes.
async function saves(browser, scene, method, steps, y) {
  const page = await open(browser, `file://${folder}/player.html#scene=${scene}&method=${method}&y=${y}&steps=${steps}`);
  await wait(page, 'window.live?.player?.ready');
  const { text, table, command, then } = await page.evaluate(() => {
    const { player } = live;
    const command = document.querySelector('.player-command').textContent.slice(2);
    const table = player.table();
    return { text: document.querySelector('textarea').value, table, command, then: player.saved() };
  });
  await page.context().close();
  fs.writeFileSync(path.join(scratch, scene + '.plist'), text);
  const words = command.split(' ').slice(1);
  const run = more => execFileSync(path.resolve('build/bin/step'), [...words, ...more],
    { cwd: scratch, encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore'] });
  const native = run([]);
  run(['--save', 'after.plist', '--output', '/dev/null']);
  const after = fs.readFileSync(path.join(scratch, 'after.plist'), 'utf8');
  return table !== native ? `${command}: the tables differ` : then !== after ? `${command}: the scenes differ` : '';
}

(async () => {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage'] });
  const page = await open(browser, 'file://' + sheet);
  for (const name of names) {
    await holds(`${name} is small enough`, () => {
      const size = fs.statSync(path.join(folder, 'live', name + '.js')).size;
      return size > 100000 ? `${size} bytes` : '';
    });
    await holds(`${name} begins, moves, stops and steps by keyboard`, () => plays(page, name));
    await holds(`the address of ${name} leads to the same run`, async () => {
      // The hard ones are a record of the article's clock in which there was a collision,
      // for it ends early, and a time that is less than the last one and a step, rounded.
      if (['clock', 'cradle', 'swing'].includes(name)) await page.evaluate(n => {
        const { run } = document.querySelector(n).liveFigure, step = run.value.every ?? run.value.dt;
        for (let early = false, i = 0; i < 300 && !early; ++i) {
          const due = run.time + step;
          document.querySelectorAll(n + ' .live-bar button')[1].click();
          early = run.time < due;
        }
      }, figure(name));
      return leads(browser, page, name);
    });
  }
  await holds('a picture of 1000 disks is worked out in a sixtieth of a second', async () => {
    await show(page, 'gas');
    await press(page, 'gas', 'Play');
    await page.waitForFunction(n => document.querySelector(n).liveFigure.costs.length > 60, figure('gas'), { timeout: 20000 });
    await press(page, 'gas', 'Pause');
    const costs = await page.evaluate(n => document.querySelector(n).liveFigure.costs.sort((a, b) => a - b), figure('gas'));
    const half = costs[costs.length >> 1];
    return half > 1000 / 60 ? `it takes ${half} ms` : '';
  });
  await holds('what does not fit is refused, and the run stays as it was', async () => {
    const packing = page.locator(figure('gas') + ' input[type=range]');
    await page.locator(figure('gas') + ' .live-fields select').first().selectOption('10');
    await packing.fill('0.65');
    const { value, text } = await page.evaluate(n => ({ value: document.querySelector(n).liveFigure.run.value.packing,
      text: document.querySelector(n + ' .live-numbers').textContent }), figure('gas'));
    return value === 0.2 && /do not go together/.test(text) ? '' : `they fill ${value}: ${text}`;
  });
  for (const test of bytes.tests())
    await holds(`${test.figure}, ${test.what}: the bytes of the terminal`, () => bytes.differs(page, test));
  await holds('a figure runs while it is in view, and only then', () => inView(browser));
  await holds('without WebAssembly nothing is added', () => withoutWasm(browser));
  await player(browser);
  const scenes = fs.readdirSync(path.join(folder, 'live')).filter(f => /^play-/.test(f)).map(f => f.slice(0, -3));
  for (const name of scenes) await holds(`${name} opens the player with its scene`, () => opens(browser, name));
  for (const [scene, method, steps, y] of [['figure-eight', 'leapfrog', 1500, 'energy'], ['cradle', 'leapfrog', 2600, ''],
    ['membrane', 'yoshida6', 300, 'z:30,parts'], ['solar-system', 'radau15', 200, 'distance:0:3']])
    await holds(`${scene} by ${method}: the player saves the bytes that step writes`, () =>
      saves(browser, scene, method, steps, y));
  await holds('nothing went wrong on the console', () => said.join('; '));
  await browser.close();
})();
