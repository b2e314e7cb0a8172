#include "zonal/report/style.h"

namespace zonal {

std::string_view page_style() {
  return R"css(
:root {
  color-scheme: light dark;
  --paper: #fbfaf8; --ink: #1d1c1a; --quiet: #68645c; --rule: #dedad2; --shade: #f2efe9; --accent: #a8470a;
}
@media (prefers-color-scheme: dark) {
  :root { --paper: #141414; --ink: #e9e6e0; --quiet: #a09b92; --rule: #33312e; --shade: #1d1c1b; --accent: #f09a52; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; scroll-behavior: smooth; }
body {
  margin: 0 auto; max-width: 1120px; padding: 56px 32px 64px; background: var(--paper); color: var(--ink);
  font: 15px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  font-variant-numeric: tabular-nums; overflow-wrap: anywhere;
}
h1 { margin: 0; font-size: 34px; line-height: 1.2; font-weight: 600; letter-spacing: -.015em; }
h2 { margin: 0; font-size: 15px; line-height: 1.55; font-weight: 600; }
h3 { margin: 32px 0 12px; font-size: 15px; font-weight: 600; }
p { margin: 0 0 14px; max-width: 66ch; }
.subtitle { margin: 6px 0 0; color: var(--quiet); max-width: none; }
.quiet, figcaption, caption, dt, thead th { color: var(--quiet); }
a { color: var(--accent); text-underline-offset: 3px; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 3px; border-radius: 2px; }

nav ul { display: flex; flex-wrap: wrap; gap: 4px 20px; margin: 22px 0 36px; padding: 0;
  list-style: none; font-size: 14px; }
nav a { color: var(--quiet); text-decoration: none; }
nav a:hover { color: var(--accent); text-decoration: underline; }

section { display: grid; grid-template-columns: 176px minmax(0, 1fr); gap: 0 32px; margin-top: 44px; padding-top: 20px;
  border-top: 1px solid var(--rule); }
section > div > :last-child { margin-bottom: 0; }

figure { margin: 0 0 20px; }
figure img, figure svg { display: block; max-width: 100%; height: auto; }
figcaption { margin-top: 8px; font-size: 13px; line-height: 1.45; }
figcaption b { color: var(--ink); font-weight: 600; }
.wide img { width: 100%; }
.ball { border-radius: 50%; }
.beside { display: grid; grid-template-columns: minmax(0, 3.3fr) minmax(0, 1fr); gap: 28px; align-items: start; }
.chart { width: 100%; color: var(--ink); font-size: 10.5px; }
.chart .ink { fill: currentColor; }
.plot { width: 100%; color: var(--ink); font-size: 13px; }
.plot .ink { fill: currentColor; }
.plates { display: flex; flex-wrap: wrap; gap: 24px 26px; margin: 0 0 18px; }
.plates figure { margin: 0; min-width: 0; }
.plates img { width: 100%; border-radius: 3px; }
.accent { color: var(--accent); fill: var(--accent); }
.marked { position: relative; }
.marked > svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.panorama-axis { display: flex; justify-content: space-between; margin-top: 5px; color: var(--quiet); font-size: 12px; }
.strip { display: grid; gap: 22px 18px; margin: 0 0 20px;
  grid-template-columns: repeat(auto-fill, minmax(128px, 1fr)); }
.fits { gap: 22px 16px; grid-template-columns: repeat(auto-fill, minmax(102px, 1fr)); }
.strip figure { margin: 0; }
.strip img { width: 100%; }
.strip img + img { margin-top: 8px; }
.pixels { image-rendering: pixelated; width: 100%; }
.pair { display: grid; gap: 24px; grid-template-columns: repeat(auto-fit, minmax(240px, 1fr)); align-items: start; }
.small { max-width: 256px; }
.scale { display: flex; align-items: center; gap: 10px; margin: 0 0 20px; color: var(--quiet); font-size: 13px; }
.scale span { white-space: nowrap; }
.scale img { width: 200px; height: 10px; flex: 0 1 200px; min-width: 60px; }

.readout { display: grid; gap: 18px 28px; margin: 26px 0 0;
  grid-template-columns: repeat(auto-fit, minmax(140px, 1fr)); }
.readout div { display: flex; flex-direction: column; }
.readout dd { order: -1; font-size: 23px; line-height: 1.25; font-weight: 500; letter-spacing: -.01em; }
.readout dt { font-size: 13px; }

dl { margin: 0 0 20px; }
dd { margin: 0; }
section dl { display: grid; gap: 0 28px; grid-template-columns: repeat(auto-fill, minmax(270px, 1fr)); }
section dl div { display: flex; justify-content: space-between; gap: 16px; padding: 5px 0;
  border-bottom: 1px solid var(--rule); }
section dl dt { flex: 0 0 auto; max-width: 62%; overflow-wrap: normal; }
section dl dd { text-align: right; min-width: 0; overflow-wrap: anywhere; }

table { width: 100%; margin: 0 0 22px; border-collapse: collapse; }
caption { padding-bottom: 8px; text-align: left; font-size: 13px; line-height: 1.45; }
th, td { padding: 5px 14px 5px 0; border-bottom: 1px solid var(--rule); text-align: left;
  vertical-align: top; font-weight: 400; }
th:last-child, td:last-child { padding-right: 0; }
thead th { font-size: 13px; vertical-align: bottom; }
tbody th:not(.n) { min-width: 7.5em; }
.n { text-align: right; white-space: nowrap; }
thead .n { white-space: normal; overflow-wrap: normal; }

.notes { margin: 0; padding: 0; list-style: none; }
.warning { margin: 0 0 12px; padding: 12px 16px; border-left: 3px solid var(--accent); background: var(--shade); }
.warning b { display: block; font-weight: 600; }
details { margin: 0 0 16px; }
summary { cursor: pointer; padding: 4px 0; color: var(--accent); }
details[open] > summary { margin-bottom: 10px; }
pre { margin: 0 0 18px; padding: 14px 16px; background: var(--shade); white-space: pre-wrap;
  font: 13px/1.55 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
footer { margin-top: 56px; padding-top: 16px; border-top: 1px solid var(--rule); color: var(--quiet); font-size: 13px; }

@media (max-width: 760px) {
  body { padding: 28px 18px 40px; }
  h1 { font-size: 26px; }
  section { display: block; margin-top: 34px; padding-top: 14px; }
  h2 { margin-bottom: 14px; font-size: 18px; }
  nav ul { margin: 16px 0 26px; }
  .strip, .fits { grid-template-columns: repeat(auto-fill, minmax(100px, 1fr)); gap: 20px 14px; }
  th, td { padding-right: 9px; }
  table { font-size: 14px; }
  .strip figcaption { font-size: 12px; }
  .beside { gap: 14px; }
  .readout { grid-template-columns: repeat(auto-fit, minmax(128px, 1fr)); }
  .readout dd { font-size: 20px; }
}
@media (max-width: 340px) {
  th, td { padding-right: 6px; }
}
@media (max-width: 560px) {
  /* Charts shrink with the page, their letters must not. */
  .chart { font-size: 23px; }
  .stacks thead { display: none; }
  .stacks, .stacks tbody, .stacks tr, .stacks th, .stacks caption { display: block; }
  .stacks tr { padding: 8px 0; border-bottom: 1px solid var(--rule); }
  .stacks th, .stacks td { padding: 2px 0; border: 0; }
  .stacks th { font-weight: 600; }
  .stacks td { display: flex; justify-content: space-between; }
  .stacks td::before { content: attr(data-label); color: var(--quiet); }
}
@media print {
  :root { --paper: #fff; --ink: #000; --quiet: #444; --rule: #bbb; --shade: #f4f4f4; --accent: #8a3a08;
    color-scheme: light; }
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  nav { display: none; }
  section { display: block; break-inside: auto; }
  h2 { margin-bottom: 8pt; break-after: avoid; }
  figure, tr, .warning, .strip figure { break-inside: avoid; }
  details::details-content { content-visibility: visible; block-size: auto; }
  img { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";
}

}  // namespace zonal
