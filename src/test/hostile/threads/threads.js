// Answers each number by what a worker thread computes; a timer goes all the time, and a signal is caught.
const { Worker } = require('worker_threads');
const readline = require('readline');

const worker = new Worker(`
    const { parentPort } = require('worker_threads');
    parentPort.on('message', seed => {
        let value = seed;
        for (let k = 0; k < 100000; k++) value = (Math.imul(value, 1103515245) + 12345) & 0x7fffffff;
        parentPort.postMessage(value);
    });`, { eval: true });
let ticks = 0;
setInterval(() => { ticks++; }, 3);
process.on('SIGCONT', () => { ticks++; });
worker.on('message', value => process.stdout.write(value + '\n'));
readline.createInterface({ input: process.stdin }).on('line', line => worker.postMessage(Number(line)))
    .on('close', () => process.exit(0));
