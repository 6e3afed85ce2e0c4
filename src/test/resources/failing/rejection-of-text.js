// says: UnhandledPromiseRejection: The promise rejected with the reason "just text".
Promise.reject("just text");
