// Colours: from XYZ to what a screen shows and to what is told of them.

// Linear sRGB, D65 (IEC 61966-2-1): rows of the matrices that the program uses too.
const SRGB_PRIMARIES = [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06]];
const P3_PRIMARIES = [[0.68, 0.32], [0.265, 0.69], [0.15, 0.06]];
const WHITE = [0.3127, 0.329];

const multiply = (m, v) => m.map(row => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
const xyzOf = ([x, y], Y = 1) => [x / y * Y, Y, (1 - x - y) / y * Y];

function inverse(m) {
  const [[a, b, c], [d, e, f], [g, h, i]] = m;
  const det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  return [[e * i - f * h, c * h - b * i, b * f - c * e],
          [f * g - d * i, a * i - c * g, c * d - a * f],
          [d * h - e * g, b * g - a * h, a * e - b * d]].map(row => row.map(v => v / det));
}

// The matrix from linear RGB of these primaries, whose white is D65, to XYZ.
function rgbToXyz(primaries) {
  const columns = primaries.map(p => xyzOf(p));
  const rows = [0, 1, 2].map(k => columns.map(column => column[k]));
  const scale = multiply(inverse(rows), xyzOf(WHITE));
  return rows.map(row => row.map((v, k) => v * scale[k]));
}

const SRGB_TO_XYZ = rgbToXyz(SRGB_PRIMARIES);
const XYZ_TO_SRGB = inverse(SRGB_TO_XYZ);
const XYZ_TO_P3 = inverse(rgbToXyz(P3_PRIMARIES));
const SRGB_TO_P3 = XYZ_TO_P3.map(row => [0, 1, 2].map(
    k => row[0] * SRGB_TO_XYZ[0][k] + row[1] * SRGB_TO_XYZ[1][k] + row[2] * SRGB_TO_XYZ[2][k]));

// Codes of the transfer function of sRGB, which Display P3 has too, for light in steps of 1/4095.
const CODES = Uint8ClampedArray.from({length: 4096}, (_, i) => {
  const v = i / 4095;
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
});
// Darker light is looked up in finer steps, since the eye tells these apart.
const DARK_CODES = Uint8ClampedArray.from({length: 4096}, (_, i) => {
  const v = i / 4095 / 16;
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
});
function codeOf(light) {
  if (!(light > 0)) return 0;
  if (light >= 1) return 255;
  return light < 1 / 16 ? DARK_CODES[light * 16 * 4095 + 0.5 | 0] : CODES[light * 4095 + 0.5 | 0];
}

// Dark violet over blue and green to yellow.
const FALSE_COLORS = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142],
                      [31, 158, 137], [53, 183, 121], [109, 205, 89], [180, 222, 44], [253, 231, 37]];
const FALSE_TABLE = Array.from({length: 256}, (_, i) => {
  const at = i / 255 * (FALSE_COLORS.length - 1), k = Math.min(Math.floor(at), FALSE_COLORS.length - 2);
  return FALSE_COLORS[k].map((v, c) => Math.round(v + (at - k) * (FALSE_COLORS[k + 1][c] - v)));
});
const falseColor = part => FALSE_TABLE[Math.max(0, Math.min(255, Math.round(255 * part)))];

function xyOf([X, Y, Z]) {
  const sum = X + Y + Z;
  return sum > 0 ? [X / sum, Y / sum] : null;
}

function labOf(xyz) {
  const white = xyzOf(WHITE);
  const [x, y, z] = xyz.map((v, k) => {
    const ratio = v / white[k], delta = 6 / 29;
    return ratio > delta ** 3 ? Math.cbrt(ratio) : ratio / (3 * delta * delta) + 4 / 29;
  });
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

// The CIE's colour difference of the year 2000.
function deltaE([l1, a1, b1], [l2, a2, b2]) {
  const rad = Math.PI / 180, pow7 = v => v ** 7;
  const weight = c => Math.sqrt(pow7(c) / (pow7(c) + pow7(25)));
  const stretch = 1.5 - 0.5 * weight((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2);
  const c1 = Math.hypot(a1 * stretch, b1), c2 = Math.hypot(a2 * stretch, b2);
  const hue = (a, b) => (Math.atan2(b, a * stretch) + 2 * Math.PI) % (2 * Math.PI);
  const h1 = hue(a1, b1), h2 = hue(a2, b2);
  let dh = h2 - h1, mean = (h1 + h2) / 2;
  if (Math.abs(dh) > Math.PI) {
    mean += h1 + h2 < 2 * Math.PI ? Math.PI : -Math.PI;
    dh += dh > 0 ? -2 * Math.PI : 2 * Math.PI;
  }
  const chroma = (c1 + c2) / 2, l50 = ((l1 + l2) / 2 - 50) ** 2;
  const t = 1 - 0.17 * Math.cos(mean - 30 * rad) + 0.24 * Math.cos(2 * mean) +
            0.32 * Math.cos(3 * mean + 6 * rad) - 0.2 * Math.cos(4 * mean - 63 * rad);
  const l = (l2 - l1) / (1 + 0.015 * l50 / Math.sqrt(20 + l50));
  const c = (c2 - c1) / (1 + 0.045 * chroma);
  const h = 2 * Math.sqrt(c1 * c2) * Math.sin(dh / 2) / (1 + 0.015 * chroma * t);
  const blue = (mean - 275 * rad) / (25 * rad);
  const turn = -2 * weight(chroma) * Math.sin(60 * rad * Math.exp(-blue * blue));
  return Math.sqrt(l * l + c * c + h * h + turn * c * h);
}

// Where the ray from `origin` crosses the piece from `a` to `b`: how far along it, and along the piece.
function crossing(origin, direction, a, b) {
  const piece = [b[0] - a[0], b[1] - a[1]], to = [a[0] - origin[0], a[1] - origin[1]];
  const cross = (u, v) => u[0] * v[1] - u[1] * v[0];
  const det = cross(direction, piece);
  if (det === 0) return null;
  const ray = cross(to, piece) / det, along = cross(to, direction) / det;
  return ray > 0 && along >= 0 && along <= 1 ? {ray, along} : null;
}

// The dominant wavelength about D65: {nm, complementary, purity}, or null. `locus` are the
// chromaticities of single wavelengths, nm by nm from 380.
function dominantWavelength(xy, locus) {
  const direction = [xy[0] - WHITE[0], xy[1] - WHITE[1]];
  if (!(Math.hypot(...direction) >= 1e-6)) return null;
  const exit = way => {
    let farthest = null;
    for (let i = 0; i + 1 < locus.length; ++i) {
      const at = crossing(WHITE, way, locus[i], locus[i + 1]);
      if (at && (!farthest || at.ray > farthest.ray)) farthest = {nm: 380 + i + at.along, ray: at.ray};
    }
    return farthest;
  };
  const found = exit(direction);
  if (found) return {nm: found.nm, complementary: false, purity: 1 / found.ray};
  const purple = crossing(WHITE, direction, locus[locus.length - 1], locus[0]);
  const opposite = exit(direction.map(v => -v));
  return purple && opposite ? {nm: opposite.nm, complementary: true, purity: 1 / purple.ray} : null;
}
