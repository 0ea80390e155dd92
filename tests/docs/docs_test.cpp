// README.md and docs/: their tables are the program's, and their links lead somewhere.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "sc/beam/engine.h"
#include "sc/beam/knobs.h"
#include "tb/base/text_pattern.h"
#include "tb/explain/figures.h"
#include "tb/explain/glossary.h"
#include "tb/golden/golden_work.h"
#include "tb/picture/picture_format.h"
#include "tb/scene/scene_kinds.h"
#include "tb/scene/scene_reader.h"
#include "tb/sweep/figures.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// All pages, by their path in the project.
std::vector<std::string> pages() {
  std::vector<std::string> all = {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  for (const auto& entry : std::filesystem::directory_iterator(RACEBEAM_SOURCE_DIR "/docs"))
    if (entry.path().extension() == ".md")
      all.push_back("docs/" + entry.path().filename().string());
  return all;
}

/// What GitHub makes of a heading: lower case, without signs, with dashes for blanks.
std::string anchor(const std::string& heading) {
  std::string name;
  for (const char letter : heading)
    if (letter == ' ' || letter == '-') name += '-';
    else if (std::isalnum(static_cast<unsigned char>(letter)) || letter == '_')
      name += static_cast<char>(std::tolower(letter));
  return name;
}

bool has_heading(const std::string& text, const std::string& name) {
  static const TextPattern heading("(?:^|\n)#+ ([^\n]*)");
  for (const TextPattern::Groups& found : heading.all(text))
    if (anchor(found[1]) == name) return true;
  return false;
}

/// Links of a page to files or headings that are not there.
std::vector<std::string> broken_links(const std::string& path, const std::string& text) {
  static const TextPattern link("\\]\\(([^)\\s]+)\\)");
  const std::filesystem::path root = RACEBEAM_SOURCE_DIR;
  std::vector<std::string> broken;
  for (const TextPattern::Groups& one : link.all(text)) {
    const std::string& target = one[1];
    if (target.find("://") != std::string::npos) continue;
    const auto hash = target.find('#');
    const std::string file = target.substr(0, hash);
    const auto place = file.empty() ? root / path : (root / path).parent_path() / file;
    const bool found = exists(place) &&
                       (hash == std::string::npos ||
                        has_heading(page(relative(place, root).string()), target.substr(hash + 1)));
    if (!found) broken.push_back(target);
  }
  return broken;
}

TEST(Docs, EveryLinkLeadsToAFileOrAHeading) {
  for (const std::string& path : pages())
    EXPECT_THAT(broken_links(path, page(path)), IsEmpty()) << "in " << path;
}

TEST(Docs, ABrokenLinkIsSeen) {
  EXPECT_THAT(broken_links("docs/x.md", "[a](contract.md#9-subdivider) [b](../README.md)"),
              IsEmpty());
  EXPECT_THAT(broken_links("docs/x.md", "[a](contract.md#9-nothing) [b](README.md) ![c](c.svg)"),
              testing::ElementsAre("contract.md#9-nothing", "README.md", "c.svg"));
}

TEST(Docs, TheReadmeHasAtMost200Lines) {
  const std::string text = page("README.md");
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 200);
}

TEST(Docs, TheReadmeExplainsEveryWordOfTheGlossary) {
  const auto rows = table_rows(page("README.md"), "### Words");
  EXPECT_EQ(rows.size(), glossary().size());
  for (const Word& word : glossary())
    EXPECT_THAT(page("README.md"), HasSubstr("\n" + word_row(word) + "\n"));
}

TEST(Docs, TheWordsOfTheGlossaryAreDifferent) {
  for (const Word& word : glossary()) {
    EXPECT_EQ(&glossary_word(word.word), &word);
    EXPECT_LE(std::string(word.meaning).size(), 80u) << word.word << " fits a terminal";
  }
  EXPECT_STREQ(glossary_word("intervals").word, "interval");
  EXPECT_STREQ(glossary_word("fifo").word, "FIFO");
}

TEST(Docs, EveryFigureIsShown) {
  std::string text;
  for (const std::string& path : pages()) text += page(path);
  for (const Figure& figure : figures())
    EXPECT_THAT(text, HasSubstr("](figures/" + std::string(figure.name) + ".svg)"));
}

TEST(Docs, ListsEveryKeyOfSceneFiles) {
  const std::string text = page("docs/scenes.md");
  for (const FileKey& key : scene_keys()) EXPECT_THAT(text, HasSubstr("\n" + key_row(key) + "\n"));
}

/// The engines that have a page of their own.
std::vector<const SceneKind*> other_engines() {
  std::vector<const SceneKind*> kinds;
  for (const SceneKind& kind : scene_kinds())
    if (&kind.engine != &beam_engine()) kinds.push_back(&kind);
  return kinds;
}

std::string page_of(const SceneKind& kind) {
  return "docs/" + std::string(kind.engine.name) + ".md";
}

TEST(Docs, ListAllOfTheOtherEngines) {
  for (const SceneKind* kind : other_engines()) {
    const std::string text = page(page_of(*kind));
    for (const FileKey& key : kind->keys) EXPECT_THAT(text, HasSubstr("\n" + key_row(key) + "\n"));
    for (const knob_row& row : kind->engine.knobs)
      EXPECT_THAT(text,
                  HasSubstr("\n| `" + std::string(row.name) + "` | " + row.text(row.standard) +
                            " | " + row.range() + " | " + row.meaning + " |\n"));
    for (const counter_info& row : kind->engine.counters)
      EXPECT_THAT(text, HasSubstr("`" + std::string(row.name) + "`"));
    for (const histogram_info& row : kind->engine.histograms)
      EXPECT_THAT(text, HasSubstr("`" + std::string(row.name) + "`"));
  }
}

TEST(Docs, TheExamplesOfSceneFilesAreGood) {
  for (const SceneKind* kind : other_engines()) {
    const std::string text = page(page_of(*kind));
    const auto begin = text.find("```toml\n") + 8;
    const AnySceneResult result =
        read_any_scene(text.substr(begin, text.find("```", begin) - begin), "example");
    ASSERT_TRUE(result.scene) << result.faults.text(page_of(*kind));
    EXPECT_EQ(&result.scene->engine(), &kind->engine);
  }
}

TEST(Docs, ListsEveryPictureFormat) {
  const auto rows = table_rows(page("docs/render.md"), "## Picture formats");
  EXPECT_EQ(rows.size(), picture_formats().size());
  for (const PictureFormat& format : picture_formats())
    EXPECT_THAT(page("docs/render.md"),
                HasSubstr("\n| `" + std::string(format.name) + "` | " + format.note + " |\n"));
}

TEST(Docs, ListsEveryCounter) {
  const std::string text = page("docs/render.md");
  const auto expect_listed = [&](const auto& rows) {
    for (const auto& row : rows)
      EXPECT_THAT(text, HasSubstr("`" + std::string(row.name) + "`")) << row.name;
  };
  const engine& beam = beam_engine();
  expect_listed(beam.counters);
  expect_listed(beam.histograms);
  expect_listed(beam.lines);
  for (const auto tracer : {GoldenTracer::Trace2, GoldenTracer::Trace3, GoldenTracer::Trace4}) {
    const GoldenTables tables = golden_tables(tracer);
    expect_listed(tables.counters);
    expect_listed(tables.histograms);
    expect_listed(tables.lines);
  }
}

TEST(Docs, ExampleSceneIsGood) {
  const std::string text = page("docs/scenes.md");
  const auto begin = text.find("```toml\n") + 8;
  const auto end = text.find("```", begin);
  ASSERT_LT(begin, end);
  const SceneResult result = read_scene(text.substr(begin, end - begin), "example");
  EXPECT_TRUE(result.faults.none()) << result.faults.text("docs/scenes.md");
  EXPECT_EQ(result.scene.rooms.size(), 22u);
}

TEST(Docs, ListsEveryFigureOfSweeps) {
  const std::string text = page("docs/explore.md");
  for (const PointFigure& figure : figure_table())
    EXPECT_THAT(text, HasSubstr("\n" + figure_row(figure) + "\n"));
}

TEST(Docs, ListsEveryKnobWithItsDefaultAndRange) {
  const std::string text = page("docs/explore.md");
  const knobs defaults;
  for (const auto& row : knob_table())
    EXPECT_THAT(text,
                HasSubstr("| `" + std::string(row.name) + "` | " + row.text(defaults.*row.member) +
                          " | " + row.range() + " | " + row.meaning + " |"));
}

/// What a page says where the pattern matches, "ten", "the eighth", "6,024"; -1 if it does not.
int number_in(const std::string& text, const std::string& pattern) {
  static const std::map<std::string, int> words = {
      {"two", 2}, {"four", 4}, {"eighth", 8}, {"ten", 10}};
  const auto found = TextPattern(pattern).all(text);
  if (found.empty()) return -1;
  std::string word = found.front()[1];
  if (const auto at = words.find(word); at != words.end()) return at->second;
  word.erase(std::remove(word.begin(), word.end(), ','), word.end());
  const std::vector<int> all = numbers(word);
  return all.empty() ? -1 : all.front();
}

TEST(Docs, ANumberThatIsNotThereIsSeen) {
  EXPECT_EQ(number_in("a stack of ten", "stack of (\\w+)"), 10);
  EXPECT_EQ(number_in("6,024 cells", "([\\d,]+) cells"), 6024);
  EXPECT_EQ(number_in("a stack of stones", "stack of (\\w+)"), -1);
  EXPECT_EQ(number_in("a heap of ten", "stack of (\\w+)"), -1);
}

TEST(Docs, TheReadmesSizesOfTheChipAreItsKnobs) {
  const std::string text = page("README.md");
  const knobs k;
  EXPECT_EQ(number_in(text, "wants a pixel every\\s+(\\w+)\\s+clocks"), k.clocks_per_pixel);
  EXPECT_EQ(number_in(text, "waits on a stack of\\s+(\\w+)"), k.interval_stack_depth);
  EXPECT_EQ(number_in(text, "A stack of\\s+(\\w+)\\s+overflows"), k.interval_stack_depth);
  EXPECT_EQ(number_in(text, "a queue of\\s+(\\w+)"), k.fifo_entries);
  EXPECT_EQ(number_in(text, "behind the\\s+(\\w+)\\s+everything is a wall"), k.max_room_depth);
}

// docs/chip.md has what yosys counts, and scripts/area --check compares it.
TEST(Docs, FlipFlopsAndCellsAreTheSameOnAllPages) {
  const std::string chip = page("docs/chip.md"), claims = page("docs/claims.md"),
                    contract = page("docs/contract.md");
  const int original = number_in(chip, "the taped-out chip has (\\d+) flip-flops");
  EXPECT_GT(original, 0);
  EXPECT_EQ(number_in(page("README.md"), "no frame buffer and\\s+(\\d+)\\s+flip-flops"), original);
  EXPECT_EQ(number_in(contract, "The original has (\\d+) in all"), original);
  EXPECT_EQ(number_in(claims, "standard cells, (\\d+) of them flip-flops"), original);
  EXPECT_EQ(number_in(claims, "The design has ([\\d,]+) standard cells"),
            number_in(chip, "its cells, ([\\d,]+), are counted"));

  int flip_flops = 0, cells = 0;
  for (const auto& row : table_rows("\n" + chip, "# The chip"))
    if (row.size() == 4 && row[0][0] == '[' && !numbers(row[2]).empty()) {
      flip_flops += numbers(row[2]).at(0);
      cells += numbers(row[3]).at(0);
    }
  const std::string all = "\\*\\*all\\*\\*[^\n]* \\| (\\d+) \\| ",
                    sound = "\\[pwm_sound\\][^\n]* \\| (\\d+) \\| ";
  EXPECT_EQ(number_in(chip, all), flip_flops);
  EXPECT_EQ(number_in(contract, "The original has \\d+ in all, ours (\\d+)"), flip_flops);
  EXPECT_EQ(number_in(claims, "flip-flops without sound \\|[^\n]*\\| ([\\d,]+) \\| holds"),
            flip_flops - number_in(chip, sound));
  EXPECT_EQ(number_in(claims, "generic cells without sound \\|[^\n]*\\| ([\\d,]+) \\| holds"),
            cells - number_in(chip, "\\[pwm_sound\\][^\n]* \\| (\\d+) \\|\n"));
}

}  // namespace
}  // namespace racebeam
