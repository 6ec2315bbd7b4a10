// A picture of the page: its colours at once, all else tile by tile when it is asked for.

const KEPT_TILES = 12; // whose spectra stay in memory

class Picture {
  constructor(description, number) {
    Object.assign(this, description, {number});
    this.tiles = this.lengths.map((lengths, i) => new Tile(this, i, lengths));
    this.most = 2 ** this.bits - 1;
    this.recent = [];
    this.colors = null; // linear sRGB, three values a pixel
  }

  // Fills an image of `channels` values a pixel from what `planesOf` gives for each tile.
  async assemble(channels, planesOf) {
    const image = new Float32Array(this.width * this.height * channels);
    await Promise.all(this.tiles.map(async tile => {
      const planes = await planesOf(tile);
      for (let y = 0, i = 0; y < tile.height; ++y) {
        let to = ((tile.y + y) * this.width + tile.x) * channels;
        for (let x = 0; x < tile.width; ++x, ++i)
          for (let k = 0; k < channels; ++k) image[to++] = planes[k][i];
      }
    }));
    return image;
  }
  async load() {
    this.colors ??= await this.assemble(3, tile => tile.colors());
    return this;
  }
  // The values of one band, one a pixel.
  band(number) {
    return this.assemble(1, async tile => {
      const [codes, [low, high]] = await Promise.all([tile.codes(number), tile.ranges()]);
      return [Float32Array.from(codes, (code, i) => low[i] + code / this.most * (high[i] - low[i]))];
    });
  }
  // Channels of layers, by their places in `layers`.
  channels(places) {
    return this.assemble(places.length, tile => Promise.all(places.map(place => tile.layer(place))));
  }

  // A layer's values at a pixel; null where the picture has no such channel.
  async valueAt(channel, x, y) {
    const place = this.layers.indexOf(channel);
    if (place < 0) return null;
    const tile = this.tileAt(x, y);
    return (await tile.layer(place))[(y - tile.y) * tile.width + x - tile.x];
  }
  tileAt(x, y) {
    const columns = Math.ceil(this.width / this.tileSize);
    return this.tiles[Math.floor(y / this.tileSize) * columns + Math.floor(x / this.tileSize)];
  }
  holds(x, y) {
    return x >= 0 && y >= 0 && x < this.width && y < this.height;
  }

  // The tile with its spectra in memory, where the last few are kept.
  async opened(tile) {
    this.recent = [tile, ...this.recent.filter(other => other !== tile)];
    for (const old of this.recent.splice(KEPT_TILES)) old.forget();
    const [codes, [low, high]] = await Promise.all([tile.allCodes(), tile.ranges()]);
    return {codes, low, high};
  }
  // The values of all bands at a pixel; empty for a picture without bands.
  async spectrum(x, y) {
    if (this.nm.length === 0) return [];
    const tile = this.tileAt(x, y), i = (y - tile.y) * tile.width + x - tile.x;
    const {codes, low, high} = await this.opened(tile);
    return codes.map(band => low[i] + band[i] / this.most * (high[i] - low[i]));
  }
  // XYZ of a spectrum, or where the picture has no bands of the pixel.
  xyz(spectrum, x, y) {
    if (spectrum.length === 0) {
      const at = 3 * (y * this.width + x);
      return multiply(SRGB_TO_XYZ, this.colors.subarray(at, at + 3));
    }
    return [0, 1, 2].map(k => spectrum.reduce((sum, v, b) => sum + v * this.bandColors[3 * b + k], 0));
  }
  // Means over a region, and the standard deviations of its pixels. Its right and lower edges are
  // the first column and row outside.
  async region({x0, y0, x1, y1}) {
    const bands = this.nm.length, sum = new Float64Array(bands), squares = new Float64Array(bands);
    const color = [0, 0, 0];
    let count = 0;
    for (const tile of this.tiles) {
      const left = Math.max(x0, tile.x), right = Math.min(x1, tile.x + tile.width);
      const top = Math.max(y0, tile.y), bottom = Math.min(y1, tile.y + tile.height);
      if (left >= right || top >= bottom) continue;
      const opened = bands > 0 ? await this.opened(tile) : null;
      for (let y = top; y < bottom; ++y)
        for (let x = left; x < right; ++x) {
          ++count;
          const at = 3 * (y * this.width + x), i = (y - tile.y) * tile.width + x - tile.x;
          for (let k = 0; k < 3; ++k) color[k] += this.colors[at + k];
          for (let b = 0; b < bands; ++b) {
            const {codes, low, high} = opened;
            const value = low[i] + codes[b][i] / this.most * (high[i] - low[i]);
            sum[b] += value;
            squares[b] += value * value;
          }
        }
    }
    const spectrum = Array.from(sum, v => v / count);
    const deviations = spectrum.map((mean, b) =>
        count > 1 ? Math.sqrt(Math.max(0, squares[b] - count * mean * mean) / (count - 1)) : 0);
    const xyz = bands > 0 ? this.xyz(spectrum, 0, 0) : multiply(SRGB_TO_XYZ, color.map(v => v / count));
    return {count, spectrum, deviations, xyz};
  }
}

// The layers of a picture by name, with the places of their channels.
function layersOf(picture) {
  const layers = new Map();
  picture.layers.forEach((channel, place) => {
    const dot = channel.lastIndexOf('.');
    const name = dot < 0 ? channel : channel.slice(0, dot);
    if (!layers.has(name)) layers.set(name, []);
    layers.get(name).push({part: channel.slice(dot + 1), place});
  });
  // A file has its channels by the alphabet, and a picture is red, green and blue.
  const order = ['R', 'G', 'B', 'X', 'Y', 'Z', 'U', 'V', 'A'];
  for (const channels of layers.values())
    channels.sort((a, b) => order.indexOf(a.part) - order.indexOf(b.part));
  return layers;
}
