#pragma once

namespace thalweg {

/// The page's style sheet: a printed report on screen; tables with rules above and below only.
inline constexpr const char* report_style = R"css(
:root { --ink: #1c1c1c; --soft: #5c5c5c; --rule: #cfcfcf; --faint: #f4f2ee; --accent: #0b5a8a; --warn: #a33b00; }
* { box-sizing: border-box; }
html { background: #fff; }
body { margin: 0 auto; max-width: 1040px; padding: 44px 28px 60px; color: var(--ink);
  font: 16px/1.5 Charter, "Bitstream Charter", "Iowan Old Style", "Palatino Linotype", Palatino, "DejaVu Serif", Georgia, serif;
  font-variant-numeric: lining-nums; }
h1, h2, h3, th, .tile, .meta, figcaption, nav, .key, .small, code { font-family: "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 29px; line-height: 1.2; font-weight: 600; letter-spacing: -0.01em; margin: 0 0 8px; }
h2 { font-size: 19px; font-weight: 600; margin: 46px 0 12px; padding-top: 10px; border-top: 2px solid var(--ink); }
h3 { font-size: 15px; font-weight: 600; margin: 26px 0 6px; }
p { margin: 8px 0 12px; max-width: 46em; }
a { color: var(--accent); text-decoration: none; } a:hover { text-decoration: underline; }
.source { color: var(--soft); font-style: italic; margin: 0 0 4px; max-width: none; }
.meta { color: var(--soft); font-size: 13px; margin: 0; max-width: none; }
.meta b { color: var(--ink); font-weight: 500; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(120px, 1fr)); margin: 22px 0 6px; border-top: 1px solid var(--rule); border-bottom: 1px solid var(--rule); }
.tile { padding: 12px 8px 10px 14px; border-left: 1px solid var(--rule); }
.tile:first-child { border-left: 0; padding-left: 0; }
.tile .v { font-size: 22px; font-weight: 600; letter-spacing: -0.01em; white-space: nowrap; }
.tile .v span { font-size: 13px; font-weight: 400; color: var(--soft); }
.tile .k { font-size: 12px; color: var(--soft); line-height: 1.3; }
.lead { max-width: none; }
.asked { font-size: 17px; max-width: none; margin: 14px 0 0; } .asked b { font-family: "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; font-weight: 600; }
.answer { display: grid; grid-template-columns: 210px 1fr; gap: 28px; margin: 16px 0 0; padding: 14px 0 12px; border-top: 2px solid var(--ink); border-bottom: 1px solid var(--rule); break-inside: avoid; }
.answer .v { font: 600 44px/1.1 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; letter-spacing: -0.02em; white-space: nowrap; } .answer .v span { font-size: 20px; font-weight: 400; color: var(--soft); }
.answer .k, .answer dl { font: 14px/1.4 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; } .answer .k { color: var(--soft); font-size: 15px; }
.answer dl { display: grid; grid-template-columns: 7em 1fr; gap: 3px 14px; margin: 0; } .answer dt { color: var(--soft); } .answer dd { margin: 0; }
.answer + h2 { margin-top: 20px; border-top: 0; padding-top: 0; }
figure { margin: 12px 0 18px; break-inside: avoid; }
figure svg, figure img { display: block; width: 100%; height: auto; }
figcaption { font-size: 12.5px; line-height: 1.45; color: var(--soft); margin-top: 4px; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 26px; }
.key { font-size: 13px; color: var(--soft); max-width: none; margin: 0 0 10px; }
.swatch { display: inline-block; width: 22px; height: 0; border-top: 4px solid; vertical-align: middle; margin: 0 5px 2px 12px; }
.swatch:first-child { margin-left: 0; }
table { border-collapse: collapse; font-size: 14px; line-height: 1.35; margin: 8px 0 16px; border-top: 1.5px solid var(--ink); border-bottom: 1.5px solid var(--ink); break-inside: avoid; }
table.long { break-inside: auto; } table.wide { width: 100%; }
th { font-size: 12px; font-weight: 500; color: var(--soft); text-align: left; vertical-align: bottom; padding: 5px 14px 5px 0; border-bottom: 1px solid var(--ink); }
td { padding: 3px 14px 3px 0; vertical-align: top; border-top: 1px solid #ececec; }
tbody tr:first-child td { border-top: 0; }
th:last-child, td:last-child { padding-right: 0; }
.n { text-align: right; font-variant-numeric: lining-nums tabular-nums; white-space: nowrap; }
td.group { font-weight: 600; padding-top: 11px; }
table.texts { max-width: 100%; } table.texts .n { white-space: normal; max-width: 18em; }
table.constants td:nth-child(2) { min-width: 10em; } table.constants td:first-child { white-space: nowrap; } table.constants { font-size: 13px; }
sup { font-size: 0.7em; line-height: 0; }
.soft { color: var(--soft); } .small { font-size: 12.5px; line-height: 1.45; color: var(--soft); max-width: none; }
.bar { display: inline-block; height: 9px; background: #9bb8cc; vertical-align: baseline; }
.on, .off { font: 600 12px "Helvetica Neue", Helvetica, Arial, sans-serif; } .on { color: #00644a; } .off { color: #8a8a8a; }
.warnings { border-left: 3px solid var(--warn); padding: 2px 0 2px 14px; margin: 12px 0; }
.warnings li { margin: 3px 0; } ul { padding-left: 18px; margin: 6px 0; }
code { font: 12.5px "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
.overview td:first-child { width: 60px; } figure svg.sample, svg.sample { width: 46px; vertical-align: middle; } .overview th { white-space: normal; max-width: 7em; }
.hover { position: relative; } .hover svg { cursor: crosshair; touch-action: pan-y; }
.hair { position: absolute; width: 0; border-left: 1px solid #777; pointer-events: none; }
.values { position: absolute; z-index: 2; background: rgba(255,255,255,.94); border: 1px solid var(--rule); padding: 5px 9px; pointer-events: none;
  font: 12px/1.35 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; box-shadow: 0 1px 5px rgba(0,0,0,.14); }
.values table { margin: 2px 0 0; border: 0; font-size: 12px; } .values td, .values th { padding: 1px 10px 1px 0; border: 0; font-size: 12px; }
#scene .canvas { height: 480px; overflow: hidden; border: 1px solid var(--rule); } #scene .canvas canvas { touch-action: none; }
.controls { display: flex; gap: 12px; align-items: center; font: 13px "Helvetica Neue", Helvetica, Arial, sans-serif; padding: 6px 0; }
.controls input[type=range] { flex: 1; } .controls output { min-width: 6em; }
.scale i { display: inline-block; width: 110px; height: 10px; vertical-align: baseline; background: linear-gradient(90deg, #005951, #59b5ab, #decca8, #bf822e, #543005); }
.missing { border: 1px dashed var(--rule); color: var(--soft); padding: 18px; font-size: 14px; }
@media screen and (max-width: 760px) { .tiles { grid-template-columns: repeat(3, 1fr); } .pair, .answer { grid-template-columns: 1fr; } }
@page { size: A4; margin: 16mm 15mm; }
@media print { .hair, .values, .controls, .onscreen { display: none !important; } body { max-width: none; padding: 0; font-size: 10.5pt; } h1 { font-size: 19pt; } h2 { font-size: 13pt; margin-top: 22pt; break-after: avoid; } h3 { break-after: avoid; }
  .lead { font-size: 11pt; } p { orphans: 3; widows: 3; } table { font-size: 9pt; } .tile .v { font-size: 14pt; } a { color: inherit; } }
)css";

}  // namespace thalweg
