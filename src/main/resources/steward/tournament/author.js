// Opens the replay of a game that is in this page: the page of a match, put together here, at the moment of the link.
(() => {
  'use strict';
  const data = JSON.parse(document.getElementById('data').textContent);
  const escape = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
  window.steward = {};
  document.addEventListener('click', event => {
    const link = event.target.closest('[data-game]');
    if (!link) return;
    event.preventDefault();
    const [replay, details] = data.replays[link.dataset.game];
    const page = data.shell.before.replaceAll('{{title}}', escape(link.dataset.title)) + replay
      + data.shell.after.replace('{{details}}', details);
    const address = URL.createObjectURL(new Blob([page], { type: 'text/html' })) + link.hash;
    window.steward.opened = address;
    window.open(address, '_blank');
  });
})();
