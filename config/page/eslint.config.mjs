// Rules of the page's modules: what is wrong, not what is ugly.
const names = ['window', 'document', 'location', 'history', 'navigator', 'localStorage', 'console', 'devicePixelRatio',
  'matchMedia', 'getComputedStyle', 'performance', 'requestAnimationFrame', 'cancelAnimationFrame', 'setTimeout',
  'clearTimeout', 'addEventListener', 'fetch', 'atob', 'Blob', 'Response', 'DecompressionStream', 'EventSource', 'URL',
  'Option', 'Event', 'ResizeObserver', 'MediaRecorder', 'Path2D', 'CSS', 'Intl', 'uPlot', 'File', 'self', 'parent',
  'TextDecoder'];

export default [{
  files: ['**/view/*.js', '**/league/*.js', '**/series/*.js', '**/beside/*.js', '**/tournament/author.js'],
  ignores: ['**/uPlot.js', '**/gifenc.js'],
  languageOptions: { ecmaVersion: 2022, sourceType: 'module', globals: Object.fromEntries(names.map(name => [name, 'readonly'])) },
  rules: {
    'no-undef': 'error', 'no-unused-vars': 'error', 'no-redeclare': 'error', 'no-shadow-restricted-names': 'error',
    'no-const-assign': 'error', 'no-dupe-keys': 'error', 'no-unreachable': 'error', 'no-self-assign': 'error',
    'no-import-assign': 'error', 'no-eval': 'error', 'no-implied-eval': 'error', eqeqeq: 'error', 'no-var': 'error',
    'prefer-const': 'error', 'max-len': ['error', { code: 165 }],
  },
}];
