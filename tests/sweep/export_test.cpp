// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/export.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tb/base/whole_file.h"
#include "tests/support/json.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// A CSV file as RFC 4180 has it.
Rows csv(const std::string& text) {
  Rows rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    if (quoted && text[i] == '"' && text[i + 1] == '"') {
      cell += text[++i];
    } else if (text[i] == '"') {
      quoted = !quoted;
    } else if (quoted || (text[i] != ',' && text[i] != '\n')) {
      cell += text[i];
    } else if (text[i] == ',') {
      rows.back().push_back("");
    } else if (i + 1 < text.size()) {
      rows.push_back({""});
    }
  }
  return rows;
}

/// What SQLite itself says, as text.
Rows query(Store& store, const std::string& sql) {
  Rows rows;
  Statement select(store.database(), sql);
  while (select.next()) {
    rows.emplace_back();
    for (int i = 0; i < select.columns(); ++i)
      rows.back().push_back(select.kind(i) == Statement::Real ? fmt::format("{}", select.real(i))
                                                              : select.text(i));
  }
  return rows;
}

class Export : public testing::Test {
 protected:
  Export() : store(folder / "sweep.sqlite") {
    const auto ids = store.points({{"dr_bits=9\nfifo_entries=4\n", "a \"quoted\", odd\nname"},
                                   {"dr_bits=8\n", ""},
                                   {"dr_bits=7\n", "fails"}});
    for (std::size_t i = 0; i < 2; ++i)
      store.frames.put({1, 1, ids[i]}, {measured(3, 10 + static_cast<int>(i)), measured(11, -8),
                                        measured(12, 1'000'000'007, true)});
    MeasuredFrame frame = measured(7, 5);
    frame.histograms["slack"] = {1, 2};
    frame.causes["starved"] = 4;
    store.frames.put(store.key, {frame});
    store.failures.put({1, 1, ids[2]}, "died: Aborted, twice");
  }
  template <class Write>
  std::string text_of(const Write& write) {
    OutputFile out(folder / "out.txt");
    write(out);
    out.commit();
    return whole_file(folder / "out.txt");
  }

  QuickFolder folder;
  OpenStore store;
};

TEST_F(Export, CsvOfFramesReadsBackAsTheStoreHasIt) {
  const Rows rows = csv(text_of([this](OutputFile& out) { export_frames(store, 1, out); }));
  Rows expected =
      query(store,
            "SELECT coalesce(p.name, p.hash), s.name, frame, kind, printf('%016x', digest), "
            "decisions, \"busy_clocks.max\", printf('%016x', picture) FROM frame f "
            "JOIN point p ON p.id = f.point JOIN scene s ON s.id = f.scene "
            "ORDER BY f.scene, f.point, frame");
  expected.insert(expected.begin(), {"point", "scene", "frame", "kind", "digest", "decisions",
                                     "busy_clocks.max", "picture"});
  EXPECT_EQ(rows, expected);
  EXPECT_EQ(rows.size(), 8u);
}

TEST_F(Export, CsvOfPointsReadsBackAsTheViewHasIt) {
  Rows rows = csv(text_of([this](OutputFile& out) { export_points(store, 1, out); }));
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"point", "scene", "dr_bits", "fifo_entries", "sample_frames",
                                      "guard_frames", "decisions", "busy_clocks.max", "failure"}));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[2][0], "a \"quoted\", odd\nname");
  EXPECT_EQ(rows[2][3] + rows[3][3], "4") << "no such setting: no value";
  EXPECT_EQ(rows[2][5], "1");
  Rows means;
  for (std::size_t i = 1; i < rows.size(); ++i)
    means.push_back({rows[i][1], rows[i][4], rows[i][6], rows[i][7], rows[i][8]});
  EXPECT_EQ(means, query(store,
                         "SELECT scene, frames, decisions, \"busy_clocks.max\", failure "
                         "FROM points"));
}

TEST_F(Export, JsonReadsBackAsTheStoreHasIt) {
  const Json all = Json::parse(text_of([this](OutputFile& out) { export_json(store, out); }));
  EXPECT_EQ(all["schema"], "racebeam-sweep");
  EXPECT_EQ(all["version"], 1);
  EXPECT_EQ(all["models"][0]["columns"], Json::array(Columns));
  EXPECT_EQ(all["points"][1]["setting"], Json({{"dr_bits", "9"}, {"fifo_entries", "4"}}));
  EXPECT_EQ(all["points"][2]["name"], Json());
  std::size_t frames = 0;
  for (const Json& result : all["results"].elements()) {
    const FrameKey key{result["model"].get<int>(), result["scene"].get<int>(),
                       result["point"].get<int>()};
    for (const FrameRow& row : store.frames.read(key)) {
      const Json& frame = result["frames"][frames % 3];
      EXPECT_EQ(frame, Json({row.frame, row.guard ? "guard" : "sample",
                             fmt::format("{:016x}", row.digest), row.values[0], row.values[1],
                             fmt::format("{:016x}", static_cast<std::uint64_t>(row.values[2]))}));
      ++frames;
    }
    if (key.point == 1) frames = 0;
  }
  EXPECT_EQ(frames, 6u);
  EXPECT_EQ(all["results"][0]["histograms"]["slack"], Json({{"frames", 1}, {"bins", {1, 2}}}));
  EXPECT_EQ(all["causes"][0]["pixels"], 4);
  EXPECT_EQ(all["failures"][0]["reason"], "died: Aborted, twice");
}

}  // namespace
}  // namespace racebeam
