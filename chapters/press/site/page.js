// What a page does besides being read: light or dark, contents on a small screen,
// keys, search, copying of code. Without script all of the text is there.
(function () {
  'use strict';
  var root = document.documentElement;
  function get(id) { return document.getElementById(id); }

  // ---- light and dark: by the reader's system, or as chosen before.
  var theme = get('theme');
  var system = matchMedia('(prefers-color-scheme: dark)');
  function dark() {
    return root.dataset.theme ? root.dataset.theme === 'dark' : system.matches;
  }
  function named() {
    theme.textContent = dark() ? 'Light' : 'Dark';
    document.dispatchEvent(new CustomEvent('theme'));
  }
  function turn() {
    root.dataset.theme = dark() ? 'light' : 'dark';
    try { localStorage.setItem('bonkers-theme', root.dataset.theme); } catch (e) { /* not kept */ }
    named();
  }
  theme.addEventListener('click', turn);
  system.addEventListener('change', named);
  named();

  // ---- contents
  var menu = get('menu'), contents = get('contents');
  function small() { return getComputedStyle(menu).display !== 'none'; }
  function toggle(open) {
    contents.classList.toggle('open', open);
    menu.setAttribute('aria-expanded', String(open));
  }
  function to_contents() {
    if (small()) toggle(true);
    var at = contents.querySelector('[aria-current]') || contents.querySelector('a');
    at.focus();
  }
  menu.addEventListener('click', function () {
    toggle(!contents.classList.contains('open'));
  });
  contents.addEventListener('click', function (e) {
    if (e.target.closest('a') && small()) toggle(false);
  });
  var current = contents.querySelector('[aria-current]');
  if (current && !small() && current.offsetTop > contents.clientHeight - 80)
    contents.scrollTop = current.offsetTop - 120;

  // ---- code to be copied
  if (navigator.clipboard || document.execCommand)
    document.querySelectorAll('.chunk pre').forEach(function (pre) {
      var button = document.createElement('button');
      button.type = 'button';
      button.className = 'copy';
      button.textContent = 'Copy';
      button.addEventListener('click', function () {
        copy(pre.querySelector('code').textContent, function () {
          button.textContent = 'Copied';
          setTimeout(function () { button.textContent = 'Copy'; }, 1500);
        });
      });
      var name = pre.parentNode.querySelector('.name');
      button.setAttribute('aria-label', 'Copy this chunk');
      name.insertBefore(button, name.firstChild);
    });
  function copy(text, done) {
    if (navigator.clipboard && window.isSecureContext)
      navigator.clipboard.writeText(text).then(done, function () { by_hand(text, done); });
    else
      by_hand(text, done);
  }
  function by_hand(text, done) {
    var area = document.createElement('textarea');
    area.value = text;
    document.body.appendChild(area);
    area.select();
    if (document.execCommand('copy')) done();
    area.remove();
  }

  // ---- search: library and text are read when it is first opened.
  var dialog, input, results, said, index, sections;
  function load(name, then) {
    var script = document.createElement('script');
    script.src = name;
    script.onload = then;
    script.onerror = function () { said.textContent = name + ' is missing'; };
    document.head.appendChild(script);
  }
  /* Until the next frame a closed dialog keeps the focus, and with it the keys. */
  function shut() {
    dialog.close();
    if (dialog.contains(document.activeElement)) document.activeElement.blur();
  }
  function make() {
    dialog = document.createElement('dialog');
    dialog.id = 'search';
    dialog.setAttribute('aria-label', 'Search');
    dialog.innerHTML = '<form method="dialog"><input type="search" id="words" autocomplete="off"' +
      ' aria-label="Words to look for" placeholder="entropy, equal masses, slab ..."><button>Close</button></form>' +
      '<p id="said" role="status"></p><ol id="results"></ol>';
    document.body.appendChild(dialog);
    input = get('words'); results = get('results'); said = get('said');
    input.addEventListener('input', look);
    dialog.addEventListener('keydown', function (e) {
      var links = Array.prototype.slice.call(results.querySelectorAll('a'));
      var at = links.indexOf(document.activeElement);
      if (e.key === 'Escape') {
        e.preventDefault();
        shut();
      } else if (e.key === 'ArrowDown' && links.length) {
        links[Math.min(at + 1, links.length - 1)].focus();
        e.preventDefault();
      } else if (e.key === 'ArrowUp' && at >= 0) {
        (at > 0 ? links[at - 1] : input).focus();
        e.preventDefault();
      } else if (e.key === 'Enter' && document.activeElement === input) {
        e.preventDefault();
        if (links.length) links[0].click();
      }
    });
    results.addEventListener('click', function (e) {
      if (e.target.closest('a')) shut();
    });
    said.textContent = 'Reading the book ...';
    load('lunr.min.js', function () { load('search-data.js', read); });
  }
  function read() {
    sections = window.bonkers_sections;
    var lunr = window.lunr;
    index = lunr(function () {
      this.ref('i');
      this.field('title', { boost: 8 });
      this.field('text');
      for (var i = 0; i < sections.length; ++i)
        this.add({ i: i, title: sections[i][2], text: sections[i][3] },
          { boost: /^gloss/.test(sections[i][1]) ? 0.1 : 1 });
    });
    said.textContent = '';
    look();
  }
  function look() {
    if (!index) return;
    var typed = input.value.trim().toLowerCase();
    results.textContent = '';
    said.textContent = '';
    if (typed.length < 2) return;
    var words = typed.split(/[^a-z0-9_]+/).filter(Boolean);
    var lunr = window.lunr;
    // First what has all words, the last one perhaps not yet whole; if nothing has, what has some.
    var found = [];
    [lunr.Query.presence.REQUIRED, lunr.Query.presence.OPTIONAL].forEach(function (presence, some) {
      if (!found.length) found = index.query(function (q) {
        words.forEach(function (word, i) {
          var last = i === words.length - 1;
          q.term(lunr.tokenizer(word), last ? { boost: 10 } : { boost: some ? 10 : 1, presence: presence });
          if (last) q.term(word, { wildcard: lunr.Query.wildcard.TRAILING, usePipeline: false });
        });
      });
    });
    // Words that stand side by side count for more.
    var phrase = words.join(' ');
    found = found.slice(0, 200);
    if (words.length > 1)
      found.forEach(function (f) {
        var s = sections[f.ref];
        if (s[2].toLowerCase().indexOf(phrase) >= 0) f.score *= 6;
        else if (s[3].toLowerCase().indexOf(phrase) >= 0) f.score *= 3;
      });
    found.sort(function (a, b) { return b.score - a.score; });
    found.slice(0, 30).forEach(function (f) { results.appendChild(line(sections[f.ref], words)); });
    said.textContent = found.length === 0 ? 'Nothing found' : found.length === 1 ? 'One place' :
      (found.length >= 200 ? 'Many' : found.length) + ' places';
  }
  function line(s, words) {
    var item = document.createElement('li'), a = document.createElement('a'), text = document.createElement('span');
    a.href = s[0] + '.html#' + s[1];
    a.append(s[2]);
    text.className = 'in';
    var low = s[3].toLowerCase(), at = -1;
    at = low.indexOf(words.join(' '));
    words.forEach(function (w) { if (at < 0) at = low.indexOf(w); });
    var from = Math.max(0, at - 60);
    if (from > 0) from = s[3].indexOf(' ', from) + 1;
    var part = (from > 0 ? '… ' : '') + s[3].substr(from, 170) + ' …';
    var pattern = new RegExp('(' + words.join('|') + ')', 'gi'), last = 0, m;
    while ((m = pattern.exec(part)) && m[0]) {
      text.append(part.slice(last, m.index));
      var mark = document.createElement('mark');
      mark.textContent = m[0];
      text.append(mark);
      last = m.index + m[0].length;
    }
    text.append(part.slice(last));
    a.append(text);
    item.append(a);
    return item;
  }
  function search() {
    if (!dialog) make();
    dialog.showModal();
    input.select();
  }
  get('find').addEventListener('click', search);

  // ---- keys
  function go(rel) {
    var link = document.querySelector('.turn a[rel=' + rel + ']');
    if (link) location.href = link.href;
  }
  document.addEventListener('keydown', function (e) {
    if (e.ctrlKey || e.metaKey || e.altKey || e.defaultPrevented) return;
    if (e.target.closest('input, textarea, select, dialog, .live, [contenteditable]')) return;
    if (e.key === 'Escape' && contents.classList.contains('open')) {
      toggle(false);
      menu.focus();
    } else if (e.key === '/' || e.key === 's') {
      e.preventDefault();
      search();
    } else if (e.key === 'c') to_contents();
    else if (e.key === 't') turn();
    else if (e.target.closest('pre, .table, .formula')) return;
    else if (e.key === 'ArrowLeft') go('prev');
    else if (e.key === 'ArrowRight') go('next');
  });
})();
