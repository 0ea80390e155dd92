// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/error_causes.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

/// The links that knobs make, and what is left between the last of them and the reference.
struct Way {
  const std::vector<ErrorLink>& links;
  ErrorCause rest;

  std::vector<ErrorCause> causes() const {
    std::vector<ErrorCause> all;
    for (const ErrorLink& link : links) all.push_back(link.cause);
    all.push_back(rest);
    return all;
  }
};

const Way& way_to(PictureReference reference) {
  static const Way geometry = {reference_geometry_links(),
                               {"ray_rest", "the camera's products; corners too far off"}};
  static const Way trace_4 = {
      reference_trace_4_links(),
      {"corner_wrap", "a corner too far for its register counts as behind the camera"}};
  return reference == PictureReference::Trace4 ? trace_4 : geometry;
}

/// Calls act(pixel) where pictures differ; most do in few places.
template <class Do>
void for_each_difference(const GoldenPicture& a, const GoldenPicture& b, const Do& act) {
  constexpr std::size_t Some = 8;
  static_assert(VisibleColumns % Some == 0);
  for (std::size_t begin = 0; begin < b.size(); begin += Some) {
    if (std::memcmp(&a[begin], &b[begin], Some) == 0) continue;
    for (std::size_t pixel = begin; pixel < begin + Some; ++pixel)
      if (a[pixel] != b[pixel]) act(pixel);
  }
}

template <class Do>
void for_each_bit(const std::string& bits, const Do& act) {
  for (std::size_t byte = 0; byte < bits.size(); ++byte)
    for (int bit = 0; bits[byte] && bit < 8; ++bit)
      if (bits[byte] >> bit & 1) act(8 * byte + static_cast<std::size_t>(bit));
}

}  // namespace

const std::vector<ErrorCause>& error_causes(PictureReference reference) {
  static const std::vector<ErrorCause> geometry = way_to(PictureReference::Geometry).causes();
  static const std::vector<ErrorCause> trace_4 = way_to(PictureReference::Trace4).causes();
  return reference == PictureReference::Trace4 ? trace_4 : geometry;
}

ErrorChain::ErrorChain(const Show& show, const knobs& k, PictureReference reference)
    : show_(show),
      reference_(reference),
      end_(show, reference == PictureReference::Base ? PictureReference::Geometry : reference, k,
           k) {
  const knobs standard = show.standard_knobs();
  const std::vector<ErrorLink>& links = way_to(reference).links;
  Step now{k, true, 0};
  for (const ErrorLink& link : links) {
    Step next = now;
    if (link.lift) link.lift(next.k, standard);
    else next.residue = next.residue && !next.k.interlace;
    if (next.k != now.k || next.residue != now.residue) steps_.push_back(now);
    now = next;
    ++now.cause;
  }
  steps_.push_back(now);
  // The pixels of a picture depend on all that come behind it, too.
  std::string behind = end_.key();
  for (std::size_t step = steps_.size(); --step > 0;) {
    behind =
        knobs_json(steps_[step].k).dump() + (steps_[step].residue ? "\n" : " plain\n") + behind;
    keys_.insert(keys_.begin(), behind);
  }
}

// Each may have lines of the one before it.
template <class Do>
void ErrorChain::render_links(int frame, const Links& links, const Do& act) const {
  std::optional<TlmPictures> tlm;
  std::optional<TlmPictures::Run> before;
  for (std::size_t step = 1; step < steps_.size(); ++step) {
    if (!links[step - 1].empty()) continue;
    if (!tlm) tlm.emplace(show_, frame, steps_[0].k);
    before = tlm->run(steps_[step].k, steps_[step].residue, before ? &*before : nullptr);
    act(step, before->picture);
  }
}

std::vector<int> ErrorChain::by_cause(int frame, const GoldenPicture& own, const GoldenPicture& end,
                                      Links& links) const {
  links.resize(keys_.size());
  // The last picture that differs; 0: none, or the point's own.
  std::vector<std::uint8_t> last(end.size());
  const auto differs_in = [&](std::size_t step) {
    return [&last, step](std::size_t pixel) {
      last[pixel] = std::max(last[pixel], static_cast<std::uint8_t>(step));
    };
  };
  std::vector<bool> is_new(steps_.size());
  render_links(frame, links, [&](std::size_t step, const GoldenPicture& picture) {
    for_each_difference(picture, end, differs_in(step));
    is_new[step] = true;
  });
  for (std::size_t step = 1; step < steps_.size(); ++step) {
    if (is_new[step]) links[step - 1].resize(end.size() / 8);
    else for_each_bit(links[step - 1], differs_in(step));
  }
  for (std::size_t pixel = 0; pixel < last.size(); ++pixel)
    if (is_new[last[pixel]])
      links[last[pixel] - 1u][pixel / 8] |= static_cast<char>(1 << (pixel % 8));
  std::vector<int> counts(error_causes(reference_).size());
  for_each_difference(own, end, [&](std::size_t pixel) { ++counts[steps_[last[pixel]].cause]; });
  return counts;
}

}  // namespace racebeam
