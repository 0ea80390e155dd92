// docs/contract.md: whoever cites it finds what is cited.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/docs/citations.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::set<std::string> Page = citable(
    "# A contract\n\n## 9. a unit\n\n### 9.5 steps\n\n## 18. corners\n\n| item | of |\n|---|---|\n"
    "| S | stack |\n");

TEST(Citations, AreNumbersAfterTheWord) {
  EXPECT_THAT(citations("// Source  contract sections 5.1, 5.2, 6; the article."),
              ElementsAre("5.1", "5.2", "6"));
  EXPECT_THAT(citations("Contract 7.1 and 7.6 in closed form, contract 9.4 to 9.7."),
              ElementsAre("7.1", "7.6", "9.4", "9.7"));
  EXPECT_THAT(citations("(contract 18, item S), contract 8, rule 3, contract 13.1: room"),
              ElementsAre("18", "S", "8", "13.1"));
  EXPECT_THAT(citations("the contract of 5 units, contract, -240..239"), IsEmpty());
}

TEST(Citations, GoOverTheEndOfALine) {
  EXPECT_THAT(citations("// as on the nav_line, contract\n// sections 11.2\n// and 11.5\n"),
              ElementsAre("11.2", "11.5"));
  EXPECT_THAT(citations("/// walks, contract section 9 and item S\n"), ElementsAre("9", "S"));
}

TEST(Citations, OnesThatLeadNowhereAreFound) {
  EXPECT_THAT(unresolved("contract 9.5, 9, and 18, item S", Page), IsEmpty());
  EXPECT_THAT(
      unresolved("contract 9.5 and 9.95\n// contract section 77; contract 18, item Q", Page),
      ElementsAre("9.95", "77", "Q"));
}

bool is_text(const std::filesystem::path& path) {
  for (const char* extension : {".png", ".gif", ".csv", ".svg", ".wav", ".gz"})
    if (path.extension() == extension) return false;
  return true;
}

TEST(Contract, EveryCitationInTheProjectLeadsToASection) {
  const std::set<std::string> contract = citable(page("docs/contract.md"));
  const std::filesystem::path root = RACEBEAM_SOURCE_DIR;
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"sc", "rtl", "tb", "tests", "scenes", "scripts", "cmake", "docs"}) {
    if (!exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() && is_text(entry.path())) files.push_back(entry.path());
  }
  for (const auto& entry : std::filesystem::directory_iterator(root))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::size_t cited = 0;
  for (const auto& path : files) {
    const std::string name = relative(path, root).string();
    if (name.find("contract_test.cpp") != std::string::npos) continue;  // plants wrong ones
    const std::string text = page(name);
    cited += citations(text).size();
    EXPECT_THAT(unresolved(text, contract), IsEmpty()) << "in " << name;
  }
  EXPECT_GT(cited, 200u) << "of which most are in comments";
}

}  // namespace
}  // namespace racebeam
