'use strict';
/* The pages in a browser: each of them at two widths, light and dark; kinds of
   pages for those who see or use them otherwise; search; the keys.
     node tests/site/browser/pages.js FOLDER
   Prints ok and not ok lines, and how many. */
const fs = require('fs');
const path = require('path');
const { pathToFileURL } = require('url');
const { chromium } = require('playwright-core');
const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const folder = path.resolve(process.argv[2]);
const names = fs.readdirSync(folder).filter(f => f.endsWith('.html')).sort()
  .concat('src/index.html', 'src/line-piston.c.html');
const address = name => pathToFileURL(path.join(folder, name)).href;
let lines = 0;
async function holds(what, check) {
  let wrong;
  try { wrong = await check(); } catch (error) { wrong = error.message.split('\n')[0]; }
  console.log(wrong ? `not ok pages: ${what} - ${wrong}` : `ok pages: ${what}`);
  ++lines;
}
const wait = (page, check, arg) => page.waitForFunction(check, arg, { timeout: 10000 });

(async () => {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage'] });
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  const page = await context.newPage();
  const said = [];
  page.on('console', m => { if (m.type() === 'error') said.push(m.text()); });
  page.on('pageerror', e => said.push(e.message));
  page.on('request', r => { if (!/^(file|data|blob):/.test(r.url())) said.push('asks for ' + r.url()); });
  page.on('requestfailed', r => said.push('does not get ' + r.url()));

  // ---- every page: no error, nothing wider than the window, at both widths and in
  // both lights. Figures are not looked at, but have their places.
  await context.route(/figures\/.*\.svg$/, r => r.fulfill({ contentType: 'image/svg+xml',
    body: '<svg xmlns="http://www.w3.org/2000/svg" width="5" height="5"/>' }));
  const wide = () => {
    const w = document.documentElement;
    if (w.scrollWidth <= w.clientWidth) return '';
    let worst = null;
    for (const e of document.querySelectorAll('body *')) {
      const r = e.getBoundingClientRect();
      if (r.right > w.clientWidth + 1 && (!worst || r.right > worst.right)) worst = { right: r.right, e };
    }
    return `${w.scrollWidth} of ${w.clientWidth}` +
      (worst ? `, ${worst.e.tagName} ${worst.e.className} ${worst.e.textContent.slice(0, 40)}` : '');
  };
  for (const name of names)
    await holds(name, async () => {
      said.length = 0;
      await page.setViewportSize({ width: 1280, height: 900 });
      await page.emulateMedia({ colorScheme: 'light' });
      await page.goto(address(name));
      const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const light = await paper();
      let over = await page.evaluate(wide);
      await page.emulateMedia({ colorScheme: 'dark' });
      if (await paper() === light) return 'dark is as light';
      await page.setViewportSize({ width: 390, height: 844 });
      over = over || await page.evaluate(wide);
      await page.emulateMedia({ colorScheme: 'light' });
      if (over) return 'wider than the window: ' + over;
      return said.join('; ');
    });
  await holds('and one that is wider would be seen', async () => {
    await page.evaluate(() => {
      const e = document.createElement('p');
      e.style.width = '500px';
      e.textContent = 'wide';
      document.querySelector('main').append(e);
    });
    return (await page.evaluate(wide)) ? '' : 'it was not';
  });
  await holds('and one that throws', async () => {
    said.length = 0;
    await page.evaluate(() => new Promise(done => {
      setTimeout(() => { setTimeout(done); throw new Error('planted'); });
    }));
    return said.length === 1 ? '' : 'it was not';
  });

  // ---- the measure: characters in a line of text, where the window has room.
  await holds('a line has 60 to 75 characters', async () => {
    await page.setViewportSize({ width: 1280, height: 900 });
    await page.goto(address('00-preface.html'));
    const mean = await page.evaluate(() => {
      let characters = 0, lines = 0;
      for (const p of document.querySelectorAll('main > p')) {
        const range = document.createRange();
        range.selectNodeContents(p);
        const tops = new Set(Array.from(range.getClientRects(), r => Math.round(r.top / 8)));
        if (tops.size < 3) continue;
        characters += p.textContent.length * (tops.size - 0.5) / tops.size;
        lines += tops.size - 0.5;
      }
      return characters / lines;
    });
    return mean >= 60 && mean <= 75 ? '' : `${mean.toFixed(1)} in the mean`;
  });

  // ---- axe, on a page of every kind, in both lights; a small window once.
  const kinds = ['index.html', '00-before.html', '05-disks.html', 'C-symbols.html', 'D-glossary.html', 'references.html',
    'terms.html', 'src/index.html', 'src/line-piston.c.html'].filter(n => names.includes(n));
  const judged = async what => {
    await page.evaluate(axe);
    const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
    return found.violations.map(v => `${v.id}: ${v.nodes.length}, as ${v.nodes[0].html.slice(0, 100)}`).join('; ');
  };
  for (const name of kinds)
    for (const scheme of ['light', 'dark'])
      await holds(`axe finds nothing in ${name}, ${scheme}`, async () => {
        await page.emulateMedia({ colorScheme: scheme });
        await page.setViewportSize(scheme === 'light' ? { width: 1280, height: 900 } : { width: 390, height: 844 });
        await page.goto(address(name));
        return judged();
      });
  await holds('and a picture without a text would be found', async () => {
    await page.evaluate(() => document.querySelector('main').append(document.createElement('img')));
    return /image-alt/.test(await judged()) ? '' : 'it was not';
  });
  await page.emulateMedia({ colorScheme: 'light' });
  await page.setViewportSize({ width: 1280, height: 900 });

  // ---- search, as one types; where it lands.
  const looked = async (words, wanted) => {
    said.length = 0;
    await page.goto(address('index.html'));
    await page.keyboard.press('/');
    const began = Date.now();
    await page.keyboard.type(words);
    await wait(page, () => document.querySelector('#results a'));
    const first = await page.evaluate(() => document.querySelector('#results a').getAttribute('href'));
    const took = Date.now() - began;
    await page.keyboard.press('Enter');
    await wait(page, () => !document.querySelector('dialog[open]') && location.hash && document.readyState === 'complete');
    const hash = await page.evaluate(() => decodeURIComponent(location.hash.slice(1)));
    const seen = await page.evaluate(h => {
      const r = document.getElementById(h).getBoundingClientRect();
      return r.top >= 0 && r.top < innerHeight;
    }, hash);
    if (said.length) return said.join('; ');
    if (!wanted.test(first)) return `the first is ${first}`;
    if (!seen) return `${hash} is not in view`;
    return took > 20000 ? `it took ${took} ms` : '';
  };
  for (const [words, wanted] of [['entropy', /#sec:entropy$/], ['equal masses', /#sec:(equal|special)/], ['slab', /^02-bonkers.*#sec:slab$/]])
    await holds(`search finds "${words}" in its section`, () => looked(words, wanted));
  await holds('and says when there is nothing', async () => {
    await page.keyboard.press('/');
    await page.fill('#words', 'xyzzyq');
    await wait(page, () => document.getElementById('said').textContent === 'Nothing found');
    await page.keyboard.press('Escape');
    return (await page.locator('dialog[open]').count()) ? 'it stays open' : '';
  });
  await holds('a closed search leaves the keys to the page at once', () => page.evaluate(() => {
    const press = key => document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
    for (const [key, wanted] of [['/', 1], ['Escape', 0], ['/', 1], ['Escape', 0]]) {
      press(key);
      const open = document.querySelectorAll('dialog[open]').length;
      if (open !== wanted) return `${key}: ${open} open, not ${wanted}`;
    }
    return '';
  }));
  await holds('axe finds nothing in the search', async () => {
    await page.keyboard.press('/');
    await page.fill('#words', 'entropy');
    await wait(page, () => document.querySelector('#results a'));
    const wrong = await judged();
    await page.keyboard.press('Escape');
    return wrong;
  });

  // ---- keys
  await holds('next and previous', async () => {
    await page.goto(address('04-piston.html'));
    await page.keyboard.press('ArrowRight');
    await page.waitForURL(/05-disks/);
    await page.keyboard.press('ArrowLeft');
    await page.waitForURL(/04-piston/);
  });
  await holds('the first Tab skips to the text', async () => {
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    return await page.evaluate(() => document.activeElement.id) === 'text' ? '' : 'it does not';
  });
  await holds('contents, in a wide window and in a small one', async () => {
    await page.keyboard.press('c');
    if (!await page.evaluate(() => document.activeElement.matches('#contents [aria-current]'))) return 'not in the wide one';
    await page.setViewportSize({ width: 390, height: 844 });
    if (await page.locator('#contents').isVisible()) return 'they are open';
    await page.keyboard.press('c');
    if (!await page.locator('#contents').isVisible()) return 'they do not open';
    await page.keyboard.press('Escape');
    if (await page.locator('#contents').isVisible()) return 'they do not close';
    return await page.evaluate(() => document.activeElement.id) === 'menu' ? '' : 'the focus is lost';
  });
  await holds('dark and light, remembered', async () => {
    const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
    await page.keyboard.press('t');
    if (await theme() !== 'dark') return 'not dark';
    await page.goto(address('05-disks.html'));
    if (await theme() !== 'dark') return 'forgotten';
    await page.locator('#theme').focus();
    await page.keyboard.press('Enter');
    return await theme() === 'light' ? '' : 'not light';
  });
  await holds('all that can be used has a focus that is seen', async () => {
    await page.setViewportSize({ width: 1280, height: 900 });
    for (let i = 0; i < 12; ++i) {
      await page.keyboard.press('Tab');
      const seen = await page.evaluate(() => {
        const s = getComputedStyle(document.activeElement);
        return s.outlineStyle !== 'none' && parseFloat(s.outlineWidth) >= 2;
      });
      if (!seen) return 'not ' + await page.evaluate(() => document.activeElement.outerHTML.slice(0, 80));
    }
  });
  await holds('code is copied', async () => {
    await page.evaluate(() => { document.execCommand = () => { window.copied = document.activeElement.value; return true; };
      Object.defineProperty(navigator, 'clipboard', { value: undefined }); });
    await page.locator('.copy').first().click();
    const same = await page.evaluate(() => window.copied === document.querySelector('.chunk pre code').textContent &&
      window.copied.length > 40);
    return same ? '' : 'something else is';
  });
  await holds('without script the text is there, and the contents', async () => {
    const plain = await browser.newContext({ javaScriptEnabled: false, viewport: { width: 1280, height: 900 } });
    const still = await plain.newPage();
    await still.goto(address('05-disks.html'));
    const there = await still.locator('#contents').isVisible() && await still.locator('main math').first().isVisible();
    await plain.close();
    return there ? '' : 'they are not';
  });
  await browser.close();
  console.log(`1..${lines}`);
  console.log(`# ${names.length} pages`);
})().catch(error => { console.log(`not ok pages: the browser - ${error.message.split('\n')[0]}`); process.exit(1); });
