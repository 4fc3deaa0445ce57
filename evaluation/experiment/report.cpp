// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/report.h"

#include <algorithm>

#include "gestalt/evaluation/experiment/plot.h"

namespace gestalt {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::string join(const Report& report, const auto& show) {
  std::string text;
  for (const ReportBlock& block : report.blocks) text += std::visit(show, block);
  return text;
}

/// What would be read as Markdown stands for itself.
std::string escape_markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string("\\|*_`<>[]#").find(c) != std::string::npos) escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + escape_markdown(cell) + " |";
  return row + "\n";
}

/// Numbers to the right, the first column, which names the row, to the left.
std::string markdown_table(const TextTable& table) {
  std::string text = markdown_row(table.head) + "|";
  for (std::size_t i = 0; i < table.head.size(); ++i) text += i == 0 ? "---|" : "---:|";
  text += "\n";
  for (const auto& row : table.rows) text += markdown_row(row);
  return text + "\n";
}

std::string html_row(const std::vector<std::string>& cells, const std::string& tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells)
    row.append("<").append(tag).append(">").append(escape_xml(cell)).append("</" + tag + ">");
  return row + "</tr>\n";
}

std::string html_table(const TextTable& table) {
  std::string text = "<table>\n<thead>" + html_row(table.head, "th") + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) text += html_row(row, "td");
  return text + "</tbody>\n</table>\n";
}

/// Characters of a UTF-8 text.
std::size_t length(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned_table(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& cell : table.head) widths.push_back(length(cell));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], length(row[i]));
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string space(widths[i] - length(cells[i]), ' ');
      text += i == 0 ? cells[i] + space : "  " + space + cells[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text = line(table.head);
  for (const auto& row : table.rows) text += line(row);
  return text + "\n";
}

constexpr const char* page_style = R"(<style>
:root{color-scheme:light dark}
body{font:15px/1.5 system-ui,"DejaVu Sans",sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222;background:#fff}
table{display:block;overflow-x:auto;border-collapse:collapse;margin:1em 0;font-variant-numeric:tabular-nums}
th,td{padding:.15em .7em;border-bottom:1px solid #ddd;text-align:right}
th:first-child,td:first-child{text-align:left}
figure{margin:1em 0;overflow-x:auto}
@media (prefers-color-scheme:dark){body{color:#eee;background:#1b1b1b}th,td{border-color:#444}}
</style>
)";

}  // namespace

std::string markdown(const Report& report) {
  return "# " + escape_markdown(report.title) + "\n\n" +
         join(report, Overloaded{[](const Heading& block) { return "## " + escape_markdown(block.text) + "\n\n"; },
                                 [](const Paragraph& block) { return escape_markdown(block.text) + "\n\n"; },
                                 [](const TextTable& table) { return markdown_table(table); },
                                 [](const Plot& plot) {
                                   return "![" + escape_markdown(plot.text) + "](" + plot.file + ")\n\n";
                                 }});
}

std::string html(const Report& report) {
  const std::string title = escape_xml(report.title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
         title + "</title>\n" + page_style + "</head>\n<body>\n<h1>" + title + "</h1>\n" +
         join(report, Overloaded{[](const Heading& block) { return "<h2>" + escape_xml(block.text) + "</h2>\n"; },
                                 [](const Paragraph& block) { return "<p>" + escape_xml(block.text) + "</p>\n"; },
                                 [](const TextTable& table) { return html_table(table); },
                                 [](const Plot& plot) {
                                   return "<figure aria-label=\"" + escape_xml(plot.text) + "\">\n" + plot.svg +
                                          "</figure>\n";
                                 }}) +
         "</body>\n</html>\n";
}

std::string plain_text(const Report& report) {
  return report.title + "\n\n" +
         join(report, Overloaded{[](const Heading& block) { return block.text + "\n"; },
                                 [](const Paragraph& block) { return block.text + "\n\n"; },
                                 [](const TextTable& table) { return aligned_table(table); },
                                 [](const Plot& plot) { return plot.text + ": " + plot.file + "\n\n"; }});
}

std::string csv(const TextTable& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::string cell = cells[i];
      if (cell.find_first_of(",\"\r\n") != std::string::npos) {
        for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2) cell.insert(at, 1, '"');
        cell.insert(0, 1, '"').append(1, '"');
      }
      text += (i == 0 ? "" : ",") + cell;
    }
    return text + "\n";
  };
  std::string text = line(table.head);
  for (const auto& row : table.rows) text += line(row);
  return text;
}

}  // namespace gestalt
