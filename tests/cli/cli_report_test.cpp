// racebeam report: the page of a sweep that was run has the sweep's own numbers and pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sweep_bench.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

class CliReport : public CliSweepTest {
 protected:
  std::string report(const Words& more = {}) const {
    Words words = {"report", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return expect(words, 0);
  }
  std::string page() const { return read_file(folder / "out/report.html"); }
  static Json data_of(const std::string& page) {
    const std::string begin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t at = page.find(begin) + begin.size();
    return Json::parse(page.substr(at, page.find("</script>", at) - at));
  }
};

TEST_F(CliReport, NumbersAreThoseOfFiguresCsv) {
  write(SmallSweep);
  expect_run("out");
  EXPECT_THAT(report(), HasSubstr("out/report.html: 4 points, "));
  const Json data = data_of(page());
  std::map<std::string, Json> figures;
  for (const Json& figure : data.at("figures").elements())
    figures[figure.at("name").get<std::string>()] = figure;
  std::map<std::string, std::size_t> places;
  for (const Json& name : data.at("points").at("name").elements())
    places.emplace(name.get<std::string>(), places.size());
  const auto rows = read_csv(read_file(folder / "out/figures.csv"));
  EXPECT_EQ(rows.size(), figures.size() * places.size()) << "no more, no less";
  for (const auto& row : rows) {
    const Json& figure = figures.at(row.at("figure"));
    for (const auto& [column, key] :
         std::map<std::string, std::string>{{"value", "value"},
                                            {"half_width", "half"},
                                            {"change", "change"},
                                            {"change_half_width", "change_half"}}) {
      if (!figure.contains(key)) {
        EXPECT_EQ(row.at(column), "") << row.at("figure") << " " << column;
        continue;
      }
      const Json cell = figure.at(key).at(places.at(row.at("point")));
      if (row.at(column).empty()) EXPECT_TRUE(cell.is_null());
      else EXPECT_EQ(cell.get<double>(), std::stod(row.at(column))) << row.at("figure");
    }
  }
}

TEST_F(CliReport, TheCommandOfAPointDrawsItsPicture) {
  write(std::string(TinySweep) + "pictures = [7223]\n");
  expect_run("out");
  report({"-o", "page.html"});
  const std::string page = read_file(folder / "page.html");
  const std::size_t at = page.find("<code>racebeam render demo --at 7223 --set fifo_entries=4 ");
  ASSERT_NE(at, std::string::npos);
  const std::string command = page.substr(at + 6, page.find("</code>", at) - at - 6);
  EXPECT_THAT(command, HasSubstr(" -o p1.png"));
  std::istringstream words(command.substr(std::string("racebeam ").size()));
  expect(Words(std::istream_iterator<std::string>(words), {}), 0);
  // The page has the picture that the sweep has kept; the command must draw the same pixels
  const auto index = read_csv(read_file(folder / "out/pictures/index.csv"));
  EXPECT_EQ(index.at(1).at("point"), "p1");
  EXPECT_EQ(read_file(folder / "p1.png"),
            read_file(folder / ("out/pictures/" + index[1].at("file"))));
  EXPECT_THAT(page, HasSubstr("alt=\"frame 7223 of demo as p1 draws it\""));
}

TEST_F(CliReport, ReadsASweepThatIsBeingMeasured) {
  write(SmallSweep);
  Program run(folder.path(), run_words("out"));
  while (run.runs() && (!std::filesystem::exists(folder / "out/status.json") ||
                        !std::filesystem::exists(store("out"))))
    usleep(1000);
  if (run.runs()) {
    report();
    EXPECT_THAT(page(), HasSubstr("id=\"points\""));
  }
  EXPECT_EQ(run.wait(), 0) << run.err();
  report();
  EXPECT_THAT(page(), Not(HasSubstr("has not ended")));
}

TEST_F(CliReport, AFolderWithoutASweepIsRefused) {
  std::filesystem::create_directory(folder / "empty");
  EXPECT_THAT(expect({"report", "empty"}, 2), HasSubstr("empty is not the folder of a sweep"));
  EXPECT_THAT(expect({"report", "nowhere"}, 2), HasSubstr("nowhere"));
  write(TinySweep);
  expect_run("out");
  EXPECT_THAT(expect({"report", "out", "-o", "no/such/page.html"}, 2),
              HasSubstr("cannot write no/such/page.html"));
}

}  // namespace
}  // namespace racebeam
