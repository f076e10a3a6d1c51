// Colours, and what all plots have in common.

const QUIET = { displayModeBar: false, responsive: true, scrollZoom: false, doubleClick: false };
const HAS_WEBGL = (() => {
  try {
    const canvas = document.createElement("canvas");
    return Boolean(canvas.getContext("webgl") || canvas.getContext("webgl2"));
  } catch {
    return false;
  }
})();

function isDark() {
  if (VIEW.theme) return VIEW.theme === "dark";
  return matchMedia("(prefers-color-scheme: dark)").matches;
}

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function applyTheme() {
  if (VIEW.theme) document.documentElement.dataset.theme = VIEW.theme;
  else delete document.documentElement.dataset.theme;
  const button = document.getElementById("theme");
  button.textContent = isDark() ? "Light" : "Dark";
  button.setAttribute("aria-label", `Switch to ${isDark() ? "light" : "dark"} colours`);
}

function axis(title, more = {}) {
  return {
    title: { text: title, standoff: 6, font: { size: 12 } },
    color: colour("ink"), gridcolor: colour("line"), zerolinecolor: colour("line"),
    linecolor: colour("second"), showline: true, ticks: "inside", ticklen: 4, nticks: 6,
    automargin: true, fixedrange: true, ...more,
  };
}

function layoutOf(x, y, more = {}) {
  return {
    paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)", showlegend: false,
    font: { family: "system-ui, sans-serif", size: 12, color: colour("ink") },
    margin: { l: 48, r: 10, t: 8, b: 38 }, dragmode: false, hovermode: "closest",
    hoverlabel: { bgcolor: colour("panel"), bordercolor: colour("curve"),
      font: { color: colour("ink") } },
    ...(x && { xaxis: x, yaxis: y }), ...more,
  };
}

function marker(x, y, more = {}) {
  return { type: "scatter", mode: "markers", x, y,
    marker: { color: colour("mark"), size: 12, symbol: "circle",
      line: { color: colour("panel"), width: 1.5 } }, ...more };
}

// A point on axes that takes no new contours to move.
function pointShape(x, y) {
  return { type: "circle", xsizemode: "pixel", ysizemode: "pixel", xanchor: x, yanchor: y,
    x0: -6, x1: 6, y0: -6, y1: 6, fillcolor: colour("mark"), line: { color: colour("panel"), width: 1.5 } };
}

function note(id, text) {
  document.getElementById(id).textContent = text;
}
