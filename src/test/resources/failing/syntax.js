// says: SyntaxError: Unexpected token '='
let x = 3;
let y = = 4;
