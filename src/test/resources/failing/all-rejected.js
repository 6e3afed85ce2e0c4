// says: [AggregateError: All promises were rejected] {
Promise.any([Promise.reject(new Error("a")),Promise.reject(new Error("b"))]);
