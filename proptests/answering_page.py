#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Uses the page of js/page in Chromium, as a reader does: what is pasted, dragged, nudged, linked and programmed there is
answered as the program answers it.

  answering_page.py --package FOLDER --program PATH   the page around the module of an npm package (build/wasm/package)
  answering_page.py ... --only WORD                   the checks whose name has this word
  answering_page.py ... --pictures FOLDER             pictures of the page: wide, narrow, dark

Exits with 77 where there is no Chromium, or no module.
"""
import argparse
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

from opened_pages import PHONE, Browser
from page_reader import Reader, served

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77
WIDE = 1280, 900
COLLINEAR = '{"p0":[0,0],"p1":[0.9,0.3],"p":[0.3,0.1]}'  # as decimals, not as doubles
OVERLAP = '{"a":[[0,0],[2,0]],"b":[[1,0],[3,0]]}'  # the textbook formula says disjoint
RAY = '{"ray":{"origin":[0,0,3],"direction":[0,0,-1]},"triangle":[[-1,-1,0],[2,-1,0],[0,2,0]]}'
PLANE = '{"sphere":{"center":[0,2,0],"radius":1},"plane":{"normal":[0,1,0],"offset":0}}'
NAMES = """[...document.querySelectorAll('button, input, select, textarea, canvas, svg[tabindex], .handle')].filter(one =>
  !(one.textContent.trim() || one.getAttribute('aria-label') || one.labels?.length || one.title)).map(one => one.outerHTML)"""


def pasted_json(reader):
    reader.open("#op=segment_segment")
    reader.paste(OVERLAP)
    wanted = reader.answered("segment_segment", OVERLAP)
    row = reader.run("document.querySelector('[data-part=double]').innerText")
    assert wanted["reference"]["cause"] == "algorithm" and "algorithm" in row and "disjoint" in row, row
    assert "accepts" in reader.text("[data-part=certificate]")


def pasted_line_of_a_report(reader):
    table = reader.told("audit", "--ops", "orientation", "--cases", "200", "--jobs", "1")
    line = next(line for line in table.splitlines() if line.lstrip().startswith("repeat"))
    answered = '{"op":"orientation","input":' + COLLINEAR + ',"answer":{"side":"on"}}'
    for text in (line, answered):
        reader.open("#op=ray_sphere")
        reader.paste(text)
        wanted = reader.answered("orientation", text[text.index('{"p0"'):text.index("]}") + 2])
    given = "document.querySelector('[data-part=given] .badge')?.textContent"
    assert reader.run(given) == "rounding", reader.text("#answers")
    reader.paste(answered.replace("on\"}}", wanted["truth"]["side"] + "\"}}"))
    assert reader.run(given) == "agree", reader.text("#answers")
    reader.click("[data-path='[\"p\",0]'][data-ulps='1']")
    assert reader.run(given) is None, "an answer is not that of another question"


def pasted_geometries(reader):
    for between in ("; ", "\n", "\n  \n"):
        reader.open("#op=segment_segment")
        reader.paste(f"LINESTRING (0 0, 2 0){between}LINESTRING (1 0, 0.10 3)")
        reader.answered("segment_segment", '{"a":[[0,0],[2,0]],"b":[[1,0],[0.1,3]]}')
    reader.open("#op=point_in_polygon")
    reader.paste('{"type":"GeometryCollection","geometries":[{"type":"Polygon","coordinates":[[[0,0],[4,0],[0,4],[0,0]]]},'
                 '{"type":"Point","coordinates":[1,1]}]}')
    reader.answered("point_in_polygon")
    reader.open("#op=point_in_polyhedron")
    reader.paste("# a comment\nv 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1/1 3/2 2/3\nf 1 2 4\nf 2 3 4\nf -4 -1 -2\n")
    reader.answered("point_in_polyhedron")
    assert json.loads(reader.text())["mesh"]["faces"][3] == [0, 3, 2]


def what_is_wrong_is_said(reader):
    reader.open("#op=orientation")
    for text, why in (("{", "not JSON: the text ends in column 2"), ("p: 1 2", "this is no JSON, WKT, GeoJSON or OBJ")):
        reader.paste(text)
        assert reader.text("#text-says") == why, reader.text("#text-says")
    reader.paste('{"p0":[0,0],"p1":[1,1],"p":[1]}')
    assert "p: " in reader.text("[data-part=refused]"), reader.text("#answers")
    reader.paste(COLLINEAR)
    reader.answered("orientation", COLLINEAR)
    assert reader.text("#text-says") == ""


def decimals_as_typed(reader):
    reader.ask("orientation", COLLINEAR)
    assert reader.answered("orientation")["truth"]["side"] != "on"
    assert '"on"' in reader.text("[data-part=as-typed]"), reader.text("[data-part=as-typed]")


def dragged_in_the_plane(reader):
    reader.ask("segment_segment", OVERLAP)
    reader.drag("b[1]", 20, -60)
    now = json.loads(reader.text())
    assert now["a"] == [[0, 0], [2, 0]] and now["b"][0] == [1, 0] and now["b"][1][1] > 0.1, now
    reader.answered("segment_segment")
    reader.click("#undo")  # of the drag, which moved it eight times
    reader.answered("segment_segment", OVERLAP)
    reader.run("document.querySelector('#snap').value = '-1'")
    reader.drag("a[0]", -33, 21)
    assert all(x == round(x, 1) for x in json.loads(reader.text())["a"][0]), reader.text()
    reader.answered("segment_segment")


def dragged_in_space(reader):
    reader.ask("ray_triangle", RAY)
    reader.drag("triangle[2]", 0, 40)
    now = json.loads(reader.text())
    assert now["triangle"][2] != [0, 2, 0] and now["triangle"][:2] == [[-1, -1, 0], [2, -1, 0]], now
    reader.answered("ray_triangle")
    reader.drag("ray.direction", 30, 0)
    now = json.loads(reader.text())
    assert now["ray"]["direction"][0] > 0.1 and now["ray"]["origin"] == [0, 0, 3], now
    reader.answered("ray_triangle")


def dragged_plane_and_radius(reader):
    reader.ask("sphere_plane", PLANE)
    reader.drag("plane.offset", 0, -30)
    now = json.loads(reader.text())
    assert now["plane"]["normal"] == [0, 1, 0] and now["plane"]["offset"] < -0.1, now
    reader.answered("sphere_plane")
    reader.drag("sphere.radius", 40, 0)
    assert json.loads(reader.text())["sphere"]["radius"] > 1.1, reader.text()
    reader.answered("sphere_plane")


def moved_by_keys(reader):
    reader.ask("segment_segment", OVERLAP)
    reader.run("document.querySelector('#snap').value = '-1'")
    reader.run("document.querySelector('[data-handle=\"a[0]\"]').focus()")
    reader.press("ArrowUp", 38)
    reader.press("ArrowUp", 38)
    assert json.loads(reader.text())["a"][0] == [0, 0.2], reader.text()
    reader.answered("segment_segment")
    reader.click("#undo")
    reader.click("#undo")
    reader.answered("segment_segment", OVERLAP)


def nudged(reader):
    reader.ask("orientation", COLLINEAR)
    more = "[data-path='[\"p\",0]'][data-ulps='1']"
    reader.click(more)
    assert json.loads(reader.text())["p"][0] == math.nextafter(0.3, 1), reader.text()
    reader.answered("orientation")
    reader.click(more.replace("'1'", "'-1'"))
    reader.answered("orientation", COLLINEAR)


def picked_by_a_word(reader):
    reader.open()
    reader.press("/", 191)
    assert reader.run("document.querySelector('#picker').open")
    reader.type("#picker input", "ray sphere")
    reader.run("document.querySelector('#picker li:not([hidden]) button').click()")
    reader.settle()
    reader.answered("ray_sphere")
    # Enter takes the operation of that name, before others that have these words.
    reader.press("/", 191)
    reader.type("#picker input", "point in obb")
    assert reader.run("document.querySelector('#picker li:not([hidden])').dataset.name") != "point_in_obb"
    reader.press("Enter", 13)
    reader.answered("point_in_obb")
    reader.click("#pick")
    pictures = "document.querySelectorAll('#picker .thumbnail').length"
    assert reader.until(f"{pictures} > 60 && {pictures}"), reader.run(pictures)


def drawn_and_shrunk(reader):
    reader.ask("segment_segment", '{"a":[[0.125,3],[2.0625,3]],"b":[[1.375,3],[3.03125,3]]}')
    before = reader.text()
    reader.until("!document.querySelector('#shrink').disabled")
    reader.click("#shrink")
    shorter = reader.until(f"(text => text.length < {len(before)} && text)(document.querySelector('#text').value)")
    reader.settle()
    assert reader.answered("segment_segment", shorter)["reference"]["cause"] == "algorithm"
    reader.click("#draw")
    assert reader.until(f"document.querySelector('#text').value !== {json.dumps(shorter)}")
    reader.settle()
    reader.answered("segment_segment")


def maps_of_neighbours(reader):
    reader.ask("orientation", '{"p0":[0.5,0.5],"p1":[12,12],"p":[24,24]}')
    reader.click("#neighbours summary")
    label = reader.until("document.querySelector('.map canvas')?.getAttribute('aria-label')")
    counts = [int(word.rstrip(",")) for word in label.split() if word.rstrip(",").isdigit()]
    assert sum(counts) == 41 * 41 and "rounding" in label, label
    reader.run("document.querySelector('.map canvas').focus()")
    reader.press("ArrowRight", 39)
    assert json.loads(reader.text())["p0"][0] > 0.5, reader.text()
    reader.answered("orientation")


def own_formula(reader):
    reader.ask("orientation", '{"p0":[0.5000000000000001,0.5],"p1":[12,12],"p":[24,24]}')
    wanted = reader.answered("orientation")
    reader.click("#own summary")
    verdict = reader.until("document.querySelector('#own .verdict .badge')?.textContent")
    assert verdict == wanted["reference"].get("cause", wanted["reference"]["verdict"]), (verdict, wanted)
    reader.click("#own .audit")
    table = reader.until("document.querySelector('#own .audited pre')?.textContent")
    assert table and "your formula" in table and "orientation" in table, table
    assert reader.run("document.querySelectorAll('#own .ways li').length") > 0
    reader.type("#own textarea", "() => { while (true); }")
    assert "stopped" in reader.until("/stopped/.test(document.querySelector('#own .verdict').textContent) && "
                                     "document.querySelector('#own .verdict').textContent")
    reader.type("#own textarea", '() => "' + wanted["truth"]["side"] + '"')
    assert reader.until("document.querySelector('#own .verdict .badge')?.textContent === 'agree'")


def the_link_holds_all(reader):
    reader.ask("ray_triangle", RAY)
    reader.drag("triangle[0]", 25, 10)
    reader.click("#own summary")
    reader.type("#own textarea", "() => 'none'")
    reader.run("document.querySelector('#snap').value = '-2'")
    reader.drag("triangle[1]", 9, 9)
    reader.run("new Promise(resolve => setTimeout(resolve, 600))")
    text, fragment = reader.text(), reader.run("location.hash")
    reader.open(fragment)
    reader.answered("ray_triangle", text)
    assert reader.text() == text and reader.text("#snap") == "-2" and reader.text("#own textarea") == "() => 'none'"
    # A formula of somebody else is not run before the reader has read it.
    assert "came with the link" in reader.text("#own .verdict"), reader.text("#own .verdict")
    reader.click("#own .judge")
    assert reader.until("document.querySelector('#own .verdict .badge')?.textContent")


def regression_tests(reader):
    reader.ask("segment_segment", OVERLAP)
    reader.click("#test summary")
    frameworks = reader.run("[...document.querySelector('#framework').options].map(one => one.value)")
    assert len(frameworks) == 5, frameworks
    for framework in frameworks:
        wanted = reader.told("ask", "segment_segment", "--as", framework, text=OVERLAP)
        reader.run(f"document.querySelector('#framework').value = '{framework}', "
                   "document.querySelector('#framework').dispatchEvent(new Event('change'))")
        assert reader.until(f"document.querySelector('#test pre').textContent === {json.dumps(wanted)}"), (
            framework, wanted, reader.text("#test pre"))


def other_formulas(reader):
    reader.open("#op=polygon_convexity")
    assert reader.run("document.querySelectorAll('[data-part$=-double]').length") == 1, reader.text("#answers")


def every_operation(reader):
    operations = json.loads(reader.told("ops", "--json"))
    without = []
    reader.open()
    for operation in operations:
        reader.follow(f"#op={operation['name']}")
        reader.answered(operation["name"])
        assert reader.text(".sentence"), operation["name"]
        if not reader.run("document.querySelectorAll('#picture .turning > *').length"):
            without.append(operation["name"])
        nameless = reader.run(NAMES)
        assert nameless == [], (operation["name"], nameless)
    assert len(without) <= 6, without


def extreme_numbers(reader):
    for scale in ("1e300", "1e-300", "5e-324"):
        reader.ask("orientation", '{"p0":[0,0],"p1":[S,S],"p":[S,0]}'.replace("S", scale))
        reader.answered("orientation")
        assert reader.run("document.querySelectorAll('#picture .mark').length") == 3, scale


def fits_a_phone(reader):
    reader.browser.resize(*PHONE)
    for operation in ("orientation", "ray_triangle", "polyhedron_polyhedron", "simulation_step"):
        reader.open(f"#op={operation}&open=neighbours,own,test,figure")
        reader.run("new Promise(resolve => setTimeout(resolve, 500))")
        assert reader.run("document.documentElement.scrollWidth <= innerWidth"), operation
    reader.browser.resize(*WIDE)


# The contrast of words with what is behind them, by WCAG 2.
CONTRAST = """(() => {
  const light = colour => colour.match(/[0-9.]+/g).slice(0, 3).map(v => v / 255)
      .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
      .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = one => { for (; one; one = one.parentElement) {
    const colour = getComputedStyle(one).backgroundColor;
    if (!/, 0\\)$/.test(colour)) return colour;
  } return 'rgb(255, 255, 255)'; };
  const words = [...document.querySelectorAll('p, h1 button, h2, summary, th, td, code, .badge, button:not(:disabled), select')]
      .filter(one => one.textContent.trim() && one.getClientRects().length);
  return Math.min(...words.map(one => {
    const [a, b] = [light(getComputedStyle(one).color), light(behind(one))].sort((x, y) => y - x);
    return (a + 0.05) / (b + 0.05);
  }));
})()"""


def light_and_dark(reader):
    grounds = set()
    for is_dark in (False, True):
        reader.dark(is_dark)
        reader.ask("segment_segment", OVERLAP)
        assert reader.run(CONTRAST) >= 4.5, (is_dark, reader.run(CONTRAST))
        grounds.add(reader.run("getComputedStyle(document.body).backgroundColor"))
    reader.dark(False)
    assert len(grounds) == 2, grounds


def scenes_play(reader):
    scene = ROOT / "simulate/scenes/bouncing_ball.json"
    wanted = reader.told("simulate", str(scene))
    reader.load("scenes.html#name=bouncing_ball")
    assert reader.until(f"document.querySelector('#summary').textContent === {json.dumps(wanted)}"), reader.text("#summary")
    drawn = "document.querySelector('#player').contentDocument?.querySelectorAll('[data-player] .turning').length"
    assert reader.until(f"{drawn} === 3"), reader.run(drawn)
    reader.browser.resize(*PHONE)
    reader.run("new Promise(resolve => setTimeout(resolve, 300))")
    assert reader.run("document.documentElement.scrollWidth <= innerWidth")
    assert reader.run("document.querySelector('#player').offsetHeight") < 6000
    reader.browser.resize(*WIDE)
    reader.run(f"document.querySelector('#scene').value = {json.dumps(scene.read_text().replace('position', 'place'))}")
    reader.click("#play")
    assert reader.until("/position/.test(document.querySelector('#status').textContent)"), reader.text("#status")


def lists_grow(reader):
    reader.ask("point_in_polygon", '{"polygon":[[0,0],[4,0],[4,4],[0,4]],"point":[1,3]}')
    reader.click("[data-longer=true]")
    reader.answered("point_in_polygon", '{"polygon":[[0,0],[4,0],[4,4],[0,4],[0,2]],"point":[1,3]}')
    reader.click("[data-longer=false]")
    reader.click("[data-longer=false]")
    reader.answered("point_in_polygon", '{"polygon":[[0,0],[4,0],[4,4]],"point":[1,3]}')


def asks_no_other_server(reader):
    reader.open("#op=orientation&open=neighbours,own")
    foreign = reader.run("performance.getEntriesByType('resource').map(one => one.name).filter(name => "
                         "!name.startsWith(location.origin) && !/^(blob|data):/.test(name))")
    assert foreign == [], foreign


CHECKS = [pasted_json, pasted_line_of_a_report, pasted_geometries, what_is_wrong_is_said, decimals_as_typed,
          dragged_in_the_plane, dragged_in_space, dragged_plane_and_radius, moved_by_keys, nudged, picked_by_a_word,
          drawn_and_shrunk, maps_of_neighbours, own_formula, the_link_holds_all, regression_tests, other_formulas,
          extreme_numbers, fits_a_phone, light_and_dark, lists_grow, scenes_play, asks_no_other_server, every_operation]


def pictures(reader, folder):
    for name, size, is_dark, fragment in (("wide", WIDE, False, "#op=segment_segment&open=neighbours"),
                                          ("narrow", PHONE, False, "#op=ray_triangle"), ("dark", WIDE, True, "#op=sphere_plane")):
        reader.browser.resize(*size)
        reader.dark(is_dark)
        reader.open(fragment)
        reader.run("new Promise(resolve => setTimeout(resolve, 1000))")
        (folder / f"{name}.png").write_bytes(reader.picture())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--package", type=pathlib.Path, required=True)
    parser.add_argument("--program", required=True)
    parser.add_argument("--only", default="")
    parser.add_argument("--pictures", type=pathlib.Path)
    arguments = parser.parse_args()
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if chromium is None or not (arguments.package / "module.wasm").exists():
        print("skipped: there is no " + ("chromium" if chromium is None else "module: ./dev wasm builds it"))
        return SKIPPED
    checks = [] if arguments.pictures else [check for check in CHECKS if arguments.only in check.__name__]
    with tempfile.TemporaryDirectory() as name:
        site = pathlib.Path(name) / "site"
        subprocess.run([ROOT / "js/page/site", arguments.package, arguments.program, site], check=True, stdout=subprocess.DEVNULL)
        browser, found = Browser(chromium, pathlib.Path(name) / "profile"), []
        try:
            with served(site) as address:
                reader = Reader(browser, address, arguments.program)
                browser.resize(*WIDE)
                if arguments.pictures:
                    pictures(reader, arguments.pictures)
                for check in checks:
                    browser.messages = []
                    try:
                        check(reader)
                    except (AssertionError, ValueError, LookupError, TypeError) as failure:
                        found.append(f"{check.__name__}: {failure!r}")
                    found += [f"{check.__name__}: the console says: {message}" for message in browser.messages]
        finally:
            browser.close()
    print("\n".join(found) or f"{len(checks)} checks hold")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
