// What is shown: one sheet, one of its states, and how; and the same as the fragment of a link.

const LEVELS = ["material", "bending", "parity", "aspect", "thickness"];
const VIEW = { sheet: NUMBERS.sheets[NUMBERS.first], index: 0, zoom: 1, eye: null, theme: "" };

function distinct(values) {
  return [...new Set(values)].sort((a, b) => (typeof a === "number" ? a - b : a < b ? -1 : 1));
}

function nearest(values, wanted) {
  return values.reduce((best, value) =>
    Math.abs(value - wanted) < Math.abs(best - wanted) ? value : best);
}

// The options of each level for the choices above it, and the sheet that is nearest to the wishes.
function chosenSheet(wishes) {
  let left = NUMBERS.sheets;
  const options = {};
  for (const level of LEVELS) {
    options[level] = distinct(left.map((sheet) => sheet[level]));
    const wish = wishes[level];
    const numeric = typeof options[level][0] === "number";
    const known = options[level].includes(wish);
    const value = known ? wish
      : numeric && Number.isFinite(wish) ? nearest(options[level], wish)
        : options[level].includes(VIEW.sheet[level]) ? VIEW.sheet[level] : options[level][0];
    left = left.filter((sheet) => sheet[level] === value);
  }
  return { sheet: left[0], options };
}

function wishesOf(sheet) {
  return Object.fromEntries(LEVELS.map((level) => [level, sheet[level]]));
}

function highest(sheet) {
  const heights = sheet.states.amplitude_over_thickness;
  let best = 0;
  heights.forEach((value, k) => { if ((value ?? 0) > (heights[best] ?? 0)) best = k; });
  return best;
}

function stateNearest(sheet, strain) {
  return sheet.states.strain.indexOf(nearest(sheet.states.strain, strain));
}

// Largest |z|/t of all states of a sheet; long sheets have their highest wrinkles off the mid-line.
function largestHeight(sheet) {
  const { amplitude_over_thickness: middle, sheet_amplitude_over_thickness: all } = sheet.states;
  return Math.max(0, ...middle.map((a) => a ?? 0), ...all.map((a) => a ?? 0));
}

// Draws the largest wrinkle of the sheet about as high as a twelfth of the width.
function fittingZoom(sheet) {
  const height = largestHeight(sheet) * sheet.thickness;
  return height > 0 ? Math.min(250, Math.max(1, Number((0.08 / height).toPrecision(1)))) : 1;
}

function fragment() {
  const parts = new URLSearchParams(wishesOf(VIEW.sheet));
  parts.set("strain", VIEW.sheet.states.strain[VIEW.index]);
  parts.set("z", Number(VIEW.zoom.toPrecision(3)));
  if (VIEW.eye) parts.set("eye", VIEW.eye.map((part) => part.toFixed(3)).join(","));
  if (VIEW.theme) parts.set("theme", VIEW.theme);
  return `#${parts}`;
}

function numberIn(parts, name) {
  const text = parts.get(name);
  return text === null || text.trim() === "" ? NaN : Number(text);
}

function readFragment() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const wishes = wishesOf(VIEW.sheet);
  for (const level of LEVELS) {
    if (!parts.has(level)) continue;
    wishes[level] = typeof wishes[level] === "number" ? numberIn(parts, level) : parts.get(level);
  }
  VIEW.sheet = chosenSheet(wishes).sheet;
  const strain = numberIn(parts, "strain"), zoom = numberIn(parts, "z");
  VIEW.index = Number.isFinite(strain) ? stateNearest(VIEW.sheet, strain) : highest(VIEW.sheet);
  VIEW.zoom = zoom >= 1 && zoom <= 251 ? zoom : fittingZoom(VIEW.sheet);
  const eye = (parts.get("eye") ?? "").split(",").map(Number);
  VIEW.eye = eye.length === 3 && eye.every((part) => Number.isFinite(part) && Math.abs(part) < 10)
    && eye.some((part) => part !== 0) ? eye : null;
  VIEW.theme = ["dark", "light"].includes(parts.get("theme")) ? parts.get("theme") : "";
}

function writeFragment() {
  const text = fragment();
  if (text !== location.hash) history.replaceState(null, "", text);
}
