// Pointer, keys and controls; then the page begins.

function setPlace(place) {
  state.place = place;
  reread();
}

function zoomKeepsPlace(factor) {
  const {place} = state;
  if (!place || 'x0' in place) return screen_.zoomTo(screen_.zoom * factor);
  screen_.zoomTo(screen_.zoom * factor, screen_.left + (place.x + 0.5) * screen_.zoom, screen_.top + (place.y + 0.5) * screen_.zoom);
}

// A click reads a pixel, a drag a region; Shift or a second finger moves the picture.
function listenToPointer(canvas) {
  const fingers = new Map();
  let begun = null; // {point, pixel, moved, moves}
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, screen_.point(event));
    begun = {point: screen_.point(event), pixel: screen_.pixel(screen_.point(event)), moved: false,
             moves: event.shiftKey || event.button === 1 || fingers.size > 1};
  });
  canvas.addEventListener('pointermove', event => {
    if (!begun || !fingers.has(event.pointerId)) return;
    const point = screen_.point(event), before = fingers.get(event.pointerId);
    if (fingers.size === 2) {
      const [still] = [...fingers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      const spread = at => Math.hypot(at[0] - still[0], at[1] - still[1]);
      screen_.move((point[0] - before[0]) / 2, (point[1] - before[1]) / 2);
      screen_.zoomTo(screen_.zoom * spread(point) / Math.max(spread(before), 1), ...still);
    } else if (begun.moves) {
      screen_.move(point[0] - before[0], point[1] - before[1]);
    }
    fingers.set(event.pointerId, point);
    begun.moved ||= Math.hypot(point[0] - begun.point[0], point[1] - begun.point[1]) > 4;
    if (begun.moves || !begun.moved) return;
    const region = regionOf(begun.pixel, screen_.pixel(point));
    screen_.marks = region ? [{...region, color: '#7db7f5'}] : [];
    screen_.draw();
  });
  const end = event => {
    if (!fingers.delete(event.pointerId) || !begun || fingers.size > 0) return;
    const {pixel, moved, moves} = begun;
    begun = null;
    if (moves || event.type === 'pointercancel') return;
    if (moved) setPlace(regionOf(pixel, screen_.pixel(screen_.point(event))));
    else if (state.picture.holds(pixel.x, pixel.y)) setPlace(pixel);
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    screen_.zoomTo(screen_.zoom * 1.2 ** -Math.sign(event.deltaY), ...screen_.point(event));
  }, {passive: false});
}

// The region between two pixels, both included, as far as the picture goes; null where it holds none.
function regionOf(a, b) {
  const {width, height} = state.picture;
  const region = {x0: Math.max(0, Math.min(a.x, b.x)), y0: Math.max(0, Math.min(a.y, b.y)),
                  x1: Math.min(width, Math.max(a.x, b.x) + 1), y1: Math.min(height, Math.max(a.y, b.y) + 1)};
  return region.x0 < region.x1 && region.y0 < region.y1 ? region : null;
}

function moveBy(dx, dy) {
  const {width, height} = state.picture, {place} = state;
  const from = !place ? {x: width >> 1, y: height >> 1} : 'x0' in place ? {x: place.x0, y: place.y0} : place;
  const step = place ? 1 : 0; // the first press chooses the middle
  setPlace({x: Math.max(0, Math.min(width - 1, from.x + step * dx)), y: Math.max(0, Math.min(height - 1, from.y + step * dy))});
}

function setExposure(stops) {
  state.stops = Math.max(-10, Math.min(10, stops));
  tellControls();
  repaint();
}

function setBand(band) {
  if (state.picture.nm.length === 0) return;
  state.band = Math.max(0, Math.min(state.picture.nm.length - 1, band));
  state.layer = $('layer').value = 'band';
  tellControls();
  repaint();
  if (state.place) reread();
}

function togglePin() {
  state.pinned = state.pinned ? null : state.place;
  $('pin').textContent = state.pinned ? 'Compare no longer' : 'Compare with this pixel';
  reread();
}

function listenToKeys(canvas) {
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  const keys = {
    '+': () => zoomKeepsPlace(1.5), '=': () => zoomKeepsPlace(1.5), '-': () => zoomKeepsPlace(1 / 1.5),
    '0': () => screen_.fit(), '1': () => screen_.zoomTo(1),
    '[': () => setExposure(state.stops - 0.5), ']': () => setExposure(state.stops + 0.5),
    ',': () => setBand(state.band - 1), '.': () => setBand(state.band + 1),
    'c': () => state.place && togglePin(), 'Escape': () => state.pinned && togglePin(),
  };
  canvas.addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const arrow = arrows[event.key], step = event.shiftKey ? 10 : 1;
    if (arrow) moveBy(arrow[0] * step, arrow[1] * step);
    else if (keys[event.key]) keys[event.key]();
    else return;
    event.preventDefault();
  });
}

function listenToControls() {
  $('picture').onchange = () => choose(pictures[+$('picture').value]);
  $('layer').onchange = () => { state.layer = $('layer').value; repaint(); if (state.place) reread(); };
  $('band').oninput = () => setBand(+$('band').value);
  $('exposure').oninput = () => setExposure(+$('exposure').value);
  $('false-color').onclick = () => { state.falseColor = !state.falseColor; tellControls(); repaint(); };
  $('zoom-in').onclick = () => zoomKeepsPlace(1.5);
  $('zoom-out').onclick = () => zoomKeepsPlace(1 / 1.5);
  $('zoom-fit').onclick = () => screen_.fit();
  $('zoom-one').onclick = () => screen_.zoomTo(1);
  $('other').onchange = () => { state.other = pictures[+$('other').value] ?? null; tellControls(); repaint(); };
  $('compare').onchange = () => { state.compare = $('compare').value; tellControls(); repaint(); };
  $('wipe').oninput = () => { state.wipe = +$('wipe').value; if (screen_.wipe !== null) screen_.wipe = state.wipe; screen_.draw(); };
  $('pin').onclick = () => state.place && togglePin();
  $('lights-reset').onclick = () => {
    state.lights.reset();
    state.lights.show($('lights'), relight);
    relight();
  };
}

async function begin() {
  const begun = performance.now(), names = pictures.map((picture, i) => [String(i), picture.name]);
  fillSelect($('picture'), names, '0');
  fillSelect($('other'), [['none', 'nothing'], ...names], 'none');
  listenToPointer($('screen'));
  listenToKeys($('screen'));
  listenToControls();
  new ResizeObserver(() => screen_.fit()).observe($('screen-box'));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', reread);
  await choose(pictures[0]);
  document.body.dataset.ready = Math.round(performance.now() - begun);
}

begin().catch(error => { $('status').textContent = `The page failed: ${error.message}`; throw error; });
