// says: Error: first line
throw new Error("first line\nsecond line");
