import { base } from './base.js';

export const left = base + 1;
