// tasks: [id, simulator, split, template, instruction, chunk, place in the chunk]. A chunk is the packed rest of the tasks
// of a home; only those of the task that is shown and of its neighbour are unpacked.
const set = JSON.parse($('#data').textContent);
const kKey = 'unietp-review/' + set.tasks_sha256;
const card = $('#card');
let reviews = {};         // by task: verdict, text, comment
let shown = [], at = 0;   // indices of the tasks that the filter leaves; a position among them
let unpacked = new Map(); // by chunk: a promise
let lastSaved = '';

$('[data-part="judgement"]', card).append($('#judgement').content);

function remember() {
  try { localStorage.setItem(kKey, JSON.stringify(reviews)); } catch { say('This browser cannot store decisions; save the file before you leave.'); }
}
function recall() {
  try { reviews = JSON.parse(localStorage.getItem(kKey)) || {}; } catch { reviews = {}; }
}
function say(text) { $('#message').textContent = text; }

async function unpack(chunk) {
  const packed = Uint8Array.from(atob($('#chunk-' + chunk).textContent), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).json();
}
function chunkOf(index) {
  const chunk = set.tasks[index][5];
  if (!unpacked.has(chunk)) {
    if (unpacked.size > 3) unpacked.delete(unpacked.keys().next().value);
    unpacked.set(chunk, unpack(chunk));
  }
  return unpacked.get(chunk);
}

/// A drawing is runs of the chunk's parts: first, length, first, length, …
function drawnFrom(runs, parts) {
  let svg = '';
  for (let i = 0; i < runs.length; i += 2) svg += parts.slice(runs[i], runs[i] + runs[i + 1]).join('');
  return svg;
}

const stateOf = id => (reviews[id] && reviews[id].verdict) || 'open';

function applyFilter(keep) {
  const simulator = $('#simulator').value, split = $('#split').value, state = $('#state').value;
  const words = $('#search').value.toLowerCase().split(/\s+/).filter(Boolean);
  shown = [];
  set.tasks.forEach((task, i) => {
    if (simulator && task[1] !== simulator || split && task[2] !== split) return;
    if (state && stateOf(task[0]) !== state) return;
    const text = `${task[0]} ${task[3]} ${task[4]}`.toLowerCase();
    if (words.every(word => text.includes(word))) shown.push(i);
  });
  const found = shown.indexOf(keep);
  at = found < 0 ? 0 : found;
  return show();
}

function count() {
  const sum = { accept: 0, reject: 0, edit: 0, open: 0 };
  for (const task of set.tasks) ++sum[stateOf(task[0])];
  const done = set.tasks.length - sum.open;
  $('#progress').max = set.tasks.length || 1;
  $('#progress').value = done;
  $('#counts').textContent = `${done.toLocaleString('en')} of ${set.tasks.length.toLocaleString('en')} reviewed: ` +
    `${sum.accept} accepted, ${sum.reject} rejected, ${sum.edit} edited`;
}

function showVerdict() {
  const id = current()[0], review = reviews[id] || {};
  card.dataset.state = stateOf(id);
  for (const button of document.querySelectorAll('[data-verdict]'))
    button.setAttribute('aria-pressed', String(Boolean(button.dataset.verdict) && button.dataset.verdict === review.verdict));
  const edited = review.verdict === 'edit';
  $('[data-part="instruction"]', card).textContent = edited ? review.text : current()[4];
  $('#was').textContent = edited ? 'Was: ' + current()[4] : '';
  $('#comment').value = review.comment || '';
  count();
}

const current = () => set.tasks[shown[at]];
let turn = 0;  // a task that is slow to unpack must not overwrite the one that was asked for after it

async function show() {
  const mine = ++turn;
  closeEditor();
  const none = shown.length === 0;
  card.hidden = none;
  $('#none').hidden = !none;
  $('#shown').textContent = shown.length.toLocaleString('en');
  $('#jump').max = shown.length;
  $('#jump').value = none ? 0 : at + 1;
  $('#previous').disabled = at <= 0;
  $('#next').disabled = at + 1 >= shown.length;
  document.documentElement.dataset.shown = '';
  count();
  if (none) return;
  const index = shown[at], [id, simulator, split, template, instruction, , place] = set.tasks[index];
  const chunk = await chunkOf(index);
  if (mine !== turn) return;
  const rest = chunk.tasks[place];
  showTask(card, { ...rest, id, simulator, split, template, instruction, layout: chunk.layout,
                   svg: drawnFrom(rest.drawing, chunk.parts) }, card.dataset.mode);
  showVerdict();
  document.documentElement.dataset.shown = id;
  if (at + 1 < shown.length) chunkOf(shown[at + 1]);
}

function go(to) {
  if (to < 0 || to >= shown.length) return;
  at = to;
  return show();
}

function judge(verdict, text) {
  if (!shown.length) return;
  const [id, , , , instruction] = current();
  const comment = $('#comment').value.trim();
  if (!verdict && !comment) delete reviews[id];
  else reviews[id] = { verdict, comment, instruction, ...(verdict === 'edit' ? { text } : {}) };
  remember();
  showVerdict();
}

/// The filter may hide what was just judged, so the next task is looked up before.
function judgeAndGo(verdict, text) {
  if (!shown.length) return;
  const next = shown[at + 1];
  judge(verdict, text);
  if (next !== undefined && verdict) applyFilter(next);
}

function openEditor() {
  if (!shown.length) return;
  const review = reviews[current()[0]];
  $('#text').value = review && review.verdict === 'edit' ? review.text : current()[4];
  $('#editor').hidden = false;
  $('#text').focus();
  $('#text').select();
}
function closeEditor() {
  const inside = $('#editor').contains(document.activeElement);
  $('#editor').hidden = true;
  if (inside) $('#task').focus({ preventScroll: true });
}
function keepEdit() {
  const text = $('#text').value.trim().replace(/\s+/g, ' ');
  if (!text) return say('An instruction cannot be empty.');
  closeEditor();
  if (text === current()[4]) return say('The text has not changed; accept it instead.');
  judgeAndGo('edit', text);
}

/// What `unietp review --apply` reads.
function reviewFile() {
  const list = set.tasks.filter(task => stateOf(task[0]) !== 'open').map(([id]) => {
    const { verdict, comment, instruction, text } = reviews[id];
    return { task: id, verdict, instruction, ...(text === undefined ? {} : { text }), comment: comment || '' };
  });
  return JSON.stringify({ format: 'unietp-review/1', set: set.name, tasks_sha256: set.tasks_sha256, reviews: list }, null, 1) + '\n';
}

function save() {
  lastSaved = reviewFile();
  const link = element('a', { href: URL.createObjectURL(new Blob([lastSaved], { type: 'application/json' })),
                              download: `review-${set.name}.json` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  say('Saved to review-' + set.name + '.json.');
}

async function load(file) {
  let read;
  try { read = JSON.parse(await file.text()); } catch { return say('This file is not JSON.'); }
  if (!read || read.format !== 'unietp-review/1' || !Array.isArray(read.reviews)) return say('This file is not a review.');
  const known = new Map(set.tasks.map(task => [task[0], task[4]]));
  let taken = 0;
  for (const { task, verdict, instruction, text, comment } of read.reviews) {
    if (known.get(task) !== instruction || !['accept', 'reject', 'edit'].includes(verdict)) continue;
    reviews[task] = { verdict, comment: String(comment || ''), instruction, ...(verdict === 'edit' ? { text: String(text) } : {}) };
    ++taken;
  }
  remember();
  say(`${taken} of ${read.reviews.length} decisions were loaded; the others refer to different texts.`);
  applyFilter(shown[at]);
}

const kActions = {
  a: () => judgeAndGo('accept'), r: () => judgeAndGo('reject'), e: openEditor, u: () => judge(''),
  c: () => $('#comment').focus(), s: save, '/': () => $('#search').focus(), '?': () => $('#help').showModal(),
  j: () => go(at + 1), k: () => go(at - 1), ArrowRight: () => go(at + 1), ArrowLeft: () => go(at - 1),
  n: () => { const next = shown.findIndex((i, k) => k > at && stateOf(set.tasks[i][0]) === 'open');
             return next < 0 ? say('There are no undecided tasks after this one.') : go(next); },
  m: () => { const tabs = [...$('[data-part="modes"]', card).children];
             const on = tabs.findIndex(tab => tab.getAttribute('aria-selected') === 'true');
             if (tabs.length) tabs[(on + 1) % tabs.length].click(); },
};

document.addEventListener('keydown', event => {
  if (event.target.id === 'text') {
    if (event.key === 'Escape') closeEditor();
    else if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) keepEdit();
    else return;
    return event.preventDefault();
  }
  if (event.target.matches('input, select, textarea')) {
    if (event.key === 'Escape' || (event.key === 'Enter' && event.target.id !== 'jump')) {
      event.target.blur();
      $('#task').focus({ preventScroll: true });
      event.preventDefault();
    }
    return;
  }
  if (event.altKey || event.ctrlKey || event.metaKey || $('#help').open) return;
  const action = kActions[event.key];
  if (!action) return;
  event.preventDefault();
  say('');
  action();
});

function fill(select, names) {
  select.append(element('option', { value: '', text: 'all' }),
                ...[...new Set(names)].sort().map(name => element('option', { value: name, text: name.replace(/_/g, ' ') })));
}

recall();
$('#set').textContent = set.name;
fill($('#simulator'), set.tasks.map(task => task[1]));
fill($('#split'), set.tasks.map(task => task[2]));
for (const id of ['simulator', 'split', 'state']) $('#' + id).addEventListener('change', () => applyFilter(shown[at]));
$('#search').addEventListener('input', () => applyFilter(shown[at]));
$('#jump').addEventListener('change', () => go(Number($('#jump').value) - 1));
$('#previous').addEventListener('click', () => go(at - 1));
$('#next').addEventListener('click', () => go(at + 1));
$('#save').addEventListener('click', save);
$('#load').addEventListener('click', () => $('#file').click());
$('#file').addEventListener('change', () => { if ($('#file').files[0]) load($('#file').files[0]); $('#file').value = ''; });
$('#help-button').addEventListener('click', () => $('#help').showModal());
$('#keep').addEventListener('click', keepEdit);
$('#discard').addEventListener('click', closeEditor);
$('#comment').addEventListener('change', () => { if (shown.length) judge((reviews[current()[0]] || {}).verdict || '', (reviews[current()[0]] || {}).text); });
for (const button of document.querySelectorAll('[data-verdict]'))
  button.addEventListener('click', () => button.dataset.verdict === 'edit' ? openEditor() : button.dataset.verdict ? judgeAndGo(button.dataset.verdict) : judge(''));
addEventListener('storage', event => { if (event.key === kKey) { recall(); showVerdict(); } });
initTheme($('#theme'));
applyFilter(-1);
document.documentElement.dataset.ready = 'yes';
