#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The page of the benchmarks: bars of ratios against each peer and curves of cost, in one file that needs no network.

  page.py --self-check   pages of made-up times; a wrong bar, point or word must be found

bench/ratios.py --page FILE writes it, from the times of its tables, and --picture FILE.svg the picture of the README.
"""

import html
import math
import re
import sys
import textwrap
import xml.etree.ElementTree

ARRAYS, PAIRS = "arrays_", "all_pairs_"
# Name in the data, in words, colour on paper and in the dark.
PEERS = {
    "naive": ("naive formula", "#1d5fa6", "#7db4f0"),
    "usual": ("usual formula, with early exits", "#7a3f98", "#cf9cec"),
    "naive_avx512": ("naive formula, AVX-512", "#7a3f98", "#cf9cec"),
    "epick": ("CGAL Epick", "#a4510c", "#f0a45c"),
    "epeck": ("CGAL Epeck", "#2c7347", "#7fcf9c"),
    "shewchuk": ("Shewchuk's predicates", "#8a6d00", "#e0c341"),
    "mpq": ("rationals", "#59636e", "#a3aeb9"),
    "robust": ("robust", "#c2186b", "#ff7ab6"),
    "avx512": ("robust, AVX-512", "#c2186b", "#ff7ab6"),
    "certificate": ("robust, with certificate", "#7a3f98", "#cf9cec"),
    "check": ("check of the certificate", "#2c7347", "#7fcf9c"),
    "cgal": ("CGAL, which only counts", "#a4510c", "#f0a45c"),
    "read": ("reading the same memory", "#59636e", "#a3aeb9"),
}
MORE_THAN_ANY_CACHE = 1 << 22  # rows of "from_memory", as bench/arrays.cpp has them
LEFT, WIDE, ROW, GAP = 190, 560, 13, 9  # pixels of bars: their names, the axis, a bar, between two operations
CURVE_WIDE, CURVE_HIGH, CURVE_LEFT, CURVE_RIGHT, CURVE_BELOW = 330, 200, 52, 30, 40
OF_ARRAYS = ["naive", "naive_avx512", "epick", "shewchuk"]
SHARES = {"random": "none", "one_in_a_hundred_near": "1 %", "near_degenerate": "all"}


def style():
    colour = lambda scheme: "".join(f"--{name}:{words[scheme]};" for name, words in PEERS.items())
    classes = "".join(f".{name}{{--c:var(--{name})}}" for name in PEERS)
    return (f":root{{color-scheme:light dark;--paper:#fff;--ink:#1b2229;--quiet:#55606b;--line:#dfe4e9;{colour(1)}}}"
            f"@media (prefers-color-scheme:dark){{:root{{--paper:#1d2329;--ink:#e6eaee;--quiet:#a3aeb9;--line:#323a42;{colour(2)}}}}}"
            "svg{font:12px ui-sans-serif,system-ui,\"DejaVu Sans\",sans-serif;max-width:100%;height:auto;display:block;background:var(--paper)}"
            "svg text{fill:var(--ink)}svg .quiet{fill:var(--quiet);font-size:11px}svg .grid{stroke:var(--line)}svg .one{stroke:var(--ink)}"
            "svg .bar{fill:var(--c)}svg .curve{stroke:var(--c);fill:none;stroke-width:2}svg .dot{fill:var(--c)}" + classes)


PAGE_STYLE = """body{margin:0 auto;max-width:1120px;padding:16px;background:var(--paper);color:var(--ink);
font:16px/1.5 ui-sans-serif,system-ui,"DejaVu Sans",sans-serif}
h1{font-size:28px;margin:12px 0}h2{font-size:20px;margin:32px 0 6px}h3{font-size:15px;margin:12px 0 4px}
p{max-width:78ch;margin:0 0 10px}.quiet{color:var(--quiet)}.busy{border-left:5px solid var(--epick);padding-left:10px}
.wide{overflow-x:auto}.wide svg{max-width:none}.many{display:grid;grid-template-columns:repeat(auto-fill,minmax(330px,1fr));gap:8px 18px}
.key{margin-right:16px;white-space:nowrap}.key i{display:inline-block;width:20px;height:8px;margin-right:6px;background:var(--c)}
pre{font:12px/1.4 ui-monospace,"DejaVu Sans Mono",monospace;overflow-x:auto}code{overflow-wrap:anywhere}summary{cursor:pointer}
@media (max-width:420px){.many{grid-template-columns:1fr}}"""


def least(times, name):
    return min(times.of[name]) if times.of.get(name) else None


def number(value):
    return f"{value:.2g}" if value < 10 else f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def spaced(name):
    return name.replace("_", " ")


def tenths(value):
    return f"{value:.1f}".removesuffix(".0")


def decades(low, high):
    """The powers of ten around both."""
    first, last = math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9)
    return list(range(first, max(last, first + 1) + 1))


def in_words(power):
    return f"{10 ** power:,}" if 0 <= power < 7 else f"{10.0 ** power:g}"


def svg(width, height, title, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" role="img" viewBox="0 0 {width} {height}" width="{width}" height="{height}">'
            f"<title>{html.escape(title)}</title>{''.join(parts)}</svg>")


def key(names):
    return "<p>" + "".join(f'<span class="key {name}"><i></i>{html.escape(PEERS[name][0])}</span>' for name in names) + "</p>"


def bars(title, rows):
    """Ratios on a scale of powers of ten. `rows`: (name, [(peer, ratio)]). A bar begins at 1; to the right of it the peer takes longer."""
    ratios = [ratio for _, own in rows for _, ratio in own]
    powers = decades(min([*ratios, 1]), max([*ratios, 1]))
    x = lambda ratio: LEFT + WIDE * (math.log10(ratio) - powers[0]) / (powers[-1] - powers[0])
    high = 24 + sum(ROW * len(own) + GAP for _, own in rows)
    parts = []
    for power in powers:
        line = "one" if power == 0 else "grid"
        parts.append(f'<path class="{line}" d="M{tenths(x(10.0 ** power))} 20V{high}"/>'
                     f'<text class="quiet" x="{tenths(x(10.0 ** power))}" y="13" text-anchor="middle">{in_words(power)}</text>')
    y = 24
    for name, own in rows:
        parts.append(f'<text x="{LEFT - 8}" y="{tenths(y + ROW * len(own) / 2 + 4)}" text-anchor="end">{html.escape(spaced(name))}</text>')
        for peer, ratio in own:
            start, end = sorted([x(1), x(ratio)])
            parts.append(f'<rect class="bar {peer}" x="{tenths(start)}" y="{y + 1}" width="{tenths(max(end - start, 1))}" height="{ROW - 2}">'
                         f"<title>{html.escape(f'{name}: {PEERS[peer][0]} / robust {number(ratio)}')}</title></rect>"
                         f'<text class="quiet" x="{tenths(end + 4)}" y="{y + ROW - 2.5}">{number(ratio)}</text>')
            y += ROW
        y += GAP
    return svg(LEFT + WIDE + 50, high, title, parts)


def curves(title, across, up, series, categories=()):
    """Both axes by powers of ten, or `categories` across. `series`: peer -> [(x, y)], in the order of x."""
    points = [point for own in series.values() for point in own]
    ys = decades(min(y for _, y in points), max(y for _, y in points))
    xs = [0, max(len(categories) - 1, 1)] if categories else decades(min(x for x, _ in points), max(x for x, _ in points))
    at_x = lambda x: CURVE_LEFT + (CURVE_WIDE - CURVE_LEFT - CURVE_RIGHT) * ((x if categories else math.log10(x)) - xs[0]) / (xs[-1] - xs[0])
    at_y = lambda y: 8 + CURVE_HIGH * (ys[-1] - math.log10(y)) / (ys[-1] - ys[0])
    parts = []
    for power in ys:
        parts.append(f'<path class="grid" d="M{CURVE_LEFT} {tenths(at_y(10.0 ** power))}H{CURVE_WIDE - CURVE_RIGHT}"/>'
                     f'<text class="quiet" x="{CURVE_LEFT - 6}" y="{tenths(at_y(10.0 ** power) + 4)}" text-anchor="end">{in_words(power)}</text>')
    marks = list(enumerate(categories)) if categories else [(10.0 ** power, in_words(power)) for power in xs]
    for place, words in marks:
        parts.append(f'<path class="grid" d="M{tenths(at_x(place))} 8V{CURVE_HIGH + 8}"/>'
                     f'<text class="quiet" x="{tenths(at_x(place))}" y="{CURVE_HIGH + 22}" text-anchor="middle">{html.escape(words)}</text>')
    parts.append(f'<text class="quiet" x="{CURVE_WIDE - CURVE_RIGHT}" y="{CURVE_HIGH + 36}" text-anchor="end">{html.escape(across)}</text>'
                 f'<text class="quiet" x="4" y="{CURVE_HIGH + 36}">{html.escape(up)}</text>')
    for peer, own in series.items():
        course = "L".join(f"{tenths(at_x(x))} {tenths(at_y(y))}" for x, y in own)
        parts.append(f'<path class="curve {peer}" d="M{course}"/>')
        for x, y in own:
            words = f"{PEERS[peer][0]}: {categories[x] if categories else format(x, ',')}, {number(y)}"
            drawn = f'<circle class="dot {peer}" cx="{tenths(at_x(x))}" cy="{tenths(at_y(y))}" r="3.5">'
            parts.append(f"{drawn}<title>{html.escape(words)}</title></circle>")
    return svg(CURVE_WIDE, CURVE_HIGH + CURVE_BELOW, title, parts)


def ratios_of(groups, data, ours, peers):
    """As `bars` takes them: the groups of these cases in which our time and one of the peers' was taken."""
    rows = []
    for group, times in groups.items():
        operation, cases = group.rsplit("/", 1)
        own = least(times, ours)
        found = [(peer, least(times, peer) / own) for peer in peers if own and least(times, peer)]
        if cases == data and found:
            rows.append((operation.removeprefix(ARRAYS), found))
    return rows


def section(heading, words, body):
    return f"<h2>{html.escape(heading)}</h2><p>{html.escape(words)}</p>{body}" if body else ""


def bar_section(heading, words, rows):
    if not rows:
        return ""
    names = [peer for peer in PEERS if any(peer == own for _, found in rows for own, _ in found)]
    return section(heading, words, key(names) + f'<div class="wide">{bars(heading, rows)}</div>')


def curve_section(heading, words, charts, across, up, categories=()):
    """`charts`: name -> series."""
    charts = {name: series for name, series in charts.items() if any(len(own) > 1 for own in series.values())}
    if not charts:
        return ""
    names = [peer for peer in PEERS if any(peer in series for series in charts.values())]
    drawn = "".join(f"<div><h3>{html.escape(spaced(name))}</h3>{curves(f'{heading}: {name}', across, up, series, categories)}</div>"
                    for name, series in charts.items())
    return section(heading, words, key(names) + f'<div class="many">{drawn}</div>')


def series_by(groups, place_of, peers, per=lambda place, time: time):
    """chart -> peer -> [(x, y)], where place_of(group) is (chart, x), or None of a group that is not in a chart."""
    charts = {}
    for group, times in groups.items():
        place = place_of(group)
        for peer in peers if place else []:
            if least(times, peer):
                charts.setdefault(place[0], {}).setdefault(peer, []).append((place[1], per(place[1], least(times, peer))))
    return {chart: {peer: sorted(own) for peer, own in series.items()} for chart, series in charts.items()}


def of_pairs(group):
    found = re.fullmatch(rf"{PAIRS}(\d+)/(\w+)", group)
    return found and (found[2], int(found[1]))


def of_faces(group):
    found = re.fullmatch(r"(\w+)_(\d+)/(\w+)", group)
    return found and (f"{found[1]}, {found[3]}", int(found[2]))


def of_rows(group):
    found = re.fullmatch(rf"{ARRAYS}(\w+)/(?:rows_(\d+)|from_memory)", group)
    return found and (found[1], int(found[2] or MORE_THAN_ANY_CACHE))


def of_shares(group):
    operation, cases = group.removeprefix(ARRAYS).rsplit("/", 1)
    return (operation, list(SHARES).index(cases)) if cases in SHARES else None


def page(circumstances, command, repetitions, load, processors, timed, tables):
    """`timed`: program -> group -> times, as ratios.py takes them; `tables`: what it prints; `load`: of the machine, before it began."""
    decided = timed.get("operations", {}) | timed.get("polygons", {})
    formulas = ["naive", "usual", "epick", "shewchuk", "epeck", "mpq"]
    busy = load >= 1
    body = (
        f"<h1>What being right costs</h1><p>{html.escape(circumstances)}</p><p>Made by <code>{html.escape(command)}</code>. "
        "Whatever is compared was timed in one process, in turns; a time is the least of "
        f"{repetitions} repetitions at most. Only ratios mean anything.</p>"
        f'<p class="{"busy" if busy else "quiet"}">{"The machine was busy, so that single ratios may be far off: its" if busy else "The"} '
        f"load was {load:.2f} on {processors} processors when this began.</p>" +
        bar_section("One question at a time, random cases", "How many times as long as robust each peer takes, 131,072 fresh cases a pass. To the "
                    "left of 1 the peer is faster.", ratios_of(decided, "random", "robust", formulas)) +
        bar_section("One question at a time, near-degenerate cases", "The same where rounding may decide. The naive formula is then often wrong.",
                    ratios_of(decided, "near_degenerate", "robust", formulas)) +
        bar_section("Arrays, random cases", "The same beside robust over arrays with AVX-512, 131,072 rows a pass.",
                    ratios_of(timed.get("arrays", {}), "random", "avx512", OF_ARRAYS)) +
        bar_section("Arrays, near-degenerate cases", "The same where rounding may decide.",
                    ratios_of(timed.get("arrays", {}), "near_degenerate", "avx512", OF_ARRAYS)) +
        curve_section("Arrays: cost against the share of near-degenerate rows", "Nanoseconds a row.",
                      series_by(timed.get("arrays", {}), of_shares, ["naive", "naive_avx512", "avx512", "epick", "shewchuk"]),
                      "near-degenerate rows", "ns a row", tuple(SHARES.values())) +
        curve_section("Arrays: cost against their length, from the cache to memory", "Nanoseconds a row of random cases, beside the time in which "
                      "the same numbers can be read.", series_by(timed.get("arrays", {}), of_rows, ["naive_avx512", "avx512", "read"]),
                      "rows", "ns a row") +
        curve_section("All pairs of boxes: cost against their number", "Nanoseconds a box; a level line is growth in proportion.",
                      series_by(timed.get("pairs", {}), of_pairs, ["robust", "certificate", "check", "cgal"], lambda n, time: time / n),
                      "boxes", "ns a box") +
        curve_section("Is a mesh embedded? Cost against the number of its faces", "Nanoseconds a face; a level line is growth in proportion.",
                      series_by(timed.get("meshes", {}), of_faces, ["robust", "epick"], lambda n, time: time / n), "faces", "ns a face") +
        curve_section("A ray on a mesh: cost against the number of its faces", "Nanoseconds a ray, the tree made before.",
                      series_by(timed.get("mesh_rays", {}), of_faces, ["robust", "epick"]), "faces", "ns a ray"))
    if "<svg" not in body:
        body += "<p>Nothing was measured of which this page has a picture.</p>"
    return ("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width,"
            f"initial-scale=1\">\n<title>touchstone: what being right costs</title>\n<style>{style()}{PAGE_STYLE}</style>\n</head>\n<body>\n{body}"
            f"\n<details><summary>All numbers</summary><pre>{html.escape(tables)}</pre></details>\n</body>\n</html>\n")


def picture(circumstances, timed):
    """One SVG file of how many times as long as robust over arrays the peers take; None where no arrays were timed."""
    rows = ratios_of(timed.get("arrays", {}), "random", "avx512", OF_ARRAYS)
    if not rows:
        return None
    title = "Times as long as robust over arrays takes, with AVX-512, on random rows"
    chart = bars(title, rows)
    high = int(re.search(r' height="(\d+)"', chart)[1])
    names = [peer for peer in PEERS if any(peer == own for _, found in rows for own, _ in found)]
    parts = [f"<style>{style()}.paper{{fill:var(--paper)}}</style>", f'<rect class="paper" width="100%" height="100%"/>',
             f'<text x="12" y="20">{html.escape(title)}</text>']
    for place, name in enumerate(names):
        x = 12 + 195 * place
        parts.append(f'<rect class="bar {name}" x="{x}" y="33" width="20" height="8"/><text x="{x + 26}" y="42">{html.escape(PEERS[name][0])}</text>')
    parts.append(f'<g transform="translate(0 56)">{chart}</g>')
    lines = textwrap.wrap(circumstances, 120)
    for place, words in enumerate(lines):
        parts.append(f'<text class="quiet" x="12" y="{56 + high + 16 + 15 * place}">{html.escape(words)}</text>')
    return svg(LEFT + WIDE + 50, 56 + high + 11 + 15 * len(lines), title, parts) + "\n"


def self_check():
    class Made:
        def __init__(self, **of):
            self.of = of

    def made(timed, load=0.0):
        text = page("g++ <12>; AMD & co.", "bench/ratios.py --page x.html", 25, load, 2, timed, "| a <b> |")
        for drawn in re.findall(r"<svg.*?</svg>", text, re.DOTALL):
            xml.etree.ElementTree.fromstring(drawn)
        assert "nan" not in text.lower().replace("nanosecond", "") and "g++ &lt;12&gt;; AMD &amp; co." in text
        assert not re.search(r"(src|href)=|url\(|@import", text)
        return text

    assert "Nothing was measured" in made({}) and "<svg" not in made({})
    # From 0.1 to 10 there are two powers of ten: 1 is in the middle, 10 at the right end.
    one = made({"operations": {"orientation/random": Made(naive=[2.0, 1.0], robust=[10.0], epick=[100.0])}})
    middle, end = LEFT + WIDE / 2, LEFT + WIDE
    found = re.findall(r'<rect class="bar (\w+)" x="([\d.]+)" y="\d+" width="([\d.]+)"', one)
    assert found == [("naive", str(LEFT), str(WIDE // 2)), ("epick", tenths(middle), tenths(end - middle))], found
    assert "naive formula / robust 0.1<" in one and "CGAL Epick / robust 10<" in one and "rationals" not in re.sub(r"<style.*?</style>", "", one)
    assert "busy, so" not in one and "busy, so" in made({}, load=3.0)
    # A level line: ten times the boxes in ten times the time.
    level = made({"pairs": {f"all_pairs_{n}/uniform": Made(robust=[50.0 * n], cgal=[500.0 * n]) for n in (10000, 100000)}})
    heights = re.findall(r'<circle class="dot robust" cx="([\d.]+)" cy="([\d.]+)"', level)
    assert len(heights) == 2 and heights[0][1] == heights[1][1] and float(heights[0][0]) == CURVE_LEFT, heights
    assert float(heights[1][0]) == CURVE_WIDE - CURVE_RIGHT
    faces = made({"mesh_rays": {f"ray_mesh_{n}/bumps": Made(robust=[1.0], epick=[2.0]) for n in (1000, 10000)}})
    assert faces.count('class="dot robust"') == faces.count('class="dot epick"') == 2 and "ray mesh, bumps" in faces
    # A single length is no curve.
    alone = {"pairs": {"all_pairs_10000/uniform": Made(robust=[1.0])}, "arrays": {"arrays_orientation/rows_1024": Made(read=[1.0])}}
    assert "Nothing was measured" in made(alone)
    shares = made({"arrays": {f"arrays_orientation/{cases}": Made(avx512=[time]) for time, cases in enumerate(SHARES, 1)}})
    assert [word in shares for word in (">none<", ">1 %<", ">all<")] == [True] * 3 and shares.count('<circle class="dot avx512"') == 3
    lengths = made({"arrays": {f"arrays_orientation/{n}": Made(avx512=[1.0], read=[0.5]) for n in ("from_memory", "rows_1024")}})
    places = [float(x) for x in re.findall(r'<circle class="dot avx512" cx="([\d.]+)"', lengths)]
    assert len(places) == 2 and places[0] < places[1], places  # by length, however they were measured
    # The picture of the README: a bar for each peer, in both schemes, and nothing where nothing was timed.
    drawn = picture("g++ <12>; AMD & co.", {"arrays": {"arrays_orientation/random": Made(avx512=[1.0], naive=[2.0], epick=[10.0])}})
    xml.etree.ElementTree.fromstring(drawn)
    assert [f'class="bar {peer}"' in drawn for peer in OF_ARRAYS] == [True, False, True, False]
    assert "robust 10<" in drawn and "prefers-color-scheme:dark" in drawn and "g++ &lt;12&gt;" in drawn and picture("", {}) is None
    # A name is no markup.
    assert "&lt;b&gt;" in made({"operations": {"<b>/random": Made(naive=[1.0], robust=[1.0])}})
    print("bench/page.py: the bars, curves and words of made-up times are right")


if __name__ == "__main__":
    if sys.argv[1:] != ["--self-check"]:
        sys.exit(__doc__)
    self_check()
