// says: ReferenceError: require is not defined in ES module scope, you can use import instead
const fs = require('fs');
