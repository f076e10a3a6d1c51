"""The page in a real browser: it says and draws what the tables hold, by mouse, key and link."""

import csv
import re
import shutil
import time
from dataclasses import replace
from urllib.parse import parse_qs, urlencode

import numpy as np
import pytest
from playwright.sync_api import expect, sync_playwright

from wrinklestudy.explorer.page import write_page
from wrinklestudy.metrics.profile import profile_from_state

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
SOFTWARE_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
OPTIONS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking"]
CURVES = {
    "amplitude": ("amplitude_over_thickness", 1.0),
    "wavelength": ("wavelength_over_width", 1.0),
    "phi": ("phi_squared", 1e3),
}
SAID = {"wrinkled": "wrinkled", "flat": "flat", "not-converged": "did not converge"}
SIZE = {"width": 1100, "height": 800}
START = {"material": "rubber", "bending": "thinning", "aspect": "2", "thickness": "0.001"}
GO = """(fragment) => new Promise((done) => {
  addEventListener("hashchange", () => setTimeout(done, 30), { once: true });
  location.hash = `${fragment}&once=${Math.random()}`;
})"""
LOCAL = ("file:", "data:", "blob:")
expect.set_options(timeout=30_000)  # in ms; WebGL in software takes its time on a busy machine

pytestmark = pytest.mark.skipif(
    CHROMIUM is None, reason="no chromium here: the explorer was not opened in a browser"
)


@pytest.fixture(scope="module")
def playwright():
    with sync_playwright() as driver:
        yield driver


@pytest.fixture(scope="module")
def browser(playwright):
    started = playwright.chromium.launch(executable_path=CHROMIUM, args=[*OPTIONS, *SOFTWARE_WEBGL])
    yield started
    started.close()


@pytest.fixture(scope="module")
def file(content, tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "explorer.html"
    write_page(content, path)
    return path


class Watched:
    """Pages of which everything is recorded that they complain of or ask the network for."""

    def __init__(self, browser, file):
        self.browser, self.file = browser, file
        self.problems, self.contexts = [], []
        self.shared = None

    def load(self, path, fragment="", browser=None):
        """Return a page of its own."""
        self.contexts.append((browser or self.browser).new_context(viewport=SIZE))
        page = self.contexts[-1].new_page()
        page.on("console", self.record_line)
        page.on("pageerror", lambda error: self.problems.append(f"error: {error}"))
        page.on("request", self.record_request)
        page.goto(f"{path.as_uri()}{fragment}")
        page.wait_for_selector("html[data-sheet=drawn]")
        return page

    def open(self, **wishes):
        """Return the page that tests share, at its start but for some parts of the fragment."""
        if self.shared is None:
            self.shared = self.load(self.file)
        self.shared.set_viewport_size(SIZE)
        self.shared.emulate_media(
            media="screen", color_scheme="light", reduced_motion="no-preference"
        )
        self.shared.evaluate(GO, f"#{urlencode(START | wishes)}")
        return self.shared

    def record_line(self, line):
        if "GL Driver Message (OpenGL, Performance" not in line.text:  # of WebGL without a GPU
            self.problems.append(f"{line.type}: {line.text}")

    def record_request(self, request):
        if not request.url.startswith(LOCAL):
            self.problems.append(request.url)

    def close(self, kept=()):
        for context in self.contexts:
            if context not in kept:
                context.close()
        self.contexts = list(kept)


@pytest.fixture(scope="module")
def watched(browser, file):
    pages = Watched(browser, file)
    yield pages
    pages.close()


@pytest.fixture
def pages(watched):
    """Pages that must ask for nothing and complain of nothing."""
    watched.problems.clear()
    yield watched
    watched.close(kept=[watched.shared.context] if watched.shared else [])
    assert watched.problems == []


@pytest.fixture
def page(pages):
    """The page at its start."""
    return pages.open()


def sheet_of(content, index=0):
    return content.sheets[index].sheet


def until(page, condition):
    """Wait for a condition; the page forbids what Playwright's own waiting evaluates."""
    for _ in range(300):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(100)
    raise AssertionError(condition)


def trace(page, plot, index, *names):
    """Return columns of a trace of a plot as lists."""
    read = """([plot, k, names]) => {
      const trace = document.getElementById(plot).data.at(k);
      return names.map((name) => [...trace[name]]);
    }"""
    return page.evaluate(read, [plot, index, list(names)])


def mark(page, plot):
    """Return the point that a curve has marked."""
    (x,), (y,) = trace(page, plot, -1, "x", "y")
    return x, y


def index_of(page):
    return int(page.locator("#strain").input_value())


def go_to(page, index):
    page.locator("#strain").fill(str(index))


def wait_for(page, index):
    expect(page.locator("#strain")).to_have_value(str(index))


def test_it_opens_at_the_highest_wrinkles_and_draws_the_sheet(pages, content):
    page = pages.load(pages.file)
    sheet = sheet_of(content)
    heights = np.nan_to_num(sheet.column("amplitude_over_thickness"))
    assert index_of(page) == np.argmax(heights)
    assert page.locator("#broken").is_hidden()
    assert page.locator("#sheet canvas").count() > 0
    rows = trace(page, "sheet", 0, "z")[0]
    drawn = np.abs(np.array([list(row.values()) if isinstance(row, dict) else row for row in rows]))
    zoom = float(page.locator("#zoom-value").inner_text().removeprefix("× "))
    shape = content.sheets[0].shapes[index_of(page)]
    exact = np.abs(shape.evaluate(np.linspace(0, 1, 41), np.linspace(0, 0.5, 121))[2]).max()
    assert drawn.max() == pytest.approx(zoom * exact, rel=1e-3)


def test_the_slider_moves_marks_and_profile_to_the_values_of_the_table(page, content):
    sheet = sheet_of(content)
    for index, (row, shape) in enumerate(zip(sheet.states, content.sheets[0].shapes, strict=True)):
        go_to(page, index)
        assert page.locator("#status").inner_text() == SAID[row.status]
        for plot, (name, factor) in CURVES.items():
            value = getattr(row, name)
            height = None if value is None else pytest.approx(factor * value, rel=1e-12)
            assert mark(page, plot) == (row.strain, height)
        y, z = trace(page, "profile", 0, "x", "y")
        if shape is None:
            assert (y, z) == ([], [])
            assert "did not converge" in page.locator("#profile-note").inner_text()
            continue
        line = profile_from_state(shape)
        tolerance = 1e-3 * max(np.abs(line.z).max() / sheet.thickness, 1e-6)
        exact = np.interp(y, line.y, line.z) / sheet.thickness
        np.testing.assert_allclose(z, exact, atol=tolerance)
        assert (y[0], y[-1]) == pytest.approx((line.y[0], line.y[-1]), abs=1e-6)


def test_a_curve_has_holes_where_states_did_not_converge(page, content):
    (heights,) = trace(page, "amplitude", 1, "y")
    assert heights == [row.amplitude_over_thickness for row in sheet_of(content).states]
    assert trace(page, "amplitude", 2, "x") == [[0.2]]


def test_arrow_keys_move_the_strain(page):
    go_to(page, 1)
    page.locator("#strain").focus()
    page.keyboard.press("ArrowRight")
    assert index_of(page) == 2
    page.keyboard.press("Home")
    assert index_of(page) == 0
    page.keyboard.press("End")
    assert index_of(page) == 6
    outline = "getComputedStyle(document.activeElement).outlineStyle"
    assert page.evaluate(outline) == "solid"


def test_space_plays_to_the_end_and_stops_there(page):
    go_to(page, 3)
    page.locator("body").press(" ")
    assert page.locator("#play").get_attribute("aria-pressed") == "true"
    wait_for(page, 6)
    page.wait_for_selector("#play[aria-pressed=false]")
    assert mark(page, "amplitude")[0] == 0.46


def test_the_button_plays_from_the_start_and_pauses(page):
    go_to(page, 6)
    page.locator("#play").click()
    expect(page.locator("#strain")).not_to_have_value("6")
    page.locator("#play").click()
    expect(page.locator("#play")).to_contain_text("Play")
    stopped = index_of(page)
    page.wait_for_timeout(500)
    assert index_of(page) == stopped


def test_who_wants_less_motion_gets_slow_steps(page):
    page.emulate_media(reduced_motion="reduce")
    go_to(page, 0)
    page.locator("#play").click()
    wait_for(page, 1)
    start = time.monotonic()
    wait_for(page, 2)
    assert time.monotonic() - start > 1.0


def test_a_link_brings_the_view_back(page, pages):
    page.locator("#bending").select_option("thinning")
    page.locator("#thickness").select_option("0.0005")
    go_to(page, 2)
    page.locator("#zoom").fill("1.5")
    page.locator("#theme").click()
    fragment = page.evaluate("location.hash")
    again = pages.load(pages.file, fragment)
    for control in ("#material", "#bending", "#thickness", "#strain", "#zoom"):
        assert again.locator(control).input_value() == page.locator(control).input_value()
    assert again.locator("#thickness").input_value() == "0.0005"
    assert mark(again, "amplitude") == mark(page, "amplitude")
    assert again.evaluate("document.documentElement.dataset.theme") == "dark"
    assert again.evaluate("location.hash") == fragment


def test_a_changed_fragment_changes_the_page(page):
    page.evaluate("location.hash = '#material=stiff&strain=0.33'")
    expect(page.locator("#material")).to_have_value("stiff")
    assert mark(page, "amplitude") == (0.32, 0.0)


@pytest.mark.parametrize(
    "fragment",
    [
        "#material=<img src=x onerror=hacked=1>&strain=many&z=-3&eye=a,b,c&theme=pink",
        "#strain=&z=&aspect=NaN&thickness=Infinity",
        "#%E0%A4%A",
    ],
)
def test_a_fragment_that_makes_no_sense_is_no_harm(page, fragment):
    page.evaluate(GO, fragment)
    assert page.locator("#material").input_value() == "rubber"
    assert page.evaluate("typeof hacked") == "undefined"


def test_a_flat_state_is_flat_and_called_so(pages):
    page = pages.open(material="stiff", strain="0.1")
    assert page.locator("#status").inner_text() == "flat"
    assert "The sheet is flat" in page.locator("#sheet-note").inner_text()
    (z,) = trace(page, "profile", 0, "y")
    assert set(z) == {0}


def test_map_and_tension_field_mark_the_point_or_say_what_is_missing(pages):
    page = pages.open(strain="0.1")
    shape = "document.getElementById('map').layout.shapes[0]"
    assert page.evaluate(f"[{shape}.xanchor, 10 ** {shape}.yanchor]") == pytest.approx([0.1, 2.0])
    go_to(page, 3)
    assert page.evaluate(f"{shape}.xanchor") == 0.12
    (values,) = trace(page, "map", 0, "z")
    assert values[2][2] is None
    assert values[1] == pytest.approx([0.525, 0.55, 0.65])
    assert trace(page, "tension", 0, "x", "y") == [[0.05, 0.2, 0.4], pytest.approx([0.1, 0.4, 0.8])]
    page.locator("#material").select_option("stiff")
    assert page.locator("#map").is_hidden()
    assert "No critical thickness" in page.locator("#map-note").inner_text()
    assert "no tension field" in page.locator("#tension-note").inner_text()


@pytest.mark.parametrize(
    ("plot", "number", "told"),
    [
        ("amplitude", 1, "strain 0.1A = 2.1 t"),
        ("wavelength", 1, "strain 0.1λ = 0.13 W"),
        ("phi", 1, "10³ Φ² = "),
    ],
)
def test_the_pointer_is_told_values_with_units(pages, plot, number, told):
    page = pages.open(strain="0.1")
    hover = "([plot, curveNumber]) => Plotly.Fx.hover(plot, [{ curveNumber, pointNumber: 2 }])"
    page.evaluate(hover, [plot, number])
    assert told in page.locator(f"#{plot} .hovertext").text_content()


def test_the_pointer_is_told_values_of_the_map(pages):
    page = pages.open(strain="0.1")
    page.locator("#map").hover(position={"x": 150, "y": 120})
    expect(page.locator("#map .hovertext")).to_have_text(
        re.compile(r"strain 0\.\d+L/W = [124]τ₁ = \d.* × 10⁻³ W")
    )


def test_a_turned_sheet_stays_turned_and_is_in_the_link(page):
    # what dragging does in the end; drawn in software, the sheet follows a mouse too slowly
    camera = "{eye: {x: -0.5, y: 0.9, z: 1.8}}"
    page.evaluate(f"Plotly.relayout('sheet', {{'scene.camera': {camera}}})")
    expect(page).to_have_url(re.compile("eye="))
    eye = "Object.values(document.getElementById('sheet').layout.scene.camera.eye)"
    turned = page.evaluate(eye)
    linked = parse_qs(page.url.partition("#")[2])["eye"][0]
    assert [float(part) for part in linked.split(",")] == pytest.approx(turned, abs=1e-3)
    go_to(page, 1)
    assert page.evaluate(eye) == turned


def downloaded(page, button):
    with page.expect_download() as download:
        page.locator(button).click()
    with open(download.value.path(), encoding="utf-8", newline="") as file:
        return download.value.suggested_filename, list(csv.DictReader(file))


def test_the_downloads_have_the_numbers(pages, content):
    page = pages.open(strain="0.1")
    name, rows = downloaded(page, "#states-csv")
    assert name == "rubber_aspect2_thickness0.001_states.csv"
    assert [float(row["strain"]) for row in rows] == list(sheet_of(content).column("strain"))
    for row, state in zip(rows, sheet_of(content).states, strict=True):
        assert row["status"] == state.status
        known = state.amplitude_over_thickness
        assert row["amplitude_over_thickness"] == "" if known is None else True
        assert known is None or float(row["amplitude_over_thickness"]) == known
    _, profile = downloaded(page, "#profile-csv")
    assert [float(row["z_over_thickness"]) for row in profile] == trace(page, "profile", 0, "y")[0]
    _, points = downloaded(page, "#map-csv")
    at = {
        (row["quantity"], float(row["aspect"]), float(row["strain"])): row["value"]
        for row in points
    }
    assert float(at["critical_thickness", 2.0, 0.1]) == 1e-3 * 1.1 / 2.0
    assert at["critical_thickness", 4.0, 0.3] == ""
    assert float(at["phi_squared_of_tension_field", 2.0, 0.2]) == 4e-4


def test_screen_readers_are_told_values_and_names(page):
    go_to(page, 2)
    expect(page.locator("#live")).to_contain_text("Strain 0.1: state wrinkled, amplitude 2.1 t")
    assert page.locator("#strain").get_attribute("aria-valuetext") == "strain 0.1, wrinkled"
    nameless = """[...document.querySelectorAll("button, select, input")].filter((one) =>
        !one.labels?.length && !one.getAttribute("aria-label") && !one.textContent.trim())"""
    assert page.evaluate(f"{nameless}.length") == 0
    assert page.get_by_role("slider", name="Strain").count() == 1
    assert page.evaluate("document.getElementById('live').getAttribute('aria-live')") == "polite"
    labels = page.locator(".plot").evaluate_all("(all) => all.map((one) => one.ariaLabel)")
    assert all("Strain 0.1" in label for label in labels)


@pytest.mark.parametrize("width", [320, 390, 699, 1024, 1920])
def test_nothing_is_wider_than_the_screen(page, width):
    page.set_viewport_size({"width": width, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    lefts = page.locator(".panel").evaluate_all(
        "(all) => all.map((one) => one.getBoundingClientRect().left)"
    )
    assert (len(set(lefts)) == 1) == (width < 700)


def test_dark_and_light_follow_the_system_and_the_switch(page):
    def background(page):
        colour = page.evaluate("getComputedStyle(document.body).backgroundColor")
        return sum(int(part) for part in colour[4:-1].split(",")) / 3

    assert background(page) > 200
    page.emulate_media(color_scheme="dark")
    assert background(page) < 60
    page.locator("#theme").click()
    assert background(page) > 200


def test_print_is_dark_on_white_without_controls(pages):
    page = pages.load(pages.file)
    page.emulate_media(color_scheme="dark")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert page.locator("#play").is_hidden()
    ink = page.evaluate("document.getElementById('amplitude').layout.font.color")
    assert ink == "#1a1a1a"
    clipped = """[...document.querySelectorAll(".plot:not([hidden])")].filter((plot) =>
        plot.scrollWidth > plot.clientWidth || plot.clientWidth > 710)"""
    until(page, f"{clipped}.length === 0")  # the sheet is drawn again, in its time
    page.emulate_media(media="screen")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.evaluate("document.documentElement.dataset.theme ?? ''") == ""
    until(page, "document.getElementById('profile').getBoundingClientRect().width > 1000")


def test_names_that_look_like_markup_are_text(pages, hostile, tmp_path):
    path = tmp_path / "hostile.html"
    write_page(hostile, path)
    page = pages.load(path)
    name = hostile.sheets[0].material
    assert page.evaluate("typeof hacked") == "undefined"
    assert page.locator("#material").input_value() == name
    assert page.locator("h1").inner_text() == hostile.title
    assert page.locator("#constants").inner_text() == f"<b>{name}</b>"
    assert page.locator("img").count() == 0


def test_even_wrinkles_are_mirrored_as_even(pages, content, tmp_path):
    first = content.sheets[0]
    even = replace(first.sheet, row=replace(first.sheet.row, parity="symmetric"))
    path = tmp_path / "even.html"
    write_page(replace(content, sheets=[replace(first, sheet=even)]), path)
    page = pages.load(path)
    (z,) = trace(page, "profile", 0, "y")
    assert z == z[::-1]
    assert max(z) > 1.0
    (odd,) = trace(pages.open(), "profile", 0, "y")
    np.testing.assert_allclose(odd, -np.array(odd[::-1]), atol=1e-12)


def test_without_webgl_it_works_and_says_so(pages, playwright):
    flat = playwright.chromium.launch(
        executable_path=CHROMIUM, args=[*OPTIONS, "--disable-3d-apis"]
    )
    page = pages.load(pages.file, browser=flat)
    assert "No WebGL" in page.locator("#sheet-note").inner_text()
    go_to(page, 2)
    assert mark(page, "amplitude")[0] == 0.1
    assert page.locator("#sheet .heatmaplayer image").count() == 1
    flat.close()


def test_a_turned_sheet_is_printed_no_wider_than_the_paper(pages):
    page = pages.load(pages.file)
    page.evaluate("Plotly.relayout('sheet', {'scene.camera': {eye: {x: -0.5, y: 0.9, z: 1.8}}})")
    expect(page).to_have_url(re.compile("eye="))
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    right = "document.body.getBoundingClientRect().right"
    wide = f"""[...document.querySelectorAll("#sheet canvas")].filter(
        (drawn) => drawn.getBoundingClientRect().right > {right}).length"""
    until(page, f"document.querySelectorAll('#sheet canvas').length > 0 && {wide} === 0")
    eye = page.evaluate("Object.values(document.getElementById('sheet').layout.scene.camera.eye)")
    assert eye == [-0.5, 0.9, 1.8]
