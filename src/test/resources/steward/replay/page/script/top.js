import { left } from './left.js';
import { right } from './right.js';

window.sum = left + right;
