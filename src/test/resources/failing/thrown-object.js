// says: { a: 1 }
throw {a:1};
