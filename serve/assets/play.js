// Plays a session of the server that this page came from: the one whose token follows # in the address, which a terminal
// may be playing too, or one of its own. Everything that is shown is what an agent is told.
let session = decodeURIComponent(location.hash.slice(1));
let turn = -1, view = null, offered = [], target = null, drawn = null;
const kKeys = { ArrowUp: 'move_forward', ArrowDown: 'move_backward', ArrowLeft: 'turn_left', ArrowRight: 'turn_right',
                PageUp: 'look_up', PageDown: 'look_down' };
const kWatch_ms = 400;  // how often the page looks whether a terminal has acted

async function call(method, parameters = {}) {
  const body = JSON.stringify(session ? { session, ...parameters } : parameters);
  const response = await fetch('/v1/' + method, { method: 'POST', body });
  const answer = await response.json();
  if (!response.ok) throw new Error(answer.error.message);
  return answer;
}

function complain(error) {
  $('#message').textContent = error instanceof TypeError ? 'The server does not answer; is it still running?' : error.message;
  $('#message').hidden = false;
}
async function attempt(work) {
  try {
    $('#message').hidden = true;
    await work();
  } catch (error) {
    complain(error);
  }
}

/// "mug_1", or in words what has no id: the picture's boxes and points in a mode without ids.
function nameOf(thing) {
  if (thing === null) return '';
  if (thing.point) return `the point ${thing.point.join(', ')}`;
  if (thing.bbox) return `the box ${thing.bbox.join(', ')}`;
  return thing;
}

function choose(thing) {
  target = thing;
  $('#target').textContent = thing === null ? 'None chosen. Click on the picture or on a name below.' : nameOf(thing);
  for (const button of document.querySelectorAll('[data-id]'))
    button.setAttribute('aria-pressed', String(button.dataset.id === thing));
  if (drawn) drawn.hidden = thing === null || typeof thing === 'string';
  for (const button of document.querySelectorAll('#actions button'))
    button.disabled = view.over || (button.dataset.needs === 'yes' && thing === null);
}

function showBoxes() {
  const { width, height } = view.image || { width: 1, height: 1 };
  drawn = element('div', { class: 'drawn' });
  drawn.hidden = true;
  const area = ([x0, y0, x1, y1]) => (x1 - x0 + 1) * (y1 - y0 + 1);
  const boxes = [...(view.boxes || [])].sort((a, b) => area(b.box) - area(a.box));  // what is small lies on top
  $('#boxes').replaceChildren(drawn, ...boxes.map(({ id, category, box: [x0, y0, x1, y1] }) => {
    const button = element('button', { type: 'button', 'data-id': id, 'aria-label': `${id} (${category})` },
                           element('span', { text: id }));
    button.style.left = 100 * x0 / width + '%';
    button.style.top = 100 * y0 / height + '%';
    button.style.width = 100 * (x1 - x0 + 1) / width + '%';
    button.style.height = 100 * (y1 - y0 + 1) / height + '%';
    button.classList.toggle('low', y0 < 0.08 * height);
    button.addEventListener('click', () => choose(id));
    return button;
  }));
}

/// What the agent knows of the home, filtered by the words of the search field.
function showKnown() {
  const words = $('#filter').value.toLowerCase().split(/\s+/).filter(Boolean);
  const parts = [];
  for (const [title, things] of [['In view', view.boxes], ['In the hand', view.held], ['Rooms', view.rooms],
                                 ['Furniture', view.furniture], ['Small things', view.movables]]) {
    const found = (things || []).filter(({ id, category }) => id && words.every(word => `${id} ${category}`.toLowerCase().includes(word)));
    if (!found.length) continue;
    parts.push(element('h4', { text: title }));
    parts.push(...found.map(({ id, category }) => {
      const button = element('button', { type: 'button', 'data-id': id, text: id, title: category });
      button.addEventListener('click', () => choose(id));
      return button;
    }));
  }
  $('#known').replaceChildren(...parts);
  choose(target);
}

function showActions() {
  const groups = new Map();
  for (const action of offered) {
    if (!groups.has(action.class)) groups.set(action.class, []);
    groups.get(action.class).push(action);
  }
  $('#actions').replaceChildren(...[...groups].map(([name, actions]) =>
    element('div', { class: 'group' }, element('span', { text: name }), element('div', {}, ...actions.map(action => {
      const needs = action.argument === 'none' ? 'no' : 'yes';
      const button = element('button', { type: 'button', text: action.action.replace(/_/g, ' '), title: action.effect,
                                         'data-action': action.action, 'data-needs': needs });
      button.addEventListener('click', () => act(action.action, needs === 'yes'));
      return button;
    })))));
}

function report({ action, success, feedback }) {
  if (success === undefined || success === null) return { text: action, state: '' };
  return success ? { text: `${action}: done`, state: 'ok' } : { text: `${action}: failed. ${feedback || ''}`, state: 'failed' };
}

function show(answer) {
  if (answer.turn === turn) return;  // seen already, as the answer to another call
  const begins = answer.observation.step === 0;
  view = answer.observation;
  turn = answer.turn;
  if (answer.task) $('#title').textContent = answer.task;
  $('#instruction').textContent = view.instruction;
  const left = view.failures_left === undefined ? '' : `, ${view.failures_left} failures left`;
  const held = (view.held || []).map(({ id, category }) => id || category).join(', ');
  $('#counts').textContent = `step ${view.step}, ${view.steps_left} left${left}` +
    (view.held === undefined ? '' : held ? `; holding ${held}` : '; holding nothing');
  if (begins) $('#log').replaceChildren();
  for (const result of view.results || []) {
    const { text, state } = report(result);
    $('#log').append(element('li', { text, class: state }));
  }
  $('#log').scrollTop = $('#log').scrollHeight;
  const { text, state } = view.last ? report(view.last) : { text: 'Nothing has been done yet.', state: '' };
  const verdict = `The episode is over: the goal is ${answer.reward > 0 ? '' : 'not '}reached.`;
  $('#feedback').textContent = view.over ? `${text}. ${verdict}` : text;
  $('#feedback').dataset.state = view.over ? 'over' : state;
  if (answer.picture) $('#picture').src = 'data:image/png;base64,' + answer.picture.png;
  const known = target !== null && typeof target === 'string';
  if (!known) target = null;  // boxes and points are of the picture before
  $('#hint').textContent = view.boxes ? 'What the camera shows. Click on a box to choose an object.'
    : 'What the camera shows. Click on an object, or draw a box around it.';
  showBoxes();
  showKnown();
  $('#choose').hidden = true;
  $('#game').hidden = $('#again').hidden = false;
  document.documentElement.dataset.turn = String(turn);
}

async function withPicture(answer) {
  if (!answer.picture && answer.observation.image) answer.picture = await call('render');
  return answer;
}

function act(action, needs) {
  return attempt(async () => {
    show(await withPicture(await call('step', { action: needs ? { action, args: [target] } : { action } })));
  });
}

async function begin(parameters) {
  const first = await withPicture(await call(...parameters));
  offered = (await call('actions')).actions;
  showActions();
  show(first);
}

/// A terminal may play the same session.
async function watch() {
  if (session && view) {
    const answer = await call('observe', { turn });
    if (answer.observation && answer.turn !== turn) show(await withPicture(answer));
  }
}

async function listTasks() {
  const { tasks } = await call('tasks');
  $('#tasks').replaceChildren(...tasks.map(({ task, instruction }) => element('option', { value: task, text: instruction })));
  $('#choose').hidden = false;
}

/// In a mode without boxes, a click is a point and a stroke is a box of the picture.
function initStage() {
  const stage = $('#stage');
  let from = null;
  const place = event => {
    const frame = $('#picture').getBoundingClientRect(), { width, height } = view.image;
    const at = (value, start, size, most) => Math.min(most - 1, Math.max(0, Math.floor((value - start) / size * most)));
    return [at(event.clientX, frame.left, frame.width, width), at(event.clientY, frame.top, frame.height, height)];
  };
  stage.addEventListener('pointerdown', event => {
    if (!view || view.boxes || !view.image) return;
    from = place(event);
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener('pointermove', event => { if (from) outline(from, place(event)); });
  stage.addEventListener('pointerup', event => {
    if (!from) return;
    const to = place(event), is_point = Math.abs(to[0] - from[0]) < 3 && Math.abs(to[1] - from[1]) < 3;
    const box = [Math.min(from[0], to[0]), Math.min(from[1], to[1]), Math.max(from[0], to[0]), Math.max(from[1], to[1])];
    outline(from, to);
    choose(is_point ? { point: from } : { bbox: box });
    from = null;
  });
}
function outline(from, to) {
  const { width, height } = view.image;
  drawn.hidden = false;
  drawn.style.left = 100 * Math.min(from[0], to[0]) / width + '%';
  drawn.style.top = 100 * Math.min(from[1], to[1]) / height + '%';
  drawn.style.width = 100 * (Math.abs(to[0] - from[0]) + 1) / width + '%';
  drawn.style.height = 100 * (Math.abs(to[1] - from[1]) + 1) / height + '%';
}

document.addEventListener('keydown', event => {
  const action = kKeys[event.key];
  if (!action || !view || view.over || event.target.matches('input, select') || event.ctrlKey || event.metaKey || event.altKey) return;
  if (!offered.some(one => one.action === action)) return;
  event.preventDefault();
  act(action, false);
});
$('#filter').addEventListener('input', showKnown);
$('#again').addEventListener('click', () => attempt(async () => show(await withPicture(await call('reset')))));
$('#choose').addEventListener('submit', event => {
  event.preventDefault();
  attempt(async () => {
    const task = $('#task').value.trim();
    session = (await call('open', { mode: $('#mode').value, pictures: true })).session;
    await begin(['reset', task ? { task } : { seed: Math.floor(Math.random() * 1e9) }]);
  });
});
initTheme($('#theme'));
initStage();
$('#again').hidden = true;
attempt(async () => {
  if (session) await begin(['observe']);
  else await listTasks();
  document.documentElement.dataset.ready = 'yes';
  setInterval(() => attempt(watch), kWatch_ms);
});
