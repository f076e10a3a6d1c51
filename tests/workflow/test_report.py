"""The report is one file that a browser shows without the network: figures, captions, claims."""

import html
import json
import re
import shutil
import subprocess

import pytest

from wrinklestudy.study.loading import load_catalogue

pytestmark = pytest.mark.workflow

CATALOGUE = load_catalogue("panaitescu2019")
OPTIONS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--virtual-time-budget=60000",
]
# Opens what a click on each result would open, and writes down what is then to be seen.
PROBE = """<script>
(async () => {
  const pause = () => new Promise((done) => setTimeout(done, 20));
  while (!app) await pause();
  const page = document.querySelector("#app");
  const seen = {};
  for (const [path, entry] of Object.entries(results)) {
    ReactDOM.flushSync(() => app.showResultInfo(path));
    seen[path] = {text: page.innerText, width: 0};
    if (entry.mime_type === "image/png") {
      const view = {content: "img", contentPath: entry.data_uri, resultPath: path};
      ReactDOM.flushSync(() => app.setView(view));
      const image = [...page.querySelectorAll("img")].find((one) => one.src === entry.data_uri);
      while (!image.complete) await pause();
      seen[path].width = image.naturalWidth;
    }
  }
  const output = document.createElement("pre");
  output.id = "seen";
  output.textContent = JSON.stringify(seen);
  document.body.append(output);
})();
</script>"""


@pytest.fixture(scope="module")
def report(finished_quick, tmp_path_factory):
    """The report of the quick study, as text."""
    path = tmp_path_factory.mktemp("report") / "report.html"
    run = finished_quick.snakemake("--report", str(path))
    assert run.returncode == 0, run.stderr
    return path.read_text()


def embedded(report, name):
    """Return one of the values that the page holds for its scripts."""
    found = re.search(rf"var {name} = (.*?);\n", report)
    assert found is not None
    return json.loads(found[1])


@pytest.fixture(scope="module")
def seen(report, tmp_path_factory):
    """What a browser shows of each result: text and width of the picture."""
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if browser is None:
        pytest.skip("no chromium here: the report was not opened in a browser")
    folder = tmp_path_factory.mktemp("browser")
    start, end = report.rsplit("</body>", 1)
    (folder / "probe.html").write_text(f"{start}{PROBE}</body>{end}")
    profile, page = f"--user-data-dir={folder / 'profile'}", (folder / "probe.html").as_uri()
    run = subprocess.run(
        [browser, *OPTIONS, profile, "--dump-dom", page],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    found = re.search(r'<pre id="seen">(.*?)</pre>', run.stdout, flags=re.DOTALL)
    assert found is not None, run.stderr[-2000:]
    return json.loads(html.unescape(found[1]))


# What a reader must be told of each file that is no figure.
TOLD = {
    "claims/claims.html": ("claimed", "computed", "agree", "tolerance"),
    "claims/claims.csv": ("claimed", "computed", "agree", "tolerance"),
    "claims/table1.csv": ("Table I", "computed"),
    "summary/peaks.csv": (
        "each sheet",
        "birth",
        "decay",
        "largest amplitude",
        "confinement",
        "mesh",
    ),
}


def assert_told_of_a_figure(text, name):
    assert re.search(r"From: wrinklestudy [\d.]+, code [0-9a-f]{16}; h5py ", text)
    assert f"Figure {CATALOGUE.figure(name).panel}. " in text
    if name == "fig01_stress":
        assert "latex (mooney-rivlin, data/latex_panaitescu2019.csv)" in text
    else:
        assert "Shown: latex, L/W = 2, t/W = 0.001: strain 0.1" in text
        assert "12 x 18 cells on the quarter sheet" in text


@pytest.fixture(scope="module")
def captions(report):
    """The caption of each file, as plain text."""
    (entries,) = re.findall(r"var results = (\{.*?\});\n", report)
    return {
        path: html.unescape(re.sub("<[^>]*>", "", entry["caption"]))
        for path, entry in json.loads(entries).items()
    }


@pytest.mark.parametrize("name", CATALOGUE.figure_names)
def test_a_caption_says_which_sheets_and_meshes_a_figure_shows(captions, name):
    assert_told_of_a_figure(captions[f"figures/quick/{name}.png"], name)


@pytest.mark.parametrize("name", TOLD)
def test_a_caption_says_what_a_table_holds(captions, name):
    text = " ".join(captions[f"results/quick/{name}"].split())
    assert [told for told in TOLD[name] if told not in text] == []


@pytest.mark.parametrize("name", CATALOGUE.figure_names)
def test_a_browser_shows_every_figure_with_its_caption(seen, name):
    shown = seen[f"figures/quick/{name}.png"]
    assert shown["width"] > 500
    assert_told_of_a_figure(shown["text"], name)


@pytest.mark.parametrize("name", TOLD)
def test_a_browser_shows_claims_and_tables_with_their_captions(seen, name):
    text = " ".join(seen[f"results/quick/{name}"]["text"].split())
    assert [told for told in TOLD[name] if told not in text] == []


def test_figures_stand_once_and_in_their_part(report):
    parts = embedded(report, "categories")
    placed = {path: part for part, found in parts.items() for one in found.values() for path in one}
    figures = {path: part for path, part in placed.items() if path.startswith("figures/")}
    assert figures == {f"figures/quick/{entry.name}.png": entry.part for entry in CATALOGUE.figures}
    assert [placed[path] for path in placed if path not in figures] == [CATALOGUE.tables_part] * 4


def test_run_times_of_every_stage_are_there(report, finished_quick):
    times = embedded(report, "runtimes_spec")["data"]["values"]
    stages = {path.name for path in (finished_quick.folder / "results" / "quick").iterdir()}
    assert {one["rule"] for one in times} == (stages - {"log", "benchmark", ".record"}) | {
        "figures"
    }
    assert all(one["runtime"] > 0 for one in times)


def test_nothing_is_loaded_from_elsewhere(report):
    assert not re.findall(r"""<(?:script|link|img|iframe)[^>]*(?:src|href)=["']https?:""", report)
