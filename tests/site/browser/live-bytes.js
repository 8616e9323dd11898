'use strict';
/* What a figure computes in the page is what a program computes in the
   terminal, to the last bit. A test gives a command and how its last rows are
   read; the numbers with which the figure begins, how far it runs, and how what
   is seen then is read. */
const { execSync } = require('child_process');

const output = command => execSync(command, { encoding: 'utf8', maxBuffer: 1 << 28,
  stdio: ['ignore', 'pipe', 'ignore'] })
  .split('\n').filter(line => line && line[0] !== '#');
const rows = (command, count) => output(command).slice(-count)
  .map(line => line.trim().split(/\s+/).map(Number));
const second = row => row.filter((_, i) => i >= 2 && i % 2 === 0); // x of t, E, x, v, x, v
const bin = 'build/bin/';

function beads(what, options, ...numbers) {
  return { figure: 'beads', what, command: `${bin}bonkers ${options} --collisions 1000`, count: 1,
    native: ([row]) => [row[0], ...second(row)],
    numbers, until: 1e9, events: 1000, seen: 60, page: a => [a[0], ...a.slice(4, 4 + a[3])] };
}

const disks = {
  figure: 'clock', what: 'four disks by our clock', count: 4,
  command: bin + 'disks --disks 4 --start lattice --warmup 0 --until 200 --every 200',
  native: all => all.flatMap(row => [row[4], row[5]]),
  numbers: [0, 0.125, 1], until: 200, events: 1e15, seen: 15, page: a => a.slice(7, 15),
};

const histogram = {
  figure: 'histogram', what: '1000 samples of ten beads', count: 1,
  command: bin + 'bonkers --preset thermal --seed 3 --every 0.24 --samples 1000 -o -',
  native: ([row]) => [row[0], ...second(row)],
  numbers: [4, 0, 0.24, 3], until: 1e9, events: 1000, seen: 140, page: a => [a[0], ...a.slice(128)],
};

const gas = (what, count, until, options, ...numbers) => ({
  figure: 'gas', what, count,
  command: `${bin}disks --disks ${count} --box 7.5,5 --start lattice --warmup 0 --until ${until} --every ${until} ${options}`,
  native: all => all.flatMap(row => [row[4], row[5]]),
  numbers: [count, ...numbers], until, events: 1e15, seen: 69 + 3 * count,
  page: a => a.slice(69).filter((_, i) => i % 3 < 2),
});

const swing = method => ({
  figure: 'swing', what: `1000 steps of ${method}`, count: 1,
  command: `${bin}scene oscillator --damping 0 | ${bin}step - --method ${method} --dt 0.05 --until 50 --every 50 --bound 100`,
  native: ([row]) => [row[7] - 4, row[10]],
  numbers: [0.05, 0, method, method], until: 1e9, events: 1000, seen: 17, page: a => [a[9], a[10]],
});

exports.tests = () => [
  beads('the wave of figure 2.1', '--masses 9.3,2.1,5.2,0.9,3.4,1.2,4.3,0.8,2.6,1.4 --positions ' +
    '0.5,4.6,5.3,6.2,6.9,7.8,8.5,9.4,10.2,11.1 --velocities 2,0,0,0,0,0,0,0,0,0 --walls 0,12', 9, 1, 0),
  beads('ten beads at random', '--preset random --seed 7', 7, 7, 0),
  histogram,
  disks,
  gas('a thousand disks', 1000, 1, '--packing 0.2 --seed 3', 0.2, 3, 0),
  gas('ten in a periodic box', 10, 50, '--packing 0.1 --boundary periodic --seed 2', 0.1, 2, 1),
  ...output(bin + 'step-studies --study methods').filter(line => !/ellipses|its error/.test(line))
    .map(line => swing(line.split(' ')[0])),
];

// Runs a test in a page that has the figure. Returns what is wrong, or ''.
exports.differs = async (page, test) => {
  const expected = test.native(rows(test.command, test.count));
  const seen = await page.evaluate(async t => {
    const c = await live.open(t.figure), names = [];
    for (let k = 0, name; c.exports.page_word && (name = c.word(k)); ++k) names.push(name);
    if (!c.begin(...t.numbers.map(n => typeof n === 'string' ? names.indexOf(n) : n))) return [];
    c.run(t.until, t.events);
    return Array.from(c.look(t.seen));
  }, { ...test, native: undefined, page: undefined });
  const found = test.page(seen);
  const wrong = expected.findIndex((x, i) => !Object.is(x, found[i]));
  return expected.length === 0 ? 'the program wrote nothing' : wrong < 0 ? ''
    : `number ${wrong + 1} of ${expected.length} is ${found[wrong]} in the page, ${expected[wrong]} in the terminal`;
};
