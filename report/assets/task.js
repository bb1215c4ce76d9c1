// Shows a task. Texts of a data set enter the page as text only; its drawing is rebuilt from the few elements that
// drawings of homes are made of.
const kSvg = 'http://www.w3.org/2000/svg';
const kDrawn = new Set(['svg', 'g', 'title', 'rect', 'polygon', 'polyline', 'circle', 'line', 'text']);
const kDrawnWith = /^(x|y|x1|y1|x2|y2|cx|cy|r|rx|ry|width|height|viewBox|points|fill|stroke|class|opacity|font-\w+|fill-\w+|stroke-\w+|text-anchor|dominant-baseline|transform)$/;

function rebuilt(node) {
  const copy = document.createElementNS(kSvg, node.localName);
  for (const { name, value } of node.attributes) {
    if (kDrawnWith.test(name) && !/url|script/i.test(value)) copy.setAttribute(name, value);
  }
  for (const child of node.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) copy.append(child.data);
    else if (child.nodeType === Node.ELEMENT_NODE && kDrawn.has(child.localName)) copy.append(rebuilt(child));
  }
  return copy;
}

function drawing(svg, description) {
  const read = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  if (read.localName !== 'svg') return document.createTextNode('This drawing cannot be shown.');
  const made = rebuilt(read);
  made.removeAttribute('width');
  made.removeAttribute('height');
  made.setAttribute('role', 'img');
  made.setAttribute('aria-label', description);
  return made;
}

function planSteps(list, plan) {
  list.replaceChildren(...plan.steps.map(([text, ok, feedback]) => {
    const line = element('li', ok ? { text } : { text, class: 'failed' });
    if (!ok) line.append(' ', element('span', { class: 'feedback', text: '✗ ' + (feedback || 'fails') }));
    return line;
  }));
}

// The parts of `root` are found by their data-part.
function showTask(root, task, mode) {
  const part = name => $(`[data-part="${name}"]`, root);
  part('instruction').textContent = task.instruction;
  part('tags').replaceChildren(...[task.id, task.simulator, task.split.replace(/_/g, ' '), task.template, task.style,
    task.layout].filter(Boolean).map(text => element('li', { text })));
  part('goal').replaceChildren(...task.goal.map(([depth, text]) => element('li', { text, style: `--depth:${depth}` })));
  part('formula').textContent = task.formula;
  part('purpose').textContent = task.purpose
    ? `For ${task.purpose}${task.because.length ? ', because ' + task.because.join(' and ') : ''}.` : '';
  part('sense').textContent = `Sense: ${task.grade}`
    + (task.sense.length ? ` (${task.sense.map(([what, grade, why]) => `${what}: ${grade}, ${why}`).join('; ')}).` : '.');
  part('edits').textContent = task.edits.length ? 'Changes to the home for this task: ' + task.edits.join('; ') + '.' : '';
  const tabs = part('modes'), steps = part('plan');
  const shown = Math.max(0, task.plans.findIndex(plan => plan.mode === mode));
  const choose = index => {
    [...tabs.children].forEach((tab, i) => tab.setAttribute('aria-selected', String(i === index)));
    if (task.plans[index]) planSteps(steps, task.plans[index]);
    root.dataset.mode = task.plans[index] ? task.plans[index].mode : '';
  };
  tabs.replaceChildren(...task.plans.map((plan, i) => {
    const tab = element('button', { type: 'button', role: 'tab', text: `${plan.mode} (${plan.steps.length})` });
    tab.addEventListener('click', () => choose(i));
    return tab;
  }));
  choose(shown);
  part('drawing').replaceChildren(drawing(task.svg, `${task.id} from above`));
  const view = part('view');
  view.src = 'data:image/png;base64,' + task.view;
  view.alt = `What the agent sees as ${task.id} begins`;
}
