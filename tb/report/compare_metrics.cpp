// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/compare_metrics.h"

#include <cstdlib>

#include "tb/base/expression.h"
#include "tb/base/nearest.h"

namespace racebeam {

const std::vector<CompareMetric>& compare_metrics() {
  static const std::vector<CompareMetric> table = {
      {"clocks_per_pixel", "clocks a pixel", "", "clocks in which the tracer works, by pixels",
       "work_clocks / pixels", 3},
      {"clocks_p99", "99 % need at most", "", "the same of a pixel, or of a line by its 640 pixels",
       "sample_p99 / sample_pixels", 3},
      {"clocks_worst", "the worst needs", "", "the largest of those",
       "sample_worst / sample_pixels", 3},
      {"pictures_per_second", "pictures/s, own clock", "1/s", "without what the host does before",
       "clock_hz * pictures / picture_clocks", 2},
      {"pictures_per_second_50", "pictures/s, 50.4 MHz", "1/s", "the same at the beam's clock",
       "50400000 * pictures / picture_clocks", 2},
      {"units_to_race", "units to race the beam", "",
       "840,000 clocks are a frame at 50.4 MHz, 307,200 pixels a picture",
       "ceil(racing_clocks * 307200 / 840000)", 0},
      {"host_clocks", "host clocks", "clocks", "in which the host sends a picture's scene",
       "host_clocks / pictures", 0},
      {"register_bits", "flip-flops", "bits", "of the RTL, the picture store outside",
       "area_registers", 0},
      {"cells", "cells", "", "generic ones, by yosys, flip-flops among them", "area_cells", 0},
      {"working_memory", "working memory", "bits", "queues, stacks, tables, copies in cores",
       "working_bits", 0},
      {"picture_store", "picture store", "bits", "outside of the chip", "picture_bits", 0},
      {"scene_memory", "scene memory", "bits", "if it is neither gates nor in the working memory",
       "scene_memory_bits", 0},
      {"multipliers", "multipliers", "", "", "multiplier_units", 0},
      {"partial_products", "partial products", "bits", "sum of width x width",
       "partial_product_bits", 0},
      {"products_per_pixel", "products a pixel", "", "that a result depended on",
       "products / pixels", 2},
      {"root_units", "roots", "", "units", "roots_built", 0},
      {"roots_per_pixel", "roots a pixel", "", "", "roots_found / pixels", 3},
      {"divider_units", "dividers", "", "units", "dividers_built", 0},
      {"quotients_per_pixel", "quotients a pixel", "", "", "quotients / pixels", 3},
      {"scene_traffic", "scene read, a pixel", "bits", "", "scene_bits / pixels", 1},
      {"store_written", "store written, a pixel", "bits", "", "store_bits_written / pixels", 2},
      {"store_read", "store read, a pixel", "bits", "by the beam, while the picture is drawn",
       "store_bits_read / pixels", 2},
      {"wrong_hits", "first hit wrong", "%", "another object than the golden tracer's",
       "100 * hits_wrong / hits_pixels", 3},
      {"wrong_hits_inner", "the same off edges", "%",
       "of pixels more than one away from an edge in the golden map",
       "100 * hits_inner_wrong / hits_inner", 3},
      {"psnr", "picture error", "dB", "PSNR by the engine's golden tracer, at its own depth",
       "10 * log10(3 * pixels * most_level * most_level / error_squares)", 2},
      {"psnr_2_bits", "the same at 2 bits", "dB", "both pictures at 2 bits a channel",
       "10 * log10(27 * pixels / error_squares_2)", 2},
      {"starved", "starved pixels", "%", "not known when the beam came", "100 * starved / pixels",
       3},
      {"simulated_clocks", "simulated M clocks/s", "M/s", "by the model at the level tlm",
       "picture_clocks / cpu_seconds / 1000000", 1, true},
      {"simulated_pictures", "simulated pictures/s", "1/s", "", "pictures / cpu_seconds", 2, true},
  };
  return table;
}

std::string metric_row(const CompareMetric& metric) {
  const std::string unit = metric.unit;
  return std::string("| `") + metric.name + "` | " + metric.title +
         (unit.empty() ? "" : ", " + unit) + " | " + metric.meaning + " | `" + metric.formula +
         "` |";
}

const CompareMetric& compare_metric(const std::string& name) {
  std::vector<std::string> known;
  for (const CompareMetric& metric : compare_metrics()) {
    if (metric.name == name) return metric;
    known.emplace_back(metric.name);
  }
  throw unknown_name("figure", name, known);
}

const std::vector<CompareName>& compare_numbers() {
  static const std::vector<CompareName> table = {
      {"pictures", "that were drawn"},
      {"pixels", "of all of them"},
      {"clock_hz", "of the engine"},
      {"most_level", "the highest level of a channel"},
      {"sample_p99", "clocks that 99 % of pixels, or lines, do not exceed"},
      {"sample_worst", "the largest"},
      {"sample_pixels", "1, or 640 if lines were measured"},
      {"working_bits", "sum of the memories of that use"},
      {"picture_bits", "the same"},
      {"scene_memory_bits", "the same"},
      {"multiplier_units", "sum of the engine's table"},
      {"partial_product_bits", "sum of number x width x width of that table"},
      {"roots_built", "units"},
      {"dividers_built", "units"},
      {"area_registers", "of `scripts/area`"},
      {"area_cells", "of `scripts/area`"},
      {"hits_pixels", "of both hit maps"},
      {"hits_wrong", "pixels in which they differ"},
      {"hits_inner", "pixels away from edges of the golden map"},
      {"hits_inner_wrong", "of those"},
      {"error_squares", "of the errors of all channels, in levels"},
      {"error_squares_2", "the same in levels of 2 bits"},
      {"cpu_seconds", "of the model, for the pictures alone"},
  };
  return table;
}

const std::vector<CompareName>& compare_quantities() {
  static const std::vector<CompareName> table = {
      {"work_clocks", "in which the tracer works on the pictures"},
      {"picture_clocks", "from one picture to the next"},
      {"host_clocks", "in which the host sends scenes"},
      {"racing_clocks", "of a pixel, that decide how many units race the beam"},
      {"products", "that a result depended on"},
      {"roots_found", "roots"},
      {"quotients", "divisions"},
      {"scene_bits", "read from rooms, spheres, planes"},
      {"store_bits_written", "by the tracer"},
      {"store_bits_read", "by the beam"},
      {"starved", "pixels"},
  };
  return table;
}

std::optional<double> formula_value(const std::string& formula, const Numbers& numbers) {
  if (formula.empty()) return {};
  char* end = nullptr;
  const double constant = std::strtod(formula.c_str(), &end);
  if (*end == 0) return constant;
  bool all = true;
  Numbers values = numbers;
  ExpressionNames names{"number", "word", "clocks / pixels",
                        [&](const std::string& name) {
                          all = all && values.count(name);
                          return &values[name];
                        },
                        [](const std::string&) { return nullptr; }};
  const double value = Expression("formula", formula, names).value();
  return all ? std::optional<double>(value) : std::nullopt;
}

}  // namespace racebeam
