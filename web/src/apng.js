// Animated PNG from PNG pictures of one size: the chunks of the first, and each picture's data as a frame (W3C, PNG third edition, 4.9).

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});
function crc(bytes) {
  let c = 0xffffffff;
  for (const byte of bytes) c = table[(c ^ byte) & 255] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

function chunk(name, ...parts) {
  const length = parts.reduce((sum, part) => sum + part.length, 0), bytes = new Uint8Array(12 + length), view = new DataView(bytes.buffer);
  view.setUint32(0, length);
  bytes.set(Uint8Array.from(name, (c) => c.charCodeAt(0)), 4);
  let at = 8;
  for (const part of parts) { bytes.set(part, at); at += part.length; }
  view.setUint32(at, crc(bytes.subarray(4, at)));
  return bytes;
}

const numbers = (...values) => { // [bytes, value] each
  const bytes = new Uint8Array(values.reduce((sum, [size]) => sum + size, 0)), view = new DataView(bytes.buffer);
  let at = 0;
  for (const [size, value] of values) {
    size === 4 ? view.setUint32(at, value) : size === 2 ? view.setUint16(at, value) : view.setUint8(at, value);
    at += size;
  }
  return bytes;
};

function chunksOf(png) {
  const view = new DataView(png.buffer, png.byteOffset), chunks = [];
  for (let at = 8; at < png.length;) {
    const length = view.getUint32(at), name = String.fromCharCode(...png.subarray(at + 4, at + 8));
    chunks.push({ name, data: png.subarray(at + 8, at + 8 + length) });
    at += 12 + length;
  }
  return chunks;
}

/** One file from pictures (Uint8Array of a PNG each), shown for `milliseconds` each, the last for a second, without end. */
export function animated(pictures, milliseconds) {
  const first = chunksOf(pictures[0]), header = first.find((c) => c.name === "IHDR").data;
  const size = new DataView(header.buffer, header.byteOffset), width = size.getUint32(0), height = size.getUint32(4);
  const parts = [Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10), chunk("IHDR", header), chunk("acTL", numbers([4, pictures.length], [4, 0]))];
  let sequence = 0;
  pictures.forEach((picture, i) => {
    const wait = i + 1 === pictures.length ? 1000 : milliseconds;
    parts.push(chunk("fcTL", numbers([4, sequence++], [4, width], [4, height], [4, 0], [4, 0], [2, wait], [2, 1000], [1, 0], [1, 0])));
    for (const { name, data } of chunksOf(picture))
      if (name === "IDAT") parts.push(i === 0 ? chunk("IDAT", data) : chunk("fdAT", numbers([4, sequence++]), data));
  });
  parts.push(chunk("IEND"));
  return new Blob(parts, { type: "image/png" });
}
