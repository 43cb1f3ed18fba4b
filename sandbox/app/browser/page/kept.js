// Keeps the program's settings and answer files in localStorage between visits. While storage is refused or full, a bar
// says so, and the answers can be saved as a file. Several tabs write the same files. The program merges the text that
// another tab wrote with its own data, even if this tab has already overwritten that text in localStorage. Loaded after
// net.js.
'use strict';

const kept = (() => {
  const $ = (id) => document.getElementById(id);
  const isAnswers = (path) => path.startsWith(net.answers_folder);

  const seen = new Map();  // path: the stored text that the program has read or written
  const put = (path, text) => {
    FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    FS.writeFile(path, text);
    seen.set(path, text);
  };

  const read = (path) => {
    try {
      return localStorage.getItem(net.kept + path);
    } catch {
      return null;  // storage is not allowed here
    }
  };

  const unmerged = [];  // [path, text] written by other tabs
  let is_open = false;

  /// Makes the program read another tab's text and add its own; if that adds anything, the program writes the result.
  const take = (path, text) => {
    if (text === seen.get(path)) return;
    put(path, text);
    Module._page_read_again();
  };

  /// Restores the program's folder before it starts.
  const restore = () => {
    try {
      for (const name of Object.keys(localStorage)) {
        const path = name.slice(net.kept.length);
        if (name.startsWith(net.kept + net.settings)) put(path, localStorage.getItem(name));
      }
    } catch {
      // Storage is not allowed here: nothing is remembered, and the first write says so.
    }
  };

  // ---- Files that are not kept, and the bar that says so

  const saved = new Map();  // path: the text that the user has saved as a file
  let is_full = false, since = '', is_hidden = false, is_silent = false, asks_before = false, has_asked = false;

  const unsaved = () => net.answers().filter(({path, text}) => net.unkept.has(path) && saved.get(path) !== text);

  const sentence = (lost) => {
    if (lost.length)
      return is_full
        ? net.say('The browser’s storage for this page is full: answers since {time} exist only in this page and are lost when it closes.', {time: since})
        : net.say('The browser does not let this page save anything: answers since {time} exist only in this page and are lost when it closes.', {time: since});
    return is_full
      ? net.say('The browser’s storage for this page is full: theme, language and lesson progress last until it closes.')
      : net.say('The browser does not let this page save anything: theme, language and lesson progress last until it closes.');
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

  /// Asks for confirmation before the page closes and answers are lost. Listens only after the first refusal: with a
  /// beforeunload listener, browsers cannot restore the page unchanged when the user comes back.
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

  /// Merges another tab's text before overwriting it, so that nothing is lost even if this tab ends in between.
  const flush = () => {
    for (const [path, own] of [...net.unkept]) {
      const other = read(path);
      if (other !== null && other !== own && other !== seen.get(path)) {
        if (net.hasEnded()) continue;  // merging needs the program: the answers are offered as a file instead
        net.unkept.delete(path);
        try {
          take(path, other);
        } finally {  // if not merged, keep our own text: the program has stopped, or another student uses this tab
          if (!net.unkept.has(path)) net.unkept.set(path, own);
        }
      }
      write(path, net.unkept.get(path));
    }
    show();
  };

  /// Tabs take turns with a lock. A tab that has waited this long for the lock reads and writes without it.
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
    navigator.storage?.persist?.().catch(() => {});  // otherwise a browser may drop the storage when the disk is full
  };

  /// Keeps a file of settings or answers that the program has written. Returns false for any other file.
  const keep = (path, bytes) => {
    if (!path.startsWith(net.settings)) return false;
    if (net.hasEnded()) return true;
    store(path, new TextDecoder().decode(bytes));
    // The program renames a file that it cannot read, but only in its own file system: store the renamed file, too.
    const [, folder, name] = /^(.*\/)([^/]*)$/.exec(path);
    for (const other of FS.readdir(folder))
      if (other.startsWith(name + '.unreadable') && !seen.has(folder + other)) store(folder + other, FS.readFile(folder + other, {encoding: 'utf8'}));
    return true;
  };

  // ---- Other tabs

  /// Merges each text from other tabs, in the order they were written.
  const merge = () => {
    if (!is_open || net.hasEnded()) return;
    while (unmerged.length) take(...unmerged.shift());
  };

  window.addEventListener('storage', ({key, newValue}) => {
    if (!key?.startsWith(net.kept + net.settings) || newValue === null) return;
    unmerged.push([key.slice(net.kept.length), newValue]);
    if (unmerged.length === 1) setTimeout(merge);
  });

  /// Call when the program has started: merges the texts that other tabs wrote while it was loading.
  const start = () => {
    is_open = true;
    merge();
  };

  /// Writes all text that is not kept yet, without waiting for the lock, since the page may not come back.
  const leave = () => {
    merge();
    flush();
  };

  return {restore, keep, start, leave, beSilent: () => { is_silent = true; }};
})();
