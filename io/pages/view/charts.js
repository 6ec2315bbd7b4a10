// The two charts: a spectrum, and the chromaticity diagram.

const inkOf = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// A canvas made as sharp as the screen is, with its context scaled to CSS pixels.
function chartOf(canvas) {
  const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  Object.assign(canvas, {width: Math.round(width * ratio), height: Math.round(height * ratio)});
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  context.font = '12px system-ui, sans-serif';
  return {context, width, height};
}

// A round step that parts a range into some five.
function roundStep(range) {
  const rough = range / 5, power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find(step => step * power >= rough);
}

// `curves`: [{values, errors, color}], errors may be missing. `marked` is a wavelength.
function drawSpectrum(canvas, nm, curves, marked) {
  const {context, width, height} = chartOf(canvas);
  if (nm.length === 0) return;
  const left = 52, right = width - 8, top = 8, bottom = height - 22;
  const all = curves.flatMap(curve => curve.values.map((v, b) => v + (curve.errors?.[b] ?? 0))).filter(Number.isFinite);
  const most = Math.max(...all, 0) || 1, least = Math.min(...all, 0);
  const first = nm[0], last = nm.length > 1 ? nm.at(-1) : first + 1;
  const atX = v => left + (v - first) / (last - first) * (right - left);
  const atY = v => bottom - (v - least) / (most - least) * (bottom - top);
  context.strokeStyle = inkOf('--line');
  context.fillStyle = inkOf('--faint');
  context.lineWidth = 1;
  const step = roundStep(most - least);
  context.textAlign = 'right';
  for (let k = Math.ceil(least / step); k * step <= most; ++k) {
    context.beginPath();
    context.moveTo(left, atY(k * step));
    context.lineTo(right, atY(k * step));
    context.stroke();
    context.fillText(String(+(k * step).toPrecision(3)), left - 5, atY(k * step) + 4);
  }
  context.textAlign = 'center';
  for (let v = Math.ceil(first / 50) * 50; v <= last; v += 50) {
    context.beginPath();
    context.moveTo(atX(v), bottom);
    context.lineTo(atX(v), bottom + 4);
    context.stroke();
    if (v % 100 === 0) context.fillText(`${v} nm`, atX(v), bottom + 17);
  }
  if (marked !== null) {
    context.beginPath();
    context.setLineDash([4, 3]);
    context.moveTo(atX(marked), top);
    context.lineTo(atX(marked), bottom);
    context.stroke();
    context.setLineDash([]);
  }
  for (const {values, errors, color} of curves) {
    context.strokeStyle = color;
    context.lineWidth = 1;
    if (errors) {
      context.beginPath();
      values.forEach((v, b) => {
        context.moveTo(atX(nm[b]), atY(v - errors[b]));
        context.lineTo(atX(nm[b]), atY(v + errors[b]));
      });
      context.stroke();
    }
    context.lineWidth = 2;
    context.beginPath();
    values.forEach((v, b) => context.lineTo(atX(nm[b]), atY(v)));
    context.stroke();
  }
}

// `points`: [{xy, color}]; `locus`: chromaticities nm by nm from 380.
function drawDiagram(canvas, locus, points) {
  const {context, width, height} = chartOf(canvas);
  const scale = Math.min((width - 40) / 0.8, (height - 30) / 0.9);
  const left = (width - 0.8 * scale) / 2 + 12, bottom = height - 20;
  const at = ([x, y]) => [left + x * scale, bottom - y * scale];
  const line = path => {
    context.beginPath();
    path.forEach(p => context.lineTo(...at(p)));
    context.closePath();
  };
  // The colours, as bright as the screen can show each; those that it cannot are cut.
  context.save();
  line(locus);
  context.clip();
  const cell = 3;
  for (let px = left; px < left + 0.8 * scale; px += cell)
    for (let py = bottom - 0.9 * scale; py < bottom; py += cell) {
      const x = (px + cell / 2 - left) / scale, y = (bottom - py - cell / 2) / scale;
      if (y <= 0) continue;
      const rgb = multiply(XYZ_TO_SRGB, [x / y, 1, (1 - x - y) / y]).map(v => Math.max(v, 0));
      const most = Math.max(...rgb);
      context.fillStyle = `rgb(${rgb.map(v => codeOf(v / most)).join()})`;
      context.fillRect(px, py, cell + 0.5, cell + 0.5);
    }
  context.restore();
  context.strokeStyle = inkOf('--ink');
  context.lineWidth = 1;
  line(locus);
  context.stroke();
  const wide = matchMedia('(color-gamut: p3)').matches;
  context.strokeStyle = '#000';
  line(wide ? P3_PRIMARIES : SRGB_PRIMARIES);
  context.stroke();
  context.fillStyle = inkOf('--faint');
  context.textAlign = 'center';
  for (let v = 0; v <= 0.8001; v += 0.2) {
    context.fillText(v.toFixed(1), at([v, 0])[0], bottom + 15);
    if (v > 0) context.fillText(v.toFixed(1), left - 14, at([0, v])[1] + 4);
  }
  context.textAlign = 'left';
  context.fillText(`triangle: ${wide ? 'Display P3' : 'sRGB'}`, left + 0.45 * scale, bottom - 0.84 * scale);
  for (const nm of [460, 480, 500, 520, 540, 560, 580, 600, 620]) {
    const [x, y] = at(locus[nm - 380]);
    context.textAlign = nm < 520 ? 'right' : 'left';
    context.fillText(nm, x + (nm < 520 ? -4 : 4), y - (nm === 520 ? 4 : 0));
  }
  for (const {xy, color} of points) {
    if (!xy) continue;
    const [x, y] = at(xy);
    context.beginPath();
    context.arc(x, y, 5, 0, 2 * Math.PI);
    context.lineWidth = 4;
    context.strokeStyle = '#fff';
    context.stroke();
    context.lineWidth = 2.5;
    context.strokeStyle = color;
    context.stroke();
  }
}
