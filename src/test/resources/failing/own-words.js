// says: gave up
console.error("no Error"); console.error("gave up"); process.exitCode = 1;
