// How a page looks: CSS, light and dark, for any width, and on paper.
#ifndef FLASHBVH_TOOLS_REPORT_STYLE_HPP
#define FLASHBVH_TOOLS_REPORT_STYLE_HPP

namespace flashbvh::tool {

/// Text has a contrast of 4.5 to 1 at least against what it stands on, lines and bars of 3 to 1.
inline constexpr const char* kColours = R"(:root{color-scheme:light dark;
--ground:#f6f7f9;--paper:#fff;--text:#1c2128;--soft:#57606a;--line:#d5dae1;--accent:#0b5cad;
--good:#12692f;--bad:#9a4a00;--leaf:#0b6bcb;--inner:#8296ad;--hot:214,90,30;
--p0:#0b5cad;--p1:#b4540a;--p2:#12805c;--p3:#8b3fb5;--p4:#5b6776;
--k0:#0b5cad;--k1:#b4400a;--k2:#0a7a4a;--k3:#9a26a0}
@media (prefers-color-scheme:dark){:root{
--ground:#0d1117;--paper:#161b22;--text:#e6edf3;--soft:#a3adb8;--line:#30363d;--accent:#79b8ff;
--good:#6fd08c;--bad:#f0a45d;--leaf:#58a6ff;--inner:#66788c;--hot:240,120,50;
--p0:#58a6ff;--p1:#f0883e;--p2:#4ac78a;--p3:#c89bf0;--p4:#9da5b0;
--k0:#58a6ff;--k1:#ff9d5c;--k2:#4ade93;--k3:#e29bff}}
)";

inline constexpr const char* kText = R"(*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--ground);color:var(--text);
font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif}
main,header{max-width:1400px;margin:0 auto;padding:0 clamp(12px,3vw,32px)}
header{padding-top:clamp(20px,4vw,40px)}main{padding-bottom:48px}
h1{font-size:clamp(1.5rem,4vw,2.1rem);line-height:1.2;margin:0;letter-spacing:-.01em;
overflow-wrap:anywhere}
h2{font-size:1.35rem;line-height:1.25;margin:0 0 .7em;overflow-wrap:anywhere}
h3{font-size:1.05rem;margin:1.5em 0 .6em;overflow-wrap:anywhere}h4{font-size:.875rem;margin:0;
font-weight:400;color:var(--soft)}
p{max-width:80ch;margin:.6em 0}.lead,.note,small,footer{color:var(--soft)}.lead{margin:0}
.note,small,.keys,footer table{font-size:.875rem}
.keys span{display:inline-block;margin-right:1.2em}
a{color:var(--accent)}code{font-size:.85em;overflow-wrap:anywhere}
section{background:var(--paper);border:1px solid var(--line);border-radius:12px;
padding:clamp(14px,2.5vw,28px);margin:22px 0}
.good{color:var(--good)}.warnings{margin:.6em 0;padding:0;list-style:none}
.verdict{list-style:none;padding:0;margin:0 0 1.4em;font-size:1.15rem;line-height:1.35}
.verdict li{padding:.3em 0}.soft{color:var(--soft)}.verdict b{color:var(--text)}.bad{color:var(--bad)}
.hide{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%);white-space:nowrap}
.facts,.tiles,.cards{display:grid;gap:14px 20px;margin:0 0 1em;
grid-template-columns:repeat(auto-fit,minmax(min(100%,200px),1fr))}
.cards{grid-template-columns:repeat(auto-fit,minmax(min(100%,150px),1fr));gap:10px}
.tiles{grid-template-columns:repeat(auto-fit,minmax(min(100%,270px),1fr))}
.facts div,.tiles div{border-left:3px solid var(--line);padding-left:12px;min-width:0}
dt{color:var(--soft);font-size:.875rem}dd{margin:0}
dd{font-size:1.15rem;font-weight:600;line-height:1.3;overflow-wrap:anywhere;
font-variant-numeric:tabular-nums}.tiles dd{font-size:1.6rem}
dd small{display:block;font-weight:400;line-height:1.4;padding-top:.15em}
.card{border:1px solid var(--line);border-radius:8px;padding:10px 14px;min-width:0;line-height:1.35;
font-variant-numeric:tabular-nums}
.card b{color:var(--good)}.card.beyond b{color:var(--bad)}
.gauge{height:9px;border-radius:5px;background:var(--line);overflow:hidden;margin:.5em 0}
.gauge span{display:block;height:100%;min-width:2px;background:var(--good)}
.beyond .gauge span{background:var(--bad)}
)";

inline constexpr const char* kTables = R"(.scroll{overflow-x:auto;margin:0 0 1em}
table{border-collapse:collapse;width:100%;font-size:.925rem;font-variant-numeric:tabular-nums}
caption{text-align:left;font-weight:600;padding:.3em 0 .4em}
th,td{padding:5px 14px 5px 0;text-align:left;font-weight:400;border-bottom:1px solid var(--line);
vertical-align:baseline}
th small{display:block;line-height:1.3}
thead th{color:var(--soft);font-size:.875rem;vertical-align:bottom}
.n{text-align:right}td.n{white-space:nowrap}th:last-child,td:last-child{padding-right:0}
tbody tr:last-child>*{border-bottom:0}
.hist td,.hist th{width:1%}.hist :is(th,td):last-child{width:auto}
.matrix{width:auto}.matrix td,.matrix thead th{padding:6px 10px}.matrix thead th{white-space:nowrap}
.matrix td:last-child,.matrix thead th:last-child{padding-right:10px}
.heat{background:rgba(var(--hot),calc(var(--heat)*.5))}
.row{display:flex;min-width:96px;height:11px;vertical-align:middle}
.over{position:relative;display:block}.over span{position:absolute;left:0;bottom:0;height:100%}
.over .leaf{height:5px;bottom:3px}
.row span{min-width:1px}.inner{background:var(--inner)}.leaf{background:var(--leaf)}
.over .inner{opacity:.55}
.key{display:inline-block;width:.75em;height:.75em;margin-right:.5em;border-radius:2px}
.bar{display:flex;height:14px;border-radius:3px;overflow:hidden;gap:1px}
.bar span{flex:1 1 0;min-width:1px}
.p0{background:var(--p0)}.p1{background:var(--p1)}.p2{background:var(--p2)}.p3{background:var(--p3)}
.p4{background:var(--p4)}
@media (min-width:540px){.hist th{white-space:nowrap}}
@media (max-width:539px){th,td{padding-right:10px}
.hist tr{display:grid;border-bottom:1px solid var(--line);padding:4px 0;
grid-template-columns:1fr 3.6em 4.6em 4.6em}
.hist :is(td,th){width:auto;border:0;padding:1px 0}.hist thead th:last-child{display:none}
.hist td:last-child{grid-column:1/-1;padding:3px 0}}
)";

inline constexpr const char* kPictures = R"(.look{border:0;margin:0;padding:0;min-width:0}
.look legend{font-weight:600;padding:0;margin-bottom:.4em}
.R{position:absolute;opacity:0}
.R+label{display:inline-block;min-width:2.4em;text-align:center;padding:3px 10px;margin:0 3px 5px 0;
border:1px solid var(--soft);border-radius:7px;cursor:pointer;font-size:.925rem}
.R+label:hover{border-color:var(--accent);color:var(--accent)}
.R:checked+label{background:var(--accent);border-color:var(--accent);color:var(--paper);font-weight:600}
.R:focus-visible+label{outline:3px solid var(--accent);outline-offset:2px}
.views,.contacts{display:grid;gap:14px;margin:.8em 0 1em}
@media (min-width:540px){.views{grid-template-columns:1fr 1fr}}
@media (min-width:760px){.contacts{grid-template-columns:1fr 1fr}}
@media (min-width:1060px){.views{grid-template-columns:repeat(4,1fr)}}
figure{margin:0;min-width:0}
figure svg{display:block;width:100%;height:auto;border:1px solid var(--line);border-radius:8px;
background:var(--ground)}
figcaption{color:var(--soft);font-size:.875rem;line-height:1.4;padding-top:5px}
figcaption b{color:var(--text)}summary{cursor:pointer;width:max-content}
svg text{font-size:39px;fill:var(--soft);text-anchor:middle;dominant-baseline:central}
@media (min-width:760px){.contacts text{font-size:28px}}
path,circle{fill:none;stroke-width:1.3px;stroke-linejoin:round;vector-effect:non-scaling-stroke}
.faces path{stroke-width:.8px}
.axis{stroke:var(--soft)}circle{stroke:var(--accent);stroke-width:2px;stroke-dasharray:6 4}
.k0{stroke:var(--k0)}.k1{stroke:var(--k1)}.k2{stroke:var(--k2)}.k3{stroke:var(--k3)}
.F path{fill-opacity:.09;stroke-width:1.7px}
.F .k0{fill:var(--k0)}.F .k1{fill:var(--k1)}.F .k2{fill:var(--k2)}.F .k3{fill:var(--k3)}
@media print{section{border:0;padding:0}body{background:none}.scroll{overflow:visible}}
)";

}  // namespace flashbvh::tool

#endif
