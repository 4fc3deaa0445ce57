// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/report.h"

#include <gtest/gtest.h>

#include "number_text.h"
#include "paper_numbers.h"

namespace gestalt::test {
namespace {

const Report page{"A <title>",
                  {Heading{"Table 1"}, Paragraph{"r_co & r_rs"},
                   TextTable{{"name", "P"}, {{"a|b", "1.5"}, {"ä", "10"}}}, Plot{"p.svg", "<svg></svg>\n", "bars"}}};

TEST(Reports, AsMarkdown) {
  EXPECT_EQ(
      markdown(page),
      "# A \\<title\\>\n\n## Table 1\n\nr\\_co & r\\_rs\n\n| name | P |\n|---|---:|\n| a\\|b | 1.5 |\n| ä | 10 |\n\n"
      "![bars](p.svg)\n\n");
}

TEST(Reports, AsOneHtmlPage) {
  const std::string text = html(page);
  EXPECT_NE(text.find("<h1>A &lt;title&gt;</h1>"), std::string::npos);
  EXPECT_NE(text.find("<p>r_co &amp; r_rs</p>"), std::string::npos);
  EXPECT_NE(text.find("<tr><td>a|b</td><td>1.5</td></tr>"), std::string::npos);
  EXPECT_NE(text.find("<svg></svg>"), std::string::npos);
  EXPECT_EQ(text.find("p.svg"), std::string::npos);
}

TEST(Reports, AsPlainText) {
  EXPECT_EQ(plain_text(page),
            "A <title>\n\nTable 1\nr_co & r_rs\n\nname    P\na|b   1.5\nä      10\n\nbars: p.svg\n\n");
}

TEST(Csv, QuotesWhatNeedsIt) {
  EXPECT_EQ(csv({{"a", "b,c"}, {{"say \"hi\"", "1"}, {"", "x\ny"}}}), "a,\"b,c\"\n\"say \"\"hi\"\"\",1\n,\"x\ny\"\n");
}

TEST(NumberText, HasFixedDecimals) {
  EXPECT_EQ(number_text(1.005, 1), "1.0");
  EXPECT_EQ(number_text(-0.04, 1), "0.0");
  EXPECT_EQ(number_text(-0.06, 1), "-0.1");
  EXPECT_EQ(number_text(1e300, 0).size(), 301u);
}

TEST(PaperNumbers, AddUp) {
  for (const std::string set : {"learn", "test"}) {
    paper::Counts sum{}, all{};
    for (const paper::Counts& row : paper::table_1()) {
      if (row.set != set) continue;
      if (row.category == "all") {
        all = row;
        continue;
      }
      sum.images += row.images, sum.objects += row.objects;
      sum.structural += row.structural, sum.assembly += row.assembly;
    }
    EXPECT_EQ(sum.images, all.images) << set;
    EXPECT_EQ(sum.structural, all.structural) << set;
    // The paper's own sums of objects and assembly relations are off by a few.
    EXPECT_NEAR(sum.objects, all.objects, 4) << set;
    EXPECT_NEAR(sum.assembly, all.assembly, 5) << set;
  }
}

}  // namespace
}  // namespace gestalt::test
