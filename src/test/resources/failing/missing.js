// says: Error: Cannot find module './lib/none'
require('./lib/none');
