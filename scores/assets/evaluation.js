// The list of episodes and the viewer, which opens the pages in the folder `report` as it needs them. Texts enter the
// page as text only.
const kListed = 200, kKeptPages = 8;
const episodes = data.episodes || [];
const viewer = $('#viewer');
let filter = new URLSearchParams(), listed = [], most = kListed, shownEpisode = null, shownView = null, at = 0, timer = 0;

const result = episode => episode.success ? 'success' : episode.classes[0] || 'failed';

function keeps(episode) {
  for (const [field, value] of filter) {
    if (value === '' || field === 'run') continue;
    if (field === 'steps') {
      const [first, last] = value.split('-').map(Number);
      const isLast = last >= Math.max(...episodes.filter(e => e.mode === episode.mode).map(e => e.count), 0);
      if (episode.count < first && !(first === 1 && episode.count === 0)) return false;
      if (episode.count > last && !isLast) return false;
      if (episode.end === 'errored') return false;
    } else if (field === 'held_out') {
      if (episode.held_out !== (value === 'yes')) return false;
    } else if (field === 'class') {
      if (result(episode) !== value && !result(episode).startsWith(value + ': ')) return false;
    } else if (field === 'mark') {
      if (!(episode.marks || []).includes(value)) return false;
    } else if (field === 'task') {
      if (!`${episode.task} ${episode.template}`.includes(value)) return false;
    } else if (String(episode[field]) !== value) return false;
  }
  return true;
}

function listEpisodes() {
  listed = episodes.filter(keeps);
  $('#shown').textContent = `${listed.length} of ${episodes.length} episodes` +
    (filter.get('held_out') ? `, templates ${filter.get('held_out') === 'yes' ? 'unseen' : 'seen'}` : '') +
    (filter.get('steps') ? `, ${filter.get('steps').replace('-', '–')} steps` : '') +
    (filter.get('success') ? `, ${filter.get('success') === 'true' ? 'succeeded' : 'not succeeded'}` : '') +
    (filter.get('end') ? ', with stop' : '') +
    (filter.get('mark') ? `, with ${filter.get('mark').replace(/_/g, ' ')}` : '');
  $('#list').replaceChildren(...listed.slice(0, most).map(episode => {
    const link = element('a', { href: '#viewer', text: episode.task + (episode.repeat > 1 ? ` #${episode.repeat}` : '') });
    const row = element('tr', { 'aria-selected': String(episode === shownEpisode) },
      element('td', {}, link), element('td', { text: episode.mode }),
      element('td', { text: result(episode), class: episode.success ? 'good' : 'bad' }),
      element('td', { text: String(episode.count), class: 'number' }));
    row.addEventListener('click', event => { event.preventDefault(); showEpisode(episode); });
    return row;
  }));
  $('#more').hidden = listed.length <= most;
}

function setFilter(next) {
  filter = next;
  most = kListed;
  for (const control of $('#filters').elements) {
    if (control.name) control.value = filter.get(control.name) || '';
  }
  listEpisodes();
  if (!listed.includes(shownEpisode) && listed.length > 0) showEpisode(listed[0]);
}

function choices(name, values) {
  const select = $(`#filters [name="${name}"]`);
  select.append(element('option', { value: '', text: 'all' }),
    ...values.map(value => element('option', { value, text: value.replace(/_/g, ' ') })));
}

const part = name => $(`[data-part="${name}"]`, viewer);

function stopPlaying() {
  clearInterval(timer);
  timer = 0;
  part('play').textContent = 'Play';
}

function box(numbers, name, isNamed) {
  const kSvg = 'http://www.w3.org/2000/svg';
  const [x0, y0, x1, y1] = numbers;
  const rect = document.createElementNS(kSvg, 'rect');
  for (const [key, value] of [['x', x0], ['y', y0], ['width', x1 - x0 + 1], ['height', y1 - y0 + 1]])
    rect.setAttribute(key, value);
  if (isNamed) rect.setAttribute('class', 'named');
  const label = document.createElementNS(kSvg, 'text');
  label.setAttribute('x', x0 + 2);
  label.setAttribute('y', Math.max(13, y0 + 13));
  label.textContent = name;
  return [rect, label];
}

function drawPicture(view, step) {
  const image = view.images[at];
  if (!image) {
    part('picture').replaceChildren(element('p', { class: 'none', text: 'The report has no picture of this moment.' }));
    return;
  }
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', `0 0 ${view.width} ${view.height}`);
  for (const [id, ...numbers] of step ? step.seen : []) svg.append(...box(numbers, id, false));
  for (const act of step ? step.acts : []) {
    if (act.box) svg.append(...box(act.box, act.object || 'nothing', true));
  }
  part('picture').replaceChildren(element('img', { src: 'data:image/png;base64,' + image, alt: 'What the agent saw' }), svg);
}

// What the agent was told before its reply number `at`, the reply, and what came of it; at the end what came of all.
function showMoment() {
  const view = shownView, step = view.steps[at], before = view.steps[at - 1];
  const last = acts => acts.length ? acts[acts.length - 1] : null;
  const reached = step ? last(step.acts) : before ? last(before.acts) : null;
  part('place').textContent = step ? `reply ${at + 1} of ${view.steps.length}` : 'the end';
  part('told').textContent = before ? before.told : view.told;
  part('thinking').textContent = step ? step.thinking || '–' : '–';
  part('said').textContent = step ? step.said : '–';
  part('done').replaceChildren(...(step ? step.acts : []).map(act => {
    const line = element('li', { text: act.text || 'no action', class: act.ok ? '' : 'failed' });
    if (!act.ok) line.append(' ', element('span', { class: 'feedback', text: '✗ ' + act.why }));
    if (act.reached) line.append(' ', element('span', { class: 'good', text: 'goal reached' }));
    return line;
  }));
  const met = reached ? reached.parts : view.met;
  part('parts').replaceChildren(...view.parts.map(([kind, text], i) =>
    element('li', { text: kind === 'state' ? text : `${text} (${kind})`, class: met[i] === '1' ? 'met' : '' })));
  const share = Math.round(100 * (reached ? reached.progress : 0));
  part('progress').style.setProperty('--share', share + '%');
  part('progress').setAttribute('aria-label', `${share} % of the goal is met`);
  drawPicture(view, step);
  let number = 0;
  part('way').replaceChildren(...view.steps.flatMap((one, i) => one.acts.map(act => {
    ++number;
    const line = element('li', { text: act.text || 'no action', class: act.ok ? '' : 'failed' });
    if (i === at) line.setAttribute('aria-current', 'step');
    return line;
  })));
  for (const line of part('way').querySelectorAll('[aria-current]')) {
    part('way').scrollTop = line.offsetTop - part('way').offsetTop - 60;
  }
  part('previous').disabled = part('first').disabled = at === 0;
  part('next').disabled = at >= view.steps.length;
  if (at >= view.steps.length) stopPlaying();
}

function move(to) {
  if (!shownView) return;
  at = Math.max(0, Math.min(shownView.steps.length, to));
  showMoment();
}

// The views of a page of episodes. A frame may send its text from a disk, where a script may read no file.
const pages = new Map();
function openPage(number) {
  if (pages.has(number)) return pages.get(number);
  const frame = element('iframe', { src: `report/${String(number).padStart(4, '0')}.html`, hidden: '', title: 'Episodes' });
  let take;
  const views = new Promise((resolve, reject) => {
    take = event => {
      if (event.source === frame.contentWindow) resolve(JSON.parse(event.data));
    };
    addEventListener('message', take);
    frame.addEventListener('load', () => setTimeout(() => reject(new Error('no answer')), 2000));
  }).finally(() => {
    removeEventListener('message', take);
    frame.remove();
  });
  views.catch(() => pages.delete(number));
  pages.set(number, views);
  if (pages.size > kKeptPages) pages.delete(pages.keys().next().value);
  document.body.append(frame);
  return views;
}

async function showEpisode(episode) {
  stopPlaying();
  shownEpisode = episode;
  shownView = null;
  for (const row of $('#list').rows) row.setAttribute('aria-selected', 'false');
  const index = listed.indexOf(episode);
  if (index >= 0 && $('#list').rows[index]) $('#list').rows[index].setAttribute('aria-selected', 'true');
  const number = episodes.indexOf(episode), page = Math.floor(number / data.in_page);
  let view;
  try {
    view = (await openPage(page + 1))[number % data.in_page];
  } catch {
    if (shownEpisode !== episode) return;
    viewer.hidden = true;
    $('#shown').textContent = 'The folder "report" beside this page has the episodes, and cannot be read.';
    return;
  }
  if (shownEpisode === episode) showView(episode, view);
}

function showView(episode, view) {
  shownView = view;
  at = 0;
  viewer.hidden = false;
  part('instruction').textContent = view.instruction;
  const end = { stop: 'the agent stopped', steps: 'limit of steps', failures: 'limit of failures',
                answers: 'limit of answers', errored: 'errored' }[episode.end];
  const tags = [episode.task, episode.mode, episode.simulator, episode.split.replace(/_/g, ' '), episode.template,
    episode.home, episode.success ? 'success' : episode.classes.join('; '), end, `${episode.count} steps`,
    `${episode.failures} failures`, episode.shortest ? `shortest known plan ${episode.shortest}` : '', view.error || ''];
  part('tags').replaceChildren(...tags.filter(Boolean).map(text => element('li', { text })));
  part('goal').replaceChildren(...view.goal.map(([depth, text]) => {
    const line = element('li', { text });
    line.style.setProperty('--depth', depth);
    return line;
  }));
  part('expert').replaceChildren(...(view.expert.length ? view.expert : ['none is known in this mode']).map(text =>
    element('li', { text })));
  showMoment();
}

function initEpisodes() {
  if (!viewer) return;
  const values = field => [...new Set(episodes.map(episode => episode[field]))].sort();
  choices('mode', values('mode'));
  choices('split', values('split'));
  choices('simulator', values('simulator'));
  const classes = [...new Set(episodes.map(result))].sort();
  choices('class', [...new Set([...classes.flatMap(name => name.includes(': ') ? [name.split(': ')[0], name] : [name])])].sort());
  $('#filters').addEventListener('input', () => {
    const next = new URLSearchParams(new FormData($('#filters')));
    setFilter(next);
  });
  $('#filters').addEventListener('submit', event => event.preventDefault());
  $('#clear').addEventListener('click', () => setFilter(new URLSearchParams()));
  $('#more').addEventListener('click', () => { most += kListed; listEpisodes(); });
  document.addEventListener('click', event => {
    const link = event.target.closest('[data-filter]');
    if (link) setFilter(new URLSearchParams(link.dataset.filter));
  });
  part('first').addEventListener('click', () => move(0));
  part('previous').addEventListener('click', () => move(at - 1));
  part('next').addEventListener('click', () => move(at + 1));
  part('play').addEventListener('click', () => {
    if (timer) return stopPlaying();
    if (!shownView) return;
    if (at >= shownView.steps.length) move(0);
    part('play').textContent = 'Pause';
    timer = setInterval(() => move(at + 1), 900);
  });
  viewer.addEventListener('keydown', event => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === 'ArrowLeft') move(at - 1);
    else if (event.key === 'ArrowRight') move(at + 1);
    else return;
    event.preventDefault();
  });
  const asked = location.hash.startsWith('#run=');  // by a leaderboard
  setFilter(new URLSearchParams(asked ? location.hash.slice(1) : ''));
  if (asked) $('#episodes').scrollIntoView();
}

// A bar of the chart of failures leads to its episodes.
function linkCharts() {
  data.charts.forEach((figure, i) => {
    if (!figure.id.startsWith('failures-') || !charts[i]) return;
    charts[i].options.onClick = (event, bars) => {
      if (!bars.length) return;
      setFilter(new URLSearchParams({ mode: figure.id.slice('failures-'.length), split: figure.labels[bars[0].index],
                                      class: figure.series[bars[0].datasetIndex].name }));
      $('#episodes').scrollIntoView();
    };
  });
}

document.addEventListener('themechange', linkCharts);
linkCharts();
initEpisodes();
