"use strict";
// The numbers of the page, and shapes from their samples.

const NUMBERS = JSON.parse(document.getElementById("numbers").textContent);

function bufferOf(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; k++) bytes[k] = raw.charCodeAt(k);
  return bytes.buffer;
}

function singles(packed) {
  return new Float32Array(bufferOf(packed.single));
}

function tableOf(packed) {
  const whole = new Int16Array(bufferOf(packed.whole));
  const [rows, columns] = packed.shape;
  const table = [];
  for (let i = 0; i < rows; i++) {
    const row = new Float64Array(columns);
    for (let j = 0; j < columns; j++) row[j] = packed.step * whole[i * columns + j];
    table.push(row);
  }
  return table;
}

// A smooth table on a grid of other counts, linear between its samples.
function resampled(table, rows, columns) {
  const lastRow = table.length - 1, lastColumn = table[0].length - 1;
  const fine = [];
  for (let i = 0; i < rows; i++) {
    const a = (i * lastRow) / (rows - 1), k = Math.min(Math.floor(a), lastRow - 1), p = a - k;
    const row = new Float64Array(columns);
    for (let j = 0; j < columns; j++) {
      const b = (j * lastColumn) / (columns - 1), l = Math.min(Math.floor(b), lastColumn - 1);
      const q = b - l;
      row[j] = (1 - p) * ((1 - q) * table[k][l] + q * table[k][l + 1])
        + p * ((1 - q) * table[k + 1][l] + q * table[k + 1][l + 1]);
    }
    fine.push(row);
  }
  return fine;
}

// The whole from a quarter: odd tables change sign across a mirror, even ones do not.
function unfolded(quarter, oddAlong, oddAcross) {
  const rows = quarter.length - 1, columns = quarter[0].length - 1;
  const whole = [];
  for (let i = -rows; i <= rows; i++) {
    const row = new Array(2 * columns + 1);
    for (let j = -columns; j <= columns; j++) {
      const sign = (oddAlong && i < 0 ? -1 : 1) * (oddAcross && j < 0 ? -1 : 1);
      row[j + columns] = sign * quarter[Math.abs(i)][Math.abs(j)];
    }
    whole.push(row);
  }
  return whole;
}

// x, y and z/t of the whole sheet in a state; null where it did not converge.
function surfaceOf(sheet, index) {
  const shape = sheet.shapes[index];
  if (shape === null) return null;
  const height = shape.height ? tableOf(shape.height[0]) : null;
  let [x, y] = shape.plane.map(tableOf);
  if (height) [x, y] = [x, y].map((part) => resampled(part, height.length, height[0].length));
  const z = (height ?? x).map((row) => row.map((value) => (height ? value / sheet.thickness : 0)));
  return {
    x: unfolded(x, true, false),
    y: unfolded(y, false, true),
    z: unfolded(z, false, sheet.parity === "antisymmetric"),
  };
}

// y/W and z/t of the mid-line over the whole width; null where the state did not converge.
function profileOf(sheet, index) {
  const shape = sheet.shapes[index];
  if (shape === null) return null;
  const [half, height] = shape.profile.map(singles);
  const odd = sheet.parity === "antisymmetric" ? -1 : 1;
  const y = [], z = [];
  for (let k = half.length - 1; k > 0; k--) {
    y.push(-half[k]);
    z.push((odd * height[k]) / sheet.thickness || 0);
  }
  for (let k = 0; k < half.length; k++) {
    y.push(half[k]);
    z.push(height[k] / sheet.thickness);
  }
  return { y, z };
}
