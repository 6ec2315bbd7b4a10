#!/usr/bin/env bash
# sharp 0.35.5 (npm, with its prebuilt libvips): a TIFF of 32-bit floats comes out black where it has an ICC profile.
#
# Seen: a TIFF of 4 x 4 pixels, red, green and blue all 0.5 in 32-bit floating point, decoded by sharp to 8 bits: without
# a profile 188, which is 0.5 taken as light and encoded for sRGB; with sharp's own sRGB profile in tag 34675, which is
# all that differs, 0. The same picture in 16 bits with the same profile is 128, as it should be. No error, no warning.
# sharp.metadata() tells of both float files format tiff, space scrgb, depth float, so it has understood them.
#
# Whom it bites: whoever shows renderings or scans of 32 bits on the web: renderers, GIMP and darktable put a profile into
# each TIFF that they write, and every thumbnail that sharp makes of these is black.
#
# The script fails if the package comes to behave otherwise. It needs node with npm and the network.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm init -y >npm.log 2>&1
npm install --no-audit --no-fund sharp@0.35.5 >>npm.log 2>&1 || { cat npm.log >&2; exit 1; }

cat >look.js <<'JS'
const sharp = require('sharp');

// A little-endian TIFF of 4 x 4 pixels, one strip, not compressed. `bits` is 32 (floats) or 16.
function tiff(bits, profile) {
  const bytes = bits / 8, count = 4 * 4 * 3, pixels = Buffer.alloc(count * bytes);
  for (let i = 0; i < count; ++i)
    if (bits === 32) pixels.writeFloatLE(0.5, i * 4);
    else pixels.writeUInt16LE(32768, i * 2);
  const triple = value => Buffer.from(Uint16Array.of(value, value, value).buffer);
  let data = pixels;
  const put = part => {
    const at = 8 + data.length;
    data = Buffer.concat([data, part, Buffer.alloc(part.length % 2)]);
    return at;
  };
  const bitsAt = put(triple(bits)), formatAt = put(triple(bits === 32 ? 3 : 1));
  const entries = [[256, 3, 1, 4], [257, 3, 1, 4], [258, 3, 3, bitsAt], [259, 3, 1, 1], [262, 3, 1, 2],
                   [273, 4, 1, 8], [277, 3, 1, 3], [278, 3, 1, 4], [279, 4, 1, pixels.length],
                   [284, 3, 1, 1], [339, 3, 3, formatAt]];
  if (profile) entries.push([34675, 7, profile.length, put(profile)]);
  const header = Buffer.from('II*\0\0\0\0\0', 'latin1');
  header.writeUInt32LE(8 + data.length, 4);
  const directory = Buffer.alloc(2 + 12 * entries.length + 4);
  directory.writeUInt16LE(entries.length, 0);
  entries.forEach(([tag, type, length, value], i) => {
    directory.writeUInt16LE(tag, 2 + 12 * i);
    directory.writeUInt16LE(type, 4 + 12 * i);
    directory.writeUInt32LE(length, 6 + 12 * i);
    directory.writeUInt32LE(value, 10 + 12 * i);
  });
  return Buffer.concat([header, data, directory]);
}

async function first(file) {
  const pixels = await sharp(file).removeAlpha().raw().toBuffer();
  const {format, space, depth} = await sharp(file).metadata();
  return `${pixels[0]} ${pixels[1]} ${pixels[2]} ${format} ${space} ${depth}`;
}

(async () => {
  const png = await sharp({create: {width: 1, height: 1, channels: 3, background: '#808080'}})
      .withIccProfile('srgb').png().toBuffer();
  const profile = (await sharp(png).metadata()).icc;
  console.log('floats, no profile: ' + await first(tiff(32)));
  console.log('floats, sRGB profile: ' + await first(tiff(32, profile)));
  console.log('16 bits, sRGB profile: ' + await first(tiff(16, profile)));
})();
JS

cat >expected <<'TEXT'
floats, no profile: 188 188 188 tiff scrgb float
floats, sRGB profile: 0 0 0 tiff scrgb float
16 bits, sRGB profile: 128 128 128 tiff rgb16 ushort
TEXT
node look.js >seen
if ! diff expected seen; then
  echo "sharp behaves otherwise than this finding says" >&2
  exit 1
fi
echo "as found: sharp 0.35.5 shows a TIFF of floats black where it has a profile"
