const data = JSON.parse($('#data').textContent);
const charts = [];
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function chartOf(figure) {
  const horizontal = figure.horizontal;
  const values = horizontal ? 'x' : 'y', names = horizontal ? 'y' : 'x';
  const ink = colour('--soft'), line = colour('--line');
  const title = text => ({ display: Boolean(text), text, color: ink });
  return {
    type: 'bar',
    data: {
      labels: figure.labels,
      datasets: figure.series.map((series, i) => ({
        label: series.name, data: series.values, backgroundColor: colour('--c' + (i % 6 + 1)),
        borderRadius: 3, maxBarThickness: 46, categoryPercentage: 0.82, barPercentage: 0.92,
      })),
    },
    options: {
      indexAxis: horizontal ? 'y' : 'x', responsive: true, maintainAspectRatio: false, animation: false,
      font: { family: getComputedStyle(document.body).fontFamily },
      plugins: {
        legend: { display: figure.series.length > 1, position: 'top', align: 'start',
                  labels: { color: ink, boxWidth: 12, boxHeight: 12 } },
        tooltip: { mode: 'index', intersect: false, axis: names },
      },
      scales: {
        [values]: { stacked: figure.stacked, beginAtZero: true, title: title(figure.measure),
                    grid: { color: line, drawBorder: false }, ticks: { color: ink, maxTicksLimit: 7, precision: 0 } },
        [names]: { stacked: figure.stacked, title: title(figure.axis), grid: { display: false },
                   ticks: { color: ink, autoSkip: !horizontal, maxRotation: horizontal ? 0 : 40 } },
      },
    },
  };
}

function drawCharts() {
  while (charts.length) charts.pop().destroy();
  for (const figure of data.charts) charts.push(new Chart($(`#chart-${figure.id}`), chartOf(figure)));
}

function initExamples() {
  const root = $('#examples');
  if (!root) return;
  const pick = $('#example');
  let at = 0;
  const show = index => {
    at = (index + data.examples.length) % data.examples.length;
    pick.value = String(at);
    $('#example-count').textContent = `${at + 1} of ${data.examples.length}`;
    showTask(root, data.examples[at], root.dataset.mode);
  };
  pick.append(...data.examples.map((task, i) =>
    element('option', { value: String(i), text: `${task.simulator}, ${task.split.replace(/_/g, ' ')}: ${task.template}` })));
  pick.addEventListener('change', () => show(Number(pick.value)));
  $('#previous').addEventListener('click', () => show(at - 1));
  $('#next').addEventListener('click', () => show(at + 1));
  root.addEventListener('keydown', event => {
    if (event.target.matches('select, input, textarea') || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === 'ArrowLeft') show(at - 1);
    else if (event.key === 'ArrowRight') show(at + 1);
    else return;
    event.preventDefault();
  });
  show(0);
}

document.addEventListener('themechange', drawCharts);
addEventListener('beforeprint', () => charts.forEach(chart => chart.resize()));
addEventListener('afterprint', () => charts.forEach(chart => chart.resize()));
initTheme($('#theme'));
initExamples();
document.documentElement.dataset.ready = 'yes';
