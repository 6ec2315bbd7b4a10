// What the page does: state, controls, and what follows from them.

const $ = id => document.getElementById(id);
const index = JSON.parse($('index').textContent);
const locus = Array.from({length: index.locus.length / 3}, (_, i) => xyOf(index.locus.slice(3 * i, 3 * i + 3)));
const pictures = index.pictures.map((description, number) => new Picture(description, number));
const screen_ = new Screen($('screen'));

const state = {
  picture: pictures[0], layer: 'picture', band: 0, stops: 0, falseColor: false,
  other: null, compare: 'wipe', wipe: 0.5,
  place: null, pinned: null, // places that are read
  lights: new Lights(),
};

// Only the last of several repaints that wait for tiles is shown.
let repaints = 0;

// What is to be painted of a picture: {colors} or {values, low, high, unit}.
async function shown(picture) {
  await picture.load();
  if (state.layer === 'lights' && state.lights.parts.length > 0) return {colors: state.lights.sum()};
  if (state.layer === 'band' && picture.nm.length > 0) {
    const values = await picture.band(Math.min(state.band, picture.nm.length - 1));
    const scale = 2 ** state.stops;
    return state.falseColor ? {values} : {colors: greys(values), scale};
  }
  const channels = layersOf(picture).get(state.layer);
  if (!channels) return {colors: picture.colors};
  const values = await picture.channels(channels.map(channel => channel.place));
  if (channels.length === 1) return {values};
  if (channels.length === 3) return {colors: values};
  return {values: values.filter((_, i) => i % channels.length === 0)};
}

function greys(values) {
  const colors = new Float32Array(3 * values.length);
  for (let i = 0; i < values.length; ++i) colors[3 * i] = colors[3 * i + 1] = colors[3 * i + 2] = values[i];
  return colors;
}

// Luminance in stops, for false colours.
function stopsOf(colors) {
  const [r, g, b] = SRGB_TO_XYZ[1], stops = new Float32Array(colors.length / 3);
  for (let i = 0; i < stops.length; ++i)
    stops[i] = Math.log2(Math.max(r * colors[3 * i] + g * colors[3 * i + 1] + b * colors[3 * i + 2], 1e-30));
  return stops;
}

// The ends of a scale that leaves out numbers which stand for "nothing there".
function rangeOf(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values)
    if (Number.isFinite(v) && Math.abs(v) < 1e9) {
      low = Math.min(low, v);
      high = Math.max(high, v);
    }
  return low <= high ? [low, high] : [0, 1];
}

function painted(picture, {colors, values}) {
  const {width, height} = picture;
  if (values) {
    const [low, high] = rangeOf(values);
    tellScale(`false colours from ${low.toPrecision(4)} to ${high.toPrecision(4)}`);
    return screen_.paintFalse(values, width, height, low, high);
  }
  if (state.falseColor) {
    const low = -8 - state.stops, high = 2 - state.stops;
    tellScale(`false colours of Y, 2^${low} to 2^${high}`);
    return screen_.paintFalse(stopsOf(colors), width, height, low, high);
  }
  return screen_.paintColors(colors, width, height, state.stops);
}

const tellScale = text => { $('status').textContent = text; };

async function repaint() {
  const mine = ++repaints;
  $('status').textContent = '';
  const {picture, other} = state, same = other && other.width === picture.width && other.height === picture.height;
  const [first, second] = await Promise.all([shown(picture), same ? shown(other) : null]);
  if (mine !== repaints) return;
  screen_.setSize(picture.width, picture.height);
  screen_.wipe = null;
  if (same && state.compare === 'delta' && first.colors && second.colors) {
    screen_.images = [deltaMap(picture, first.colors, second.colors), null];
  } else {
    screen_.images = [painted(picture, first), same ? painted(other, second) : null];
    if (same) screen_.wipe = state.wipe;
  }
  if (other && !same) tellScale('the pictures differ in size');
  screen_.draw();
  document.body.dataset.painted = mine;
}

// CIEDE2000 of each pixel under D65 at Y = 1.
function deltaMap(picture, colors, others) {
  const lab = (values, i) => labOf(multiply(SRGB_TO_XYZ, [values[3 * i], values[3 * i + 1], values[3 * i + 2]]));
  const values = new Float32Array(colors.length / 3);
  let sum = 0, worst = 0;
  for (let i = 0; i < values.length; ++i) {
    values[i] = deltaE(lab(colors, i), lab(others, i));
    sum += values[i];
    worst = Math.max(worst, values[i]);
  }
  const most = 5 * 2 ** -state.stops;
  tellScale(`CIEDE2000: mean ${(sum / values.length).toFixed(3)}, largest ${worst.toFixed(2)}; yellow is ${+most.toPrecision(3)} and more`);
  return screen_.paintFalse(values, picture.width, picture.height, 0, most);
}

let readings = 0;
async function reread() {
  const mine = ++readings, {picture, place, pinned} = state;
  screen_.marks = [];
  const mark = (at, color) => screen_.marks.push('x0' in at ? {...at, color} : {x0: at.x, y0: at.y, x1: at.x + 1, y1: at.y + 1, color});
  if (pinned) mark(pinned, '#f2a06f');
  if (place) mark(place, '#7db7f5');
  screen_.draw();
  if (!place) return tellNothing();
  await picture.load();
  const [reading, other] = await Promise.all([read(picture, place), pinned ? read(picture, pinned) : null]);
  if (mine !== readings) return;
  const rows = factsOf(reading, locus);
  if (reading.count > 1) rows.unshift(['pixels', `${reading.count}; means`]);
  if (other) {
    factsOf(other, locus).forEach(([name, text]) => rows.find(row => row[0] === name)?.push(text));
    rows.push(['CIEDE2000', deltaE(labOf(reading.xyz), labOf(other.xyz)).toFixed(4)]);
  }
  $('place').textContent = placeText(picture, place) + (other ? `, beside ${placeText(picture, pinned).toLowerCase()}` : '');
  fillTable($('facts'), rows);
  tellSpectrum(picture, reading, other);
  drawDiagram($('diagram'), locus, [{xy: other && xyOf(other.xyz), color: inkOf('--other')}, {xy: xyOf(reading.xyz), color: inkOf('--accent')}]);
  document.body.dataset.read = mine;
}

function tellNothing() {
  $('place').textContent = 'No pixel is chosen';
  fillTable($('facts'), []);
  fillTable($('numbers'), []);
  drawSpectrum($('spectrum'), [], [], null);
  drawDiagram($('diagram'), locus, []);
}

function tellSpectrum(picture, reading, other) {
  $('spectrum-box').hidden = picture.nm.length === 0;
  if (picture.nm.length === 0) return;
  const curves = [{values: reading.spectrum, errors: reading.deviations, color: inkOf('--accent')}];
  if (other) curves.unshift({values: other.spectrum, errors: other.deviations, color: inkOf('--other')});
  drawSpectrum($('spectrum'), picture.nm, curves, state.layer === 'band' ? picture.nm[state.band] : null);
  $('spectrum-note').textContent = reading.deviations ? 'Bars: standard deviations of the pixels of the region.' : '';
  const number = v => v.toPrecision(6);
  fillTable($('numbers'), [['nm', 'value per nm', ...(reading.deviations ? ['deviation'] : []), ...(other ? ['other'] : [])],
    ...picture.nm.map((nm, b) => [nm.toFixed(3), number(reading.spectrum[b]),
      ...(reading.deviations ? [number(reading.deviations[b])] : []), ...(other ? [number(other.spectrum[b])] : [])])]);
}

function fillSelect(select, options, value) {
  select.replaceChildren(...options.map(([key, text]) => Object.assign(document.createElement('option'), {value: key, textContent: text})));
  select.value = value;
}

// Brings the controls to the picture that is chosen.
async function choose(picture) {
  state.picture = picture;
  state.place = state.place && picture.holds(state.place.x1 ?? state.place.x, state.place.y1 ?? state.place.y) ? state.place : null;
  state.lights = await Lights.of(picture, pictures);
  const layers = [['picture', 'the picture']];
  if (picture.nm.length > 0) layers.push(['band', 'one wavelength']);
  if (state.lights.parts.length > 0) layers.push(['lights', 'lights as set']);
  for (const name of layersOf(picture).keys()) layers.push([name, name]);
  if (!layers.some(([key]) => key === state.layer)) state.layer = 'picture';
  fillSelect($('layer'), layers, state.layer);
  $('band').max = Math.max(0, picture.nm.length - 1);
  $('lights-box').hidden = state.lights.parts.length === 0;
  state.lights.show($('lights'), relight);
  tellControls();
  await Promise.all([repaint(), reread()]);
}

function relight() {
  state.layer = $('layer').value = 'lights';
  tellControls();
  repaint();
}

function tellControls() {
  const {picture} = state, band = Math.min(state.band, picture.nm.length - 1);
  $('band-box').hidden = picture.nm.length === 0;
  $('band-nm').textContent = picture.nm.length > 0 ? `${+picture.nm[band].toFixed(2)} nm` : '';
  $('band').value = band;
  $('exposure').value = state.stops;
  $('exposure-stops').textContent = `${state.stops > 0 ? '+' : ''}${state.stops} EV`;
  $('false-color').setAttribute('aria-pressed', state.falseColor);
  $('other-box').hidden = pictures.length < 2;
  $('compare-box').hidden = !state.other;
  $('wipe-box').hidden = !state.other || state.compare !== 'wipe';
  $('title').textContent = picture.name;
  $('note').textContent = `${picture.width} × ${picture.height}` + (picture.nm.length > 0
    ? `, ${picture.nm.length} bands; values of bands are kept with an error of at most ${(100 * index.bandError).toPrecision(2)} % of the range of their pixel` : '');
}
