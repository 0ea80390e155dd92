// racebeam claims: measured once, kept, and turned by a wrong chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <sstream>

#include "tests/cli/sweep_bench.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class CliClaims : public CliSweepTest {
 protected:
  Words words(const Words& more) const {
    Words all = {"claims", "-o", "out", "--jobs", "2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  /// Verdicts by row; the exit code is 1 if one of them does not hold.
  std::map<std::string, std::string> verdicts(const Words& more) {
    Words all = words(more);
    all.push_back("--json");
    Program run(folder.path(), all);
    const int code = run.wait();
    std::map<std::string, std::string> found;
    const Json json = Json::parse(run.out());
    bool differs = false;
    for (const Json& claim : json.at("claims").elements()) {
      const std::string verdict = claim.at("verdict").get<std::string>();
      found[claim.at("id").get<std::string>()] = verdict;
      differs = differs || verdict == "does not hold";
    }
    EXPECT_EQ(code, differs ? 1 : 0) << run.err();
    return found;
  }
};
using LongCliClaims = CliClaims;

TEST_F(CliClaims, TheSameCommandAgainMeasuresNothingAndSaysTheSame) {
  const Words few = words({"--only", "35", "--only", "22", "--frames", "2"});
  Program first(folder.path(), few);
  EXPECT_THAT(first.wait(), testing::AnyOf(0, 1)) << first.err();
  const auto runs = [this](const std::string& scene) {
    return query(store("out/" + scene), "SELECT count(*) FROM run").at(0);
  };
  EXPECT_EQ(runs("grid"), "1");
  Program again(folder.path(), few);
  again.wait();
  EXPECT_EQ(again.out(), first.out());
  EXPECT_EQ(runs("grid"), "1");
  EXPECT_EQ(runs("demo"), "1");
  expect({"sweep", "check", "out/demo", "--sample", "2"}, 0);
}

TEST_F(CliClaims, ARowThatIsNotThereIsRefused) {
  EXPECT_THAT(expect(words({"--only", "S0-6"}), 2), HasSubstr("there is no claim 'S0-6'"));
  EXPECT_THAT(expect(words({"--frames", "0"}), 2), HasSubstr("1..16383, or all"));
  EXPECT_THAT(expect(words({"--set", "dr_bit=3"}), 2), HasSubstr("dr_bits"));
}

TEST_F(CliClaims, MarkdownHasARowForEachCheck) {
  expect(words({"--only", "66", "--frames", "2", "--markdown", "c.md"}), 0);
  const std::string text = read_file(folder / "c.md");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 + 7);
  EXPECT_THAT(text, HasSubstr("| S0-65, 66 |"));
}

// A chip that was built otherwise turns the row that is about that.
TEST_F(CliClaims, ACutThatKeepsEverythingTurnsTheProduct) {
  EXPECT_EQ(verdicts({"--only", "94", "--frames", "2"}).at("S0-30, 31, 94"), "holds");
  EXPECT_EQ(verdicts({"--only", "94", "--frames", "2", "--set", "partial_products_cut=0"})
                .at("S0-30, 31, 94"),
            "does not hold");
}

// The chip's own verdicts are pinned: all that are not here hold. 64 frames of each chip, golden
// tracers and syntheses: 80 s of processor time.
TEST_F(LongCliClaims, VerdictsOf64FramesArePinned) {
  const auto chip = verdicts({"--frames", "64"});
  std::map<std::string, std::string> others;
  for (const auto& [id, verdict] : chip)
    if (verdict != "holds") others[id] = verdict;
  EXPECT_EQ(others, (std::map<std::string, std::string>{{"S0-09", "holds in kind"},
                                                        {"S0-111, 115", "does not hold"},
                                                        {"S0-22, 44", "holds in kind"},
                                                        {"S0-49", "holds in kind"},
                                                        {"S0-51", "holds in kind"},
                                                        {"S0-61", "holds in kind"},
                                                        {"S0-78", "holds in kind"},
                                                        {"S0-87", "holds in kind"},
                                                        {"S0-93", "does not hold"}}));
}

/// "S0-62, 63": the number by which --only finds the row.
std::string number_of(const std::string& id) { return id.substr(3, id.find(',') - 3); }

/// The rows that a cell of the table names, "S0-62; S0-77"; "none" names none.
std::vector<std::string> rows_in(const std::string& cell) {
  std::vector<std::string> rows;
  std::istringstream in(cell == "none" ? "" : cell);
  for (std::string row; std::getline(in >> std::ws, row, ';');) rows.push_back(row);
  return rows;
}

// The museum of wrong knobs is the table of docs/claims.md: knobs, rows that do not hold, rows that
// hold in kind, rows that stay as they are. Three minutes of processor time.
TEST_F(LongCliClaims, WrongKnobsTurnTheRowsOfTheTableAndNoOther) {
  const auto table = table_rows(page("docs/claims.md"), "## Wrong knobs");
  ASSERT_GE(table.size(), 7u);
  Words asked = {"--frames", "64"};
  std::set<std::string> all;
  for (const auto& row : table)
    for (const std::size_t column : {2, 3, 4})
      for (const std::string& id : rows_in(row.at(column)))
        if (all.insert(id).second) asked.insert(asked.end(), {"--only", number_of(id)});
  const auto chip = verdicts(asked);
  for (const auto& row : table) {
    SCOPED_TRACE(row[0]);
    Words wrong = {"--frames", "64", "--set", row[0].substr(1, row[0].size() - 2)};
    std::map<std::string, std::string> expected;
    for (const auto& [column, verdict] : std::vector<std::pair<std::size_t, std::string>>{
             {2, "does not hold"}, {3, "holds in kind"}, {4, ""}})
      for (const std::string& id : rows_in(row.at(column))) {
        wrong.insert(wrong.end(), {"--only", number_of(id)});
        expected[id] = verdict.empty() ? chip.at(id) : verdict;
        EXPECT_TRUE(verdict.empty() || verdict != chip.at(id)) << id << " does not turn";
      }
    EXPECT_EQ(verdicts(wrong), expected);
  }
}

}  // namespace
}  // namespace racebeam
