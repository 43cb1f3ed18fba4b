// The sandbox embedded in a host page: the parts that its address requests, and the messages that it answers (README,
// "In your own page"). Every message is checked before it has any effect; the answer is the requested data, or one
// sentence that reports the error. Loaded after page.js.
'use strict';

const messages = (() => {
  const refuse = (sentence) => { throw new Error(sentence); };
  const quoted = (value) => {
    let text;
    try {
      text = JSON.stringify(value);
    } catch {
      // A cycle, or a number that JSON cannot represent.
    }
    text ??= String(value);
    return text.length > 60 ? text.slice(0, 60) + '…' : text;
  };
  const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);
  const fitting = (text) => {
    const trouble = page.textTrouble(text);
    return trouble ? refuse(trouble) : text;
  };
  const asJson = (name, value) => {
    let text;
    try {
      text = JSON.stringify(value);
    } catch {
      // Reported below.
    }
    return text === undefined ? refuse(`${name} must be a JSON value, got ${quoted(value)}`) : text;
  };

  // ---- Requests

  const picture = ({view = 'camera', size, samples}) => {
    if (typeof view !== 'string') refuse(`picture: view must be a string such as "camera", got ${quoted(view)}`);
    const isSide = (side) => Number.isInteger(side) && side >= 1;
    if (size !== undefined && !(Array.isArray(size) && size.length === 2 && size.every(isSide)))
      refuse(`picture: size must be two whole numbers of pixels such as [640, 360], got ${quoted(size)}`);
    if (samples !== undefined && !(Number.isInteger(samples) && samples >= 0))
      refuse(`picture: samples must be 0 or 4, got ${quoted(samples)}`);
    const file = page.ask('page_picture', view, ...(size ?? [0, 0]), samples ?? -1);
    return file.startsWith('/') ? 'data:image/png;base64,' + base64(FS.readFile(file)) : refuse(file);
  };
  const base64 = (bytes) => {
    let signs = '';
    for (let i = 0; i < bytes.length; i += 32768) signs += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(signs);
  };

  const things = {
    state: {give: () => JSON.parse(page.ask('page_state'))},
    matrices: {give: () => JSON.parse(page.ask('page_matrices'))},
    link: {give: () => page.ask('page_link')},
    rests: {give: () => Module._page_rests() === 1},
    picture: {give: picture, takes: ['view', 'size', 'samples']},
  };

  const set = (fields) => {
    const names = isObject(fields) ? Object.keys(fields) : [];
    if (!names.length) refuse(`set must be an object of fields such as {"camera.yaw": 30}, got ${quoted(fields)}`);
    for (const name of names) if (/[=\s]/.test(name)) refuse(`set: ${quoted(name)} is not the name of a field such as "camera.yaw"`);
    const lines = names.map((name) => name + '=' + asJson(`set: ${name}`, fields[name]));
    const trouble = page.ask('page_set', fitting(lines.join('\n')));
    return trouble ? refuse(trouble) : true;
  };

  let latest = 0;
  const open = async (what) => {
    const isText = typeof what === 'string';
    if (!isText && !isObject(what)) refuse(`open must be a preset's name, a link, or a state as an object, got ${quoted(what)}`);
    const trouble = page.ask('page_open', fitting(isText ? what : asJson('open', what)));
    if (trouble) refuse(trouble);
    for (const mine = ++latest;;) {
      const said = page.ask('page_open_answer');
      if (said) return said === 'opened' ? true : refuse(said);
      await new Promise((go_on) => setTimeout(go_on, 20));
      if (net.hasEnded()) refuse('open: the sandbox ended before it finished');
      if (mine !== latest) refuse('open: something else was opened before it finished');
    }
  };

  const get = (name, asked) => {
    if (!Object.hasOwn(things, name)) refuse(`get must be one of ${Object.keys(things).join(', ')}, got ${quoted(name)}`);
    return things[name].give(asked);
  };
  const actions = {set, open, get};

  const answer = async (asked) => {
    const named = Object.keys(actions).filter((name) => asked[name] !== undefined);
    if (named.length !== 1)
      refuse(`a message must have exactly one of ${Object.keys(actions).join(', ')}; this one has ${named.join(' and ') || 'none'}`);
    const [action] = named;
    const known = ['to', 'id', action, ...((action === 'get' && Object.hasOwn(things, asked.get) && things[asked.get].takes) || [])];
    const unknown = Object.keys(asked).find((name) => !known.includes(name));
    if (unknown) refuse(`${quoted(unknown)} is unknown beside ${action}; use ${known.join(', ')}`);
    return actions[action](asked[action], asked);
  };

  // ---- The address: #embed&big=camera&controls=light.position,projection.near&matrices=S&preset=orbit

  let is_arranging = false;

  /// Reports errors in the address, both in the sandbox and to the host page. Defaults replace the values in error.
  const tell = (troubles) => {
    if (!troubles.length) return;
    const sentence = 'In the address: ' + troubles.join('; ');
    page.report(sentence);
    net.tellHost({is: 'trouble', error: sentence});
  };

  const embed = (parts) => {
    Module._page_embed();
    kept.beSilent();
    const usual = {big: 'camera', controls: '', matrices: ''}, chosen = {}, rest = [], troubles = [];
    for (const part of parts) {
      const [name, ...values] = part.split('=');
      if (!Object.hasOwn(usual, name)) {
        rest.push(part);
        continue;
      }
      if (Object.hasOwn(chosen, name)) troubles.push(`${name} appears twice`);
      try {
        chosen[name] = decodeURIComponent(values.join('='));
      } catch {
        troubles.push(`${part} is cut off: % must be followed by two hexadecimal digits`);
      }
    }
    const list = (names) => JSON.stringify(names.split(',').filter((name) => name));
    const setting = (name, value) => `view.layout.${name}=${name === 'big' ? JSON.stringify(value) : list(value)}`;
    if (rest.length) page.open('#' + rest.join('&'));
    const arrange = () => {  // waits until the opened state is on screen
      if (net.hasEnded()) return;
      if (!Module._page_rests()) return setTimeout(arrange, 20);
      for (const [name, value] of Object.entries({...usual, ...chosen})) {
        const trouble = page.ask('page_set', setting(name, value));
        if (!trouble) continue;
        troubles.push(trouble);
        page.ask('page_set', setting(name, usual[name]));
      }
      tell(troubles);
      is_arranging = false;
    };
    is_arranging = true;
    arrange();
  };

  /// Tells the host page that it may send requests from now on: the state named in the address is on screen.
  const greet = () => {
    if (net.hasEnded()) return;
    if (is_arranging || !Module._page_rests()) return setTimeout(greet, 20);
    net.answerBy(answer);
    net.tellHost({is: 'ready'});
  };

  // ---- Keys that the sandbox does not use go to the host: as key events if it has the same origin, otherwise as
  // messages

  const handOn = (event) => {
    const {type, key, code, keyCode, ctrlKey, shiftKey, altKey, metaKey, repeat} = event;
    const pressed = {key, code, keyCode, ctrlKey, shiftKey, altKey, metaKey, repeat, bubbles: true, cancelable: true};
    let frame = null;
    try {
      frame = window.frameElement;
    } catch {
      // Another origin.
    }
    if (!frame) return net.tellHost({is: 'key', type, event: pressed});
    const goes_on = frame.dispatchEvent(new window.parent.KeyboardEvent(type, pressed));
    if (!goes_on) event.preventDefault();
  };

  return {embed, greet, handOn};
})();
