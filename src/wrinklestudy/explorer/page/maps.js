// The map of tau_1 over strain and L/W, and the tension field.

const mapOf = (sheet) => NUMBERS.maps[sheet.model] ?? null;
const tensionOf = (sheet) => NUMBERS.tension[sheet.material] ?? [];

function shades() {
  return { colorscale: "YlGnBu", reversescale: !isDark() };
}

// Where L/W varies much its axis is that of the logarithm: points on it keep their size that way.
function aspectScale(aspects) {
  const [low, high] = [aspects[0], aspects[aspects.length - 1]];
  if (high <= 2.4 * low) return { at: (v) => v, axis: axis("L/W", { range: [low, high] }) };
  const ticks = [0.5, 0.7, 1, 1.2, 1.5, 2, 2.5, 3, 4, 6, 8, 12, 20].filter((v) => v >= low && v <= high);
  return { at: Math.log10, axis: axis("L/W", { range: [low, high].map(Math.log10),
    tickvals: ticks.map(Math.log10), ticktext: ticks.map(String) }) };
}

function contour(strains, aspects, z, symbol, unit, title) {
  const scale = aspectScale(aspects);
  return { type: "contour", x: strains, y: aspects.map(scale.at), z, ...shades(), ncontours: 12,
    text: aspects.map((aspect) => strains.map(() => String(aspect))),
    contours: { coloring: "heatmap", showlabels: true, labelfont: { size: 10 } },
    line: { width: 0.6, color: colour("ink") }, colorbar: bar(title),
    hovertemplate: `strain %{x:.4~g}<br>L/W = %{text}<br>${symbol} = %{z:.4~g} ${unit}<extra></extra>` };
}

function drawMap() {
  const sheet = VIEW.sheet, map = mapOf(sheet), strain = sheet.states.strain[VIEW.index];
  plot("map").hidden = map === null;
  if (map === null) return note("map-note", "No critical thickness was computed for this material and bending law.");
  const thickness = 1e3 * sheet.thickness;
  const values = map.values.map((row) => scaled(row, 1e3));
  const range = [0, map.strains[map.strains.length - 1]];
  if (map.aspects.length < 2) return drawCriticalCurve(map, values[0], thickness, strain);
  const scale = aspectScale(map.aspects);
  const border = { type: "contour", x: map.strains, y: map.aspects.map(scale.at), z: values, hoverinfo: "skip",
    contours: { type: "constraint", operation: "=", value: thickness }, showlegend: false,
    line: { color: colour("mark"), width: 2.5 }, showscale: false };
  const computed = { type: "scatter", mode: "markers", hoverinfo: "skip",
    x: map.computed.map((place) => place[0]), y: map.computed.map((place) => scale.at(place[1])),
    marker: { size: 3, color: colour("ink"), opacity: 0.55 } };
  const traces = [contour(map.strains, map.aspects, values, "τ₁", "× 10⁻³ W", "10³ τ₁/W"), border, computed];
  const shapes = [pointShape(strain, scale.at(sheet.aspect))];
  Plotly.react(plot("map"), traces, layoutOf(axis("strain ε", { range }), scale.axis, { shapes }), QUIET);
  const between = map.computed.length ? " Dots: where it was computed; between them it is interpolated." : "";
  note("map-note", `Sheets thinner than τ₁ wrinkle. Thick line: τ₁ = t of this sheet, ${sheet.thickness} W; point: this state.${between}`);
}

// With a single L/W there is no map: the curve of that L/W.
function drawCriticalCurve(map, values, thickness, strain) {
  const hover = "strain %{x:.4~g}<br>τ₁ = %{y:.4~g} × 10⁻³ W<extra></extra>";
  const traces = [
    { type: "scatter", mode: "lines", x: map.strains, y: values, hovertemplate: hover,
      line: { color: colour("curve"), width: 1.6 } },
  ];
  const end = map.strains[map.strains.length - 1];
  const top = 1.1 * Math.max(thickness, ...values.map((value) => value ?? 0));
  const line = { type: "line", x0: 0, x1: end, y0: thickness, y1: thickness,
    line: { color: colour("mark"), width: 1.5, dash: "dash" } };
  Plotly.react(plot("map"), traces, layoutOf(axis("strain ε", { range: [0, end] }),
    axis("10³ τ₁/W", { range: [0, top] }), { shapes: [pointShape(strain, thickness), line] }), QUIET);
  note("map-note", `Only L/W = ${map.aspects[0]} was computed for this material and bending law: τ₁ over strain. The sheet wrinkles where τ₁ is above its t (dashed).`);
}

function moveMap() {
  if (mapOf(VIEW.sheet) !== null && plot("map").data) movePoint("map");
}

function movePoint(id) {
  const [{ yanchor }, ...others] = plot(id).layout.shapes;
  const shapes = [pointShape(VIEW.sheet.states.strain[VIEW.index], yanchor), ...others];
  Plotly.relayout(plot(id), { shapes });
}

function drawTension() {
  const sheet = VIEW.sheet, rows = tensionOf(sheet);
  plot("tension").hidden = rows.length === 0;
  if (!rows.length) return note("tension-note", "This study has no tension field of this material. The config's block tension, or wrinklestudy explore with a sheet of one's own, computes it.");
  const aspects = distinct(rows.map((row) => row.aspect));
  if (aspects.length > 2) return drawTensionMap(rows, aspects);
  const aspect = nearest(aspects, sheet.aspect);
  const own = rows.filter((row) => row.aspect === aspect);
  const x = own.map((row) => row.strain), y = scaled(own.map((row) => row.phi_squared), 1e3);
  const states = sheet.states, thick = scaled(states.phi_squared, 1e3);
  const hover = (name) => `${name}: strain %{x:.4~g}<br>10³ Φ² = %{y:.4~g}<extra></extra>`;
  const traces = [
    { type: "scatter", mode: "lines+markers", x, y, hovertemplate: hover("t → 0"),
      line: { color: colour("curve"), width: 1.6 }, marker: { size: 5 } },
    { type: "scatter", mode: "lines+markers", x: states.strain, y: thick, hovertemplate: hover("this sheet"),
      line: { color: colour("second"), width: 1.2, dash: "dash" }, marker: { size: 3 } },
    marker([states.strain[VIEW.index]], [thick[VIEW.index]], { hovertemplate: hover("this state"), cliponaxis: false }),
  ];
  const top = Math.max(...y.map((v) => v ?? 0), ...thick.map((v) => v ?? 0), 1e-3);
  Plotly.react(plot("tension"), traces, layoutOf(axis("strain ε", { range: [0, 1.02 * Math.max(...x, ...states.strain)] }),
    axis("10³ Φ²", { range: [0, 1.1 * top] })), QUIET);
  const other = aspect === sheet.aspect ? "" : ` It was computed for L/W = ${aspect} only.`;
  note("tension-note", `Full line: Φ² in the limit of no thickness, the width that wrinkles hide. Dashed: this sheet, with its point.${other}`);
}

function drawTensionMap(rows, aspects) {
  const strains = distinct(rows.map((row) => row.strain)), sheet = VIEW.sheet;
  const at = new Map(rows.map((row) => [`${row.aspect} ${row.strain}`, row.phi_squared]));
  const values = aspects.map((a) => scaled(strains.map((e) => at.get(`${a} ${e}`) ?? null), 1e3));
  const scale = aspectScale(aspects);
  const shapes = [pointShape(sheet.states.strain[VIEW.index], scale.at(sheet.aspect))];
  const layout = layoutOf(axis("strain ε", { range: [0, strains[strains.length - 1]] }), scale.axis, { shapes });
  Plotly.react(plot("tension"), [contour(strains, aspects, values, "10³ Φ²", "", "10³ Φ²")], layout, QUIET);
  note("tension-note", "Φ² in the limit of no thickness, the width that wrinkles hide. Point: this state.");
}

function moveTension() {
  const sheet = VIEW.sheet, rows = tensionOf(sheet);
  if (!rows.length || !plot("tension").data) return;
  const many = distinct(rows.map((row) => row.aspect)).length > 2;
  if (many) return movePoint("tension");
  const value = scaled([sheet.states.phi_squared[VIEW.index]], 1e3);
  moveMark("tension", [sheet.states.strain[VIEW.index]], value);
}
