// The canvas with the picture: zoom, place, marks, and what pixels become on it.

class Screen {
  constructor(canvas) {
    this.canvas = canvas;
    this.wide = matchMedia('(color-gamut: p3)').matches;
    const options = this.wide ? {colorSpace: 'display-p3'} : {};
    this.context = canvas.getContext('2d', options);
    this.options = options;
    this.zoom = 1;
    this.left = this.top = 0; // the picture's corner, in pixels of the canvas
    this.width = this.height = 1;
    this.images = [null, null]; // what is shown, and what it is compared with
    this.wipe = null;
    this.marks = [];
  }

  // Turns values into a canvas of the picture's size. `colorAt(i, out)` fills three codes.
  paint(width, height, colorAt) {
    const image = new OffscreenCanvas(width, height);
    const context = image.getContext('2d', this.options);
    const data = context.createImageData(width, height, this.options);
    const codes = data.data;
    for (let i = 0, at = 0; i < width * height; ++i, at += 4) {
      colorAt(i, codes, at);
      codes[at + 3] = 255;
    }
    context.putImageData(data, 0, 0);
    return image;
  }
  // Linear sRGB as it looks.
  paintColors(colors, width, height, stops) {
    const scale = 2 ** stops, m = SRGB_TO_P3, wide = this.wide;
    return this.paint(width, height, (i, codes, at) => {
      const r = colors[3 * i] * scale, g = colors[3 * i + 1] * scale, b = colors[3 * i + 2] * scale;
      codes[at] = codeOf(wide ? m[0][0] * r + m[0][1] * g + m[0][2] * b : r);
      codes[at + 1] = codeOf(wide ? m[1][0] * r + m[1][1] * g + m[1][2] * b : g);
      codes[at + 2] = codeOf(wide ? m[2][0] * r + m[2][1] * g + m[2][2] * b : b);
    });
  }
  // One value a pixel, in false colours from `low` to `high`; white where there is no number.
  paintFalse(values, width, height, low, high) {
    return this.paint(width, height, (i, codes, at) => {
      const v = values[i];
      const color = Number.isFinite(v) ? falseColor(high > low ? (v - low) / (high - low) : 0) : [255, 255, 255];
      for (let k = 0; k < 3; ++k) codes[at + k] = color[k];
    });
  }

  setSize(width, height) {
    if (width === this.width && height === this.height) return;
    Object.assign(this, {width, height});
    this.fit();
  }
  measure() {
    const box = this.canvas.getBoundingClientRect(), ratio = devicePixelRatio || 1;
    const width = Math.max(1, Math.round(box.width * ratio)), height = Math.max(1, Math.round(box.height * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, {width, height});
  }
  fit() {
    this.measure();
    this.zoom = Math.min(this.canvas.width / this.width, this.canvas.height / this.height);
    this.left = (this.canvas.width - this.zoom * this.width) / 2;
    this.top = (this.canvas.height - this.zoom * this.height) / 2;
    this.draw();
  }
  // Zooms about a point of the canvas, or its middle.
  zoomTo(zoom, x = this.canvas.width / 2, y = this.canvas.height / 2) {
    const next = Math.max(0.02, Math.min(128, zoom)), factor = next / this.zoom;
    this.left = x - (x - this.left) * factor;
    this.top = y - (y - this.top) * factor;
    this.zoom = next;
    this.draw();
  }
  move(dx, dy) {
    this.left += dx;
    this.top += dy;
    this.draw();
  }
  // The point of the canvas under an event of the pointer.
  point(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left) * this.canvas.width / box.width,
            (event.clientY - box.top) * this.canvas.height / box.height];
  }
  // The pixel of the picture at a point of the canvas.
  pixel([x, y]) {
    return {x: Math.floor((x - this.left) / this.zoom), y: Math.floor((y - this.top) / this.zoom)};
  }

  draw() {
    this.measure();
    const {context, canvas, zoom, left, top} = this;
    context.fillStyle = '#000';
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingEnabled = zoom < 1;
    const show = image => image && context.drawImage(image, left, top, this.width * zoom, this.height * zoom);
    show(this.images[0]);
    if (this.images[1] && this.wipe !== null) {
      const edge = left + this.wipe * this.width * zoom;
      context.save();
      context.beginPath();
      context.rect(edge, 0, canvas.width - edge, canvas.height);
      context.clip();
      show(this.images[1]);
      context.restore();
      context.fillStyle = '#fff';
      context.fillRect(Math.round(edge), top, 2, this.height * zoom);
    }
    for (const {x0, y0, x1, y1, color} of this.marks) {
      const grow = zoom < 6 ? 3 : 0; // a mark of a pixel is seen where a pixel is not
      const box = [left + x0 * zoom - grow, top + y0 * zoom - grow, (x1 - x0) * zoom + 2 * grow, (y1 - y0) * zoom + 2 * grow];
      context.lineWidth = 4;
      context.strokeStyle = '#000';
      context.strokeRect(...box);
      context.lineWidth = 2;
      context.strokeStyle = color;
      context.strokeRect(...box);
    }
  }
}
