// racebeam sweep with a store of another model or program, of a newer version, damaged; and what it
// exports of a good one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr const char* Model = "0123456789abcdef0123456789abcdef";

class CliSweepStore : public CliSweepTest {
 protected:
  CliSweepStore() {
    write(TinySweep);
    expect_run("out");
  }
  std::string all_frames() const {
    std::string text;
    for (const std::string& row :
         query(store("out"),
               "SELECT model || ' ' || point || ' ' || frame || ' ' || digest || ' ' "
               "|| decisions FROM frame ORDER BY 1"))
      text += row + "\n";
    return text;
  }
  /// The same model in another file: another program.
  Program::Setting other_program() const {
    const std::string file = folder / "racebeam";
    if (!fs::exists(file)) {
      fs::copy_file(RACEBEAM_BINARY, file);
      std::ofstream(file, std::ios::app | std::ios::binary) << "another one";
    }
    Program::Setting setting;
    setting.program = file;
    return setting;
  }
  void expect_left_alone(const std::string& bytes) const {
    EXPECT_EQ(read_file(store("out")), bytes);
  }
};

TEST_F(CliSweepStore, AnotherModelIsRefusedWithBothHashesUntilItMayMeasureAnew) {
  const std::string own = query(store("out"), "SELECT hash FROM model")[0];
  query(store("out"), std::string("UPDATE model SET hash = '") + Model + "'");
  const std::string before = all_frames();
  EXPECT_THAT(expect(run_words("out"), 2),
              AllOf(HasSubstr(std::string("out has results of another model, ") + Model),
                    HasSubstr("this program's is " + own), HasSubstr("--fresh")));
  EXPECT_EQ(all_frames(), before);
  expect_run("out", {"--fresh"});
  EXPECT_EQ(query(store("out"), "SELECT hash FROM model ORDER BY id"),
            (std::vector<std::string>{Model, own}));
  EXPECT_THAT(all_frames(), HasSubstr(before)) << "the old results are kept";
  EXPECT_EQ(query(store("out"), "SELECT count(*) FROM frame")[0], "16");
  EXPECT_EQ(read_csv(frames_of("out")).size(), 8u) << "one model at a time";
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr("8 frames are stored"));
}

TEST_F(CliSweepStore, ResultsOfAnotherModelAreNotReused) {
  const std::string own = query(store("out"), "SELECT hash FROM model")[0];
  query(store("out"), std::string("UPDATE model SET hash = '") + Model + "'");
  EXPECT_THAT(expect(run_words("new", {"--reuse", "out"}), 2),
              AllOf(HasSubstr("out has results of the model " + std::string(Model)),
                    HasSubstr("this program is " + own)));
}

TEST_F(CliSweepStore, AnotherProgramOfTheSameModelGoesOn) {
  const std::string before = frames_of("out");
  EXPECT_THAT(expect(run_words("out"), 0, other_program()), Not(HasSubstr("differently")));
  EXPECT_EQ(frames_of("out"), before);
}

// In the store's first, middle or last frame: those are repeated.
TEST_F(CliSweepStore, AnotherProgramThatCountsDifferentlyIsRefused) {
  query(store("out"), "UPDATE frame SET decisions = decisions + 1");
  const std::string before = all_frames();
  const auto refusal =
      AllOf(HasSubstr("does not repeat: decisions was "), HasSubstr("counts differently"));
  for (int start = 0; start < 2; ++start)
    EXPECT_THAT(expect(run_words("out"), 1, other_program()), refusal);
  write(std::string(TinySweep) + "[[point]]\nname = \"more\"\nknobs = { dr_bits = 9 }\n");
  EXPECT_THAT(expect(run_words("out"), 1, other_program()), refusal);
  EXPECT_EQ(all_frames(), before);
  EXPECT_THAT(expect({"sweep", "status", "out"}, 0), HasSubstr("differed from themselves"));
}

TEST_F(CliSweepStore, NewerVersionIsNamedAndLeftAlone) {
  query(store("out"), "UPDATE meta SET value = '99' WHERE key = 'version'");
  const std::string bytes = read_file(store("out"));
  for (const Words& words :
       {run_words("out"), run_words("new", {"--reuse", "out"}), Words{"sweep", "status", "out"},
        Words{"sweep", "check", "out"}, Words{"sweep", "export", "out", "--csv", "x.csv"}})
    EXPECT_THAT(expect(words, 2), HasSubstr("out/sweep.sqlite is of a newer racebeam: version 99"));
  expect_left_alone(bytes);
}

TEST_F(CliSweepStore, DamageIsNamedAndNothingIsOverwritten) {
  const std::string sound = read_file(store("out"));
  for (const std::string& bytes :
       {sound.substr(0, sound.size() / 2), std::string("not a database, but a letter, dear"),
        std::string(sound.size(), '\xa5')}) {
    std::ofstream(store("out"), std::ios::binary) << bytes;
    for (const Words& words : {run_words("out"), Words{"sweep", "status", "out"},
                               Words{"sweep", "export", "out", "--frames", "x.csv"}})
      EXPECT_THAT(expect(words, 2), AllOf(HasSubstr("out/sweep.sqlite is damaged: "),
                                          HasSubstr("racebeam sweep check out tells what can be "
                                                    "read; nothing was overwritten")));
    expect_left_alone(bytes);
    EXPECT_THAT(expect({"sweep", "check", "out"}, 1), HasSubstr("damaged"));
    expect_left_alone(bytes);
  }
}

TEST_F(CliSweepStore, CheckTellsWhatCanBeReadBesideADamagedTable) {
  const auto page = query(store("out"), "SELECT rootpage FROM sqlite_schema WHERE name = 'frame'");
  std::string bytes = read_file(store("out"));
  bytes.replace((std::stoul(page[0]) - 1) * 4096, 4096, std::string(4096, '\xa5'));
  std::ofstream(store("out"), std::ios::binary) << bytes;
  EXPECT_THAT(expect({"sweep", "check", "out"}, 1),
              AllOf(HasSubstr("table frame cannot be read to its end"),
                    HasSubstr("point: 2 rows can be read")));
  write(std::string(TinySweep) + "[[point]]\nname = \"more\"\nknobs = { dr_bits = 9 }\n");
  EXPECT_THAT(expect(run_words("out"), 2), HasSubstr("out/sweep.sqlite is damaged: "));
  const std::string left = read_file(store("out"));
  EXPECT_EQ(left.substr(100), bytes.substr(100)) << "behind the head, which says who has opened it";
}

TEST_F(CliSweepStore, CsvAndJsonReadBackAsTheStoreHasThem) {
  expect({"sweep", "export", "out", "--csv", "p.csv", "--frames", "f.csv", "--json", "a.json"}, 0);
  const auto json = read_json(folder / "a.json");
  const auto rows = read_csv(read_file(folder / "f.csv"));
  const std::vector<Json> columns = json.at("models").at(0).at("columns").elements();
  EXPECT_GT(columns.size(), 40u);
  const std::string order = " FROM frame ORDER BY scene, point, frame";
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const auto name = columns[column].get<std::string>();
    const bool picture = name == "picture";
    const auto stored =
        query(store("out"),
              (picture ? "SELECT printf('%016x', picture)" : "SELECT \"" + name + "\"") + order);
    ASSERT_EQ(stored.size(), rows.size());
    std::size_t row = 0;
    for (const Json& result : json.at("results").elements())
      for (const Json& frame : result.at("frames").elements()) {
        const Json value = frame.at(column + 3);
        EXPECT_EQ(picture ? value.get<std::string>() : value.dump(), stored.at(row));
        EXPECT_EQ(rows[row].at(name), stored.at(row)) << name;
        ++row;
      }
    EXPECT_EQ(row, stored.size());
    if (picture) continue;
    const auto means = query(store("out"), "SELECT avg(\"" + name +
                                               "\") FROM frame GROUP BY scene, point ORDER BY "
                                               "scene, point");
    const auto points = read_csv(read_file(folder / "p.csv"));
    ASSERT_EQ(points.size(), means.size());
    for (std::size_t point = 0; point < points.size(); ++point)
      EXPECT_DOUBLE_EQ(std::stod(points[point].at(name)), std::stod(means[point])) << name;
  }
  const auto digests = query(store("out"), "SELECT printf('%016x', digest)" + order);
  const auto frames = query(store("out"), "SELECT frame" + order);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(rows[row].at("digest"), digests[row]);
    EXPECT_EQ(rows[row].at("frame"), frames[row]);
  }
}

}  // namespace
}  // namespace racebeam
