// SPDX-License-Identifier: Apache-2.0
#include "report/parts/html_style.h"

#include "report/figures/space_model.h"
#include "report/figures/svg.h"
#include "report/maps/palette.h"

namespace touchstone::report {
namespace {

constexpr const char* light_variables =
    "--paper:#fff;--ground:#f5f6f8;--ink:#1b2229;--quiet:#55606b;--faint:#b9c0c8;--line:#dfe4e9;--link:#17528f;"
    "--code:#f1f3f5;--q0:#1d5fa6;--q1:#a4510c;--q2:#2c7347;--q3:#7a3f98;--truth:#c2186b;--said:#0b7a75;";

constexpr const char* dark_variables =
    "--paper:#1d2329;--ground:#14181c;--ink:#e6eaee;--quiet:#a3aeb9;--faint:#4c5761;--line:#323a42;--link:#8ec1f5;"
    "--code:#252c33;--q0:#7db4f0;--q1:#f0a45c;--q2:#7fcf9c;--q3:#cf9cec;--truth:#ff7ab6;--said:#4fd1c7;";

constexpr const char* rules = R"css(
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:16px/1.55 ui-sans-serif,system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
main,header,footer,nav{max-width:1120px;margin:0 auto;padding:0 24px}
header{padding-top:36px}
footer{padding:24px;color:var(--quiet);font-size:13px}
nav{padding-top:18px;font-size:14px;display:flex;gap:18px;flex-wrap:wrap}
nav .end{margin-left:auto}
a{color:var(--link)}a:hover{text-decoration-thickness:2px}
:focus-visible{outline:3px solid var(--link);outline-offset:2px;border-radius:3px}
.kicker{margin:0;color:var(--quiet);font-size:13px;letter-spacing:.06em;text-transform:uppercase}
h1{font-size:30px;line-height:1.2;margin:2px 0 8px;letter-spacing:-.01em}
h2{font-size:20px;margin:36px 0 10px}h3{font-size:16px;margin:0 0 6px}h4{font-size:14px;margin:0 0 6px;font-weight:600}
p{margin:0 0 12px;max-width:78ch}.lead{font-size:17px}.quiet{color:var(--quiet)}.small{font-size:13.5px}
.card{background:var(--paper);border:1px solid var(--line);border-radius:10px;padding:18px 20px;margin:0 0 18px}
.tiles{display:grid;grid-template-columns:repeat(var(--columns),minmax(0,1fr));gap:10px;margin:20px 0 8px}
.tile{background:var(--paper);border:1px solid var(--line);border-left:5px solid var(--c,var(--faint));border-radius:8px;padding:9px 12px}
.tile b{display:block;font-size:20px;white-space:nowrap;line-height:1.25;font-variant-numeric:tabular-nums;font-weight:650}
.tile span{color:var(--quiet);font-size:13px}
.bar{display:flex;height:16px;border-radius:4px;overflow:hidden;background:var(--line);gap:1px}
.bar i{display:block;background-color:var(--c);min-width:2px}
.bar.thin{height:9px;min-width:80px}
.algorithm.hatch{background-image:repeating-linear-gradient(45deg,#fff5 0 2px,#fff0 2px 6px)}
.range.hatch{background-image:repeating-linear-gradient(90deg,#fff5 0 2px,#fff0 2px 6px)}
.rounding.hatch{background-image:repeating-linear-gradient(-45deg,#fff4 0 1.5px,#fff0 1.5px 7px)}
.swatch{display:inline-block;width:13px;height:13px;border-radius:3px;background:var(--c);vertical-align:-1px;margin-right:7px;border:1px solid #0003}
.badge{display:inline-block;border:1px solid var(--line);border-left:5px solid var(--c);border-radius:4px;padding:0 8px;font-size:13px;font-weight:600;background:var(--paper);white-space:nowrap}
dl.legend{display:grid;grid-template-columns:max-content 1fr;gap:5px 16px;margin:0;font-size:14.5px}
dl.legend dt{font-weight:600}dl.legend dd{margin:0;color:var(--quiet)}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:14px}
th,td{text-align:right;padding:4px 7px;font-variant-numeric:tabular-nums;white-space:nowrap;border-bottom:1px solid var(--line)}
th{color:var(--quiet);font-weight:600;font-size:13px;vertical-align:bottom}
th:first-child,td:first-child{text-align:left;padding-left:2px}thead th{white-space:normal}
tbody th{color:var(--ink);font-size:14px}
tbody tr.total>*{font-weight:650;border-top:2px solid var(--faint);padding-top:8px}
td.none{color:var(--quiet)}td.wide{width:34%;min-width:160px}td.text,th.text{text-align:left;white-space:normal}
td.found{font-weight:600}
code,pre{font:13px/1.5 ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace}
code{background:var(--code);border-radius:4px;padding:1px 5px;overflow-wrap:anywhere}
pre{background:var(--code);border-radius:6px;padding:9px 12px;margin:4px 0 12px;white-space:pre-wrap;overflow-wrap:break-word}
pre.repeat{user-select:all}
.facts{display:grid;grid-template-columns:fit-content(190px) 1fr;gap:5px 16px;margin:14px 0 4px;font-size:14.5px}
.facts dt{color:var(--quiet)}.facts dd{margin:0;min-width:0}
.facts dd code{display:inline-block}
figure{margin:12px 0}.seen{display:flex;flex-wrap:wrap;gap:4px 28px;align-items:flex-start}.seen figure{flex:0 1 auto;max-width:100%;min-width:0}.seen .said{flex:1 1 400px;width:auto;margin-top:14px}figcaption{font-size:14.5px;max-width:60ch;overflow-wrap:break-word}
.searches{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(400px,100%),1fr));gap:0 28px}.searches figure{min-width:0;max-width:100%;overflow-x:auto}.key .fig.space .node.face{fill-opacity:.3}
.beside{flex:1 1 100%;display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:0 28px}.beside .to-lens{display:none}.views{display:flex;flex-wrap:wrap;gap:0 28px}.view{position:relative;min-width:0;width:fit-content;max-width:100%}
.save{position:absolute;top:11px;right:calc(var(--beyond,0%) + 4px);font:inherit;font-size:11px;line-height:1.2;color:var(--quiet);background:var(--paper);border:1px solid transparent;border-radius:4px;padding:1px 5px;cursor:pointer}.save:hover,.save:focus-visible{border-color:var(--faint)}
.drag-figure{display:flex;flex-wrap:wrap;gap:4px 28px;margin:12px 0}.dragged{flex:1 1 340px}.drag{touch-action:none;overflow:visible}.drag .area{fill:var(--c);fill-opacity:.1}.drag .grip{fill:transparent}.handle{cursor:grab}.handle:focus-visible .grip{stroke:var(--link);stroke-width:2}.handle:focus{outline:none}.drag .stroke{stroke-linejoin:round}.drag .truth.stroke{stroke-width:3}
.dragged button{font:inherit;font-size:14px;color:inherit;background:var(--paper);border:1px solid var(--faint);border-radius:6px;min-height:36px;padding:0 12px;cursor:pointer}
.deck-contents ol{list-style:none;columns:3 260px;padding:0;margin:0 0 24px;font-size:14.5px}.deck-contents small{display:inline-block;min-width:58px;color:var(--quiet)}.deck-page h2{margin-top:0}.deck-page .card{border:0;padding:0}.breaks>summary{font-size:16px;font-weight:600}
.formula{border:1px solid var(--line);border-left:4px solid var(--link);border-radius:6px;padding:8px 14px;margin:4px 0 12px;overflow-x:auto;font-size:17px;background:var(--code)}.formula math{text-align:left;margin:3px 0}
.truth-said{color:var(--truth)}.who-said{color:var(--said)}
.finding h3{display:flex;flex-wrap:wrap;gap:4px 10px;align-items:baseline}.how-often{font-weight:400;color:var(--quiet);font-size:14px}
thead button{all:unset;cursor:pointer;text-decoration:underline dotted}thead button:focus-visible{outline:3px solid var(--link);outline-offset:2px}[aria-sort=ascending] button::after{content:" \2191"}[aria-sort=descending] button::after{content:" \2193"}
.by-deck h3{margin:14px 0 2px}.by-deck ul{margin:0;columns:2 380px;font-size:14.5px}.contract p{max-width:90ch}.contract :last-child{margin-bottom:0}.contract details p{font-size:14.5px}
.apart{margin-top:14px}.question{font-weight:400;white-space:normal}td small{color:var(--quiet);font-weight:400}
.confusion td{text-align:right}.confusion td small{display:block}.confusion td.right{background:var(--agree)}.confusion td.found{box-shadow:inset 4px 0 var(--rounding)}
.walk pre{white-space:pre-wrap}
.said{margin:8px 0 4px}.said th{width:30%}.said td,.said th{white-space:normal;vertical-align:top}.said td:nth-child(2){text-align:left}
.said tr.truth th{color:var(--truth)}
details{margin-top:10px}summary{cursor:pointer;color:var(--link);font-size:14px}
.maps{display:grid;grid-template-columns:repeat(auto-fit,minmax(280px,1fr));gap:24px}
.map{position:relative}.map img,.gallery img{image-rendering:pixelated;width:100%;height:auto;display:block}
.map.walked{cursor:crosshair;touch-action:none;overflow:hidden}
.cross{position:absolute;width:15px;height:15px;margin:-7.5px;border:2px solid #000;outline:1.5px solid #fff;border-radius:50%;pointer-events:none}
.sample{vertical-align:-1px;margin-right:7px;border-radius:3px;image-rendering:pixelated}
.mapped .below{margin-top:14px}
.walk{border-top:1px solid var(--line);padding-top:12px;display:flex;flex-wrap:wrap;gap:0 28px}.walk>p{flex-basis:100%}.lenses{flex:1 1 260px}.answers{flex:2 1 420px;min-width:0}.walk code{overflow-wrap:normal}
.lenses{display:grid;grid-template-columns:repeat(auto-fit,minmax(130px,200px));gap:16px}.lenses figure{margin:0 0 8px}
.lens-view{display:block;width:100%;aspect-ratio:1;background:var(--ground);cursor:grab;touch-action:none;border:1px solid var(--line)}
.lens-view .point{fill:none;stroke:#000;stroke-width:.12;paint-order:stroke;filter:drop-shadow(0 0 .08px #fff) drop-shadow(0 0 .08px #fff)}
.maps ul{list-style:none;margin:10px 0 0;padding:0;font-size:14px}
.maps li{display:flex;gap:4px;align-items:baseline}.maps li b{margin-left:auto;font-weight:500;font-variant-numeric:tabular-nums}
.gallery{display:grid;grid-template-columns:repeat(auto-fill,minmax(240px,1fr));gap:18px}
.gallery a{min-width:0;text-decoration:none;color:inherit;font-size:14px}.gallery a strong{color:var(--link)}
.chips{display:flex;gap:8px;flex-wrap:wrap;margin:0 0 14px;padding:0;list-style:none;font-size:13.5px;color:var(--quiet)}
.runs{display:grid;grid-template-columns:repeat(auto-fit,minmax(220px,1fr));gap:14px}.run{margin:0;background:var(--paper);border:1px solid var(--line);border-radius:10px;padding:10px 12px;min-width:0}.run .fig{width:100%;height:auto}.run .facts{grid-template-columns:max-content 1fr;font-size:13.5px;gap:1px 12px;margin-top:6px;font-variant-numeric:tabular-nums}.run .facts dd{margin:0;text-align:right;overflow-wrap:anywhere}
.controls{display:flex;flex-wrap:wrap;gap:8px;align-items:center;margin:14px 0 4px}.controls label{display:inline-flex;gap:6px;align-items:center;min-height:40px}.controls output{margin-left:auto;font-variant-numeric:tabular-nums}
.player button,.player select{font:inherit;color:inherit;background:var(--paper);border:1px solid var(--faint);border-radius:6px;min-height:40px;min-width:44px;padding:0 12px;cursor:pointer}.player .play{min-width:84px;font-weight:600}.player .scrub{width:100%;height:30px;margin:0;accent-color:var(--link)}
.player .marks{display:flex;flex-wrap:wrap;gap:8px;list-style:none;margin:8px 0;padding:0}.player .marks button{border-color:var(--truth);font-size:14px;text-align:left}.key{margin-right:16px;white-space:nowrap}.key .fig{display:inline-block;vertical-align:2px;margin-right:6px}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(320px,1fr));gap:0 18px}.plots section{min-width:0}.plots h2{margin:22px 0 4px}.plots p{margin:0 0 6px}.player .aid.face{fill-opacity:.03}
.player .plot{width:100%;height:auto;display:block;cursor:crosshair;background:var(--paper);border:1px solid var(--line);border-radius:8px}.plot path{fill:none}.plot .grid{stroke:var(--line)}.plot .tick,.plot .axis{stroke:var(--quiet)}.plot .mark{stroke:var(--truth);stroke-dasharray:3 3}.plot .now{stroke:var(--ink)}.plot .stroke{stroke-width:1.6;stroke-linejoin:round}.key .stroke,.plot .stroke{stroke:var(--c);fill:none;stroke-width:1.8}
.chips li{border:1px solid var(--line);border-radius:99px;padding:1px 11px;background:var(--paper)}
@media screen and (max-width:900px){.to-lens{display:none}.with-lens .view{flex-basis:100%}.beside{grid-template-columns:minmax(0,1fr)}.tiles{grid-template-columns:repeat(var(--fewer),minmax(0,1fr))}}
@media screen and (max-width:640px){
main,header,nav,footer{padding-left:14px;padding-right:14px}.card{padding:14px}
h1{font-size:25px}.facts,dl.legend{grid-template-columns:1fr;gap:2px}.facts dd,dl.legend dd{margin-bottom:8px}
.beside{min-width:0;max-width:100%}.seen .said{flex-basis:100%}.tiles{grid-template-columns:1fr 1fr}.tile:last-child:nth-child(odd){grid-column:span 2}
table.stack thead{display:none}table.stack,table.stack tbody{display:block}
table.stack tr{display:block;border-bottom:1px solid var(--line);padding:8px 0}
table.stack th,table.stack td{display:block;border:0;padding:1px 0;text-align:left;white-space:normal;background:none;box-shadow:none}
table.stack td[data-label]{display:flex;justify-content:flex-end;align-items:baseline;gap:8px;text-align:right}
table.stack td[data-label]::before{content:attr(data-label);color:var(--quiet);font-weight:400;text-align:left;margin-right:auto}
table.stack.confusion td{padding:2px 8px;margin-bottom:1px}
table.stack td.none{display:none}table.stack td.bar-cell{padding:4px 0;width:auto}table.stack td:empty{display:none}
.said tr{display:block;border-bottom:1px solid var(--line);padding:5px 0}.said th,.said td{display:block;width:auto;border:0;padding:1px 0;text-align:left}
.walk{display:block}.lenses{grid-template-columns:1fr 1fr}
}
@page{margin:13mm}
@media print{
body{background:#fff;font-size:10pt}nav,.screen,.save,.walk,.cross,.controls,.scrub,.player .marks{display:none}
main,header,footer{max-width:none;padding:0}header{padding-top:0}h2{margin-top:24px}h2,h3,h4{break-after:avoid}
*{-webkit-print-color-adjust:exact;print-color-adjust:exact}
.card{border-color:#bbb;padding:12px 14px;-webkit-box-decoration-break:clone;box-decoration-break:clone}
p,.seen,figure,.tile,tr,pre,.maps,.legend,.said,.facts>*,.gallery a,.gallery img{break-inside:avoid}tr.total,summary,p:has(+pre){break-after:avoid}
.finding>h3{break-inside:avoid}.card>h3,.card>h3+p,.deck-page>.lead,.card:has(.legend),.maps{break-after:avoid}.card:has(.legend),.card:has(.maps),.card:has(.chips){break-inside:avoid}
thead{display:table-row-group}.tile b{font-size:15pt}figcaption,.contract details p,.small,.kicker{font-size:9pt}.formula{font-size:9pt;overflow:visible}
.scroll{overflow:visible}table,th,tbody th,th .small{font-size:7.2pt}th,td{padding:2px 3px}td.wide{min-width:90px}.bar.thin{min-width:40px}
.seen .said{flex-basis:260px}.said code{font-size:7pt}.seen{column-gap:16px}.seen figure{flex-basis:350px}.seen figure:has(.with-lens,.magnified){flex-basis:100%}.seen .with-lens .view{flex:0 1 45%}.said,.said th,.said .badge,.said .small{font-size:8pt}.facts,dl.legend{font-size:9pt}code,pre{font-size:8pt}
.maps,.runs{grid-template-columns:repeat(3,1fr);gap:16px}.run,.plots section{break-inside:avoid}.run .facts{font-size:7.5pt}.maps li{break-inside:avoid}.maps ul{font-size:8pt}.maps ul,.maps h4{break-inside:avoid}
.gallery{grid-template-columns:repeat(3,1fr)}
details::details-content{content-visibility:visible;block-size:auto}
}
)css";

std::string verdict_variables(Scheme scheme) {
  std::string text = "--range:" + hex_of(range_colour(scheme)) + ";";
  for (std::size_t v = 0; v < verdict_count; ++v) {
    text += std::string("--") + verdict_names[v] + ":" + hex_of(colour_of(static_cast<Verdict>(v), scheme)) + ";";
  }
  return text;
}

std::string verdict_classes() {
  std::string text = ".range{--c:var(--range)}";
  for (const char* name : verdict_names) text += std::string(".") + name + "{--c:var(--" + name + ")}";
  return text;
}

}  // namespace

const std::string& page_style() {
  static const std::string style =
      std::string(":root{color-scheme:light dark;") + light_variables + verdict_variables(Scheme::light) + "}" +
      "@media screen and (prefers-color-scheme:dark){:root{" + dark_variables + verdict_variables(Scheme::dark) + "}}" +
      rules + verdict_classes() + figure_style() + space_style();
  return style;
}

}  // namespace touchstone::report
