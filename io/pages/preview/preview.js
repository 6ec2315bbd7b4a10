// The page of a preview: it follows what the program says, and says what the user wishes.

const $ = id => document.getElementById(id);
const screen_ = new Screen($('screen'));
const state = {shown: 0, picture: null, stops: 0, camera: '', choosesRegion: false, size: [0, 0]};
const pause = ms => new Promise(done => setTimeout(done, ms));

async function wish(values) {
  const answer = await fetch('wish?' + new URLSearchParams(values), {method: 'POST'});
  if (!answer.ok) tellError(await answer.text());
}

// Wishes that come faster than they can be answered are added up, and sent a few times a second.
const moves = {yaw: 0, pitch: 0, closer: 1};
let moving = null;
function move(yaw, pitch, closer) {
  moves.yaw += yaw;
  moves.pitch += pitch;
  moves.closer *= closer;
  moving ??= setTimeout(() => {
    moving = null;
    wish({...moves});
    Object.assign(moves, {yaw: 0, pitch: 0, closer: 1});
  }, 80);
}

async function fetchPicture() {
  const bytes = await (await fetch('picture')).arrayBuffer();
  const [number, frameWidth, frameHeight, x0, y0, x1, y1, channels] = new Int32Array(bytes, 0, 8);
  state.picture = {number, frameWidth, frameHeight, x0, y0, width: x1 - x0, height: y1 - y0, channels, values: new Float32Array(bytes, 32)};
  state.shown = number;
  repaint();
}

function repaint() {
  const {picture, stops} = state;
  if (!picture) return;
  const {width, height, values, channels, frameWidth, frameHeight, x0, y0} = picture;
  let part;
  if (channels === 3) {
    part = screen_.paintColors(values, width, height, stops);
  } else {
    let low = Infinity, high = -Infinity;
    for (const v of values)
      if (Math.abs(v) < 1e9) { low = Math.min(low, v); high = Math.max(high, v); }
    part = screen_.paintFalse(values, width, height, low, high);
  }
  const frame = new OffscreenCanvas(frameWidth, frameHeight);
  frame.getContext('2d', screen_.options).drawImage(part, x0, y0);
  screen_.images = [frame, null];
  screen_.setSize(frameWidth, frameHeight);
  screen_.draw();
  document.body.dataset.picture = picture.number;
}

const clock = seconds => seconds < 60 ? `${seconds.toFixed(1)} s` : `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;

function tell(status) {
  $('title').textContent = status.title || 'abbe preview';
  document.title = `${status.title} – abbe preview`;
  state.camera = status.camera;
  state.size = [status.width, status.height];
  const words = [{reading: 'reading', coarse: 'coarse picture', rendering: 'rendering', done: 'done', error: 'not rendered'}[status.state]];
  if (status.state === 'rendering' || status.state === 'done') {
    words.push(`${+status.samples.toFixed(1)} samples a pixel`);
    words.push(status.noise === null ? 'noise not known yet' : `noise ${(100 * status.noise).toPrecision(2)} %`);
    words.push(`${(status.raysPerSecond / 1e6).toFixed(2)} million rays/s`);
    words.push(`first picture after ${status.firstPicture.toFixed(2)} s`);
    words.push(status.state === 'done' ? `in ${clock(status.seconds)}` : `${clock(status.left)} left`);
  }
  $('told').textContent = words.join(' · ');
  $('progress').value = status.state === 'done' ? 1 : status.fraction;
  tellError(status.error);
  $('warnings').hidden = !status.warnings;
  $('warnings').textContent = status.warnings;
  if (!$('camera-box').hidden) $('camera').textContent = state.camera;
  document.body.dataset.state = status.state;
  document.body.dataset.renderings = status.renderings;
  document.body.dataset.latest = status.picture;
}

// A mistake of the scene, its place first. The last good picture stays.
function tellError(text) {
  const [, place, rest] = /^(.*?:\d+:\d+): ([^]*)$/.exec(text) ?? [null, '', text];
  $('error').hidden = !text;
  $('error-place').textContent = place;
  $('error-text').textContent = rest;
}

async function follow() {
  for (let seen = -1;;) {
    try {
      const status = await (await fetch(`status?seen=${seen}`)).json();
      seen = status.version;
      tell(status);
      if (status.picture !== state.shown) await fetchPicture();
      await pause(30);
    } catch {
      $('told').textContent = 'The program has ended, or cannot be reached.';
      document.body.dataset.state = 'lost';
      await pause(1000);
    }
  }
}

function setExposure(stops) {
  state.stops = Math.max(-10, Math.min(10, stops));
  $('exposure').value = state.stops;
  $('exposure-stops').textContent = `${state.stops > 0 ? '+' : ''}${state.stops} EV`;
  repaint();
}

// The place of an event in the frame, from 0 to 1.
function within(event) {
  const [x, y] = screen_.point(event);
  return [(x - screen_.left) / (screen_.zoom * screen_.width), (y - screen_.top) / (screen_.zoom * screen_.height)];
}
const isWithin = at => at.every(v => v >= 0 && v <= 1);

// The region between two places, in pixels of the frame that is wished.
function sendRegion(a, b) {
  const [width, height] = state.size.map(v => Math.max(1, Math.round(v * $('size').value)));
  const edge = (v, length) => Math.max(0, Math.min(length, v * length));
  const x0 = Math.floor(edge(Math.min(a[0], b[0]), width)), x1 = Math.ceil(edge(Math.max(a[0], b[0]), width));
  const y0 = Math.floor(edge(Math.min(a[1], b[1]), height)), y1 = Math.ceil(edge(Math.max(a[1], b[1]), height));
  if (x1 > x0 && y1 > y0) setRegion(`${x0},${y0},${x1},${y1}`);
}
function setRegion(crop) {
  state.choosesRegion = false;
  $('region').setAttribute('aria-pressed', false);
  $('whole').hidden = !crop;
  wish({crop});
}

function listenToPointer(canvas) {
  let begun = null; // {at, last, moved}
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    begun = {at: within(event), last: [event.clientX, event.clientY], moved: false};
  });
  canvas.addEventListener('pointermove', event => {
    if (!begun) return;
    const dx = event.clientX - begun.last[0], dy = event.clientY - begun.last[1];
    if (!begun.moved && Math.hypot(dx, dy) < 4) return;
    begun.moved = true;
    begun.last = [event.clientX, event.clientY];
    if (!state.choosesRegion) return move(0.008 * dx, 0.008 * dy, 1);
    const at = within(event), w = screen_.width, h = screen_.height;
    screen_.marks = [{x0: Math.min(at[0], begun.at[0]) * w, y0: Math.min(at[1], begun.at[1]) * h,
                      x1: Math.max(at[0], begun.at[0]) * w, y1: Math.max(at[1], begun.at[1]) * h, color: '#7db7f5'}];
    screen_.draw();
  });
  canvas.addEventListener('pointerup', event => {
    if (!begun) return;
    const {at, moved} = begun;
    begun = null;
    screen_.marks = [];
    if (state.choosesRegion && moved) sendRegion(at, within(event));
    else if (!moved && isWithin(at)) wish({'focus-x': at[0], 'focus-y': at[1]});
  });
  canvas.addEventListener('pointercancel', () => { begun = null; });
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    move(0, 0, 1.1 ** Math.sign(event.deltaY));
  }, {passive: false});
}

function listenToKeys(canvas) {
  const step = Math.PI / 36, keys = {
    ArrowLeft: () => move(-step, 0, 1), ArrowRight: () => move(step, 0, 1),
    ArrowUp: () => move(0, -step, 1), ArrowDown: () => move(0, step, 1),
    '+': () => move(0, 0, 1 / 1.1), '=': () => move(0, 0, 1 / 1.1), '-': () => move(0, 0, 1.1),
    'f': () => wish({'focus-x': 0.5, 'focus-y': 0.5}),
    '[': () => setExposure(state.stops - 0.5), ']': () => setExposure(state.stops + 0.5),
  };
  canvas.addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
    keys[event.key]();
    event.preventDefault();
  });
}

async function copyCamera() {
  $('camera-box').hidden = false;
  $('camera').textContent = state.camera;
  try {
    await navigator.clipboard.writeText(state.camera);
    $('copied').textContent = 'copied: put these lines in the place of the old ones';
  } catch {
    $('copied').textContent = 'copy these lines and put them in the place of the old ones';
  }
}

$('exposure').oninput = () => setExposure(+$('exposure').value);
$('size').onchange = () => {
  const scaled = state.size.map(v => Math.max(1, Math.round(v * $('size').value)));
  $('whole').hidden = true; // a region is in pixels of the old size
  wish({size: $('size').value === '1' ? '' : scaled.join('x'), crop: ''});
};
$('integrator').onchange = () => wish({integrator: $('integrator').value});
$('layer').onchange = () => wish({layer: $('layer').value});
$('aperture').onchange = () => wish({aperture: $('aperture').value});
$('region').onclick = () => {
  state.choosesRegion = !state.choosesRegion;
  $('region').setAttribute('aria-pressed', state.choosesRegion);
};
$('whole').onclick = () => setRegion('');
$('own-camera').onclick = () => {
  $('aperture').value = '';
  wish({'scene-camera': 1});
};
$('lines').onclick = copyCamera;
listenToPointer($('screen'));
listenToKeys($('screen'));
new ResizeObserver(() => screen_.fit()).observe($('screen-box'));
follow();
