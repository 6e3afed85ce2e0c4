// says: TypeError: rejected x
async function f(){ throw new TypeError("rejected x"); } f();
