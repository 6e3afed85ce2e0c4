import './base.js';
const base = 2;
