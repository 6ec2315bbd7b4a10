// The tiles of a picture, which the page holds compressed, each stream for itself. io/pages/packed_tile.h
// of the program says what the streams are.

async function inflate(text) {
  const characters = atob(text), packed = new Uint8Array(characters.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = characters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Planes of floats, each with all first bytes of its values before all second ones.
function floatPlanes(bytes, pixels) {
  const planes = [], size = 4 * pixels, view = new DataView(new ArrayBuffer(4));
  for (let begin = 0; begin < bytes.length; begin += size) {
    const joined = new Uint8Array(size);
    for (let k = 0; k < 4; ++k)
      for (let i = 0; i < pixels; ++i) joined[4 * i + k] = bytes[begin + k * pixels + i];
    planes.push(new Float32Array(joined.buffer)); // browsers run on little-endian machines
  }
  return planes;
}

// Codes of a band, of 8 or 16 bits, from differences between neighbours.
function codes(bytes, pixels, bits) {
  const values = bits === 8 ? new Uint8Array(pixels) : new Uint16Array(pixels);
  let code = 0;
  for (let i = 0; i < pixels; ++i) {
    code += bits === 8 ? bytes[i] : bytes[i] << 8 | bytes[pixels + i];
    values[i] = code; // modulo 2^8 or 2^16
  }
  return values;
}

class Tile {
  constructor(picture, number, lengths) {
    const columns = Math.ceil(picture.width / picture.tileSize);
    this.picture = picture;
    this.element = document.getElementById(`tile-${picture.number}-${number}`);
    this.x = number % columns * picture.tileSize; // within the picture
    this.y = Math.floor(number / columns) * picture.tileSize;
    this.width = Math.min(picture.tileSize, picture.width - this.x);
    this.height = Math.min(picture.tileSize, picture.height - this.y);
    this.pixels = this.width * this.height;
    this.ends = [0];
    for (const length of lengths) this.ends.push(this.ends.at(-1) + length);
    this.kept = new Map();
  }

  // The bytes of a stream.
  stream(number) {
    return inflate(this.element.textContent.slice(this.ends[number], this.ends[number + 1]));
  }
  async colors() {
    return floatPlanes(await this.stream(0), this.pixels);
  }
  // The lowest and the highest value of each pixel.
  async ranges() {
    if (!this.kept.has('ranges')) this.kept.set('ranges', floatPlanes(await this.stream(1), this.pixels));
    return this.kept.get('ranges');
  }
  async codes(band) {
    return codes(await this.stream(2 + band), this.pixels, this.picture.bits);
  }
  // The codes of all bands; kept, since pixels near to each other are asked for one after the other.
  async allCodes() {
    if (!this.kept.has('codes'))
      this.kept.set('codes', await Promise.all(this.picture.nm.map((_, band) => this.codes(band))));
    return this.kept.get('codes');
  }
  async layer(channel) {
    const before = this.picture.nm.length > 0 ? 2 + this.picture.nm.length : 1;
    return floatPlanes(await this.stream(before + channel), this.pixels)[0];
  }
  forget() {
    this.kept.clear();
  }
}
