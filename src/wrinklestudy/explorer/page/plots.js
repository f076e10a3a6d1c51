// The plots: each is drawn whole for a sheet, and only its marks and its shape move with the strain.

const CURVES = {
  amplitude: { column: "amplitude_over_thickness", axis: "A/t", unit: "t", name: "A" },
  wavelength: { column: "wavelength_over_width", axis: "λ/W", unit: "W", name: "λ" },
  phi: { column: "phi_squared", axis: "10³ Φ²", unit: "", name: "10³ Φ²", factor: 1e3 },
  force: { column: "nominal_stress_pa", axis: "F/(W t) (kPa)", unit: "kPa", name: "F/(W t)", factor: 1e-3 },
};
// What a hole has in place of a surface: it is not drawn.
const NOTHING = { x: [[0, 0], [1, 1]], y: [[0, 1], [0, 1]], z: [[0, 0], [0, 0]] };
const EYE = { x: 0.4, y: -1.9, z: 0.95 };

const plot = (id) => document.getElementById(id);
const scaled = (values, factor = 1) => values.map((value) => (value === null ? null : factor * value));
const lastStrain = () => 1.04 * Math.max(...VIEW.sheet.states.strain);

function limitLines() {
  const lines = [];
  for (const strain of [VIEW.sheet.birth, VIEW.sheet.decay]) {
    if (strain === null || strain > lastStrain()) continue;
    lines.push({ type: "line", x0: strain, x1: strain, y0: 0, y1: 1, yref: "paper",
      line: { color: colour("second"), width: 1, dash: "dot" } });
  }
  return lines;
}

function drawCurve(id) {
  const curve = CURVES[id], sheet = VIEW.sheet, strain = sheet.states.strain;
  const values = scaled(sheet.states[curve.column], curve.factor);
  const through = sheet.curves[curve.column];
  const [lineX, lineY] = through ? [through[0], scaled(through[1], curve.factor)] : [strain, values];
  const hover = `strain %{x:.4~g}<br>${curve.name} = %{y:.4~g} ${curve.unit}<extra></extra>`;
  const holes = strain.filter((_, k) => sheet.states.status[k] === "not-converged");
  const traces = [
    { type: "scatter", mode: "lines", x: lineX, y: lineY, connectgaps: false, hoverinfo: "skip",
      line: { color: colour("curve"), width: 1.5 } },
    { type: "scatter", mode: "markers", x: strain, y: values, hovertemplate: hover,
      marker: { color: colour("curve"), size: 5 } },
    { type: "scatter", mode: "markers", x: holes, y: holes.map(() => 0), cliponaxis: false,
      marker: { color: colour("mark"), symbol: "x-thin-open", size: 8 },
      hovertemplate: "strain %{x:.4~g}<br>did not converge<extra></extra>" },
    marker([strain[VIEW.index]], [values[VIEW.index]], { hovertemplate: hover, cliponaxis: false }),
  ];
  const known = values.filter((value) => value !== null);
  const top = Math.max(...known, 0);
  const from = id === "wavelength" && known.length ? 0.9 * Math.min(...known) : 0;
  const range = [from, top > 0 ? 1.1 * top : 1];
  const layout = layoutOf(axis("strain ε", { range: [0, lastStrain()] }), axis(curve.axis, { range }),
    { shapes: limitLines() });
  if (!known.some((value) => value > 0)) {
    layout.annotations = [{ text: "flat at every strain", showarrow: false, xref: "paper",
      yref: "paper", x: 0.5, y: 0.5 }];
  }
  Plotly.react(plot(id), traces, layout, QUIET);
}

function moveCurve(id) {
  if (!plot(id).data) return;
  const curve = CURVES[id], states = VIEW.sheet.states;
  const value = scaled([states[curve.column][VIEW.index]], curve.factor);
  moveMark(id, [states.strain[VIEW.index]], value);
}

function moveMark(id, x, y) {
  Plotly.restyle(plot(id), { x: [x], y: [y] }, [plot(id).data.length - 1]); // it is the last trace
}

function drawProfile() {
  const sheet = VIEW.sheet;
  const largest = Math.max(0, ...sheet.states.amplitude_over_thickness.map((a) => a ?? 0));
  const hover = "y = %{x:.4f} W<br>z = %{y:.4f} t<extra></extra>";
  const dashed = { type: "scatter", mode: "lines", hoverinfo: "skip",
    line: { color: colour("mark"), width: 1, dash: "dash" } };
  const traces = [
    { type: "scatter", mode: "lines", line: { color: colour("curve"), width: 1.6 }, hovertemplate: hover },
    { ...dashed }, { ...dashed },
  ];
  const layout = layoutOf(axis("y/W across the sheet", { range: [-0.52, 0.52], zeroline: false }),
    axis("z/t", { range: largest > 0 ? [-1.25 * largest, 1.25 * largest] : [-1, 1] }));
  Plotly.react(plot("profile"), traces, layout, QUIET);
  moveProfile();
}

function moveProfile() {
  if (!plot("profile").data) return;
  const sheet = VIEW.sheet, profile = profileOf(sheet, VIEW.index) ?? { y: [], z: [] };
  const height = sheet.states.amplitude_over_thickness[VIEW.index];
  const y = height ? [profile.y[0], profile.y[profile.y.length - 1]] : [];
  const update = { x: [profile.y, y, y], y: [profile.z, y.map(() => height), y.map(() => -height)] };
  Plotly.restyle(plot("profile"), update, [0, 1, 2]);
  note("profile-note", height ? "Dashed: ±A from the table. The line half-way between the clamps, over its whole width."
    : profile.y.length ? "The line half-way between the clamps; this state is flat." : "This state did not converge: a hole.");
}

const DIVERGING = [[0, "#2f63b8"], [0.25, "#8fb3e8"], [0.5, "#dedede"], [0.75, "#eea184"], [1, "#b8352f"]];

function bar(title) {
  return { title: { text: title, side: "top", font: { size: 12 } }, thickness: 10, len: 0.85,
    outlinewidth: 0, tickfont: { color: colour("ink") }, nticks: 6 };
}

// The surface with z made larger; its true height is in the colours and under the pointer.
function lifted(surface) {
  const factor = VIEW.zoom * VIEW.sheet.thickness;
  return surface.z.map((row) => row.map((value) => factor * value));
}

function drawSheet() {
  if (!HAS_WEBGL) return drawFromAbove();
  const sheet = VIEW.sheet, top = Math.max(0.01, largestHeight(sheet)), half = 0.5 * sheet.aspect * lastStrainOf(sheet);
  const surface = surfaceOf(sheet, VIEW.index) ?? NOTHING;
  const trace = {
    type: "surface", visible: surface !== NOTHING, x: surface.x, y: surface.y, z: lifted(surface), surfacecolor: surface.z,
    cmin: -top, cmax: top, colorscale: DIVERGING, colorbar: bar("z/t"), showscale: true,
    lighting: { ambient: 0.92, diffuse: 0.75, specular: 0.15, roughness: 0.6, fresnel: 0.1 },
    lightposition: { x: -2000, y: -9000, z: 5000 }, contours: { x: { highlight: false },
      y: { highlight: false }, z: { highlight: false } },
    customdata: surface.z,
    hovertemplate: "x = %{x:.3f} W<br>y = %{y:.3f} W<br>z = %{customdata:.3f} t<extra></extra>",
  };
  const height = Math.max(0.12, 1.1 * VIEW.zoom * top * sheet.thickness);
  const hidden = { visible: false, showspikes: false };
  const longest = Math.max(2 * half, 1.04);
  const box = plot("sheet").getBoundingClientRect(); // the view is as high as the plot, however wide
  const size = Math.min(3.5, (2 * (box.width - 80)) / (box.height || 1));
  const ratio = (length) => (size * length) / longest;
  const eye = VIEW.eye ? { x: VIEW.eye[0], y: VIEW.eye[1], z: VIEW.eye[2] } : EYE;
  const scene = {
    xaxis: { ...hidden, range: [-half, half] }, yaxis: { ...hidden, range: [-0.52, 0.52] },
    zaxis: { ...hidden, range: [-height, height] }, aspectmode: "manual",
    aspectratio: { x: ratio(2 * half), y: ratio(1.04), z: ratio(2 * height) },
    camera: { eye, center: { x: 0, y: 0, z: -0.1 }, projection: { type: "orthographic" } }, dragmode: "turntable",
  };
  const layout = layoutOf(null, null, { scene, margin: { l: 0, r: 64, t: 0, b: 0 } });
  Plotly.react(plot("sheet"), [trace], layout, { ...QUIET, scrollZoom: true });
  sayOfSheet();
}

function lastStrainOf(sheet) {
  return 1 + Math.max(...sheet.states.strain);
}

// Where there is no WebGL: height as colour, on the undeformed sheet.
function drawFromAbove() {
  const sheet = VIEW.sheet, top = Math.max(0.01, largestHeight(sheet)), surface = surfaceOf(sheet, VIEW.index);
  const rows = surface?.z.length ?? 2, columns = surface?.z[0].length ?? 2;
  const line = (count, length) => Array.from({ length: count }, (_, k) => (k / (count - 1) - 0.5) * length);
  const across = (surface?.z[0] ?? []).map((_, j) => surface.z.map((row) => row[j]));
  const trace = { type: "heatmap", x: line(rows, sheet.aspect), y: line(columns, 1), z: across,
    zmin: -top, zmax: top, colorscale: DIVERGING, colorbar: bar("z/t"),
    hovertemplate: "X = %{x:.3f} W<br>Y = %{y:.3f} W<br>z = %{z:.3f} t<extra></extra>" };
  const layout = layoutOf(axis("X/W along the pull", { range: [-sheet.aspect / 2, sheet.aspect / 2] }),
    axis("Y/W", { range: [-0.5, 0.5], scaleanchor: "x" }));
  Plotly.react(plot("sheet"), [trace], layout, QUIET);
  sayOfSheet();
}

function moveSheet() {
  if (!plot("sheet").data) return; // it is drawn a little later than the controls
  if (!HAS_WEBGL) return drawSheet();
  const surface = surfaceOf(VIEW.sheet, VIEW.index) ?? NOTHING;
  Plotly.restyle(plot("sheet"), { visible: surface !== NOTHING, x: [surface.x], y: [surface.y], z: [lifted(surface)],
    surfacecolor: [surface.z], customdata: [surface.z] }, [0]);
  sayOfSheet();
}

function sayOfSheet() {
  const status = VIEW.sheet.states.status[VIEW.index];
  const drawn = HAS_WEBGL ? `z is drawn ${digits(VIEW.zoom, 2)} times larger than it is; x and y are not. Drag to turn, wheel to come nearer.`
    : "No WebGL in this browser: the undeformed sheet from above in place of three dimensions.";
  note("sheet-note", { wrinkled: drawn, flat: `The sheet is flat. ${HAS_WEBGL ? "" : drawn}`,
    "not-converged": "This state did not converge: there is no shape to show." }[status]);
}
