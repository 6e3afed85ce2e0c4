const crypto = require('crypto'), fs = require('fs'), util = require('util');
const kind = process.argv[2], wall = () => performance.now();
const cpu = () => { const used = process.cpuUsage(); return (used.user + used.system) / 1000; };
let sink = [], first = true;

function burn(ms, clock, step) {
  for (const end = clock() + ms; clock() < end; step()) { continue; }
}
const compute = () => { for (let k = 0; k < 5000; k++) { sink.length = k % 7; } };

async function turn() {
  if (kind === 'clock') {
    burn(45, wall, compute);
  } else if (kind === 'work') {
    burn(45, cpu, compute);
  } else if (kind === 'sleep') {
    await new Promise(done => setTimeout(done, 45));
  } else if (kind === 'read') {
    sink = fs.readFileSync('big.txt', 'utf8').split('7');
  } else if (kind === 'start' && first) {
    await new Promise(done => setTimeout(done, 300));
    burn(300, cpu, compute);
  } else if (kind === 'threads') {
    const hash = util.promisify(crypto.pbkdf2);
    await Promise.all([1, 2, 3, 4].map(() => hash('a', 'b', 5000, 32, 'sha512')));
  } else if (kind === 'garbage') {
    burn(30, cpu, () => { sink = Array.from({ length: 500 }, k => ({ k })); });
  }
}

(async () => {
  for await (const line of require('readline').createInterface({ input: process.stdin })) {
    if (line.startsWith('{"type":"turn"')) {
      await turn();
      first = false;
      process.stdout.write('{"pods":[{"x":1,"y":1,"thrust":0}]}\n');
    }
  }
})();
