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

const piston = {
  figure: 'piston', what: '5000 collisions round a piston', count: 1,
  command: bin + 'bonkers --preset adiabatic --seed 2 --collisions 5000 -o -',
  native: ([row]) => [row[0], ...second(row)],
  numbers: [5, 401, 1200, 2], until: 1e9, events: 5000, seen: 9 + 2 * 403, page: a => [a[0], ...a.slice(9, 9 + 403)],
};

const depletion = {
  figure: 'depletion', what: '110 sweeps of two large disks and 72 small ones', count: 1,
  command: bin + 'sample --method markov --disks 2 --radius 1 --box 5,5 --boundary periodic --small 0.2,72 ' +
    '--measure states --step 0.3 --samples 100', // and 10 before them
  native: ([row]) => row.slice(1),
  numbers: [72, 0.2, 0.3, 1], until: 1e9, events: 110 * 74, seen: 10 + 2 * 74, page: a => a.slice(10),
};

// The cradle: what the scene says goes to bonkers as lists, and to step.
const scene = bin + 'scene cradle --balls 5 --left 2 --gap 0.01 --dt 0.002';
const words = (head, from, to) => output(scene).filter(line => line.startsWith(head))
  .map(line => line.split(' ').slice(from, to).join(',')).join(',');
const cradle = (what, command, native, at) => ({
  figure: 'cradle', what, command, native, count: 1,
  numbers: [5, 2, 0.01, 0.002, 0, 10000, 0.0005], until: 1e9, events: 1000, seen: 2 + 3 * 12,
  page: a => a.slice(2 + 12 * at + 2, 2 + 12 * at + 12),
});
const cradles = () => {
  const box = words('box', 1, 3);
  const places = row => [...[0, 1, 2, 3, 4].map(i => row[1 + 6 * i]), ...[0, 1, 2, 3, 4].map(i => row[4 + 6 * i])];
  return [
    cradle('a cradle by events', `${bin}bonkers --masses 1,1,1,1,1 --positions=${words('pos', 2, 3)} ` +
      `--velocities=${words('vel', 2, 3)} --radii ${words('pos', 7, 8)} --walls=${box} --until 2 -o -`,
      ([row]) => [4, 6, 8, 10, 12].map(k => row[k]).concat([5, 7, 9, 11, 13].map(k => row[k])), 0),
    cradle('a cradle by steps', `${scene} | ${bin}step - --until 2`, ([row]) => places(row), 1),
    cradle('a cradle by springs', `${scene} | sed 's/^contact$/&\\nlinear 10000 0/; s/^dt .*/dt 0.0005/' | ` +
      `${bin}step - --until 2`, ([row]) => places(row), 2),
  ];
};

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
  piston,
  disks,
  depletion,
  gas('a thousand disks', 1000, 1, '--packing 0.2 --seed 3', 0.2, 3, 0),
  gas('ten in a periodic box', 10, 50, '--packing 0.1 --boundary periodic --seed 2', 0.1, 2, 1),
  ...output(bin + 'step-studies --study methods').filter(line => !/ellipses|its error/.test(line))
    .map(line => swing(line.split(' ')[0])),
  ...cradles(),
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
