// says: AssertionError [ERR_ASSERTION]: Expected values to be strictly equal:
require('assert').strictEqual(1,2);
