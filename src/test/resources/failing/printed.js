// says: Error: caught
console.error("no Error"); try { throw new Error("caught"); } catch (e) { console.error(e); process.exitCode = 1; }
