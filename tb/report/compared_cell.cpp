// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/compared_cell.h"

#include <ctime>

#include "sc/base/constants.h"
#include "tb/base/byte_stream.h"
#include "tb/bench/benches.h"
#include "tb/report/area_figures.h"
#include "tb/report/compare_kinds.h"
#include "tb/show/set_knob.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

constexpr int Percentile = 99, CoarseLevels = 3;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Sums of the squares of errors, of all channels.
struct ErrorSquares {
  std::uint64_t own = 0, coarse = 0;

  void add(const PackedPicture& a, const PackedPicture& b) {
    const int most = (1 << a.bits) - 1;
    const auto rounded = [most](int level) { return (level * CoarseLevels + most / 2) / most; };
    for (std::size_t n = 0; n < a.pixels(); ++n)
      for (int c = 0; c < 3; ++c) {
        const int x = static_cast<int>(a.colour(n) >> c * a.bits) & most;
        const int y = static_cast<int>(b.colour(n) >> c * b.bits) & most;
        own += square(x - y);
        coarse += square(rounded(x) - rounded(y));
      }
  }
  static std::uint64_t square(int value) { return static_cast<std::uint64_t>(value * value); }
};

void put_counts(Numbers& numbers, const engine& built, const frame_counts& sums) {
  for (std::size_t n = 0; n < built.counters.size(); ++n)
    numbers[built.counters[n].name] = static_cast<double>(sums.counters[n]);
  for (std::size_t n = 0; n < built.histograms.size(); ++n)
    for (std::size_t value = 0; value < sums.histograms[n].size(); ++value)
      numbers[std::string(built.histograms[n].name) + "_" + std::to_string(value)] =
          static_cast<double>(sums.histograms[n][value]);
}

void put_lines(Numbers& numbers, const engine& built, const frame_counts& counts) {
  for (std::size_t n = 0; n < built.lines.size(); ++n)
    for (const int clocks : counts.lines[n])
      if (clocks >= 0) numbers[built.lines[n].name] += clocks;
}

void put_silicon(Numbers& numbers, const silicon& made, const knob_values& k) {
  numbers["working_bits"] = static_cast<double>(made.bits(memory_row::Working));
  numbers["picture_bits"] = static_cast<double>(made.bits(memory_row::Picture));
  numbers["scene_memory_bits"] = static_cast<double>(made.bits(memory_row::Scene));
  double units = 0, partial = 0;
  for (const multiplier_row& row : made.multipliers) {
    units += row.count;
    partial += double(row.count) * row.a_bits * row.b_bits;
  }
  numbers["multiplier_units"] = units;
  numbers["partial_product_bits"] = partial;
  numbers["roots_built"] = made.roots;
  numbers["dividers_built"] = made.dividers;
  for (const scene_number& row : made.scene) numbers[row.name] = row.value;
  if (const AreaFigures* const area = area_of(k)) {
    numbers["area_registers"] = area->registers;
    numbers["area_cells"] = area->cells;
  }
}

void put_hits(Numbers& numbers, const HitErrors& hits) {
  numbers["hits_pixels"] = static_cast<double>(hits.pixels);
  numbers["hits_wrong"] = static_cast<double>(hits.wrong);
  numbers["hits_inner"] = static_cast<double>(hits.inner);
  numbers["hits_inner_wrong"] = static_cast<double>(hits.inner_wrong);
}

/// All that the figures come from, and then they.
void conclude(ComparedCell& cell, const silicon& made) {
  Numbers all = cell.numbers;
  for (const quantity_row& row : made.quantities) {
    const std::optional<double> value = formula_value(row.formula, all);
    cell.quantities.push_back({row.name, row.formula, value});
    if (value) all[row.name] = *value;
    else all.erase(row.name);
  }
  for (const CompareMetric& metric : compare_metrics())
    cell.metrics.push_back(formula_value(metric.formula, all));
}

/// The one list of what crosses a pipe, written or read.
template <class Cell, class Field>
void each_field(Cell& cell, const Field& field) {
  field(cell.engine);
  field(cell.scene);
  field(cell.first);
  field(cell.knobs);
  field(cell.metrics);
  for (auto* picture : {&cell.picture, &cell.ideal}) {
    field(picture->width);
    field(picture->height);
    field(picture->bits);
    field(picture->colours);
  }
  for (auto* map : {&cell.hits, &cell.ideal_hits}) {
    field(map->width);
    field(map->height);
    field(map->objects);
  }
}

}  // namespace

ComparedCell measure_cell(const Show& show, const knob_values& k, int first, int pictures) {
  const engine& built = show.engine();
  const CompareKind& kind = compare_kind_of(built);
  const BenchKind& benched = bench_of(built);
  const auto bench = benched.make(built.levels.front(), {built, k, show.tables(), show.frames()},
                                  {false, false, benched.intervals});
  ComparedCell cell;
  cell.engine = built.name;
  cell.scene = show.name();
  cell.first = first;
  cell.knobs = knobs_text(k);
  frame_counts sums;
  Spread costs;
  HitErrors hits;
  ErrorSquares squares;
  double seconds = 0, pixels = 0;
  bool judged = true;
  for (int n = 0; n < pictures; ++n) {
    bench->seek((first + n) % show.frames());
    const double begin = cpu_seconds();
    const ChipBench::Frame frame = bench->render();
    seconds += cpu_seconds() - begin;
    sums.add(*frame.stats);
    put_lines(cell.numbers, built, *frame.stats);
    kind.add_costs(show, k, frame, costs);
    cell.hits = hits_of(built).chip(show, k, frame);
    cell.ideal_hits = hits_of(built).golden(show, k, frame.number);
    hits += hit_errors(cell.hits, cell.ideal_hits);
    cell.picture = frame.picture;
    pixels += static_cast<double>(frame.picture.pixels());
    const std::optional<VgaFrame> ideal = ideal_picture(show, k, frame.number);
    judged = judged && ideal;
    if (!ideal) continue;
    cell.ideal = *ideal;
    squares.add(frame.picture, *ideal);
  }
  for (std::size_t n = 0; n < k.rows().size(); ++n) cell.numbers[k.rows()[n].name] = k[n];
  const silicon made = sweep_kind(kind.engine).made_of(k, show.tables());
  put_counts(cell.numbers, built, sums);
  put_silicon(cell.numbers, made, k);
  put_hits(cell.numbers, hits);
  cell.numbers["pictures"] = pictures;
  cell.numbers["pixels"] = pixels;
  cell.numbers["clock_hz"] = PixelClockHz * built.video(k).clocks_per_pixel;
  cell.numbers["most_level"] = (1 << cell.picture.bits) - 1;
  cell.numbers["sample_p99"] = costs.percentile(Percentile);
  cell.numbers["sample_worst"] = costs.max();
  cell.numbers["sample_pixels"] = kind.sample_pixels;
  if (judged) {
    cell.numbers["error_squares"] = static_cast<double>(squares.own);
    cell.numbers["error_squares_2"] = static_cast<double>(squares.coarse);
  } else {
    cell.ideal.width = 0;
  }
  cell.numbers["cpu_seconds"] = seconds;
  conclude(cell, made);
  return cell;
}

std::string ComparedCell::bytes() const {
  ByteWriter to;
  each_field(*this, [&](const auto& value) { to.put(value); });
  to.put(numbers.size());
  for (const auto& [name, value] : numbers) {
    to.put(name);
    to.put(value);
  }
  to.put(quantities.size());
  for (const Quantity& row : quantities) {
    to.put(row.name);
    to.put(row.formula);
    to.put(row.value);
  }
  return to.bytes();
}

ComparedCell ComparedCell::of_bytes(const std::string& bytes) {
  ByteReader from(bytes);
  ComparedCell cell;
  each_field(cell, [&](auto& value) { from.get(value); });
  std::size_t size = 0;
  from.get(size);
  for (std::size_t n = 0; n < size; ++n) {
    std::string name;
    from.get(name);
    from.get(cell.numbers[name]);
  }
  from.get(size);
  cell.quantities.resize(size);
  for (Quantity& row : cell.quantities) {
    from.get(row.name);
    from.get(row.formula);
    from.get(row.value);
  }
  return cell;
}

}  // namespace racebeam
