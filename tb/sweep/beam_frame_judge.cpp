// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "tb/judge/error_causes.h"
#include "tb/judge/reference_picture.h"
#include "tb/judge/visible_error.h"
#include "tb/sweep/frame_judge.h"
#include "tb/sweep/packed.h"
#include "tb/sweep/row_digest.h"

namespace racebeam {

namespace {

constexpr std::size_t PictureSize = std::size_t(VisibleColumns) * VisibleRows;

class BeamFrameJudge final : public FrameJudge {
 public:
  BeamFrameJudge(const Show& show, const Block& block)
      : k_(block.k), kind_(block.reference), reference_(show, block.reference, k_, block.base) {
    if (block.causes) chain_.emplace(show, k_, block.reference);
  }

  ReferenceKeys keys() const override {
    ReferenceKeys keys{reference_.key()};
    if (!chain_) return keys;
    if (kind_ == PictureReference::Base) keys.end = chain_->end().key();
    for (const std::string& key : chain_->keys()) keys.links.push_back("link " + text_hash(key));
    return keys;
  }

  std::vector<std::int64_t> errors(const ChipBench::Frame& frame, const KeptPictures& kept,
                                   Answer& answer) override {
    const GoldenPicture& colours = frame.picture.colours;
    if (reference_.made_with() == k_ && kind_ == PictureReference::Base) {
      meant_ = colours;  // not rendered again
      if (kept.reference.empty()) answer.made.reference = packed_colours(colours);
    } else {
      put(meant_, reference_, frame.number, kept.reference, answer.made.reference);
    }
    if (chain_) put_causes(frame, kept, answer);
    return {golden_difference(colours, meant_), visible_difference(colours, meant_)};
  }

 private:
  /// As it is kept, or else made and packed.
  static void put(GoldenPicture& picture, const ReferencePicture& reference, int frame,
                  const std::string& kept, std::string& packed_one) {
    picture.resize(PictureSize);
    if (!kept.empty()) return unpack_colours(kept, picture);
    picture = reference.picture(frame);
    packed_one = packed_colours(picture);
  }

  void put_causes(const ChipBench::Frame& frame, const KeptPictures& kept, Answer& answer) {
    GoldenPicture& end = kind_ == PictureReference::Base ? end_ : meant_;
    if (kind_ == PictureReference::Base)
      put(end, chain_->end(), frame.number, kept.end, answer.made.end);
    ErrorChain::Links links(chain_->keys().size());
    for (std::size_t i = 0; i < kept.links.size(); ++i)
      if (!kept.links[i].empty()) links.at(i) = unpacked(kept.links[i], PictureSize / 8);
    const ErrorChain::Links known = links;
    const std::vector<int> pixels =
        chain_->by_cause(frame.number, frame.picture.colours, end, links);
    for (std::size_t i = 0; i < links.size(); ++i)
      answer.made.links.push_back(known[i].empty() ? packed(links[i]) : "");
    const auto& names = error_causes(kind_);
    for (std::size_t i = 0; i < names.size(); ++i) answer.frame.causes[names[i].name] = pixels[i];
  }

  const knobs k_;
  const PictureReference kind_;
  const ReferencePicture reference_;
  std::optional<ErrorChain> chain_;
  GoldenPicture meant_, end_;  // of the last frame: their memory is used again
};

}  // namespace

std::unique_ptr<FrameJudge> make_beam_frame_judge(const Show& show, const Block& block) {
  return std::make_unique<BeamFrameJudge>(show, block);
}

}  // namespace racebeam
