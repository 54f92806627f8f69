// Reads an onboard file (.npz) without numpy, as docs/reference/file_formats.md describes it: node read_onboard.js FILE.npz
// Prints JSON: the header, the windows (center, size, vector) and the reference objects (x, y, area, class).
"use strict";
const crypto = require("crypto");
const fs = require("fs");
const zlib = require("zlib");

// The .npy files of a zip by name, found through its central directory.
function unzip(file) {
  const end = file.lastIndexOf("PK\x05\x06", file.length, "latin1");
  if (end < 0) throw new Error("no zip file");
  const members = {};
  for (let n = 0, at = file.readUInt32LE(end + 16); n < file.readUInt16LE(end + 10); n++) {
    const [method, packed] = [file.readUInt16LE(at + 10), file.readUInt32LE(at + 20)];
    const [size, local] = [file.readUInt32LE(at + 24), file.readUInt32LE(at + 42)];
    const nameLength = file.readUInt16LE(at + 28);
    const name = file.toString("latin1", at + 46, at + 46 + nameLength);
    const data = local + 30 + file.readUInt16LE(local + 26) + file.readUInt16LE(local + 28);
    const bytes = file.subarray(data, data + packed);
    members[name.replace(/\.npy$/, "")] = method === 8 ? zlib.inflateRawSync(bytes, { maxOutputLength: size }) : bytes;
    at += 46 + nameLength + file.readUInt16LE(at + 30) + file.readUInt16LE(at + 32);
  }
  return members;
}

// {shape, values} of a .npy file of unsigned whole numbers.
function array(npy) {
  const first = 10 + npy.readUInt16LE(8);
  const header = npy.toString("latin1", 10, first);
  const found = /'descr': '[<|]u([124])', 'fortran_order': False, 'shape': \((\d+),(?: (\d+))?\)/.exec(header);
  if (!found) throw new Error("no array of whole numbers");
  const kind = { 1: Uint8Array, 2: Uint16Array, 4: Uint32Array }[found[1]];
  const shape = found.slice(2).filter((length) => length !== undefined).map(Number);
  // Copied, because typed arrays begin at multiples of their size.
  return { shape, values: new kind(Uint8Array.from(npy.subarray(first)).buffer) };
}

function read(path) {
  const members = unzip(fs.readFileSync(path));
  const hash = crypto.createHash("sha256");
  for (const name of Object.keys(members).sort()) if (name !== "content_hash" && name !== "signature") hash.update(members[name]);
  const arrays = Object.fromEntries(Object.entries(members).map(([name, npy]) => [name, array(npy)]));
  if (!hash.digest().equals(Buffer.from(arrays.content_hash.values))) throw new Error("the content hash is another");
  const header = JSON.parse(Buffer.from(arrays.header.values).toString("utf8"));
  if (header.format !== "semref onboard" || header.version > 1) throw new Error("foreign or newer file");
  const values = (name) => Array.from(arrays[name].values);
  const [x0, pixel, , y0] = header.parameters.geotransform;
  const [perVector, classCount] = [header.parameters.references_per_vector, header.reference_classes.length];
  const levels = values("windows_levels");
  const windows = values("windows_columns").map((column, n) => {
    const [row, size] = [arrays.windows_rows.values[n], header.window_sizes_px[levels[n] - 1]];
    const steps = Array.from(arrays.windows_vectors.values.subarray(3 * perVector * n, 3 * perVector * (n + 1)));
    const vector = steps.map((step, k) => step / (k < 2 * perVector ? 255 : classCount));
    const center = [x0 + (column + size / 2) * pixel, y0 - (row + size / 2) * pixel];
    return { name: `${column}_${row}`, center, size: size * pixel, vector };
  });
  const references = values("references_classes").map((value, n) => ({
    x: header.position_origin[0] + arrays.references_positions.values[2 * n] * header.position_step,
    y: header.position_origin[1] + arrays.references_positions.values[2 * n + 1] * header.position_step,
    area: Math.exp(header.log_area_lowest + arrays.references_areas.values[n] * header.log_area_step),
    class: value,
    touches_edge: arrays.references_touches_edge.values[n] > 0,
  }));
  return { header, windows, references };
}

console.log(JSON.stringify(read(process.argv[2])));
