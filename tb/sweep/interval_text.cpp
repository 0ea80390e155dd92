// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/interval_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <locale>

namespace racebeam {

namespace {

constexpr int IntervalDigits = 2, ExactDigits = 4;

struct Grouping : std::numpunct<char> {
  char do_thousands_sep() const override { return ','; }
  std::string do_grouping() const override { return "\3"; }
};

/// Rounded to `decimals` behind the point; negative ones are before it.
std::string rounded(double value, int decimals) {
  static const std::locale commas(std::locale::classic(), new Grouping);
  if (decimals < 0) {
    const double step = std::pow(10, -decimals);
    value = std::round(value / step) * step;
  }
  std::string text = fmt::format(commas, "{:.{}Lf}", value, std::max(decimals, 0));
  if (text[0] == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

/// The decimals that leave `value` so many digits; rounding 0.0996 up to 0.10 is looked through.
int decimals_for(double value, int digits) {
  if (value == 0) return 0;
  const double order = std::floor(std::log10(std::abs(value)));
  const int decimals = digits - 1 - int(order);
  const double scale = std::pow(10, decimals);
  return std::round(std::abs(value) * scale) >= std::pow(10, digits) ? decimals - 1 : decimals;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::string frames_text(const char* which, int frames) {
  return fmt::format("{}{} frame{}", which, grouped(frames), frames == 1 ? "" : "s");
}

/// In %, as exact as a bound is worth.
std::string percent(double share, int digits = IntervalDigits) {
  return rounded(100 * share, std::max(decimals_for(100 * share, digits), 0));
}

}  // namespace

std::string grouped(long long number) { return rounded(double(number), 0); }

std::string text_of(double exact, const std::string& unit) {
  const int decimals = exact == std::round(exact) ? 0 : decimals_for(exact, ExactDigits);
  return with_unit(rounded(exact, std::max(decimals, 0)), unit);
}

std::string text_of(const Estimate& estimate, const std::string& unit) {
  if (std::isnan(estimate.value)) return "not measured";
  if (estimate.all())
    return fmt::format("{} ({})", text_of(estimate.value, unit),
                       frames_text("all ", estimate.frames));
  if (std::isinf(estimate.half_width))
    return with_unit(rounded(estimate.value, decimals_for(estimate.value, IntervalDigits)), unit) +
           " (too few frames)";
  if (estimate.half_width == 0)
    return fmt::format("{} (alike in {})", text_of(estimate.value, unit),
                       frames_text("", estimate.frames));
  const int decimals = decimals_for(estimate.half_width, IntervalDigits);
  return fmt::format("{} +/- {}", with_unit(rounded(estimate.value, decimals), unit),
                     rounded(estimate.half_width, decimals));
}

std::string text_of(const Worst& worst, const std::string& unit) {
  if (std::isnan(worst.value)) return "not measured";
  return fmt::format("{} (worst of {})", text_of(worst.value, unit),
                     frames_text(worst.all() ? "all " : "", worst.frames));
}

std::string text_of(const Share& share, double confidence) {
  const std::string sure = fmt::format("({:.4g} %)", 100 * confidence);
  if (share.all() && share.hits == 0) return "none of " + frames_text("", share.frames);
  if (share.all())
    return fmt::format("{} % of {}", percent(share.value(), ExactDigits),
                       frames_text("all ", share.frames));
  if (share.hits == 0)
    return fmt::format("fewer than {} % of frames {}", percent(share.high), sure);
  if (share.hits == share.frames)
    return fmt::format("more than {} % of frames {}",
                       rounded(100 * share.low, decimals_for(100 * (1 - share.low), 2)), sure);
  return fmt::format("{} % of frames, {} to {} % {}", percent(share.value()), percent(share.low),
                     percent(share.high), sure);
}

}  // namespace racebeam
