import { base } from './base.js';

export const right = base + 2;
