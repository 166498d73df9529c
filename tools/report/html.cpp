#include "report/html.hpp"

#include <cmath>
#include <utility>

#include "flashbvh/version.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// The style of all pages: CSS, light and dark, for any width, and for paper.

/// The contrast of text and its background is at least 4.5 to 1, that of lines and bars 3 to 1.
/// p0 to p4: parts of flash; v0 to v4: verdicts, which also differ in lightness, for readers who
/// cannot distinguish the colours; l0 to l5: lines of a chart.
inline constexpr const char* kColours = R"(:root{color-scheme:light dark;
--ground:#f6f7f9;--paper:#fff;--text:#1c2128;--soft:#57606a;--line:#d5dae1;--accent:#0b5cad;
--good:#12692f;--bad:#9a4a00;--leaf:#0b6bcb;--inner:#8296ad;--hot:214,90,30;
--p0:#0b5cad;--p1:#b4540a;--p2:#12805c;--p3:#8b3fb5;--p4:#5b6776;
--v0:#8a97a6;--v1:#c07f00;--v2:#6a45d6;--v3:#a8071a;--v4:#1c2128;
--l0:#0b5cad;--l1:#00795c;--l2:#7a4b1e;--l3:#007c9e;--l4:#5b6776;--l5:#3b3f9e}
@media (prefers-color-scheme:dark){:root{
--ground:#0d1117;--paper:#161b22;--text:#e6edf3;--soft:#a3adb8;--line:#30363d;--accent:#79b8ff;
--good:#6fd08c;--bad:#f0a45d;--leaf:#58a6ff;--inner:#66788c;--hot:240,120,50;
--p0:#58a6ff;--p1:#f0883e;--p2:#4ac78a;--p3:#c89bf0;--p4:#9da5b0;
--v0:#66788c;--v1:#ffc53d;--v2:#a78bfa;--v3:#ff4d4f;--v4:#e6edf3;
--l0:#58a6ff;--l1:#4ade93;--l2:#d9b38c;--l3:#4dd0e1;--l4:#a3adb8;--l5:#b4bcff}}
)";

inline constexpr const char* kText = R"(*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--text);font:16px/1.5 system-ui,sans-serif}
main,header{max-width:1400px;margin:0 auto;padding:20px clamp(12px,3vw,32px) 0}
h1,h2,h3,code,dd,.verdict li{overflow-wrap:anywhere}
h1{margin:0}h2{margin:0 0 .7em}h3{margin:1.5em 0 .6em}h4{margin:0;font-weight:400}
p{max-width:80ch;margin:.6em 0}
.lead,.note,small,footer,h4,dt,.soft{color:var(--soft)}
.note,small,.keys,h4,dt,footer table{font-size:.875rem}
.keys span{display:inline-block;margin-right:1.2em}
.key{display:inline-block;width:.75em;height:.75em;margin-right:.5em;border-radius:2px}
a{color:var(--accent)}
section{background:var(--paper);border:1px solid var(--line);border-radius:12px;
padding:clamp(14px,2.5vw,28px);margin:22px 0}
.good{color:var(--good)}.bad{color:var(--bad)}.verdict b{color:var(--text)}
.warnings,.verdict{list-style:none;padding:0;margin:.6em 0}.verdict{font-size:1.15rem}
.hide{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%);white-space:nowrap}
.facts,.cards{display:grid;gap:14px 20px;margin:0 0 1em;
grid-template-columns:repeat(auto-fit,minmax(min(100%,200px),1fr))}
.facts div{border-left:3px solid var(--line);padding-left:12px;min-width:0}
dd{margin:0;font-size:1.15rem;font-weight:600}
dd small{display:block;font-weight:400}
.card{border:1px solid var(--line);border-radius:8px;padding:10px 14px;min-width:0}
.card b{color:var(--good)}.card.beyond b{color:var(--bad)}
.gauge{height:9px;background:var(--line);overflow:hidden;margin:.5em 0}
.gauge span{display:block;height:100%;min-width:2px;background:var(--good)}
.beyond .gauge span{background:var(--bad)}
)";

inline constexpr const char* kTables = R"(.scroll{overflow-x:auto;margin:0 0 1em}
table{border-collapse:collapse;width:100%;font-size:.925rem;font-variant-numeric:tabular-nums}
caption{text-align:left;font-weight:600;padding:.3em 0 .4em}
th,td{padding:5px 14px 5px 0;text-align:left;font-weight:400;border-bottom:1px solid var(--line);
vertical-align:baseline}
th small,td small{display:block}
thead th{color:var(--soft);vertical-align:bottom}
.n{text-align:right}td.n{white-space:nowrap}
.hist td,.hist th{width:1%}.hist :is(th,td):last-child{width:auto}
.heat{background:rgba(var(--hot),calc(var(--heat)*.5))}
.row{display:flex;min-width:96px;height:11px}
.over{position:relative;display:block}.over span{position:absolute;left:0;bottom:0;height:100%}
.over .leaf{height:5px;bottom:3px}
.inner{background:var(--inner)}.leaf{background:var(--leaf)}
.bar{display:flex;height:14px;overflow:hidden;gap:1px}
.bar span{flex:1 1 0;min-width:1px}
.p0{background:var(--p0)}.p1{background:var(--p1)}.p2{background:var(--p2)}.p3{background:var(--p3)}
.p4{background:var(--p4)}
.matrix{width:auto}.matrix td,.matrix thead th{padding:6px 10px;text-align:center}
.pairs td{border:2px solid var(--paper);line-height:1.25}
.pairs td small{color:var(--text);white-space:nowrap}
.matrix tbody th{white-space:nowrap;padding-right:10px;position:sticky;left:0;background:var(--paper)}
.is-never{background:rgba(40,160,90,.2)}.is-can{background:rgba(var(--hot),.34)}
.is-contact,.is-believed{background:rgba(220,160,20,.3)}.is-fixed{background:rgba(130,145,165,.22)}
.is-undecided{background:rgba(160,80,200,.28)}
@media (min-width:540px){.hist th{white-space:nowrap}}
@media (max-width:539px){th,td{padding-right:8px}
table:not(.matrix){font-size:.8rem}table:not(.matrix) :is(th,td):not(td.n){overflow-wrap:anywhere}
.pairs tbody th,.pairs thead th{white-space:normal;overflow-wrap:anywhere;min-width:5.5em;max-width:7em}
.hist tr,.words tr{display:grid;border-bottom:1px solid var(--line);padding:4px 0;
grid-template-columns:1fr 4em 4.6em 4.6em}
:is(.hist,.words) :is(td,th){width:auto;border:0;padding:1px 0}
:is(.hist,.words) thead th:last-child{display:none}
:is(.hist,.words) td:last-child{grid-column:1/-1;padding:3px 0}}
@media print{section{border:0;padding:0}.scroll{overflow:visible}
td,.key{print-color-adjust:exact;-webkit-print-color-adjust:exact}figure,tr{break-inside:avoid}}
)";

inline constexpr const char* kCharts = R"(figure{margin:0;min-width:0}
figure svg{display:block;width:100%;height:auto;border:1px solid var(--line);background:var(--ground)}
figcaption{color:var(--soft);font-size:.875rem}figcaption b{color:var(--text)}
svg text{font-size:32px;fill:var(--soft);text-anchor:middle;dominant-baseline:central}
path{fill:none;stroke-width:1.3px;stroke-linejoin:round;vector-effect:non-scaling-stroke}
.axis{stroke:var(--soft)}
.v0{background:var(--v0);fill:var(--v0)}.v1{background:var(--v1);fill:var(--v1)}
.v2{background:var(--v2);fill:var(--v2)}.v3{background:var(--v3);fill:var(--v3)}
.v4{background:var(--v4);fill:var(--v4)}
@media (min-width:760px){.chart text{font-size:15px}}
.chart path,.sample path{stroke-width:1.8px}
.chart .stop{stroke:var(--v3);stroke-dasharray:7 5}.chart .warn{stroke:var(--v1);stroke-dasharray:7 5}
.chart .number{font-weight:600;fill:var(--text);paint-order:stroke;stroke:var(--ground);stroke-width:6px}
.sample{width:40px;height:8px;margin-right:.4em}
.l0{stroke:var(--l0)}.l1{stroke:var(--l1);stroke-dasharray:12 4}
.l2{stroke:var(--l2);stroke-dasharray:6 3}.l3{stroke:var(--l3);stroke-dasharray:12 3 2 3}
.l4{stroke:var(--l4);stroke-dasharray:18 5}.l5{stroke:var(--l5);stroke-dasharray:12 3 2 3 2 3}
.chart .l6,.sample .l6{stroke:var(--text);stroke-width:1px;stroke-dasharray:2 2}
)";

constexpr const char* kReplacement = "\xEF\xBF\xBD";

std::uint32_t byte_at(const std::string& text, std::size_t place) {
  return place < text.size() ? static_cast<std::uint8_t>(text[place]) : 0;
}

/// Bytes of the valid character at `place`, 0 if it is invalid (Unicode, table 3-7).
std::size_t character_length(const std::string& text, std::size_t place) {
  const std::uint32_t first = byte_at(text, place);
  if (first < 0x80) {
    return first < 0x20 || first == 0x7F ? 0 : 1;
  }
  const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 0 || first > 0xF4) {
    return 0;
  }
  const std::uint32_t second = byte_at(text, place + 1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
      (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90)) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, place + i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  return length;
}

std::string escaped_character(const std::string& character) {
  constexpr std::pair<char, const char*> kEntities[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  for (const auto& [special, entity] : kEntities) {
    if (character[0] == special) {
      return entity;
    }
  }
  return character;
}

/// A "th" or "td" element with its content.
std::string cell(const std::string& tag, const std::string& attributes,
                 const std::string& content) {
  return "<" + tag + attributes + ">" + content + "</" + tag + ">";
}

std::string whole_table(const std::string& style, const std::string& caption,
                        const std::string& head, const std::string& body) {
  return "<div class=scroll><table" + style + ">" +
         (caption.empty() ? "" : "<caption>" + caption + "</caption>") + "\n<thead><tr>" + head +
         "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string html;
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t length = character_length(text, place);
    html += length == 0 ? kReplacement : escaped_character(text.substr(place, length));
    place += length == 0 ? 1 : length;
  }
  return html;
}

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t place = text.size(); place > 3; place -= 3) {
    text.insert(place - 3, ",");
  }
  return text;
}

std::string counted(std::uint64_t number, const char* one, const char* many) {
  return grouped(number) + " " + (number == 1 ? one : many);
}

std::string length_of(const Measure& measure, double length) {
  const double size = std::fabs(length);
  return (size >= 1e4 && size < 1e9 ? fixed(length, 0) : significant(length, 4)) + measure.suffix;
}

std::string square(const std::string& style) {
  return "<i class=\"key " + style + "\"></i>";
}

std::string key(const std::string& style, const std::string& text) {
  return "<span>" + square(style) + text + "</span>\n";
}

std::string fact(const std::string& name, const std::string& value, const std::string& note) {
  return "<div><dt>" + name + "</dt><dd>" + value +
         (note.empty() ? "" : "<small>" + note + "</small>") + "</dd></div>\n";
}

std::string facts(const std::string& items) {
  return "<dl class=facts>\n" + items + "</dl>\n";
}

std::string note(const std::string& text) {
  return "<p class=note>" + text + "</p>\n";
}

std::string verdict_line(const std::string& style, const std::string& what, const std::string& of) {
  return "<li" + style + "><b>" + what + "</b>" + of + "</li>\n";
}

std::string decision(const std::string& style, const std::string& what, const std::string& of) {
  return "<li>" + square(style) + "<b>" + what + "</b>" + (of.empty() ? "" : ": " + of) + "</li>\n";
}

std::string decision_section(const std::string& title, const std::string& decisions) {
  return section("decision", title, "<ul class=verdict>\n" + decisions + "</ul>");
}

std::string footer() {
  return "<footer>" + note(version_text()) + "</footer>\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& body) {
  return "<section" + (id.empty() ? "" : " id=" + id) + ">" +
         (title.empty() ? "" : "<h2>" + title + "</h2>") + "\n" + body + "</section>\n";
}

std::string page(const std::string& title, const char* command, const char* lead,
                 const std::string& body) {
  return concat(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n<title>",
      title, " &middot; flashbvh ", command, "</title>\n<style>\n", kColours, kText, kTables,
      kCharts, "</style>\n</head>\n<body>\n<header>\n<p class=lead>flashbvh ", command, ": ", lead,
      "</p>\n<h1>", title, "</h1>\n</header>\n<main>\n", body, "</main>\n</body>\n</html>\n");
}

std::string version_text() {
  return concat("flashbvh ", FLASHBVH_VERSION_MAJOR, ".", FLASHBVH_VERSION_MINOR, ".",
                FLASHBVH_VERSION_PATCH);
}

std::string table(const std::string& caption, const Cells& columns,
                  const std::vector<Cells>& rows) {
  const auto is_number = [&](std::size_t i) { return columns[i][0] == '#'; };
  std::string head;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    head += cell("th", std::string(" scope=col") + (is_number(i) ? " class=n" : ""),
                 columns[i].substr(is_number(i) ? 1 : 0));
  }
  std::string body;
  for (const Cells& row : rows) {
    body += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      body += i == 0 ? cell("th", " scope=row", row[i])
                     : cell("td", is_number(i) ? " class=n" : "", row[i]);
    }
    body += "</tr>\n";
  }
  return whole_table("", caption, head, body);
}

std::string matrix(const std::string& style, const std::string& caption, const Cells& names,
                   const std::function<std::string(std::size_t, std::size_t)>& cell_at) {
  std::string head = "<td></td>";
  std::string body;
  for (std::size_t i = 0; i < names.size(); ++i) {
    head += cell("th", " scope=col", names[i]);
    body += "<tr>" + cell("th", " scope=row", names[i]);
    for (std::size_t j = 0; j < names.size(); ++j) {
      body += cell_at(i, j);
    }
    body += "</tr>\n";
  }
  return whole_table(" class=\"matrix " + style + "\"", caption, head, body);
}

}  // namespace flashbvh::tool
