// The page around the program: brings events, time and sizes to the functions of app/browser/page.cpp, and does for it
// what only a page can do: files, clipboard, address, full screen, suspending. Loaded before the program's own script, whose
// names (Module, FS, stackSave, wasmTable, page_pause) are global.
'use strict';

const page = (() => {
  const $ = (id) => document.getElementById(id);
  const canvas = $('view'), typed = $('typed'), notice = $('notice');
  const kept = 'viewing-sandbox:';  // before the names of files in the browser's storage
  const settings = '/home/web_user/.config/viewing-sandbox';

  // ---- Calls with texts

  const call = (name, kind, kinds, values) => Module.ccall(name, kind, kinds, values);
  const tellFile = (name, path) => call(name, null, ['string'], [path]);

  // ---- Frames: one when something happened, or when the program wants one

  let is_open = false, frame_asked = 0, timer = 0, is_lost = false;
  const scale = () => window.devicePixelRatio || 1;

  const fit = () => {
    const width = Math.max(1, Math.round(canvas.clientWidth * scale()));
    const height = Math.max(1, Math.round(canvas.clientHeight * scale()));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  };

  /// Calls when a unit of the page has another number of pixels: another screen, or the page's zoom.
  const watchScale = (changed) =>
    matchMedia(`(resolution: ${scale()}dppx)`).addEventListener('change', () => {
      changed();
      watchScale(changed);
    }, {once: true});

  const draw = () => {
    frame_asked = 0;
    if (!is_open || is_lost || document.hidden) return;
    fit();
    const next_s = Module._page_frame(canvas.width, canvas.height, scale());
    follow();
    if (next_s === 0) ask();
    else if (next_s > 0) timer = setTimeout(ask, 1000 * next_s);
  };

  const ask = () => {
    clearTimeout(timer);
    timer = 0;
    if (!frame_asked) frame_asked = requestAnimationFrame(draw);
  };

  /// As after an event.
  const again = () => {
    Module._page_event();
    ask();
  };

  /// The page is hidden, and may never be seen again: what was done is kept now, not in a frame that does not come.
  const leave = () => {
    if (!is_open || is_lost) return;
    const most_frames = 8;
    for (let i = 0; i < most_frames && Module._page_frame(canvas.width, canvas.height, scale()) === 0; ++i);
    Module._page_keep();
  };

  // ---- What the page shows of the program's state beside the picture

  let cursor = '', opened = '', said = '', rest_timer = 0, rest_by_ms = 0, is_embedded = false, is_arranging = false;

  const follow = () => {
    const shape = UTF8ToString(Module._page_cursor());
    if (shape !== cursor) canvas.style.cursor = cursor = shape;
    const wants_text = Module._page_wants_text() !== 0;
    if (wants_text !== (document.activeElement === typed)) (wants_text ? typed : canvas).focus({preventScroll: true});
    const now = text('page_opened');
    if (now !== said && !is_embedded) {  // else it is still on its way, and the address knows it already
      said = now;
      const is_state = now === '' && opened.startsWith('#1');  // which has no other name than its own link
      if (now !== opened && !is_state) enter(now);
    }
    const now_ms = performance.now();
    if (!rest_timer) rest_by_ms = now_ms + 3000;  // now and then while something moves as well
    if (now_ms > rest_by_ms) return;
    clearTimeout(rest_timer);
    rest_timer = setTimeout(rest, 500);
  };

  /// A lesson's next step takes the place of the one before: back leads out of the lesson.
  const enter = (now) => {
    const is_same_lesson = now.startsWith('#lesson=') && opened.split('&')[0] === now.split('&')[0];
    opened = now;
    const address = now || location.pathname + location.search;
    if (location.hash !== now) history[is_same_lesson ? 'replaceState' : 'pushState'](null, '', address);
  };

  const text = (name) => UTF8ToString(Module['_' + name]());
  const show = (id, words) => {
    if ($(id).textContent !== words) $(id).textContent = words;
  };

  /// When nothing has been drawn for a while: for screen readers, and the address.
  const rest = () => {
    rest_timer = 0;
    document.documentElement.lang = text('page_language');
    show('told', text('page_told'));
    show('matrices', text('page_matrices_text'));
    if (!is_embedded) keepState();
  };

  /// At rest the address names what is shown, so that a reload or a copy of it brings that back.
  const keepState = () => {
    if (opened.startsWith('#lesson=')) return;
    const address = Module._page_departs() ? text('page_link') : opened;
    if (address !== location.hash) history.replaceState(null, '', address || location.pathname + location.search);
  };

  // ---- Pointer: mouse, pen and one finger are the mouse; two fingers orbit by their middle and zoom by their distance

  const fingers = new Map();
  let pair = null;
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
        if (fingers.size === 2) {  // what the first finger held is let go
          Module._page_button(0, 0);
          pair = both();
          Module._page_pointer(pair.x, pair.y, 1);
          Module._page_button(1, 1);
          return;
        }
        if (fingers.size > 2) return;
      }
      point(event);
      Module._page_button(event.button === 1 ? 2 : event.button === 2 ? 1 : event.button, 1);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!fingers.has(event.pointerId)) return point(event);
      fingers.set(event.pointerId, at(event));
      if (!pair) return point(event);
      if (fingers.size !== 2) return;
      const now = both();
      Module._page_pointer(now.x, now.y, 1);
      const step = 20;  // pixels of the page between the fingers that are one line of the wheel
      const lines = Math.trunc((now.apart - pair.apart) / step);
      if (lines !== 0) {
        Module._page_wheel(0, lines);
        pair.apart += lines * step;
      }
    });
    const up = (event) => {
      const was_finger = fingers.delete(event.pointerId);
      if (was_finger && pair) {
        if (fingers.size < 2) {
          Module._page_button(1, 0);
          if (fingers.size === 0) pair = null;
        }
      } else {
        if (event.type === 'pointerup') point(event);
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
      event.preventDefault();
      const lines = [1 / 100, 1 / 3, 1][event.deltaMode];  // pixels, lines, pages
      Module._page_wheel(-event.deltaX * lines, -event.deltaY * lines);
    }, {passive: false});
  };

  // ---- Keyboard. What is typed comes by the text field: it knows input methods and keyboards on the screen

  const is_paste = (event) => (event.ctrlKey || event.metaKey) && event.code === 'KeyV';
  const key = (event, is_down) =>
    call('page_key', 'number', ['string', 'string', 'number', 'number', 'number'],
         [event.code, event.key, is_down ? 1 : 0, event.ctrlKey || event.metaKey ? 1 : 0, event.shiftKey ? 1 : 0]);
  const characters = (text) => {
    for (const sign of text) if (sign >= ' ') Module._page_character(sign.codePointAt(0));
  };

  const listenToKeys = () => {
    window.addEventListener('keydown', (event) => {
      if (event.isComposing || is_paste(event)) return;
      // Ctrl+R, T, W, L, N and the developer's tools stay the browser's.
      const is_browsers = (event.ctrlKey || event.metaKey) && ['KeyR', 'KeyT', 'KeyW', 'KeyL', 'KeyN', 'KeyI', 'KeyJ'].includes(event.code);
      if (is_browsers || (event.altKey && event.code.startsWith('Arrow'))) return;
      if (event.repeat) again();  // the program repeats what is held by itself, frame by frame
      const is_known = event.repeat ? 1 : key(event, true);
      const prints = event.key.length === 1 && !event.ctrlKey && !event.metaKey;
      if (document.activeElement === typed && prints) return;  // its input event brings it
      if (prints && event.repeat === false) characters(event.key);
      if (is_known) event.preventDefault();
    });
    window.addEventListener('keyup', (event) => {
      if (!is_paste(event)) key(event, false);
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
      event.preventDefault();
      const [file] = event.clipboardData.files;
      if (file) return drop([file]);
      call('page_paste', null, ['string'], [event.clipboardData.getData('text/plain')]);
      for (const is_down of [1, 0]) {
        call('page_key', 'number', ['string', 'string', 'number', 'number', 'number'], ['ControlLeft', 'Control', is_down, is_down, 0]);
        if (is_down)
          for (const down of [1, 0])
            call('page_key', 'number', ['string', 'string', 'number', 'number', 'number'], ['KeyV', 'v', down, 1, 0]);
      }
    });
    window.addEventListener('focus', () => Module._page_focus(1));
    window.addEventListener('blur', () => Module._page_focus(0));
  };

  // ---- Files

  const put = async (file) => {
    const path = '/files/' + file.name.replace(/[/\\]/g, '_');
    FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    return path;
  };
  const drop = async (files) => {
    for (const file of files) tellFile('page_drop', await put(file));
  };

  const listenToFiles = () => {
    window.addEventListener('dragover', (event) => event.preventDefault());
    window.addEventListener('drop', (event) => {
      event.preventDefault();
      drop(event.dataTransfer.files);
    });
    $('file').addEventListener('change', async () => {
      const [file] = $('file').files;
      if (file) tellFile('page_file_is_chosen', await put(file));
      $('file').value = '';
      again();
    });
  };

  const handOver = (path) => {
    const bytes = FS.readFile(path);
    if (path.startsWith(settings)) {
      try {
        localStorage.setItem(kept + path, new TextDecoder().decode(bytes));
      } catch {
        // Storage is full or not allowed: what was remembered lasts as long as the page.
      }
      return;
    }
    FS.unlink(path);  // it is the person's now
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = path.split('/').pop();
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };

  const restoreFiles = () => {
    try {
      for (const name of Object.keys(localStorage)) {
        if (!name.startsWith(kept + settings)) continue;
        const path = name.slice(kept.length);
        FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        FS.writeFile(path, localStorage.getItem(name));
      }
    } catch {
      // No storage is allowed here: nothing is remembered.
    }
    ENV.VIEWING_SANDBOX_LINK_BASE = location.href.split('#')[0];  // what links are put behind
    if (navigator.language.startsWith('ko')) ENV.LANG = 'ko_KR.UTF-8';
  };

  // ---- Work beside the frames, suspended where the browser can (JavaScript Promise Integration)

  const can_suspend = typeof WebAssembly.Suspending === 'function' && typeof WebAssembly.promising === 'function';
  let base = 0;
  const turn = () => new Promise((go_on) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = go_on;
    channel.port2.postMessage(0);
  });
  // A work has a stack of its own, so that frames may come and go while it stands still.
  const pause = async () => {
    const own = stackSave();
    stackRestore(base);
    await turn();
    base = stackSave();
    stackRestore(own);
  };
  const beginWork = (run, stack_end) => setTimeout(async () => {
    const work = wasmTable.get(run);
    if (!can_suspend || !stack_end) return work();
    base = stackSave();
    stackRestore(stack_end);
    const end = WebAssembly.promising(work)();
    stackRestore(base);
    await end;
    stackRestore(base);
  });

  // ---- What lies beside the page, or in it where it is one file

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
      tellTrouble('The sandbox cannot be loaded: ' + error.message);
    }
  };

  // ---- Fonts, beside the page or inside it

  const fetchFont = async (name) => {
    try {
      const bytes = new Uint8Array(await (await beside(name)).arrayBuffer());
      const place = Module._malloc(bytes.length);
      HEAPU8.set(bytes, place);
      call('page_font_has_come', null, ['string', 'number', 'number'], [name, place, bytes.length]);
      Module._free(place);
      again();
    } catch (error) {
      console.warn('The font ' + name + ' cannot be fetched: ' + error.message);
    }
  };

  // ---- Everything else that the program asks of the page

  const tellTrouble = (text, button, act) => {
    notice.hidden = false;
    $('notice-text').textContent = text;
    $('notice-button').hidden = !button;
    $('notice-button').textContent = button ?? '';
    $('notice-button').onclick = act;
  };

  const copy = (text) => {
    const by_hand = () => {  // where there is no permission: an old way, which wants a selection
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

  /// Dear ImGui asks for these before each frame, and each answer waits for the driver; nothing that draws here leaves
  /// them otherwise, and what it sets back is set anew by all that draws.
  const prepareGl = (gl) => {
    const settled = new Map([
      [gl.BLEND_SRC_RGB, gl.ONE], [gl.BLEND_DST_RGB, gl.ZERO], [gl.BLEND_SRC_ALPHA, gl.ONE], [gl.BLEND_DST_ALPHA, gl.ZERO],
      [gl.BLEND_EQUATION_RGB, gl.FUNC_ADD], [gl.BLEND_EQUATION_ALPHA, gl.FUNC_ADD], [gl.SCISSOR_BOX, new Int32Array(4)],
    ]);
    const asks = gl.getParameter.bind(gl);
    gl.getParameter = (name) => settled.get(name) ?? asks(name);
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      is_lost = true;
      tellTrouble('The graphics driver has let go of the picture.', 'Load again', () => location.reload());
    });
  };

  // "ANGLE (Mesa, llvmpipe (LLVM 15.0.6 256 bits), OpenGL ES 3.2)": what stands between the first two commas.
  const rendererName = (gl) => {
    const told = gl.getExtension('WEBGL_debug_renderer_info');
    const whole = gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    return (/^ANGLE \([^,]*, ([^,(]*)/.exec(whole)?.[1] ?? whole).trim();
  };

  const start = () => {
    if (!Module._page_is_open()) return;
    is_open = true;
    notice.hidden = true;
    listenToPointer();
    listenToKeys();
    listenToFiles();
    listenToMessages();
    const calm = matchMedia('(prefers-reduced-motion: reduce)');
    const move = () => Module._page_move(calm.matches ? 0 : 1);
    calm.addEventListener('change', move);
    move();
    new ResizeObserver(again).observe(canvas);
    watchScale(again);
    document.addEventListener('visibilitychange', () => document.hidden ? leave() : ask());
    window.addEventListener('pagehide', leave);
    window.addEventListener('hashchange', () => openLink());
    if (location.hash.length > 1) openLink();
    canvas.focus();
    ask();
    if (window.parent !== window) greet();
  };

  // ---- The address: "#preset=NAME", "#lesson=ID&step=N", "#1…" (a state); "#embed&…" for somebody else's page

  const openLink = () => {
    if (location.hash === opened) return;
    const parts = location.hash.slice(1).split('&');
    if (parts.includes('embed')) return embed(parts.filter((part) => part !== 'embed'));
    opened = location.hash;
    call('page_open_link', null, ['string'], [location.hash || '#preset=opening']);
  };

  /// What is shown is chosen by parts of the address: big=camera&controls=light.position,projection.near&matrices=S
  const embed = (parts) => {
    is_embedded = true;
    Module._page_embed();
    const chosen = {big: 'camera', controls: '', matrices: ''}, rest = [];
    for (const part of parts) {
      const [name, value = ''] = part.split('=');
      if (name in chosen) chosen[name] = decodeURIComponent(value);
      else rest.push(part);
    }
    const list = (names) => JSON.stringify(names.split(',').filter((name) => name));
    const shown = [`view.layout.big=${chosen.big}`, `view.layout.controls=${list(chosen.controls)}`, `view.layout.matrices=${list(chosen.matrices)}`];
    if (rest.length) call('page_open_link', null, ['string'], ['#' + rest.join('&')]);
    const arrange = () => {  // when what was opened is there
      if (!Module._page_rests()) return setTimeout(arrange, 20);
      for (const setting of shown) set(setting);
      is_arranging = false;
    };
    is_arranging = true;
    arrange();
  };
  const set = (setting) => UTF8ToString(call('page_set', 'number', ['string'], [setting]));

  // ---- Messages from the page around it: README, "In a page of your own"

  /// The page around it may ask from now on: what the address names is shown.
  const greet = () => {
    if (is_arranging || !Module._page_rests()) return setTimeout(greet, 20);
    window.parent.postMessage({from: 'viewing-sandbox', is: 'ready'}, '*');
  };

  const answers = {
    state: () => JSON.parse(text('page_state')),
    matrices: () => JSON.parse(text('page_matrices')),
    link: () => text('page_link'),
    picture: ({view = 'camera', size: [width, height] = [0, 0], samples = -1}) => {
      const file = UTF8ToString(call('page_picture', 'number', ['string', 'number', 'number', 'number'], [view, width, height, samples]));
      if (!file) throw new Error(`there is no picture of ${view} so large`);
      return 'data:image/png;base64,' + base64(FS.readFile(file));
    },
    rests: () => Module._page_rests() === 1,
  };
  const base64 = (bytes) => {
    let signs = '';
    for (let i = 0; i < bytes.length; i += 32768) signs += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(signs);
  };
  const answer = (asked) => {
    const {get, set: wanted, open} = asked;
    if (wanted !== undefined) {
      for (const [path, value] of Object.entries(wanted)) {
        const trouble = set(path + '=' + JSON.stringify(value));
        if (trouble) throw new Error(trouble);
      }
      return true;
    }
    if (open !== undefined) {
      call('page_open', null, ['string'], [typeof open === 'string' ? open : JSON.stringify(open)]);
      return true;
    }
    if (!Object.hasOwn(answers, get)) throw new Error(`no such thing to get: ${get}; there are ${Object.keys(answers).join(', ')}`);
    return answers[get](asked);
  };
  const listenToMessages = () => window.addEventListener('message', ({data, source, origin}) => {
    if (data?.to !== 'viewing-sandbox') return;
    const reply = {from: 'viewing-sandbox', id: data.id};
    try {
      reply.answer = answer(data);
    } catch (error) {
      reply.error = error.message;
    }
    source?.postMessage(reply, origin === 'null' ? '*' : origin);
  });

  return {askForFile: () => $('file').click(), handOver, beginWork, instantiate, fetchFont, tellTrouble, copy, fullScreen, prepareGl, rendererName,
          restoreFiles, start, wake: ask, canPause: can_suspend};
})();

var Module = typeof Module === 'undefined' ? {} : Module;
Module.instantiateWasm = (imports, receive) => {
  page.instantiate(imports, receive);
  return {};
};
Module.preRun = [page.restoreFiles];
Module.postRun = [page.start];
