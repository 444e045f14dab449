#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens every page in Chromium: nothing may be written to the console, as many figures must be drawn as the page has, each
can be saved by a button within its frame, and nothing is wider than the window.

  opened_pages.py --program PATH   a report of all operations, the deck, and the player of each scene
  opened_pages.py PAGE...          these pages
  opened_pages.py --program PATH --pictures FOLDER   the pictures of README.md: a finding of a report, and a player
  opened_pages.py --self-check     pages with one defect each: every defect must be found

Exits with 77 where there is no Chromium.
"""
import argparse
import base64
import collections
import contextlib
import fcntl
import html.parser
import json
import os
import pathlib
import select
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77
SECONDS = 60  # for one answer
CASES = 40
PHONE = 390, 844  # pixels: the narrowest window that pages have to fit into
FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-extensions", "--remote-debugging-pipe")

# Counts what a page has drawn, once all maps are there and everything that moves has been moved to both ends.
COUNT = """(async () => {
  const all = (selector, place = document) => [...place.querySelectorAll(selector)];
  const settled = map => map.dataset.walk === 'ready' || map.querySelector('.failed');
  for (let waited = 0; waited < 2000 && !all('[data-map]').every(settled); ++waited)
    await new Promise(resolve => setTimeout(resolve, 5));
  for (const slider of all('input[type=range]'))
    for (const end of [slider.min, slider.max, slider.min]) slider.value = end, slider.dispatchEvent(new Event('input'));
  const seen = one => { const {width, height} = one.getBBox(); return width > 0 || height > 0; };
  const drawn = one => all('path:not(.tick), circle', one).some(seen);
  const saved = svg => {
    const text = typeof figureAsSvg === 'function' ? figureAsSvg(svg) : '';
    return text.includes('.frame') && !new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror');
  };
  return {
    'figures in space': all('[data-space] .turning').filter(drawn).length,
    'runs of a player': all('[data-player] .turning').filter(drawn).length,
    'plots of a player': all('[data-player] .plot').filter(drawn).length,
    'figures to drag': all('[data-drag] .moving').filter(drawn).length,
    'figures to save': all('.view > svg').filter(saved).length,
    'wider than the window': document.documentElement.scrollWidth > innerWidth ? 1 : 0,
    'buttons across a frame': all('.view').filter(view => {
      const [button, frame] = ['.save', '.frame'].map(part => view.querySelector(part)?.getBoundingClientRect());
      return button?.width && frame?.width &&
          (button.left < frame.left || button.right > frame.right || button.top < frame.top || button.bottom > frame.bottom);
    }).length,
    'failure maps': all('[data-map] .map img').filter(image => image.naturalWidth > 0).length,
    'views of a map': all('[data-map] .lens-view image').length,
    'other figures': all('svg.fig[role=img]:not(.plot)').filter(drawn).length,
    'said to have failed': all('.failed').length,
  };
})()"""


class Page(html.parser.HTMLParser):
    """Counts the figures of a page, by its text alone."""

    def __init__(self, text):
        super().__init__()
        self.counts = collections.Counter()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        fields = dict(attributes)
        if "data-space" in fields:
            views = 2 if "lens" in json.loads(fields["data-space"]) else 1
            self.counts.update({"figures in space": views, "figures to save": views})
        if "data-drag" in fields:
            self.counts.update({"figures to drag": 1, "figures to save": 1})
        if "data-player" in fields:
            data = json.loads(fields["data-player"])
            self.counts["runs of a player"] += len(data["runs"])
            self.counts["plots of a player"] += 3 if data["distances"] else 2
        if "data-map" in fields:
            self.counts["failure maps"] += len(json.loads(fields["data-map"])["maps"])
            self.counts["views of a map"] += len(json.loads(fields["data-map"])["maps"])
        if tag == "svg" and "fig" in fields.get("class", "").split() and fields.get("role") == "img":
            self.counts.update({"other figures": 1, "figures to save": 1})


class Browser:
    """Chromium without a window. It is told what to do through a pipe, in JSON, each message with a zero byte at its end."""

    def __init__(self, program, profile):
        # It reads from descriptor 3 and writes to 4, so ours are greater.
        ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (*os.pipe(), *os.pipe())]
        orders, self.orders, self.reports, reports = ends

        def connect():
            os.dup2(orders, 3)
            os.dup2(reports, 4)

        self.process = subprocess.Popen([program, *FLAGS, f"--user-data-dir={profile}"], preexec_fn=connect, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(orders)
        os.close(reports)
        self.sent, self.session, self.rest, self.messages = 0, None, b"", []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.ask(domain + ".enable")

    def next(self):
        while b"\0" not in self.rest:
            part = os.read(self.reports, 1 << 20) if select.select([self.reports], [], [], SECONDS)[0] else b""
            if not part:
                raise SystemExit(f"Chromium has ended, or says nothing for {SECONDS} s")
            self.rest += part
        text, _, self.rest = self.rest.partition(b"\0")
        event = json.loads(text)
        said = event.get("params", {})
        if event.get("method") == "Runtime.consoleAPICalled":
            self.messages.append(" ".join(str(one.get("description", one.get("value"))) for one in said["args"]))
        elif event.get("method") == "Runtime.exceptionThrown":
            details = said["exceptionDetails"]
            self.messages.append(details.get("exception", {}).get("description", details["text"]))
        elif event.get("method") == "Log.entryAdded":
            self.messages.append(said["entry"]["text"])
        return event

    def ask(self, method, **parameters):
        self.sent += 1
        order = {"id": self.sent, "method": method, "params": parameters}
        if self.session:
            order["sessionId"] = self.session
        os.write(self.orders, json.dumps(order).encode() + b"\0")
        while (event := self.next()).get("id") != self.sent:
            pass
        if "error" in event:
            raise SystemExit(f"{method}: {event['error']['message']}")
        return event["result"]

    def load(self, page, fragment=""):
        self.ask("Page.navigate", url=page.resolve().as_uri() + fragment)
        while self.next().get("method") != "Page.loadEventFired":
            pass

    def open(self, page):
        """Returns what a page writes to the console, and what is drawn on it."""
        self.messages = []
        self.load(page)
        result = self.ask("Runtime.evaluate", expression=COUNT, awaitPromise=True, returnByValue=True)
        return self.messages, result["result"].get("value", {})

    def resize(self, wide, high):
        self.ask("Emulation.setDeviceMetricsOverride", width=wide, height=high, deviceScaleFactor=1, mobile=False)

    def picture(self, page, fragment, place, wide, high):
        """The part of a page around an element, as a PNG."""
        self.resize(wide, high)
        self.load(page, fragment)
        box = f"document.querySelector('{place}').getBoundingClientRect().toJSON()"
        x, y = map(self.ask("Runtime.evaluate", expression=box, returnByValue=True)["result"]["value"].get, "xy")
        clip = {"x": x, "y": y, "width": wide - 2 * x, "height": high, "scale": 1}
        return base64.b64decode(self.ask("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)["data"])

    def close(self):
        with contextlib.suppress(OSError):
            self.ask("Browser.close")
        self.process.wait()


def complaints(browser, page):
    """Returns the complaints about one page, and how many figures it has."""
    messages, drawn = browser.open(page)
    wanted = Page(page.read_text(encoding="utf-8")).counts
    found = [f"{page.name}: the console says: {message}" for message in messages]
    for what in sorted({*wanted, *drawn}):
        if wanted[what] != drawn.get(what, 0):
            found.append(f"{page.name}: {what}: {drawn.get(what, 0)}, the page has {wanted[what]}")
    return found, wanted


def run(program, *arguments):
    done = subprocess.run([program, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"touchstone {' '.join(arguments)}: {done.stderr}")


# Calls at two places, a wrong one in the plane and one in space, each beside a tie.
LOG = [
    {"op": "orientation", "input": {"p0": [0, 0], "p1": [2, 2], "p": [1, 1]}, "answer": {"side": "left"}, "site": "walk.cpp:7"},
    {"op": "orientation", "input": {"p0": [0, 0], "p1": [2, 2], "p": [0, 9]}, "answer": {"side": "left"}, "site": "walk.cpp:9"},
    {"op": "ray_sphere", "input": {"ray": {"origin": [0, 0, 0], "direction": [1, 0, 0]},
                                   "sphere": {"center": [3, 0, 0], "radius": 1}}, "answer": False, "site": "shoot.cpp:3"},
]


def judged(program, directory):
    """The pages of recorded calls."""
    (directory / "calls.jsonl").write_text("".join(json.dumps(call) + "\n" for call in LOG), encoding="utf-8")
    run(program, "judge", str(directory / "calls.jsonl"), "--report", str(directory / "judged"))
    pages = sorted((directory / "judged").glob("*.html"))
    if [page.stem for page in pages] != ["index", "orientation", "ray_sphere"]:
        raise SystemExit(f"pages of recorded calls: {[page.stem for page in pages]}")
    return pages


def made(program, directory):
    """The pages that the program writes."""
    run(program, "audit", "--cases", str(CASES), "--jobs", "1", "--summary", "--report", str(directory))
    scenes = ROOT / "simulate/scenes"
    run(program, "deck", "--cases", "4", "--jobs", "1", "--scenes", str(scenes), "--page", str(directory / "deck.html"))
    for scene in sorted(scenes.glob("*.json")):
        if "gas" not in json.loads(scene.read_text(encoding="utf-8")):  # an exact gas has no steps to play
            run(program, "simulate", str(scene), "--page", str(directory / f"scene_{scene.stem}.html"))
    operations = json.loads(subprocess.run([program, "ops", "--json"], check=True, stdout=subprocess.PIPE).stdout)
    pages = {page.stem for page in directory.glob("*.html")}
    missing = [o["name"] for o in operations if o["name"] not in pages]
    if missing:
        raise SystemExit(f"operations without a page: {', '.join(missing)}")
    return sorted(directory.glob("*.html")) + judged(program, directory)


def write_pictures(browser, program, directory, folder):
    run(program, "audit", "--ops", "segment_segment", "--cases", "2000", "--summary", "--report", str(directory))
    run(program, "simulate", str(ROOT / "simulate/scenes/two_balls_in_a_box.json"), "--page", str(directory / "player.html"))
    for name, page, fragment, place in (("report_page", "segment_segment.html", "", ".finding"),
                                        ("player", "player.html", "#step=420", "main")):
        (folder / f"{name}.png").write_bytes(browser.picture(directory / page, fragment, place, 1120, 480))
    return []


def check(browser, pages):
    browser.resize(*PHONE)
    total, found = collections.Counter(), []
    for page in pages:
        of_page, counts = complaints(browser, page)
        total.update(counts)
        found += of_page
    print(f"{len(pages)} pages; " + ", ".join(f"{n} {what}" for what, n in sorted(total.items())))
    return found


PLAIN = ('<!DOCTYPE html><title>a page</title><link rel="icon" href="data:,"><script>const figureAsSvg = svg => '
         'new XMLSerializer().serializeToString(svg) + "<!-- .frame -->"</script>')
RIGHT = '<div class="view"><svg class="fig" role="img"><path d="M0 0h9"/></svg></div>'
DEFECTS = {
    "<script>console.log('a word')</script>": "the console says: a word",
    "<script>nobody()</script>": "the console says: ReferenceError: nobody is not defined",
    "<script>Promise.reject(new Error('late'))</script>": "the console says: Error: late",
    '<svg><path d="M0 0LNaN 1"/></svg>': "the console says: Error: <path> attribute d",
    '<div data-space="{}"></div>': "figures in space: 0, the page has 1",
    '<div data-space="{&quot;lens&quot;:{}}"><svg><g class="turning"><path d="M0 0h9"/></g></svg></div>':
        "figures in space: 1, the page has 2",
    '<div data-space="{}"><svg><g class="turning"><path class="tick" d="M0 0h9"/></g></svg></div>':
        "figures in space: 0, the page has 1",
    '<svg class="fig" role="img"><path d="M1 1"/></svg>': "other figures: 0, the page has 1",
    '<div data-map="{&quot;maps&quot;:[{}]}" data-walk="ready"><div class="map"><img src="data:image/png,"></div></div>':
        "failure maps: 0, the page has 1",
    '<svg class="fig" role="img"><path d="M0 0h9"/></svg>': "figures to save: 0, the page has 1",
    '<div data-drag="{}"><svg><g class="moving"></g></svg></div>': "figures to drag: 0, the page has 1",
    '<p style="width:9000px">wide</p>': "wider than the window: 1, the page has 0",
    '<div class="view"><svg><rect class="frame" width="9" height="9"/></svg><button class="save">SVG</button></div>':
        "buttons across a frame: 1, the page has 0",
    '<p class="failed"></p>': "said to have failed: 1, the page has 0",
}


def self_check(browser, directory):
    page = directory / "planted.html"
    page.write_text(PLAIN + RIGHT, encoding="utf-8")
    assert complaints(browser, page) == ([], {"other figures": 1, "figures to save": 1}), complaints(browser, page)
    for body, wanted in DEFECTS.items():
        page.write_text(PLAIN + body, encoding="utf-8")
        found, _ = complaints(browser, page)
        assert any(wanted in one for one in found), (body, found)
    print(f"{len(DEFECTS)} defects found")
    return []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program")
    parser.add_argument("--self-check", action="store_true")
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("pages", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    if chromium is None:
        print("skipped: there is no chromium")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        (directory / "pages").mkdir()
        browser = Browser(chromium, directory / "profile")
        try:
            if arguments.self_check:
                found = self_check(browser, directory)
            elif arguments.pictures:
                found = write_pictures(browser, arguments.program, directory / "pages", arguments.pictures)
            else:
                found = check(browser, arguments.pages or made(arguments.program, directory / "pages"))
        finally:
            browser.close()
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
