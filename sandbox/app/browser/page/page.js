// The page around the program: passes events, time and sizes to the functions of app/browser/page.cpp, and does what
// only a page can do: files, clipboard, address, full screen, suspending. Loaded after net.js and kept.js, and before
// the program's own script, whose names (Module, FS, stackSave, wasmTable, page_pause) are global.
'use strict';

const page = (() => {
  const $ = (id) => document.getElementById(id);
  const canvas = $('view'), typed = $('typed');
  const is_framed = window.parent !== window;

  // ---- Calls that pass texts. The texts go on the program's heap, since its stack is small. The size of a text from
  // outside is checked first

  const put_down = (text) => {
    const size = lengthBytesUTF8(text) + 1, place = Module._malloc(size);
    if (!place) throw new RangeError('out of memory');
    stringToUTF8(text, place, size);
    return place;
  };
  const call = (name, ...values) => {
    const places = [];
    try {
      return Module['_' + name](...values.map((value) => {
        if (typeof value !== 'string') return value;
        places.push(put_down(value));
        return places[places.length - 1];
      }));
    } finally {
      if (!net.hasEnded()) places.forEach(Module._free);
    }
  };
  const ask = (name, ...values) => UTF8ToString(call(name, ...values));
  const report = (sentence) => call('page_report', sentence);
  /// Returns why a text is rejected; '' if it is accepted.
  const textTrouble = (text) => ask('page_text_trouble', lengthBytesUTF8(text));
  const takes = (text) => {
    const trouble = textTrouble(text);
    if (trouble) report(trouble);
    return !trouble;
  };

  // ---- Frames: drawn after an event, or when the program asks for one

  let is_open = false, frame_asked = 0, timer = 0;
  const scale = () => window.devicePixelRatio || 1;

  const fit = () => {
    const width = Math.max(1, Math.round(canvas.clientWidth * scale()));
    const height = Math.max(1, Math.round(canvas.clientHeight * scale()));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  };

  /// Calls `changed` when the number of pixels per CSS pixel changes, because of another screen or the page's zoom.
  const watchScale = (changed) =>
    matchMedia(`(resolution: ${scale()}dppx)`).addEventListener('change', () => {
      changed();
      watchScale(changed);
    }, {once: true});

  const draw = () => {
    frame_asked = 0;
    if (!is_open || net.hasEnded() || document.hidden) return;
    fit();
    const next_s = Module._page_frame(canvas.width, canvas.height, scale());
    follow();
    if (next_s === 0) wake();
    else if (next_s > 0) timer = setTimeout(wake, 1000 * next_s);
  };

  const wake = () => {
    clearTimeout(timer);
    timer = 0;
    if (!frame_asked && !net.hasEnded()) frame_asked = requestAnimationFrame(draw);
  };

  /// Requests a frame, as an event would.
  const again = () => {
    Module._page_event();
    wake();
  };

  /// Saves now, since the page is hidden and may never return, so the next frame may never come.
  const leave = () => {
    if (!is_open || net.hasEnded()) return;
    const most_frames = 8;
    for (let i = 0; i < most_frames && Module._page_frame(canvas.width, canvas.height, scale()) === 0; ++i);
    Module._page_keep();
    kept.leave();
  };

  // ---- The program's state outside the picture

  let cursor = '', opened = '', said = '', rest_timer = 0, rest_by_ms = 0, is_embedded = false, known = location.hash;

  const follow = () => {
    const shape = UTF8ToString(Module._page_cursor());
    if (shape !== cursor) canvas.style.cursor = cursor = shape;
    const wants_text = Module._page_wants_text() !== 0;
    const may_focus = !is_framed || document.hasFocus();  // a frame never takes the keyboard from the host page
    if (may_focus && wants_text !== (document.activeElement === typed)) (wants_text ? typed : canvas).focus({preventScroll: true});
    const now = ask('page_opened');
    if (now !== said && !is_embedded) {  // unchanged while the state that the address names is still loading
      said = now;
      const is_state = now === '' && opened.startsWith('#1');  // nothing but the opened link names this state
      if (now !== opened && !is_state) enter(now);
    }
    const now_ms = performance.now();
    if (!rest_timer) rest_by_ms = now_ms + 3000;  // update now and then during motion, too
    if (now_ms > rest_by_ms) return;
    clearTimeout(rest_timer);
    rest_timer = setTimeout(rest, 500);
  };

  /// In the browser's history, a lesson's next step replaces the previous one, so that Back leaves the lesson.
  const enter = (now) => {
    const is_same_lesson = now.startsWith('#lesson=') && opened.split('&')[0] === now.split('&')[0];
    opened = now;
    if (location.hash !== now) write(is_same_lesson ? 'replaceState' : 'pushState', now);
  };

  /// An address that the user has just typed arrives later, as an event; until then, do not overwrite it.
  const write = (how, fragment) => {
    if (location.hash !== known) return;
    history[how](null, '', fragment || location.pathname + location.search);
    known = location.hash;
  };

  const show = (id, words) => {
    if ($(id).textContent !== words) $(id).textContent = words;
  };

  /// Called when nothing has been drawn for a while: updates the text for screen readers and the address.
  const rest = () => {
    rest_timer = 0;
    if (net.hasEnded()) return;
    document.documentElement.lang = ask('page_language');
    show('told', ask('page_told'));
    show('matrices', ask('page_matrices_text'));
    if (!is_embedded) keepState();
  };

  /// At rest, the address names the state shown, so that a reload or a copied address restores it.
  const keepState = () => {
    if (opened.startsWith('#lesson=')) return;
    const address = Module._page_departs() ? ask('page_link') : opened;
    if (address !== location.hash) write('replaceState', address);
  };

  // ---- Pointer: mouse, pen and one finger act as the mouse; two fingers pan by their center and zoom by their
  // distance

  const fingers = new Map();
  let pair = null;
  const slop = 8;  // CSS pixels that a resting finger may move
  let resting = null;  // where the only finger came down, and the timer of its long touch
  const restless = () => {
    if (resting) clearTimeout(resting.timer);
    resting = null;
  };
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const point = (event) => Module._page_pointer(...at(event), 1);
  const both = () => {
    const [[ax, ay], [bx, by]] = [...fingers.values()];
    return {x: (ax + bx) / 2, y: (ay + by) / 2, apart: Math.hypot(ax - bx, ay - by)};
  };

  const listenToPointer = () => {
    canvas.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType === 'touch') {
        fingers.set(event.pointerId, at(event));
        restless();
        if (fingers.size === 1) resting = {at: at(event), timer: setTimeout(() => Module._page_long_touch(), 600)};
        if (fingers.size === 2) {  // release what the first finger held
          Module._page_button(0, 0);
          pair = both();
          Module._page_pointer(pair.x, pair.y, 1);
          for (const button of [3, 1]) Module._page_button(button, 1);  // 3: these are fingers, so the drag pans
          return;
        }
        if (fingers.size > 2) return;
      }
      point(event);
      Module._page_button(event.button === 1 ? 2 : event.button === 2 ? 1 : event.button, 1);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!fingers.has(event.pointerId)) return point(event);
      const [x, y] = at(event);
      if (resting && Math.hypot(x - resting.at[0], y - resting.at[1]) < slop) return;
      restless();
      fingers.set(event.pointerId, at(event));
      if (!pair) return point(event);
      if (fingers.size !== 2) return;
      const now = both();
      Module._page_pointer(now.x, now.y, 1);
      const step = 20;  // change in the fingers' distance, in CSS pixels, that counts as one line of the wheel
      const lines = Math.trunc((now.apart - pair.apart) / step);
      if (lines !== 0) {
        Module._page_wheel(0, lines);
        pair.apart += lines * step;
      }
    });
    const up = (event) => {
      const rested = resting;
      restless();
      const was_finger = fingers.delete(event.pointerId);
      if (was_finger && pair) {
        if (fingers.size < 2) {
          for (const button of [1, 3]) Module._page_button(button, 0);
          if (fingers.size === 0) pair = null;
        }
      } else {
        if (event.type === 'pointerup' && !rested) point(event);
        Module._page_button(event.button === 1 ? 2 : event.button === 2 ? 1 : Math.max(event.button, 0), 0);
      }
      if (was_finger && fingers.size === 0) Module._page_pointer(0, 0, 0);
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener('pointerleave', (event) => {
      if (event.buttons === 0 && event.pointerType !== 'touch') Module._page_pointer(0, 0, 0);
    });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      if (is_embedded && !document.hasFocus()) return;  // scrolls the host page
      event.preventDefault();
      const lines = [1 / 100, 1 / 3, 1][event.deltaMode];  // pixels, lines, pages
      Module._page_wheel(-event.deltaX * lines, -event.deltaY * lines);
    }, {passive: false});
  };

  // ---- Keyboard. Typed text comes through the text field, which supports input methods and on-screen keyboards

  const is_paste = (event) => (event.ctrlKey || event.metaKey) && event.code === 'KeyV';
  const key = (event, is_down) =>
    call('page_key', event.code, event.key, is_down ? 1 : 0, event.ctrlKey || event.metaKey ? 1 : 0, event.shiftKey ? 1 : 0);
  const used = new Set();  // held keys that the sandbox uses
  const is_ours = () => !is_embedded || Module._page_wants_text() !== 0;
  const characters = (text) => {
    for (const sign of text) if (sign >= ' ') Module._page_character(sign.codePointAt(0));
  };

  const listenToKeys = () => {
    window.addEventListener('keydown', (event) => {
      if (event.isComposing || event.key === undefined) return;  // autofill events have no key
      if (is_paste(event)) return is_ours() ? undefined : messages.handOn(event);
      // Leave Ctrl+R, T, W, L, N and the developer tools to the browser.
      const is_browsers = (event.ctrlKey || event.metaKey) && ['KeyR', 'KeyT', 'KeyW', 'KeyL', 'KeyN', 'KeyI', 'KeyJ'].includes(event.code);
      if (is_browsers || (event.altKey && event.code.startsWith('Arrow'))) return;
      if (event.repeat) again();  // the program itself repeats held keys, frame by frame
      else if (key(event, true)) used.add(event.code);
      else used.delete(event.code);
      const is_used = used.has(event.code);
      if (is_embedded && !is_used) return messages.handOn(event);
      const prints = event.key.length === 1 && !event.ctrlKey && !event.metaKey;
      if (document.activeElement === typed && prints) return;  // the text field's input event delivers it
      if (prints && event.repeat === false) characters(event.key);
      if (is_used) event.preventDefault();
    });
    window.addEventListener('keyup', (event) => {
      if (is_paste(event) || event.key === undefined) return;
      key(event, false);
      if (is_embedded && !used.has(event.code)) messages.handOn(event);
      used.delete(event.code);
    });
    typed.addEventListener('input', (event) => {
      if (event.isComposing) return;
      characters(typed.value);
      typed.value = '';
    });
    typed.addEventListener('compositionend', () => {
      characters(typed.value);
      typed.value = '';
    });
    window.addEventListener('paste', (event) => {
      if (!is_ours()) return;
      event.preventDefault();
      const [file] = event.clipboardData.files;
      if (file) return drop([file]);
      const text = event.clipboardData.getData('text/plain');
      if (!takes(text)) return;
      call('page_paste', text);
      call('page_key', 'ControlLeft', 'Control', 1, 1, 0);
      for (const is_down of [1, 0]) call('page_key', 'KeyV', 'v', is_down, 1, 0);
      call('page_key', 'ControlLeft', 'Control', 0, 0, 0);
    });
    window.addEventListener('focus', () => Module._page_focus(1));
    window.addEventListener('blur', () => Module._page_focus(0));
  };

  // ---- Files

  const most_file_bytes = 2 ** 28;  // for figures; texts and meshes are checked when they are read
  /// Passes a user's file to the program's function of this name.
  const bring = async (file, name) => {
    const path = '/files/' + file.name.replace(/[/\\]/g, '_');
    try {
      if (file.size > most_file_bytes) {
        const values = {file: file.name, size: file.size.toLocaleString('en'), limit: most_file_bytes.toLocaleString('en')};
        return report(net.say('{file} has {size} bytes, but the limit is {limit}', values));
      }
      FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    } catch (error) {  // a folder, or a file that is gone
      return report(net.say('{file} cannot be read: {reason}', {file: file.name, reason: error.message}));
    }
    call(name, path);
  };
  const drop = async (files) => {
    for (const file of files) await bring(file, 'page_drop');
  };

  const listenToFiles = () => {
    window.addEventListener('dragover', (event) => event.preventDefault());
    window.addEventListener('drop', (event) => {
      event.preventDefault();
      drop(event.dataTransfer.files);
    });
    $('file').addEventListener('change', async () => {
      const [file] = $('file').files;
      if (file) await bring(file, 'page_file_is_chosen');
      $('file').value = '';
      again();
    });
  };

  const handOver = (path) => {
    const bytes = FS.readFile(path);
    if (kept.keep(path, bytes)) return;
    FS.unlink(path);  // the user has it now
    net.handOver(bytes, path.split('/').pop());
  };

  const prepare = () => {
    kept.restore();
    ENV.VIEWING_SANDBOX_LINK_BASE = location.href.split('#')[0];  // links begin with this
    if (navigator.language.startsWith('ko')) ENV.LANG = 'ko_KR.UTF-8';
  };

  // ---- Background work, suspended between frames if the browser can (JavaScript Promise Integration)

  const can_suspend = typeof WebAssembly.Suspending === 'function' && typeof WebAssembly.promising === 'function';
  let base = 0;
  const turn = () => new Promise((go_on) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = go_on;
    channel.port2.postMessage(0);
  });
  // Work has its own stack, so that frames can run while it is suspended.
  const pause = async () => {
    const own = stackSave();
    stackRestore(base);
    await turn();
    base = stackSave();
    stackRestore(own);
  };
  const beginWork = (run, stack_end) => setTimeout(async () => {
    if (net.hasEnded()) return;
    const work = wasmTable.get(run);
    if (!can_suspend || !stack_end) return work();
    base = stackSave();
    stackRestore(stack_end);
    const end = WebAssembly.promising(work)();
    stackRestore(base);
    await end;
    stackRestore(base);
  });

  // ---- Files beside the page, or inside a single-file page

  const packed = (name) => document.querySelector(`script[data-file="${name}"]`);
  const unpacked = async (name) => {
    const bytes = Uint8Array.from(atob(packed(name).textContent), (sign) => sign.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')));
  };
  const fetched = async (name) => {
    const answer = await fetch(name);
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    return answer;
  };
  const beside = (name) => (packed(name) ? unpacked(name) : fetched(name));

  const instantiate = async (imports, receive) => {
    if (can_suspend)
      for (const functions of Object.values(imports))
        for (const name of Object.keys(functions))
          if (functions[name] === page_pause) functions[name] = new WebAssembly.Suspending(pause);
    try {
      const module = await beside('viewing-sandbox.wasm');
      const can_stream = module.headers.get('content-type') === 'application/wasm';
      const made = can_stream ? await WebAssembly.instantiateStreaming(module, imports)
                              : await WebAssembly.instantiate(await module.arrayBuffer(), imports);
      receive(made.instance);
    } catch (error) {
      net.failed(error);
    }
  };

  // ---- Fonts, beside the page or inside it

  const fetchFont = async (name) => {
    try {
      const bytes = new Uint8Array(await (await beside(name)).arrayBuffer());
      const place = Module._malloc(bytes.length);
      HEAPU8.set(bytes, place);
      call('page_font_has_come', name, place, bytes.length);
      Module._free(place);
      again();
    } catch (error) {
      console.warn('The font ' + name + ' cannot be loaded: ' + error.message);
    }
  };

  // ---- Everything else that the program asks of the page

  const copy = (text) => {
    const by_hand = () => {  // without permission: the old way, which needs a selection
      const before = document.activeElement;
      const place = document.body.appendChild(document.createElement('textarea'));
      place.value = text;
      place.select();
      document.execCommand('copy');
      place.remove();
      before?.focus();
    };
    if (navigator.clipboard) navigator.clipboard.writeText(text).catch(by_hand);
    else by_hand();
  };

  const fullScreen = (wanted) => {
    const is_full = document.fullscreenElement !== null;
    if (wanted === (is_full ? 1 : 0)) return;
    const done = is_full ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
    done?.catch(() => {});
  };

  /// Dear ImGui queries these values before each frame, and each query waits for the driver. Fixed answers suffice: our
  /// drawing code leaves no other values behind, and sets all the state that it needs, whatever values ImGui restores.
  const prepareGl = (gl) => {
    const settled = new Map([
      [gl.BLEND_SRC_RGB, gl.ONE], [gl.BLEND_DST_RGB, gl.ZERO], [gl.BLEND_SRC_ALPHA, gl.ONE], [gl.BLEND_DST_ALPHA, gl.ZERO],
      [gl.BLEND_EQUATION_RGB, gl.FUNC_ADD], [gl.BLEND_EQUATION_ALPHA, gl.FUNC_ADD], [gl.SCISSOR_BOX, new Int32Array(4)],
    ]);
    const asks = gl.getParameter.bind(gl);
    gl.getParameter = (name) => settled.get(name) ?? asks(name);
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      if (is_open) Module._page_keep();
      net.end(net.say('The graphics driver lost the picture.'));
    });
  };

  // Shortens "ANGLE (Mesa, llvmpipe (LLVM 15.0.6 256 bits), OpenGL ES 3.2)" to the part between its first two commas.
  const rendererName = (gl) => {
    const told = gl.getExtension('WEBGL_debug_renderer_info');
    const whole = gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    return (/^ANGLE \([^,]*, ([^,(]*)/.exec(whole)?.[1] ?? whole).trim();
  };

  const start = () => {
    if (net.hasEnded() || !Module._page_is_open()) return;
    is_open = true;
    net.opened();
    kept.start();
    listenToPointer();
    listenToKeys();
    listenToFiles();
    const calm = matchMedia('(prefers-reduced-motion: reduce)');
    const move = () => Module._page_move(calm.matches ? 0 : 1);
    calm.addEventListener('change', move);
    move();
    new ResizeObserver(again).observe(canvas);
    watchScale(again);
    document.addEventListener('visibilitychange', () => document.hidden ? leave() : wake());
    window.addEventListener('pagehide', leave);
    window.addEventListener('hashchange', () => openLink());
    if (location.hash.length > 1) openLink();
    if (!is_framed) canvas.focus();
    wake();
    if (is_framed) messages.greet();
  };

  // ---- The address: "#preset=NAME", "#lesson=ID&step=N", "#1…" (a state); "#embed&…" in a host page

  const openLink = () => {
    known = location.hash;
    if (known === opened) return;
    const parts = location.hash.slice(1).split('&');
    if (parts.includes('embed')) {
      is_embedded = true;
      return messages.embed(parts.filter((part) => part !== 'embed'));
    }
    opened = known;
    open(known || '#preset=opening');
  };
  const open = (link) => takes(link) && call('page_open_link', link);

  return {ask, report, textTrouble, open, leave, askForFile: () => $('file').click(), handOver, beginWork, instantiate, fetchFont, copy,
          fullScreen, prepareGl, rendererName, prepare, start, wake, tellTrouble: (text) => net.end(net.say(text)), canPause: can_suspend};
})();

var Module = typeof Module === 'undefined' ? {} : Module;
Module.instantiateWasm = (imports, receive) => {
  page.instantiate(imports, receive);
  return {};
};
Module.preRun = [page.prepare];
Module.postRun = [page.start];
Module.onAbort = (what) => net.failed(new Error(what));
