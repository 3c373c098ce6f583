// What is seen, and what a click does.
// Views.
let mode = 'colour', held = null, chosen = 0;
const views = [];
function hashed(index) {
  const h = Math.imul(index, 0x9e3779b1) >>> 0;
  return index === 0 ? [0, 0, 0] : [64 + (h & 127), 64 + (h >> 8 & 127), 64 + (h >> 16 & 127)];
}
function picture(frame) {
  const out = new ImageData(W, H);
  let near = Infinity, far = 0;
  for (const d of frame.depth) if (d >= 0) near = Math.min(near, d), far = Math.max(far, d);
  for (let i = 0; i < W * H; ++i) {
    let c = [frame.rgb[4 * i], frame.rgb[4 * i + 1], frame.rgb[4 * i + 2]];
    if (mode === 'index') c = hashed(frame.index[i]);
    if (mode === 'depth') {
      const grey = 255 - 200 * (frame.depth[i] - near) / Math.max(1, far - near);
      c = frame.depth[i] < 0 ? [20, 30, 80] : [grey, grey, grey];
    }
    out.data.set([...c, 255], 4 * i);
  }
  return out;
}
function addView(name, title, frame) {
  const div = document.createElement('div');
  div.className = 'view';
  div.innerHTML = `<b>${title}</b><div class="stack"><canvas id="view-${name}" width="${W}" height="${H}"></canvas>` +
    `<canvas class="over" id="over-${name}" width="${W}" height="${H}"></canvas></div>` +
    `<canvas class="loupe" id="loupe-${name}" width="165" height="165"></canvas>`;
  $('views').append(div);
  const view = {name, frame, canvas: $('view-' + name), over: $('over-' + name), loupe: $('loupe-' + name)};
  views.push(view);
  const spot = e => {
    const box = view.over.getBoundingClientRect();
    return [Math.min(W - 1, Math.max(0, Math.floor((e.clientX - box.left) * W / box.width))),
            Math.min(H - 1, Math.max(0, Math.floor((e.clientY - box.top) * H / box.height)))];
  };
  view.over.addEventListener('mousemove', e => { if (!held) showPixel(...spot(e)); });
  view.over.addEventListener('click', e => hold(...spot(e)));
}
function hold(px, py) {
  held = [Math.min(W - 1, px), Math.min(H - 1, py)];
  showPixel(...held);
  showTriangle(hls.index[held[1] * W + held[0]]);
}
function drawViews() {
  for (const v of views) if (v.frame) v.canvas.getContext('2d').putImageData(picture(v.frame), 0, 0);
  drawOver();
}
function drawOver() {
  for (const v of views) {
    const c = v.over.getContext('2d');
    c.clearRect(0, 0, W, H);
    if (chosen && streams.stamp) {
      for (const [kind, colour] of [['stamp', 'rgba(255,220,0,.45)'], ['update', 'rgba(0,220,255,.6)']]) {
        const s = streams[kind];
        c.fillStyle = colour;
        for (const n of (s && s.of.get(chosen)) || []) {
          eachPixel(s, n, (at, lane) => {
            if (num(s, n, s.by.mask, lane)) c.fillRect(at % W, Math.floor(at / W), 1, 1);
          });
        }
      }
    }
    if (held) {
      c.strokeStyle = '#f0f';
      c.strokeRect(held[0] - 3.5, held[1] - 3.5, 8, 8);
    }
  }
}
function drawLoupes(px, py) {
  for (const v of views) {
    const c = v.loupe.getContext('2d');
    c.imageSmoothingEnabled = false;
    c.fillStyle = '#444';
    c.fillRect(0, 0, 165, 165);
    c.drawImage(v.canvas, px - 7, py - 7, 15, 15, 0, 0, 165, 165);
    c.strokeStyle = '#f0f';
    c.strokeRect(77.5, 77.5, 10, 10);
  }
}

// Panels.
const link = (text, what, a, b) =>
  `<span class="jump" data-${what}="${a}"${b === undefined ? '' : ` data-y="${b}"`}>${text}</span>`;
const triangleLink = t => t ? link('triangle ' + t, 'triangle', t) : 'background';
function fieldsOf(s, n, lane, from) {
  const text = [];
  for (const f of s.fields) {
    for (let l = 0; l < f.count; ++l) {
      if (f.count > 1 && lane !== undefined && l !== lane) continue;
      const name = f.count > 1 ? `${f.name}[${l}]` : f.name, value = shown(s, n, f, l);
      const got = from === undefined ? value : shown(s, n, f, l, from);
      const told = got === value ? `${name} ${value}` : `<b class="bad">${name} expected ${value} got ${got}</b>`;
      const when = f.valid_if ? '; counts if ' + f.valid_if : '';
      const title = (f.meaning || '') + (f.unit ? ` (${f.unit})` : '') + when;
      text.push(`<span title="${title}"${counts(s, n, f, l) ? '' : ' class="off"'}>${told}</span>`);
    }
  }
  return `<div class="fields">${text.join(', ')}</div>`;
}
function wordHtml(s, n, lane, note = '') {
  return `<div class="word"><span title="${s.what}; ${s.order}">${s.name} word ${n + s.begin}</span> ` +
    `(${s.from} → ${s.to}) ${note}${fieldsOf(s, n, lane)}</div>`;
}
const hex = (v, digits) => v < 0 ? '–' : '0x' + v.toString(16).padStart(digits, '0');
function showPixel(px, py) {
  const at = py * W + px, lane = laneOf(px, py), t = hls.index[at];
  $('px').value = px, $('py').value = py;
  $('pixel-title').textContent =
    `Pixel (${px}, ${py}), stamp (${Math.floor(px / LX)}, ${Math.floor(py / LY)}), lane ${lane}`;
  const row = (name, index, depth, colour) => `<tr><th>${name}<td>${index}<td>${depth}<td>${colour}`;
  const of = (name, f) => row(name, triangleLink(f.index[at]), hex(f.depth[at], 4), colourText(f.rgb, at));
  let text = '<table>' + row('', '<b>shows</b>', '<b>depth</b>', '<b>colour</b>');
  text += (ref ? of('ref', ref) : '') + of('hls', hls);
  if (rtl) text += row('rtl', '', '', colourText(rtl, at));
  $('pixel').innerHTML = text + '</table>';
  let words = '';
  for (const s of D.streams) {
    if (s.placed) {
      for (const n of wordsAt(s, px, py)) {
        let note = '';
        if (s.name === 'stamp' && update) {
          const index = num(s, n, s.by.index);
          const passed = wordsAt(update, px, py).some(u => num(update, u, update.by.index) === index);
          note = triangleLink(index) + (passed ? ': passed the Z-test' : ': not nearer than what was there');
        }
        words += wordHtml(s, n, lane, note);
      }
    } else if (t) {
      for (const n of s.of.get(t) || []) words += wordHtml(s, n);
    }
  }
  $('words').innerHTML = words || 'no words here';
  drawLoupes(px, py);
  drawOver();
}
function colourText(rgb, at) {
  const c = [...rgb.slice(4 * at, 4 * at + 3)];
  return `<i style="display:inline-block;width:12px;height:12px;background:rgb(${c})"></i> ${c.join(' ')}`;
}
function fragments(kind, t) {
  const s = streams[kind], found = [];
  for (const n of (s && s.of.get(t)) || []) {
    eachPixel(s, n, (at, lane) => { if (num(s, n, s.by.mask, lane)) found.push(at); });
  }
  return found;
}
function showTriangle(t) {
  chosen = t;
  $('triangle').value = t || '';
  $('triangle-title').textContent = t ? `Triangle ${t}` : 'No triangle: background';
  if (!t) { $('of-triangle').innerHTML = ''; return drawOver(); }
  const setup = streams.setup && (streams.setup.of.get(t) || [])[0];
  const covered = fragments('stamp', t), passed = new Set(fragments('update', t)).size;
  const shows = covered.filter(at => hls.index[at] === t).length;
  let why;
  if (setup === undefined) why = 'There is no such triangle in this frame.';
  else if (num(streams.setup, setup, streams.setup.by.empty)) {
    why = 'Not visible: its area is zero, or its box has no pixel centre of the frame.';
  }
  else if (!covered.length) why = 'Not visible: it covers no pixel centre.';
  else if (!passed) why = `Not visible: none of its ${covered.length} fragments is nearer than what was there.`;
  else {
    why = shows ? 'Visible: ' : 'Not visible in the end: ';
    why += `${passed} of its ${covered.length} fragments passed the Z-test, `;
    why += shows ? `${shows} pixels show it.` : 'and nearer ones came later.';
  }
  const before = new Map();
  for (const k of covered.map(at => hls.index[at])) if (k !== t) before.set(k, (before.get(k) || 0) + 1);
  const nearer = [...before].sort((a, b) => b[1] - a[1]).slice(0, 6).map(([k, n]) => `${triangleLink(k)} (${n})`);
  let text = `<p id="why">${why}</p>` + (nearer.length ? `<p>Its pixels show instead: ${nearer.join(', ')}.</p>` : '');
  const stamps = (streams.stamp && streams.stamp.of.get(t)) || [];
  text += `<p>${stamps.length} stamps: yellow what they cover, blue what passed.</p>`;
  for (const s of D.streams) if (!s.placed) for (const n of s.of.get(t) || []) text += wordHtml(s, n);
  for (const n of stamps.slice(0, 200)) text += wordHtml(streams.stamp, n);
  $('of-triangle').innerHTML = text;
  drawOver();
}

// What is wrong: words that the co-simulation found, and pixels of its picture.
let rtl = null;
function placeOf(s, n) {
  if (s.placed) {
    const x = num(s, n, s.by.x), y = num(s, n, s.by.y);
    return s.pixels ? [x, y] : [x * LX, y * LY];
  }
  const index = s.by.index && s.by.index.count === 1 ? num(s, n, s.by.index) : 0;
  const stamp = index && streams.stamp && (streams.stamp.of.get(index) || [])[0];
  return stamp === undefined || stamp === 0 && !index ? null : placeOf(streams.stamp, stamp);
}
function showWrong() {
  const run = D.cosim || {}, failures = (run.failures || []), text = [];
  if (!D.cosim) text.push('<p>Nothing of the RTL was compared: there is no cosim.json.</p>');
  else if (!failures.length) text.push(`<p>Nothing: ${run.words} words of the RTL agree.</p>`);
  for (const line of failures) text.push(`<div class="bad">${line}</div>`);
  if (run.first_wrong) text.push(`<p>First wrong in flow order: <b>${run.first_wrong}</b>; what follows from it:</p>`);
  for (const line of run.follows || []) text.push(`<div>${line}</div>`);
  for (const result of run.streams || []) {
    const s = streams[result.name];
    for (const w of (s && result.wrong || []).slice(0, 40)) {
      const n = w.word - s.begin;
      if (n < 0 || n >= s.words) continue;
      const place = placeOf(s, n), t = s.by.index && s.by.index.count === 1 ? num(s, n, s.by.index) : 0;
      const name = `${s.name} word ${w.word}`;
      text.push(`<div class="word">${place ? link(name, 'x', ...place) : name}, ` +
        `cycle ${w.cycle}${t ? ', ' + triangleLink(t) : ''}${fieldsOf(s, n, undefined, BigInt('0x' + w.got))}</div>`);
    }
  }
  if (rtl && colourStream) {
    const wrong = [];
    for (let i = 0; i < W * H; ++i) {
      if ([0, 1, 2].some(c => rtl[4 * i + c] !== hls.rgb[4 * i + c])) wrong.push(i);
    }
    const spots = wrong.slice(0, 30).map(i => [i % W, Math.floor(i / W)]);
    text.push(`<p id="wrong-pixels">${wrong.length} pixels of the picture differ from the kernels'` +
      spots.map(([x, y]) => ' ' + link(`(${x}, ${y})`, 'x', x, y)).join('') + '</p>');
  }
  $('wrong').innerHTML = text.join('');
}
document.addEventListener('click', e => {
  const {triangle, x, y} = e.target.dataset || {};
  if (triangle) showTriangle(Number(triangle));
  if (x !== undefined) hold(Number(x), Number(y));
});
document.addEventListener('keydown', e => { if (e.key === 'Escape') { held = null; drawOver(); } });

// Time.
function showTime() {
  const line = D.cosim && D.cosim.timeline, canvas = $('time');
  if (!line) { canvas.remove(); $('time-told').textContent = 'The co-simulation left no time line.'; return; }
  const names = Object.keys(line.streams), left = 150, tall = 22, most = line.streams[names[0]].length;
  const wide = Math.max(2, Math.floor(1050 / most));
  canvas.width = left + most * wide, canvas.height = names.length * tall + 18;
  const c = canvas.getContext('2d');
  c.font = '12px system-ui, sans-serif';
  names.forEach((name, row) => {
    c.fillStyle = '#222';
    c.fillText(name, 4, row * tall + 15);
    line.streams[name].forEach((counts, at) => {
      const all = counts[0] + counts[1] + counts[2] || 1;
      let y = row * tall + 2;
      counts.forEach((n, k) => {
        c.fillStyle = ['#2a7', '#ddd', '#e80'][k];
        c.fillRect(left + at * wide, y, wide, (tall - 4) * n / all);
        y += (tall - 4) * n / all;
      });
    });
  });
  c.fillStyle = '#c0f';
  const x = cycle => left + (cycle - line.first) / line.step * wide;
  for (const end of D.cosim.frame_ends || []) c.fillRect(x(end), 0, 1, names.length * tall);
  c.fillText('ends of frames', Math.max(left, canvas.width - 100), canvas.height - 4);
  const b = D.cosim.bound || {}, tight = ['setup', 'covered_stamps', 'shader'].find(k => b[k] === b.cycles);
  if (b.cycles) {
    $('bound').textContent = `  bound of a frame: ${b.cycles} cycles (${tight}); measured ${D.cosim.cycles}: ` +
      `${(D.cosim.cycles / b.cycles).toFixed(3)} ×`;
    const end = (D.cosim.frame_ends || []).slice(-1)[0] || line.first + b.cycles;
    c.fillStyle = '#06c';
    c.fillRect(x(end - b.cycles), canvas.height - 16, b.cycles / line.step * wide, 4);
    c.fillText('the bound', Math.max(left, x(end - b.cycles)), canvas.height - 3);
  }
  canvas.addEventListener('mousemove', e => {
    const box = canvas.getBoundingClientRect(), scale = canvas.width / box.width;
    const at = Math.floor(((e.clientX - box.left) * scale - left) / wide);
    const name = names[Math.floor((e.clientY - box.top) * scale / tall)], from = line.first + at * line.step;
    const counts = name && line.streams[name][at];
    $('time-told').textContent = !counts ? '\u00a0' : `${name}, cycles ${from} to ${from + line.step - 1}: ` +
      `${counts[0]} words, ${counts[1]} waiting for the sender, ${counts[2]} for the taker`;
  });
}

function start() {
  $('title').textContent = `${D.scene}, ${D.config}, ${LX}×${LY} lanes, ${W}×${H}: ${D.note}`;
  const words = D.streams.reduce((n, s) => n + s.words, 0);
  $('summary').textContent = `frame ${D.frame + 1} of ${D.frames}; ${words} words on ${D.streams.length} streams`;
  if (ref) addView('ref', 'ref: floating point', ref);
  addView('hls', 'hls: the kernels', hls);
  if (D.rtl_png) {
    addView('rtl', 'rtl: as it drew it', null);
    const image = new Image();
    image.onload = () => {
      const c = $('view-rtl').getContext('2d', {willReadFrequently: true});
      c.drawImage(image, 0, 0);
      rtl = c.getImageData(0, 0, W, H).data;
      ready();
    };
    image.src = 'data:image/png;base64,' + D.rtl_png;
  } else {
    ready();
  }
}
function ready() {
  for (const m of ['colour', 'index', 'depth']) {
    $('show-' + m).onclick = e => {
      mode = m;
      document.querySelectorAll('#bar button').forEach(b => b.classList.toggle('on', b === e.target));
      drawViews();
    };
  }
  $('triangle').onchange = e => showTriangle(Number(e.target.value));
  $('px').onchange = $('py').onchange = () => hold(Number($('px').value), Number($('py').value));
  // Motion has no colours.
  if (!colourStream) $('show-index').click();
  drawViews();
  showWrong();
  showTime();
  document.body.dataset.ready = 'yes';
}
start();
