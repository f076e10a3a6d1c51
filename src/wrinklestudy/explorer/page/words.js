// What is said in words: beside the plots, to screen readers, and as files.

function digits(value, count = 4) {
  return String(Number(value.toPrecision(count)));
}

function small(value) {
  const [head, power] = value.toExponential(3).split("e");
  const raised = String(Number(power)).replace(/[-\d]/g, (letter) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(letter)]);
  return `${Number(head)} × 10${raised}`;
}

function inMm(value, sheet, factor) {
  return sheet.widthMm === null ? "" : ` = ${digits(value * factor * sheet.widthMm)} mm`;
}

const STATUS = { wrinkled: "wrinkled", flat: "flat", "not-converged": "did not converge" };

// Name and value of each number of a state, only those that there are.
function facts(sheet, index) {
  const at = (name) => sheet.states[name][index];
  const found = [];
  const add = (label, spoken, value, text) => { if (value !== null) found.push({ label, spoken, text: text(value) }); };
  add("State", "state", at("status"), (status) => STATUS[status]);
  if (at("reason")) found.push({ label: "Reason", spoken: "reason", text: at("reason") });
  const t = sheet.thickness;
  if (at("status") === "wrinkled") {
    add("Amplitude A", "amplitude", at("amplitude_over_thickness"), (a) => `${digits(a)} t${inMm(a, sheet, t) || ` = ${small(a * t)} W`}`);
    add("Wavelength λ", "wavelength", at("wavelength_over_width"), (l) => `${digits(l)} W${inMm(l, sheet, 1)}`);
    add("Confinement Φ²", "confinement phi squared", at("phi_squared"), small);
  }
  add("Force F/(W t)", "force over cross-section", at("nominal_stress_pa"), (p) => {
    const newton = sheet.widthMm === null ? "" : `, F = ${digits(1e-6 * p * t * sheet.widthMm ** 2)} N`;
    return `${digits(p / 1e3)} kPa${newton}`;
  });
  add("Critical thickness τ₁", "critical thickness", at("critical_thickness"), (tau) => `${small(tau)} W`);
  add("Thickness t", "thickness", t, (value) => `${small(value)} W${inMm(value, sheet, 1)}`);
  const never = sheet.birth === null;
  found.push({ label: "Wrinkles from", spoken: "wrinkles from strain", text: never ? "never" : digits(sheet.birth) });
  if (!never) found.push({ label: "Wrinkles to", spoken: "to strain", text: sheet.decay === null ? "beyond the range" : digits(sheet.decay) });
  return found;
}

function describeSheet(sheet) {
  return `${sheet.material}, bending ${sheet.bending}, ${sheet.parity}, L/W ${sheet.aspect}, t/W ${sheet.thickness}`;
}

function sayState() {
  const sheet = VIEW.sheet, strain = sheet.states.strain[VIEW.index];
  const told = facts(sheet, VIEW.index);
  const list = document.getElementById("values");
  list.replaceChildren(...told.flatMap(({ label, text }) => {
    const term = document.createElement("dt"), value = document.createElement("dd");
    term.textContent = label;
    value.textContent = text;
    return [term, value];
  }));
  note("strain-value", digits(strain));
  const status = sheet.states.status[VIEW.index];
  note("status", STATUS[status]);
  const slider = document.getElementById("strain");
  slider.setAttribute("aria-valuetext", `strain ${digits(strain)}, ${STATUS[status]}`);
  const words = `Strain ${digits(strain)}: ${told.map(({ spoken, text }) => `${spoken} ${text}`).join(", ")}.`;
  document.querySelectorAll(".plot").forEach((element) => {
    const title = element.closest("section").querySelector("h2").textContent;
    element.setAttribute("aria-label", `${title} of ${describeSheet(sheet)}. ${words}`);
  });
  return words;
}

let speaking = 0;
function speak(words) {
  clearTimeout(speaking);
  speaking = setTimeout(() => note("live", words), 250);
}

function quoted(value) {
  const text = value === null || value === undefined ? "" : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function csv(columns, rows) {
  return [columns, ...rows].map((row) => row.map(quoted).join(",")).join("\n") + "\n";
}

function statesCsv(sheet) {
  const own = ["model", "law", "bending", "parity", "aspect", "thickness"];
  const columns = Object.keys(NUMBERS.columns);
  const rows = sheet.states.strain.map((_, k) =>
    [...own.map((name) => sheet[name]), ...columns.map((name) => sheet.states[name][k])]);
  return csv(["material", ...own.slice(1), ...columns], rows);
}

function profileCsv(sheet, index) {
  const profile = profileOf(sheet, index) ?? { y: [], z: [] };
  return csv(["y_over_width", "z_over_thickness"], profile.y.map((y, k) => [y, profile.z[k]]));
}

function mapCsv(sheet) {
  const map = mapOf(sheet), rows = [];
  map?.aspects.forEach((aspect, i) => map.strains.forEach((strain, j) =>
    rows.push(["critical_thickness", aspect, strain, map.values[i][j]])));
  for (const row of tensionOf(sheet)) rows.push(["phi_squared_of_tension_field", row.aspect, row.strain, row.phi_squared]);
  return csv(["quantity", "aspect", "strain", "value"], rows);
}

function download(name, text) {
  const place = document.createElement("a");
  place.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  place.download = name;
  document.body.append(place);
  place.click();
  place.remove();
  setTimeout(() => URL.revokeObjectURL(place.href), 1000);
}
