// The inspector: all that it shows is in the page. Words are of the vector set, so of the kernels; of the RTL there is
// the picture, what was wrong, and when.
'use strict';
const D = JSON.parse(document.getElementById('data').textContent);
const $ = id => document.getElementById(id);
const W = D.width, H = D.height, LX = D.lanes_x, LY = D.lanes_y, SX = Math.ceil(W / LX);

function bytesOf(base64) {
  const text = atob(base64 || ''), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// Streams: bytes of a word least significant first.
const streams = {};
for (const s of D.streams) {
  s.raw = bytesOf(s.data);
  delete s.data;
  s.by = {};
  for (const f of s.fields) s.by[f.name] = f;
  streams[s.name] = s;
}

function bits(s, n, lsb, width) {
  let value = 0n;
  for (let i = ((lsb + width - 1) >> 3); i >= lsb >> 3; --i) value = value << 8n | BigInt(s.raw[n * s.bytes + i] || 0);
  return value >> BigInt(lsb & 7) & (1n << BigInt(width)) - 1n;
}
// Fields that decide something are below 2^32: plain numbers, as there are millions of them.
function num(s, n, f, lane = 0) {
  const lsb = f.lsb + lane * f.width, at = n * s.bytes + (lsb >> 3);
  let value = 0;
  for (let i = (lsb + f.width - 1 >> 3) - (lsb >> 3); i >= 0; --i) value = value * 256 + s.raw[at + i];
  return Math.floor(value / 2 ** (lsb & 7)) % 2 ** f.width;
}
function shown(s, n, f, lane, from) {
  const raw = from !== undefined ? from >> BigInt(f.lsb + lane * f.width) & (1n << BigInt(f.width)) - 1n
                                 : bits(s, n, f.lsb + lane * f.width, f.width);
  const counted = f.width <= 4 || /index|^[xy]|last/.test(f.name);
  if (!f.signed && f.fraction === 0) return counted ? String(raw) : '0x' + raw.toString(16);
  const value = f.signed ? BigInt.asIntN(f.width, raw) : raw;
  return String(Number((Number(value) / 2 ** f.fraction).toPrecision(9)));
}
function counts(s, n, f, lane) {
  return (f.valid_if || '').split(' ').filter(c => c && !c.includes('.')).every(c => {
    const flag = s.by[c.replace('!', '')];
    return !flag || (num(s, n, flag, flag.count > 1 ? lane : 0) === 0) === c.startsWith('!');
  });
}

// Where words are: by stamp or pixel, and by triangle.
const stampKey = (x, y) => y * SX + x;
for (const s of D.streams) {
  const {x, y, index} = s.by;
  s.at = new Map(), s.of = new Map();
  const add = (map, key, n) => map.has(key) ? map.get(key).push(n) : map.set(key, [n]);
  s.placed = x && y && x.count === 1 && (x.unit === 'stamps' || s.name === 'motion') && s.name !== 'triangle_depth';
  s.pixels = s.placed && x.unit === 'pixels';
  for (let n = 0; n < s.words; ++n) {
    if (s.placed) add(s.at, s.pixels ? num(s, n, y) * W + num(s, n, x) : stampKey(num(s, n, x), num(s, n, y)), n);
    if (index && index.count === 1) add(s.of, num(s, n, index), n);
  }
}
const laneOf = (px, py) => (py % LY) * LX + px % LX;
function wordsAt(s, px, py) {
  const found = s.at.get(s.pixels ? py * W + px : stampKey(Math.floor(px / LX), Math.floor(py / LY))) || [];
  return s.by.mask ? found.filter(n => num(s, n, s.by.mask, laneOf(px, py))) : found;
}

// The kernels' frame, from the words.
const colourStream = streams.pixel || streams.entry || null;
const hls = {index: new Uint32Array(W * H), depth: new Float64Array(W * H).fill(-1),
             rgb: new Uint8ClampedArray(W * H * 4)};
function eachPixel(s, n, put) {
  const x = num(s, n, s.by.x) * LX, y = num(s, n, s.by.y) * LY;
  for (let lane = 0; lane < LX * LY; ++lane) {
    const px = x + lane % LX, py = y + Math.floor(lane / LX);
    if (px < W && py < H) put(py * W + px, lane);
  }
}
for (let n = 0; n < (streams.scan ? streams.scan.words : 0); ++n) {
  eachPixel(streams.scan, n, (at, lane) => { hls.index[at] = num(streams.scan, n, streams.scan.by.index, lane); });
}
const update = streams.update;
for (let n = 0; update && update.by.depth && n < update.words; ++n) {
  eachPixel(update, n, (at, lane) => {
    if (num(update, n, update.by.mask, lane)) hls.depth[at] = num(update, n, update.by.depth, lane);
  });
}
for (let n = 0; colourStream && n < colourStream.words; ++n) {
  const s = colourStream, full = 2 ** s.by.r.width - 1;
  eachPixel(s, n, (at, lane) => {
    ['r', 'g', 'b'].forEach((c, i) => { hls.rgb[4 * at + i] = Math.round(num(s, n, s.by[c], lane) * 255 / full); });
    hls.rgb[4 * at + 3] = 255;
  });
}
let ref = null;
if (D.reference) {
  const u32 = text => new Uint32Array(bytesOf(text).buffer);
  ref = {index: u32(D.reference.index), depth: Float64Array.from(u32(D.reference.depth)),
         rgb: new Uint8ClampedArray(bytesOf(D.reference.rgba).buffer)};
  for (let i = 0; i < W * H; ++i) if (ref.index[i] === 0) ref.depth[i] = -1;
}
