// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace gestalt {

/// A table of texts. Every row has as many cells as the head.
struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// What a report consists of.
struct Heading {
  std::string text;
};
struct Paragraph {
  std::string text;
};
struct Plot {
  std::string file;  ///< name of the SVG file beside the report
  std::string svg;
  std::string text;  ///< what is to be seen, for those who cannot
};
using ReportBlock = std::variant<Heading, Paragraph, TextTable, Plot>;

/// A page that is written once and shown as Markdown, HTML or plain text.
struct Report {
  std::string title;
  std::vector<ReportBlock> blocks;
};

/// GitHub's Markdown; plots are links to their files.
std::string markdown(const Report& report);

/// One self-contained page: plots are inside, nothing is fetched.
std::string html(const Report& report);

/// For a terminal: columns aligned, plots as the name of their file.
std::string plain_text(const Report& report);

/// RFC 4180, lines ending in \n.
std::string csv(const TextTable& table);

}  // namespace gestalt
