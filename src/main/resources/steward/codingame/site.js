// Before a bot in JavaScript: the functions that CodinGame gives it. Then the bot runs as if Node.js had been called with
// it alone. Reading waits for a line; where there are no more, the program ends.
{
  const fs = require('fs');
  const buffer = Buffer.alloc(65536);
  let rest = Buffer.alloc(0);
  const more = () => {
    for (;;) {
      try {
        return fs.readSync(0, buffer, 0, buffer.length, null);
      } catch (problem) {
        if (problem.code !== 'EAGAIN') throw problem;           // the bot reads by process.stdin, too
        Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 1);
      }
    }
  };
  globalThis.readline = () => {
    let end = rest.indexOf(10);
    while (end < 0) {
      const count = more();
      if (count === 0) process.exit();
      const from = rest.length;
      rest = Buffer.concat([rest, buffer.subarray(0, count)]);
      end = rest.indexOf(10, from);
    }
    const line = rest.toString('utf8', 0, end);
    rest = rest.subarray(end + 1);
    return line.endsWith('\r') ? line.slice(0, -1) : line;
  };
  globalThis.print = console.log;
  globalThis.printErr = console.error;
  process.argv[1] = require('path').resolve(process.argv[1]);   // a plain name would be one of a module
  require('module').runMain();
}
