// What happens when: choices, strain, play, keys, links, files, print.

const REDUCED = matchMedia("(prefers-reduced-motion: reduce)");
const PAUSE = 160, SLOW_PAUSE = 1500; // ms between states
let playing = 0, waiting = 0;

const part = (id) => document.getElementById(id);

function fillChoices() {
  const { options } = chosenSheet(wishesOf(VIEW.sheet));
  for (const level of LEVELS) {
    const select = part(level);
    select.replaceChildren(...options[level].map((value) => new Option(String(value), String(value))));
    select.value = String(VIEW.sheet[level]);
    select.closest("label").hidden = false;
    select.disabled = options[level].length < 2;
  }
  note("constants", NUMBERS.constants[VIEW.sheet.material] ?? "");
  const slider = part("strain");
  slider.max = VIEW.sheet.states.strain.length - 1;
}

function setControls() {
  part("strain").value = VIEW.index;
  part("zoom").value = Math.log10(VIEW.zoom);
  note("zoom-value", `× ${digits(VIEW.zoom, 2)}`);
  part("zoom").setAttribute("aria-valuetext", `${digits(VIEW.zoom, 2)} times`);
  part("zoom").closest(".inner").hidden = !HAS_WEBGL;
}

// In this order; three dimensions take longest.
const STEPS = [...Object.keys(CURVES).map((id) => () => drawCurve(id)), drawProfile, listen,
  drawMap, drawTension, drawSheetAndListen];

function showChoice() {
  clearTimeout(waiting);
  fillChoices();
  setControls();
  speak(sayState());
  writeFragment();
}

function drawAll() {
  showChoice();
  if (document.documentElement.dataset.sheet !== "drawn") return drawInTurn(STEPS);
  STEPS.slice(0, -1).forEach((draw) => draw());
  waiting = setTimeout(drawSheetAndListen, 0);
}

// At first the page answers between the plots: controls and numbers work before there is any.
function drawInTurn([draw, ...others]) {
  waiting = setTimeout(() => {
    draw();
    if (others.length) drawInTurn(others);
  }, 0);
}

function drawNow() {
  showChoice();
  STEPS.forEach((draw) => draw());
}

function drawSheetAndListen() {
  drawSheet();
  document.documentElement.dataset.sheet = "drawn";
  if (!HAS_WEBGL) return;
  plot("sheet").removeAllListeners("plotly_relayout");
  plot("sheet").on("plotly_relayout", (change) => {
    const eye = change["scene.camera"]?.eye;
    if (!eye) return;
    VIEW.eye = [eye.x, eye.y, eye.z];
    writeFragment();
  });
}

function moveTo(index) {
  VIEW.index = index;
  setControls();
  moveSheet();
  Object.keys(CURVES).forEach(moveCurve);
  moveProfile();
  moveMap();
  moveTension();
  const words = sayState();
  if (!playing) { // neither readers nor the address bar are to follow every state of a film
    speak(words);
    writeFragment();
  }
}

// Plotly has its own events, which are there once a plot is drawn.
function listen() {
  for (const id of Object.keys(CURVES)) {
    const element = plot(id);
    element.removeAllListeners("plotly_click");
    element.on("plotly_click", (event) => moveTo(stateNearest(VIEW.sheet, event.points[0].x)));
  }
}

function stop() {
  clearTimeout(playing);
  playing = 0;
  part("play").textContent = "▶ Play";
  part("play").setAttribute("aria-pressed", "false");
  speak(sayState());
  writeFragment();
}

function step() {
  const last = VIEW.sheet.states.strain.length - 1;
  moveTo(Math.min(VIEW.index + 1, last));
  if (VIEW.index >= last) return stop();
  playing = setTimeout(step, REDUCED.matches ? SLOW_PAUSE : PAUSE);
}

function toggle() {
  if (playing) return stop();
  part("play").textContent = "❚❚ Pause";
  part("play").setAttribute("aria-pressed", "true");
  playing = setTimeout(step, 0);
  if (VIEW.index >= VIEW.sheet.states.strain.length - 1) moveTo(0);
}

function choose() {
  const strain = VIEW.sheet.states.strain[VIEW.index];
  const wishes = Object.fromEntries(LEVELS.map((level) => {
    const text = part(level).value;
    return [level, typeof VIEW.sheet[level] === "number" ? Number(text) : text];
  }));
  if (playing) stop();
  VIEW.sheet = chosenSheet(wishes).sheet;
  VIEW.index = stateNearest(VIEW.sheet, strain);
  VIEW.zoom = fittingZoom(VIEW.sheet);
  drawAll();
}

async function copyLink() {
  writeFragment();
  try {
    await navigator.clipboard.writeText(location.href);
    note("live", "Link copied.");
    part("link").textContent = "Copied";
  } catch {
    part("link").textContent = "It is in the address bar";
  }
  setTimeout(() => { part("link").textContent = "Copy link"; }, 2500);
}

function fileName(what) {
  const sheet = VIEW.sheet;
  const name = `${sheet.model}_aspect${sheet.aspect}_thickness${sheet.thickness}_${what}`;
  return `${name.replace(/[^\w.-]+/g, "-")}.csv`;
}

function redrawn(theme) {
  VIEW.theme = theme;
  applyTheme();
  drawAll();
}

// What is printed is dark on white, and as wide as the paper.
let themeBefore = null;

function startPrint() {
  if (themeBefore !== null) return;
  if (playing) stop();
  themeBefore = VIEW.theme;
  document.documentElement.classList.add("printing");
  Plotly.purge(plot("sheet")); // a scene that was turned keeps its width on the screen
  VIEW.theme = "light";
  applyTheme();
  drawNow();
  document.querySelectorAll(".plot").forEach((element) => {
    const { clientWidth: width, clientHeight: height } = element;
    if (element.data && width) Plotly.relayout(element, { width, height });
  });
}

function endPrint() {
  if (themeBefore === null) return;
  document.documentElement.classList.remove("printing");
  redrawn(themeBefore);
  themeBefore = null;
}

function connect() {
  LEVELS.forEach((level) => part(level).addEventListener("change", choose));
  part("strain").addEventListener("input", () => moveTo(Number(part("strain").value)));
  part("zoom").addEventListener("input", () => {
    VIEW.zoom = 10 ** Number(part("zoom").value);
    setControls();
    if (plot("sheet").data) drawSheet();
    writeFragment();
  });
  part("play").addEventListener("click", toggle);
  part("link").addEventListener("click", copyLink);
  part("theme").addEventListener("click", () => redrawn(isDark() ? "light" : "dark"));
  part("states-csv").addEventListener("click", () => download(fileName("states"), statesCsv(VIEW.sheet)));
  part("profile-csv").addEventListener("click", () =>
    download(fileName(`profile_strain${VIEW.sheet.states.strain[VIEW.index]}`), profileCsv(VIEW.sheet, VIEW.index)));
  part("map-csv").addEventListener("click", () => download(fileName("map"), mapCsv(VIEW.sheet)));
  document.addEventListener("keydown", (event) => {
    const taken = event.target.closest?.("button, select, a");
    if (event.key !== " " || taken || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    if (!event.repeat) toggle();
  });
  addEventListener("hashchange", () => {
    if (location.hash === fragment()) return;
    if (playing) stop();
    readFragment();
    applyTheme();
    drawAll();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    if (!VIEW.theme) redrawn("");
  });
  addEventListener("beforeprint", startPrint);
  addEventListener("afterprint", endPrint);
}

try {
  readFragment();
  applyTheme();
  connect();
  drawAll();
  document.documentElement.dataset.ready = performance.now().toFixed(0);
} catch (error) {
  part("broken").hidden = false;
  note("broken", `This page could not be drawn (${error.message}).`);
  throw error;
}
