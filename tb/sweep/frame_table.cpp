// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/frame_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tb/base/errors.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/schema.h"
#include "tb/sweep/store_errors.h"

namespace racebeam {

namespace {

constexpr const char* OfPoint = " WHERE model = ?1 AND scene = ?2 AND point = ?3";
constexpr const char* OfFrame = " WHERE model = ?1 AND scene = ?2 AND point = ?3 AND frame = ?4";

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += ", " + quoted(name);
  return list;
}

std::string places(std::size_t count) {
  std::string list;
  for (std::size_t i = 0; i < count; ++i) list += ", ?";
  return list;
}

}  // namespace

/// What put() works with.
struct FrameTable::Block {
  Block(Database& database, const FrameKey& of, const std::vector<std::string>& names)
      : key(of),
        columns(names),
        insert(database, "INSERT INTO frame(model, scene, point, frame, kind, digest" +
                             quoted_list(names) + ") VALUES (?, ?, ?, ?, ?, ?" +
                             places(names.size()) + ") ON CONFLICT DO NOTHING"),
        find(database, "SELECT kind, digest" + quoted_list(names) + " FROM frame" + OfFrame),
        sample(database, std::string("UPDATE frame SET kind = 'sample'") + OfFrame) {}

  const FrameKey key;
  const std::vector<std::string>& columns;
  Statement insert, find, sample;
  int added = 0;
  bool counts = false;  ///< the last row has become one of the sample
  std::map<std::string, Histogram> histograms{};
  std::vector<std::string> disputes{};
};

int FrameTable::take_over(const FrameKey& key, const FrameTable& other, const FrameKey& from) {
  if (!read(key, {}).empty()) return 0;
  if (other.columns(from.model) != columns(key.model))
    throw UsageError(other.database_.file() + " has other figures than this program measures");
  const auto all_causes = other.causes(from);
  std::vector<MeasuredFrame> frames;
  for (FrameRow& row : other.read(from)) {
    const auto causes = all_causes.find(row.frame);
    frames.push_back({std::move(row), {}, {}});
    if (causes != all_causes.end()) frames.back().causes = causes->second;
  }
  return put(key, frames, other.histograms(from));
}

int FrameTable::put(const FrameKey& key, const std::vector<MeasuredFrame>& frames,
                    const std::map<std::string, Histogram>& more) {
  const std::vector<std::string>& names = columns(key.model);
  for (const MeasuredFrame& frame : frames)
    if (const FrameRow& row = frame.row;
        row.values.size() != names.size() || row.digest != frame_digest(row.frame, row.values))
      throw std::invalid_argument(fmt::format("frame {} is not as its digest says", row.frame));
  Transaction all(database_);
  Block block(database_, key, names);
  block.histograms = more;
  for (const MeasuredFrame& frame : frames) {
    put_row(block, frame.row);
    put_causes(block, frame);
    if (!block.counts) continue;
    for (const auto& [name, bins] : frame.histograms) block.histograms[name].add(1, bins);
  }
  add_histograms(block);
  all.commit();
  if (block.disputes.empty()) return block.added;
  std::string text = block.disputes.front();
  if (const std::size_t more = block.disputes.size() - 1)
    text += fmt::format(" (and {} more)", more);
  throw NotDeterministic(text + ": this program counts differently");
}

void FrameTable::put_row(Block& block, const FrameRow& row) {
  const FrameKey& key = block.key;
  const auto digest = static_cast<std::int64_t>(row.digest);
  const char* const kind = row.guard ? "guard" : "sample";
  block.insert.with(key.model, key.scene, key.point, row.frame, kind, digest);
  for (std::size_t i = 0; i < row.values.size(); ++i)
    block.insert.bind(static_cast<int>(i) + 7, row.values[i]);
  block.insert.run();
  const bool fresh = database_.changes() == 1;
  block.added += fresh;
  block.counts = fresh && !row.guard;
  if (fresh) return;
  block.find.with(key.model, key.scene, key.point, row.frame).next();
  const bool guard = block.find.view(0) == "guard";
  bool same = block.find.integer(1) == digest;
  for (std::size_t i = 0; i < row.values.size(); ++i)
    same = same && block.find.integer(static_cast<int>(i) + 2) == row.values[i];
  block.find.reset();
  if (!same) {
    dispute(block, row);
  } else if (guard && !row.guard) {
    block.sample.with(key.model, key.scene, key.point, row.frame).run();
    block.counts = true;
  }
}

void FrameTable::put_causes(Block& block, const MeasuredFrame& frame) {
  if (frame.causes.empty()) return;
  const FrameKey& key = block.key;
  const int number = frame.row.frame;
  Statement find(database_, std::string("SELECT cause, pixels FROM cause") + OfFrame);
  std::map<std::string, std::int64_t> there;
  for (find.with(key.model, key.scene, key.point, number); find.next();)
    there[find.text(0)] = find.integer(1);
  if (there == frame.causes) return;
  if (!there.empty()) {
    block.disputes.push_back(fmt::format("frame {} has other causes of its errors", number));
    return;
  }
  Statement insert(database_, insert_with_digest("cause"));
  for (const auto& [cause, pixels] : frame.causes)
    insert.with(key.model, key.scene, key.point, number, cause, pixels).run();
}

void FrameTable::add_histograms(const Block& block) {
  if (block.histograms.empty()) return;
  const FrameKey& key = block.key;
  std::map<std::string, Histogram> sums = histograms(key);
  Statement remove(database_, std::string("DELETE FROM histogram") + OfPoint + " AND name = ?4");
  Statement insert(database_, insert_with_digest("histogram"));
  for (const auto& [name, more] : block.histograms) {
    Histogram& sum = sums[name];
    sum.add(more.frames, more.bins);
    remove.with(key.model, key.scene, key.point, name).run();
    const std::string bytes = bytes_of(sum.bins);
    insert.with(key.model, key.scene, key.point, name, sum.frames);
    insert.bind_blob(6, bytes);
    insert.run();
  }
}

// Both results as text: what is there, and what has come.
void FrameTable::dispute(Block& block, const FrameRow& row) {
  const FrameKey& key = block.key;
  Statement stored(database_,
                   "SELECT digest" + quoted_list(block.columns) + " FROM frame" + OfFrame);
  stored.with(key.model, key.scene, key.point, row.frame).next();
  std::string before, now, first;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const std::string& name = block.columns[i];
    const std::int64_t was = stored.integer(static_cast<int>(i) + 1), is = row.values[i];
    before += fmt::format("{}={}\n", name, was);
    now += fmt::format("{}={}\n", name, is);
    if (first.empty() && was != is) first = fmt::format(": {} was {}, and is {}", name, was, is);
  }
  Statement insert(database_,
                   "INSERT INTO disputed VALUES (?, ?, ?, ?, ?, ?) "
                   "ON CONFLICT DO NOTHING");
  insert.with(key.model, key.scene, key.point, row.frame, stored.integer(0), before).run();
  const auto digest = static_cast<std::int64_t>(row.digest);
  insert.with(key.model, key.scene, key.point, row.frame, digest, now).run();
  Statement point(database_, "SELECT coalesce(name, hash) FROM point WHERE id = ?");
  point.with(key.point).next();
  block.disputes.push_back(
      fmt::format("frame {} of {} does not repeat{}", row.frame, point.text(0), first));
}

std::unordered_map<std::int64_t, std::vector<KeptFrame>> FrameTable::there(
    std::int64_t model, std::int64_t scene) const {
  Statement select(database_,
                   "SELECT point, frame, kind FROM frame "
                   "WHERE model = ? AND scene = ? ORDER BY point, frame");
  std::unordered_map<std::int64_t, std::vector<KeptFrame>> frames;
  std::int64_t last = 0;
  std::vector<KeptFrame>* list = nullptr;
  for (select.with(model, scene); select.next();) {
    if (const std::int64_t point = select.integer(0); !list || point != last) {
      list = &frames[point];
      last = point;
    }
    list->push_back({static_cast<int>(select.integer(1)), select.view(2) == "guard"});
  }
  return frames;
}

std::vector<FrameRow> FrameTable::read(const FrameKey& key,
                                       const std::vector<std::string>& names) const {
  const std::vector<std::string>& known = columns(key.model);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw std::invalid_argument("frames have no column " + name);
  Statement select(database_, "SELECT frame, kind, digest" + quoted_list(names) + " FROM frame" +
                                  OfPoint + " ORDER BY frame");
  std::vector<FrameRow> rows;
  for (select.with(key.model, key.scene, key.point); select.next();) {
    FrameRow row{static_cast<int>(select.integer(0)),
                 select.view(1) == "guard",
                 static_cast<std::uint64_t>(select.integer(2)),
                 {}};
    row.values.reserve(names.size());
    for (int i = 3; i < select.columns(); ++i) row.values.push_back(select.integer(i));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::map<std::string, Histogram> FrameTable::histograms(const FrameKey& key) const {
  Statement select(database_, std::string("SELECT name, frames, bins FROM histogram") + OfPoint);
  std::map<std::string, Histogram> all;
  for (select.with(key.model, key.scene, key.point); select.next();)
    all[select.text(0)] = {select.integer(1), bins_of(select.text(2))};
  return all;
}

std::map<int, std::map<std::string, std::int64_t>> FrameTable::causes(const FrameKey& key) const {
  Statement select(database_, std::string("SELECT frame, cause, pixels FROM cause") + OfPoint);
  std::map<int, std::map<std::string, std::int64_t>> all;
  for (select.with(key.model, key.scene, key.point); select.next();)
    all[static_cast<int>(select.integer(0))][select.text(1)] = select.integer(2);
  return all;
}

std::vector<FrameRow> FrameTable::read_causes(const FrameKey& key,
                                              const std::vector<std::string>& names) const {
  std::vector<FrameRow> rows;
  for (const auto& [frame, pixels] : causes(key)) {
    FrameRow row{frame, false, 0, {}};
    for (const std::string& name : names) {
      const auto at = pixels.find(name);
      row.values.push_back(at == pixels.end() ? 0 : at->second);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::unordered_map<std::int64_t, std::vector<int>> FrameTable::with_causes(
    std::int64_t model, std::int64_t scene) const {
  Statement select(database_,
                   "SELECT DISTINCT point, frame FROM cause "
                   "WHERE model = ? AND scene = ? ORDER BY point, frame");
  std::unordered_map<std::int64_t, std::vector<int>> frames;
  for (select.with(model, scene); select.next();)
    frames[select.integer(0)].push_back(static_cast<int>(select.integer(1)));
  return frames;
}

std::int64_t FrameTable::count(std::int64_t model) const {
  Statement select(database_, "SELECT count(*) FROM frame WHERE model = ?");
  select.with(model).next();
  return select.integer(0);
}

std::int64_t FrameTable::disputed(std::int64_t model) const {
  Statement select(database_,
                   "SELECT count(*) FROM (SELECT DISTINCT scene, point, frame "
                   "FROM disputed WHERE model = ?)");
  select.with(model).next();
  return select.integer(0);
}

const std::vector<std::string>& FrameTable::columns(std::int64_t model) const {
  if (const auto at = columns_.find(model); at != columns_.end()) return at->second;
  Statement select(database_, "SELECT columns FROM model WHERE id = ?");
  if (!select.with(model).next())
    throw std::invalid_argument(fmt::format("the store has no model {}", model));
  return columns_[model] = lines_of(select.text(0));
}

}  // namespace racebeam
