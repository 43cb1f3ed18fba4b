// The safety net, loaded first and independent of everything else: an error in the page becomes a sentence with the
// button Load again, and buttons that save the answers kept by the browser. Also the only entry for messages from the
// host page, which are answered even after the program has ended. Read page.js next.
'use strict';

const net = (() => {
  const $ = (id) => document.getElementById(id);

  // ---- Texts of the scripts, independent of the program and its catalog

  const korean = {
    'Loading…': '불러오는 중…',
    'Load again': '다시 불러오기',
    'Save answers': '답안 저장',
    'Save answers of {student}': '{student} 답안 저장',
    'Hide': '숨기기',
    'The sandbox cannot be loaded: {reason}.': '샌드박스를 불러올 수 없습니다. {reason}.',
    'the server did not send {file}': '서버에서 {file} 파일을 받지 못했습니다',
    'The sandbox stopped because of an internal error ({reason}). The picture is the last one; loading again restores saved work.':
      '샌드박스가 내부 오류({reason})로 멈췄습니다. 보이는 그림은 마지막 장면이며, 다시 불러오면 보관된 내용이 돌아옵니다.',
    'The sandbox used up the memory that the browser gives a page. The picture is the last one; loading again restores saved work.':
      '브라우저가 페이지에 주는 메모리를 샌드박스가 모두 썼습니다. 보이는 그림은 마지막 장면이며, 다시 불러오면 보관된 내용이 돌아옵니다.',
    'The graphics driver lost the picture.': '그래픽 드라이버에서 그림이 사라졌습니다.',
    'This browser does not support WebGL 2, which the sandbox needs.': '이 브라우저에는 샌드박스가 그림을 그리는 데 쓰는 WebGL 2가 없습니다.',
    'The browser does not let this page save anything: answers since {time} exist only in this page and are lost when it closes.':
      '브라우저가 이 페이지에 보관을 허용하지 않습니다. {time} 이후의 답안은 이 페이지에만 있으며 페이지를 닫으면 사라집니다.',
    'The browser’s storage for this page is full: answers since {time} exist only in this page and are lost when it closes.':
      '이 페이지에 주어진 브라우저 저장 공간이 가득 찼습니다. {time} 이후의 답안은 이 페이지에만 있으며 페이지를 닫으면 사라집니다.',
    'The browser does not let this page save anything: theme, language and lesson progress last until it closes.':
      '브라우저가 이 페이지에 보관을 허용하지 않습니다. 테마, 언어, 단원 진도는 페이지를 닫을 때까지만 유지됩니다.',
    'The browser’s storage for this page is full: theme, language and lesson progress last until it closes.':
      '이 페이지에 주어진 브라우저 저장 공간이 가득 찼습니다. 테마, 언어, 단원 진도는 페이지를 닫을 때까지만 유지됩니다.',
    '{file} cannot be read: {reason}': '{file} 파일을 읽을 수 없습니다. {reason}',
    '{file} has {size} bytes, but the limit is {limit}': '{file} 파일의 크기는 {size}바이트이며, {limit}바이트까지만 읽습니다.',
  };

  // Keys of the browser's storage: this prefix, then the name of one of the program's files.
  const kept = 'viewing-sandbox:', settings = '/home/web_user/.config/viewing-sandbox/';
  const answers_folder = settings + 'answers/';
  const unkept = new Map();  // path: text that the browser has not kept yet, or has refused to keep

  const isKorean = () => {
    if (is_open) return document.documentElement.lang === 'ko';
    try {
      const {language} = JSON.parse(localStorage.getItem(kept + settings + 'window.json')) ?? {};
      if (language) return language === 'ko';
    } catch {
      // The language is not stored, or cannot be read: use the browser's.
    }
    return navigator.language.startsWith('ko');
  };
  const say = (text, values = {}) =>
    (isKorean() ? korean[text] ?? text : text).replace(/\{(\w+)\}/g, (place, name) => values[name] ?? place);

  // ---- Answers, as files to hand in

  const handOver = (bytes, name) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };

  /// Returns the answers of everyone who has answered in this browser: [{path, text, student, name}].
  const answers = () => {
    const found = new Map();
    try {
      for (const name of Object.keys(localStorage))
        if (name.startsWith(kept + answers_folder)) found.set(name.slice(kept.length), localStorage.getItem(name));
    } catch {
      // Storage is not allowed here.
    }
    for (const [path, text] of unkept) if (path.startsWith(answers_folder)) found.set(path, text);
    return [...found].filter(([path]) => path.endsWith('.json')).map(([path, text]) => {
      let student = '', name = '';
      try {
        const sheet = JSON.parse(text);
        student = String(sheet.student ?? '');
        name = String(sheet.name ?? '');
      } catch {
        // Damaged: saved unchanged.
      }
      return {path, text, student, name};
    });
  };
  /// Names the file like hand_in_file_name() in exercise_desk.h.
  const saveAnswers = ({text, student, name}) => {
    const file = [student, name].filter(Boolean).join('_').replace(/[\0- "*/:<>?\\|\x7f]|^\./g, '-');
    handOver(text, `${file || 'answers'}.json`);
  };

  // ---- The notice over the page

  let ended = '', is_open = false;

  const button = (text, act) => {
    const made = document.createElement('button');
    made.textContent = text;
    made.onclick = act;
    return made;
  };

  /// Shows a notice over the whole page. If `is_over`, the last picture stays visible behind the notice.
  const notice = (text, is_over) => {
    $('notice').hidden = false;
    $('notice').classList.toggle('over', is_over);
    $('notice-text').textContent = text;
    const buttons = [button(say('Load again'), () => location.reload())];
    for (const found of answers()) {
      const words = found.student ? say('Save answers of {student}', found) : say('Save answers');
      buttons.push(button(words, () => saveAnswers(found)));
    }
    $('notice-buttons').replaceChildren(...buttons);
  };

  const tellHost = (what) => {
    if (window.parent !== window) window.parent.postMessage({from: 'viewing-sandbox', ...what}, '*');
  };

  /// Stops all calls into the program: from now on they could only damage the stored answers.
  const end = (sentence) => {
    if (ended) return;
    ended = sentence;
    if (typeof Module !== 'undefined')
      for (const name of Object.keys(Module)) if (name.startsWith('_page_')) Module[name] = () => 0;
    notice(sentence, is_open);
    tellHost({is: 'ended', error: sentence});
  };

  // ---- Errors

  const isOfProgram = (error) =>
    error instanceof WebAssembly.RuntimeError || (WebAssembly.Exception && error instanceof WebAssembly.Exception);
  // The folder of the scripts; in the single-file page, the page itself. Browser extensions have other addresses.
  const folder = document.currentScript.src.replace(/[^/]*$/, '') || location.href.split('#')[0];
  const isOurs = (place) => place.includes(folder);

  const failed = (error) => {
    const text = isOfProgram(error) && !(error instanceof Error) ? 'exception' : String(error?.message ?? error);
    const reason = text.split('\n')[0].replace(/\.$/, '');
    if (!is_open) return end(say('The sandbox cannot be loaded: {reason}.', {reason}));
    if (/enlarge memory|out of memory|allocation failed|OOM/i.test(reason))
      return end(say('The sandbox used up the memory that the browser gives a page. The picture is the last one; loading again restores saved work.'));
    end(say('The sandbox stopped because of an internal error ({reason}). The picture is the last one; loading again restores saved work.', {reason}));
  };

  const missing = (address) =>
    end(say('The sandbox cannot be loaded: {reason}.', {reason: say('the server did not send {file}', {file: address.split('/').pop()})}));

  window.addEventListener('error', (event) => {
    const {target, error, filename} = event;
    if (target instanceof HTMLScriptElement) return missing(target.src);
    // A DOMException means that the browser refused one thing: the program continues.
    if (error && !(error instanceof DOMException) && (isOfProgram(error) || isOurs(filename ?? ''))) failed(error);
  }, true);
  window.addEventListener('unhandledrejection', ({reason}) => {
    if (isOfProgram(reason) || (reason instanceof Error && !(reason instanceof DOMException) && isOurs(reason.stack ?? ''))) failed(reason);
  });

  // ---- Messages, only from the page around this one. An opener or any other window is ignored

  let answer = null;  // an async function
  window.addEventListener('message', ({data, source, origin}) => {
    if (window.parent === window || source !== window.parent || data?.to !== 'viewing-sandbox') return;
    const send = (what) => source.postMessage({from: 'viewing-sandbox', id: data.id, ...what}, origin === 'null' ? '*' : origin);
    if (ended) return send({error: ended});
    if (!answer) return send({error: 'the sandbox is still loading: wait until it reports ready'});
    answer(data).then((value) => send({answer: value}), (error) => {
      if (isOfProgram(error)) failed(error);
      send({error: ended || String(error?.message ?? error).split('\n')[0]});
    });
  });

  $('notice-text').textContent = say('Loading…');
  // The style sheet has loaded or failed before the first script runs; if it failed, Chromium has an empty one.
  if (!getComputedStyle(document.documentElement).getPropertyValue('--has-come')) missing('page.css');
  return {
    say, button, handOver, answers, saveAnswers, tellHost, end, failed, kept, settings, answers_folder, unkept,
    hasEnded: () => ended !== '',
    opened: () => {
      is_open = true;
      $('notice').hidden = true;
    },
    answerBy: (made) => { answer = made; },
  };
})();
