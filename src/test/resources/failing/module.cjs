// says: SyntaxError: Cannot use import statement outside a module
import fs from 'fs';
console.log(1);
