// What the browser keeps for the program from one time to the next: its files of settings and answers, in localStorage.
// Where that is refused or full a bar says so as long as it is so, and the answers can be saved as a file. Other tabs of
// the page write the same files: whatever one of them has written, or this one has written over, is merged by the
// program. Loaded after net.js.
'use strict';

const kept = (() => {
  const $ = (id) => document.getElementById(id);
  const isAnswers = (path) => path.startsWith(net.answers_folder);

  const seen = new Map();  // path: the text in the storage that the program knows
  const put = (path, text) => {
    FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    FS.writeFile(path, text);
    seen.set(path, text);
  };

  const read = (path) => {
    try {
      return localStorage.getItem(net.kept + path);
    } catch {
      return null;  // no storage is allowed here
    }
  };

  const unmerged = [];  // [path, text] that other tabs have written
  let is_open = false;

  /// The program reads a text of another tab and adds what this tab has; where that is more, it writes.
  const take = (path, text) => {
    if (text === seen.get(path)) return;
    put(path, text);
    Module._page_read_again();
  };

  /// The program's folder before it starts.
  const restore = () => {
    try {
      for (const name of Object.keys(localStorage)) {
        const path = name.slice(net.kept.length);
        if (name.startsWith(net.kept + net.settings)) put(path, localStorage.getItem(name));
      }
    } catch {
      // No storage is allowed here: nothing is remembered, and the first write says so.
    }
  };

  // ---- What is not kept, and the bar that says so

  const saved = new Map();  // path: the text that the person has saved
  let is_full = false, since = '', is_hidden = false, is_silent = false, asks_before = false, has_asked = false;

  const unsaved = () => net.answers().filter(({path, text}) => net.unkept.has(path) && saved.get(path) !== text);

  const sentence = (lost) => {
    if (lost.length)
      return is_full
        ? net.say('The browser’s storage for this page is full: answers since {time} are in this page alone and are lost when it closes.', {time: since})
        : net.say('The browser lets this page keep nothing: answers since {time} are in this page alone and are lost when it closes.', {time: since});
    return is_full
      ? net.say('The browser’s storage for this page is full: theme, language and progress in lessons last until it closes.')
      : net.say('The browser lets this page keep nothing: theme, language and progress in lessons last until it closes.');
  };

  const show = () => {
    const lost = unsaved();
    if (!lost.length) since = '';
    const is_shown = lost.length > 0 || (!is_hidden && !is_silent && [...net.unkept.keys()].some((path) => !isAnswers(path)));
    $('bar').hidden = !is_shown;
    if (!is_shown) return;
    const save = () => {
      for (const answers of unsaved()) {
        net.saveAnswers(answers);
        saved.set(answers.path, answers.text);
      }
      show();
    };
    const hide = () => {
      is_hidden = true;
      show();
    };
    $('bar-text').textContent = sentence(lost);
    $('bar-buttons').replaceChildren(lost.length ? net.button(net.say('Save answers'), save) : net.button(net.say('Hide'), hide));
  };

  /// Asks before answers go that are nowhere else. From the first refusal on: a page that has nothing to ask must not
  /// listen, or browsers cannot bring it back as it was.
  const askBeforeItGoes = () => {
    if (asks_before) return;
    asks_before = true;
    window.addEventListener('beforeunload', (event) => {
      page.leave();
      if (!unsaved().length) return;
      event.preventDefault();
      event.returnValue = '';
    });
  };

  const write = (path, text) => {
    try {
      localStorage.setItem(net.kept + path, text);
      seen.set(path, text);
      net.unkept.delete(path);
    } catch (error) {
      is_full = error.name === 'QuotaExceededError' || error.name === 'NS_ERROR_DOM_QUOTA_REACHED';
      if (isAnswers(path)) since ||= new Date().toLocaleTimeString([], {hour: '2-digit', minute: '2-digit', hour12: false});
      askBeforeItGoes();
    }
  };

  /// What another tab has written meanwhile is merged first: a tab that ends between two writes has overwritten nothing.
  const flush = () => {
    for (const [path, own] of [...net.unkept]) {
      const other = read(path);
      if (other !== null && other !== own && other !== seen.get(path)) {
        if (net.hasEnded()) continue;  // nobody can merge: offered as a file instead
        net.unkept.delete(path);
        try {
          take(path, other);
        } finally {  // not merged where the program stops, or where these are the answers of a student who has left this tab
          if (!net.unkept.has(path)) net.unkept.set(path, own);
        }
      }
      write(path, net.unkept.get(path));
    }
    show();
  };

  /// One tab reads and writes at a time: under a lock, where the browser gives one within this time.
  const lock_wait_ms = 1000;
  const flushUnderLock = () => {
    if (!navigator.locks) return flush();
    navigator.locks.request(net.kept, {signal: AbortSignal.timeout(lock_wait_ms)}, flush).catch(flush);
  };

  const store = (path, text) => {
    net.unkept.set(path, text);
    flushUnderLock();
    if (!isAnswers(path) || has_asked) return;
    has_asked = true;
    navigator.storage?.persist?.().catch(() => {});  // else a browser may drop it when its disk is full
  };

  /// A file that the program has written; false: it is none of these.
  const keep = (path, bytes) => {
    if (!path.startsWith(net.settings)) return false;
    if (net.hasEnded()) return true;
    store(path, new TextDecoder().decode(bytes));
    // What the program could not read it has given another name, in its own folder alone.
    const [, folder, name] = /^(.*\/)([^/]*)$/.exec(path);
    for (const other of FS.readdir(folder))
      if (other.startsWith(name + '.unreadable') && !seen.has(folder + other)) store(folder + other, FS.readFile(folder + other, {encoding: 'utf8'}));
    return true;
  };

  // ---- Other tabs

  /// Each text of another tab, in the order in which they were written.
  const merge = () => {
    if (!is_open || net.hasEnded()) return;
    while (unmerged.length) take(...unmerged.shift());
  };

  window.addEventListener('storage', ({key, newValue}) => {
    if (!key?.startsWith(net.kept + net.settings) || newValue === null) return;
    unmerged.push([key.slice(net.kept.length), newValue]);
    if (unmerged.length === 1) setTimeout(merge);
  });

  /// The program has started: what other tabs wrote while it was loading is merged.
  const start = () => {
    is_open = true;
    merge();
  };

  /// The page may not come back: what is not kept yet is written now, without the lock.
  const leave = () => {
    merge();
    flush();
  };

  return {restore, keep, start, leave, beSilent: () => { is_silent = true; }};
})();
