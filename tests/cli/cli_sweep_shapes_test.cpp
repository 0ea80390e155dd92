// Sweeps of all shapes: whatever the file asks for, each frame has the figures that render gives it
// with the same knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

namespace fs = std::filesystem;
using Row = std::map<std::string, std::string>;

class CliSweepShapes : public CliSweepTest {
 protected:
  /// The part of a line's figures, such as "busy_clocks.never", in the statistics of a frame, if
  /// they say it; of no line at all they say null, and the row of the frame nothing.
  static std::optional<std::string> part_of(const Json& line, const std::string& part) {
    for (const std::string& name :
         part == "never" ? Words{"lines_not_done", "lines_without"} : Words{part})
      if (line.contains(name)) return line.at(name).is_null() ? "" : line.at(name).dump();
    return {};
  }

  /// Runs the sweep and renders all that it has measured. The points' names by scene.
  std::map<std::string, std::set<std::string>> compare(const std::string& text) const {
    write(text);
    expect_run("out");
    expect({"sweep", "export", "out", "--csv", "p.csv", "--frames", "f.csv"}, 0);
    const auto frames = read_csv(read_file(folder / "f.csv"));
    std::map<std::string, std::set<std::string>> points;
    for (const Row& point : read_csv(read_file(folder / "p.csv"))) {
      points[point.at("scene")].insert(point.at("point"));
      std::vector<Row> rows;
      std::string list;
      for (const Row& frame : frames)
        if (frame.at("point") == point.at("point") && frame.at("scene") == point.at("scene")) {
          list += (list.empty() ? "" : ",") + frame.at("frame");
          rows.push_back(frame);
        }
      Words words = {"render", point.at("scene"), "--at", list, "--stats", "r.json"};
      for (const std::string& knob : knobs_) {
        words.push_back("--set");
        words.push_back(knob + "=" + point.at(knob));
      }
      expect(words, 0);
      const auto json = read_json(folder / "r.json");
      for (std::size_t i = 0; i < rows.size(); ++i) compare(rows[i], json.at("frames").at(i));
    }
    return points;
  }

 private:
  void compare(const Row& row, const Json& frame) const {
    static const std::set<std::string> own = {
        "point", "scene", "kind", "digest", "error_pixels", "visible_error_pixels", "picture"};
    for (const auto& [name, value] : row) {
      if (own.count(name)) continue;
      const auto dot = name.find('.');
      const std::optional<std::string> rendered =
          dot == std::string::npos ? frame.at(name).dump()
                                   : part_of(frame.at(name.substr(0, dot)), name.substr(dot + 1));
      if (!rendered) continue;  // render does not say it of this line
      EXPECT_EQ(value, *rendered) << name << " of frame " << row.at("frame") << " of "
                                  << row.at("point") << " on " << row.at("scene");
    }
  }
  std::vector<std::string> knob_names() const {
    Program list(folder.path(), {"knobs", "--json"});
    std::vector<std::string> names;
    const auto json = list.json();
    for (const Json& knob : json.at("knobs").elements())
      names.push_back(knob.at("name").get<std::string>());
    return names;
  }

  const std::vector<std::string> knobs_ = knob_names();
};

TEST_F(CliSweepShapes, OneSceneFileWithQuotesAndSigns) {
  fs::create_directory(folder / "sub dir, é");
  expect({"scene", "new", "sub dir, é/my \"scene\".toml"}, 0);
  const auto points = compare(
      "name = \"a \\\"house\\\" 🏠, 'b'\"\n"
      "scenes = [\"sub dir, é/my \\\"scene\\\".toml\"]\n"
      "[frames]\nsample = 5\nguard = 2\nskip = [\"shot 0\"]\n"
      "[knobs]\n"
      "fifo_entries = { from = 3, to = 11, step = 4 }\nbisection = [\"pow2\", \"midpoint\"]\n"
      "where = \"fifo_entries != 7 || bisection == 0\"\n"
      "[[point]]\nname = \"no \\\"limits\\\", 🚀\"\n"
      "knobs = { interval_stack_depth = 64, fifo_entries = 64, hurry_threshold = -1 }\n"
      "[[point]]\nname = \"p\"\nknobs = {}\n"
      "[base]\nname = \"my base,1\"\nknobs = { speed = 3 }\n");
  EXPECT_EQ(points.begin()->second,
            (std::set<std::string>{"my base,1", "no \"limits\", 🚀", "p1", "p2", "p3", "p4", "p5"}));
}

TEST_F(CliSweepShapes, OneByOneOnTwoScenesAgainstTheBase) {
  expect({"scene", "new", "my.toml"}, 0);
  const auto points = compare(
      "scenes = [\"my.toml\", \"demo\"]\n"
      "[frames]\nsample = 3\nguard = 0\nskip = [\"*ray*\", \"t*\"]\n"
      "[search]\nmethod = \"one-by-one\"\nseed = 77\n"
      "[knobs]\nstepping = [\"jumper\", \"fraction\"]\ndr_bits = [8, 13]\n"
      "camera_cosine = [\"exact\"]\nskip_shared_edges = [\"table\"]\ninterlace = \"off\"\n"
      "[measure]\nreference = \"base\"\n");
  EXPECT_EQ(points.at("demo"), points.at("my.toml"));
  for (const Row& point : read_csv(read_file(folder / "p.csv")))
    EXPECT_EQ(point.at("interlace"), point.at("point") == "chip" ? "on" : "off")
        << "one value: all points of the search have it";
}

TEST_F(CliSweepShapes, SobolWithLimitsAndRacing) {
  compare(
      "frames = { sample = 17, guard = 0, until = { busy = \"20 %\" }, most = 30, "
      "skip = [\"[!t]*\", \"tunnel\"] }\n"
      "search = { method = \"sobol\", points = 6, seed = 5 }\n"
      "goals = { picture_error = \"min\", starved = { most = \"9 %\" }, \"busy.max\" = \"min\" }\n"
      "[knobs]\ninterval_stack_depth = [1, 2, 64]\nclocks_per_pixel = { from = 1, to = 8 }\n"
      "hurry_threshold = [-1, 0, 639]\ncorner_bits = [10, 12]\nmax_room_depth = [1, 8, 14]\n"
      "face_stack_depth = [2, 9, 15]\nhead_start = [0, 320]\n"
      "where = \"interval_stack_depth * 17 + hurry_threshold <= 1000 && clocks_per_pixel < 7\"\n"
      "[measure]\nreference = \"trace4\"\n");
}

TEST_F(CliSweepShapes, PointsWithNamesAloneAndEveryFrame) {
  std::string scene = folder / "my.toml";
  expect({"scene", "new", "my.toml"}, 0);
  std::string text = read_file(scene);
  text.replace(text.find("frames = 600"), 12, "frames = 12 ");
  text.erase(text.find("[[shot]]"));
  std::ofstream(scene) << text;
  const auto points = compare(
      "scenes = [\"my.toml\"]\n[frames]\nsample = \"all\"\nguard = 4\n"
      "[[point]]\nname = \"a,b c\"\nknobs.head_start = 320\n"
      "[[point]]\nname = \"same as a,b c\"\nknobs.head_start = 320\n"
      "[[point]]\nname = \"fractions\"\n"
      "knobs = { stepping = \"fraction\", stepping_fraction_bits = 4, ddr_fraction_bits = 2 }\n"
      "[[point]]\nname = \"'; DROP TABLE frame; --\"\n"
      "knobs = { fifo_merge = \"off\", corner_rounding = \"on\", bisection = \"floor\" }\n");
  EXPECT_EQ(points.at("my.toml").size(), 4u);
  EXPECT_EQ(query(store("out"), "SELECT count(*) FROM frame")[0], "48");
}

TEST_F(CliSweepShapes, FramesInWhichNoLineIsDone) {
  compare(
      "[frames]\nsample = 2\nguard = 0\n"
      "skip = [\"pillars*\", \"narrow*\", \"portals*\", \"*and*\", \"tunnel\", \"heights\", "
      "\"*twist*\", \"*sweep*\"]\n[knobs]\nhead_start = 320\n");
  const auto frames = read_csv(read_file(folder / "f.csv"));
  ASSERT_EQ(frames.size(), 4u);
  for (const Row& frame : frames) {
    EXPECT_EQ(frame.at("done_clock.never"), "480");
    EXPECT_EQ(frame.at("done_clock.max"), "");
    EXPECT_EQ(frame.at("done_clock.sum"), "0");
  }
  for (const Row& point : read_csv(read_file(folder / "p.csv")))
    EXPECT_EQ(point.at("done_clock.max"), "");
  expect({"sweep", "export", "out", "--json", "all.json"}, 0);
  const auto all = read_json(folder / "all.json");
  std::size_t place = 3;  // behind frame, kind and digest
  for (const Json& column : all.at("models").at(0).at("columns").elements()) {
    if (column.get<std::string>() == "done_clock.max") break;
    ++place;
  }
  EXPECT_TRUE(all.at("results").at(0).at("frames").at(0).at(place).is_null());
}

}  // namespace
}  // namespace racebeam
