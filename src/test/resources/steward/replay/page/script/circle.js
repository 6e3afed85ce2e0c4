import './circle.js';
