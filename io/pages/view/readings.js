// What is told of a pixel or a region, as text.

const digits = (values, count) => values.map(v => v.toFixed(count)).join('  ');

function dominantText(dominant) {
  if (!dominant) return '-';
  const {nm, purity, complementary} = dominant;
  return `${nm.toFixed(2)} nm${complementary ? ' (complementary)' : ''}, purity ${purity.toFixed(4)}`;
}

// Rows [name, text] for a reading {xyz, error}.
function factsOf(reading, locus) {
  const {xyz} = reading, xy = xyOf(xyz);
  const rows = [
    ['X Y Z', digits(xyz, 6)],
    ['x y', xy ? digits(xy, 5) : '-'],
    ['L* a* b*', digits(labOf(xyz), 3)],
    ['linear sRGB', digits(multiply(XYZ_TO_SRGB, xyz), 5)],
    ['dominant wavelength', xy ? dominantText(dominantWavelength(xy, locus)) : '-'],
  ];
  if (reading.errorY !== null && reading.errorY !== undefined)
    rows.splice(1, 0, ['standard error of Y', `± ${reading.errorY.toPrecision(3)}`]);
  if (reading.errorRgb)
    rows.splice(rows.length - 1, 0, ['its standard error', `± ${reading.errorRgb.map(v => v.toPrecision(2)).join('  ')}`]);
  return rows;
}

// Reads what is chosen: {x, y} of a pixel, or {x0, y0, x1, y1} of a region.
async function read(picture, place) {
  if ('x0' in place) return {...await picture.region(place), place};
  const {x, y} = place, spectrum = await picture.spectrum(x, y);
  const reading = {place, spectrum, xyz: picture.xyz(spectrum, x, y), count: 1};
  reading.errorY = await picture.valueAt('error.Y', x, y);
  const variances = await Promise.all(['R', 'G', 'B'].map(c => picture.valueAt(`variance.${c}`, x, y)));
  if (variances[0] !== null) reading.errorRgb = variances.map(Math.sqrt);
  return reading;
}

function placeText(picture, place) {
  if ('x0' in place)
    return `Region ${place.x0 + picture.x0}, ${place.y0 + picture.y0} to ${place.x1 + picture.x0}, ${place.y1 + picture.y0}`;
  return `Pixel ${place.x + picture.x0}, ${place.y + picture.y0}`;
}

// Fills a table; the cells of each row are texts.
function fillTable(table, rows) {
  table.replaceChildren(...rows.map(cells => {
    const row = document.createElement('tr');
    row.append(...cells.map((text, i) => Object.assign(document.createElement(i === 0 ? 'th' : 'td'), {textContent: text})));
    return row;
  }));
}
