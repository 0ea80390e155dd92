// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/measurer.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/sweep/model_hash.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/store_errors.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

// A worker takes some 4 ms to begin and a frame some 6 ms: blocks are long enough for the first not
// to matter. If there are others, the fewer frames are left, the shorter they get, for all workers
// to end at about the same time. A frame of the base takes longer: its reference picture is made.
constexpr std::size_t SmallestBlock = 32, SmallestOfBase = 8, LargestBlock = 256, BlocksOfAJob = 2;

bool has(const std::vector<int>& sorted, int frame) {
  return std::binary_search(sorted.begin(), sorted.end(), frame);
}

void insert(std::vector<int>& sorted, int frame) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), frame);
  if (at == sorted.end() || *at != frame) sorted.insert(at, frame);
}

}  // namespace

Measurer::Measurer(const SweepPlan& plan, const SweepFolder& folder, Store& store,
                   std::int64_t model, ForkServer& server, int jobs, std::function<void()> look,
                   BlockPlace* place)
    : plan_(plan),
      folder_(folder),
      store_(store),
      model_(model),
      server_(server),
      jobs_(jobs),
      look_(std::move(look)),
      place_(place) {
  for (const SweepScene& scene : plan.scenes)
    scenes_.push_back(store.scene({scene.name, scene.show.hash(), scene.show.frames()}));
  take_in_points();
}

void Measurer::take_in_points() {
  const std::size_t before = failures_.size();
  kept_.resize(plan_.points.size() * plan_.scenes.size());
  failures_.resize(plan_.points.size());
  std::vector<StoredPoint> points;
  for (const PlannedPoint& point : plan_.points)
    for (const std::string& setting : point.settings) points.push_back({setting, point.point.name});
  points_ = store_.points(points);
  for (std::size_t scene = 0; scene < plan_.scenes.size(); ++scene) {
    const auto there = store_.frames.there(model_, scenes_[scene]);
    const auto causes = plan_.file.measure.causes
                            ? store_.frames.with_causes(model_, scenes_[scene])
                            : decltype(store_.frames.with_causes(0, 0)){};
    for (std::size_t point = before; point < plan_.points.size(); ++point) {
      const std::size_t at = point * plan_.scenes.size() + scene;
      const auto frames = there.find(points_[at]);
      if (frames == there.end()) continue;
      for (const KeptFrame& frame : frames->second)
        (frame.guard ? kept_[at].guard : kept_[at].sample).push_back(frame.frame);
      if (const auto with = causes.find(points_[at]); with != causes.end())
        kept_[at].causes = with->second;
    }
  }
}

std::size_t Measurer::index(int point, int scene) const {
  return static_cast<std::size_t>(point) * plan_.scenes.size() + static_cast<std::size_t>(scene);
}

FrameKey Measurer::key(int point, int scene) const {
  return {model_, scenes_[static_cast<std::size_t>(scene)], points_[index(point, scene)]};
}

int Measurer::failed() const {
  return static_cast<int>(std::count_if(failures_.begin(), failures_.end(),
                                        [](const std::string& why) { return !why.empty(); }));
}

void Measurer::forget_failures() {
  for (int point = 0; point < static_cast<int>(plan_.points.size()); ++point)
    for (int scene = 0; scene < static_cast<int>(plan_.scenes.size()); ++scene)
      if (failure(point).empty()) store_.failures.remove(key(point, scene));
}

std::vector<int> Measurer::lacks(const Want& want) const {
  const Kept& there = kept(want.point, want.scene);
  std::vector<int> frames;
  const bool causes = plan_.file.measure.causes && !want.guard;
  for (const int frame : want.frames)
    if ((!has(there.sample, frame) && !(want.guard && has(there.guard, frame))) ||
        (causes && !has(there.causes, frame)))
      frames.push_back(frame);
  std::sort(frames.begin(), frames.end());
  return frames;
}

int Measurer::missing(const std::vector<Want>& wants) const {
  std::size_t frames = 0;
  for (const Want& want : wants) frames += lacks(want).size();
  return static_cast<int>(frames);
}

Block Measurer::block_of(const Want& want) const {
  const SweepScene& scene = plan_.scenes[static_cast<std::size_t>(want.scene)];
  Block block;
  block.point = want.point;
  block.scene = want.scene;
  block.scene_name = scene.name;
  block.scene_hash = scene.show.hash();
  block.k =
      plan_.points[static_cast<std::size_t>(want.point)].k[static_cast<std::size_t>(want.scene)];
  block.base = plan_.points[0].k[static_cast<std::size_t>(want.scene)];
  block.frames = want.frames;
  block.guard = want.guard;
  block.causes = plan_.file.measure.causes && !want.guard;
  block.reference = plan_.file.measure.reference;
  return block;
}

std::size_t Measurer::add_block(std::list<Block>& blocks, const Want& want, std::size_t begin,
                                std::size_t size) {
  Block block = block_of(want);
  const std::size_t taken = std::min(size, want.frames.size() - begin);
  const auto first = want.frames.begin() + static_cast<std::ptrdiff_t>(begin);
  block.frames.assign(first, first + static_cast<std::ptrdiff_t>(taken));
  block.number = ++blocks_;
  blocks.push_back(std::move(block));
  return taken;
}

void Measurer::add_blocks(std::list<Block>& blocks, const Want& want) {
  for (std::size_t begin = 0; begin < want.frames.size();)
    begin += add_block(blocks, want, begin, LargestBlock);
}

bool Measurer::run(std::list<Block> blocks) {
  return BlockRunner(server_, jobs_, *this).run(std::move(blocks));
}

// The base at once with the others: to wait for it alone would be to queue twice.
bool Measurer::measure_elsewhere(const std::vector<Want>& wants) {
  std::list<Block> blocks;
  for (const Want& want : wants) {
    if (!failure(want.point).empty()) continue;
    Want lacking = want;
    lacking.frames = lacks(want);
    add_block(blocks, lacking, 0, lacking.frames.size());
  }
  return place_->run(std::move(blocks), *this);
}

bool Measurer::measure(const std::vector<Want>& wants) {
  if (place_) return measure_elsewhere(wants);
  for (const bool base : {true, false}) {
    std::vector<Want> all;
    std::size_t left = 0;  // frames that no block has
    for (const Want& want : wants) {
      if ((want.point == 0) != base || !failure(want.point).empty()) continue;
      Want lacking = want;
      lacking.frames = lacks(want);
      left += lacking.frames.size();
      all.push_back(std::move(lacking));
    }
    const std::size_t parts = jobs_ == 1 ? 1 : BlocksOfAJob * static_cast<std::size_t>(jobs_);
    std::list<Block> blocks;
    for (const Want& want : all)
      for (std::size_t begin = 0; begin < want.frames.size();) {
        const std::size_t size =
            std::clamp(left / parts, base ? SmallestOfBase : SmallestBlock, LargestBlock);
        const std::size_t taken = add_block(blocks, want, begin, size);
        begin += taken;
        left -= taken;
      }
    if (!run(std::move(blocks))) return false;
    if (!failure(0).empty()) break;  // nothing to compare with
  }
  return true;
}

bool Measurer::repeat(const Want& want) {
  std::list<Block> blocks;
  add_block(blocks, want, 0, want.frames.size());
  return run(std::move(blocks));
}

bool Measurer::scan(int scene) {
  std::vector<int> there;
  for (const ScannedFrame& one : store_.scans.read(key(0, scene))) there.push_back(one.frame);
  Want want{0, scene, {}};
  for (const int frame : plan_.scenes[static_cast<std::size_t>(scene)].order)
    if (!has(there, frame)) want.frames.push_back(frame);
  std::sort(want.frames.begin(), want.frames.end());
  std::list<Block> blocks;
  if (place_) add_block(blocks, want, 0, want.frames.size());
  else add_blocks(blocks, want);
  for (Block& block : blocks) block.scan = true;
  return place_ ? place_->run(std::move(blocks), *this) : run(std::move(blocks));
}

std::map<int, std::string> Measurer::pictures(const Want& want) {
  std::map<int, std::string> pictures;
  std::list<Block> blocks;
  add_blocks(blocks, want);
  for (Block& block : blocks) block.pictures = true;
  pictures_ = &pictures;
  run(std::move(blocks));
  pictures_ = nullptr;
  return pictures;
}

/// What tells the pictures of a block's frames from others.
struct Measurer::PictureKeys {
  std::string whose;  ///< model and scene
  std::string reference, end;
  std::vector<std::string> links;

  std::string of(int frame, const std::string& text) const {
    return text_hash(fmt::format("{} {} runs\n{}", whose, frame, text));
  }
};

Measurer::PictureKeys Measurer::picture_keys(const Block& block) const {
  const Show& show = plan_.scenes[static_cast<std::size_t>(block.scene)].show;
  const ReferenceKeys keys = sweep_kind(show.engine()).judge(show, block)->keys();
  return {fmt::format("{} {}", model_hash(show.engine().name), block.scene_hash), keys.reference,
          keys.end, keys.links};
}

void Measurer::prepare(Block& block) {
  if (block.scan || block.pictures) return;
  const PictureKeys keys = picture_keys(block);
  for (const int frame : block.frames) {
    const auto find = [&](const std::string& key) {
      return key.empty() ? "" : store_.references.find(keys.of(frame, key)).value_or("");
    };
    KeptPictures& kept = block.kept[frame];
    kept.reference = find(keys.reference);
    kept.end = find(keys.end);
    for (const std::string& link : keys.links) kept.links.push_back(find(link));
  }
}

void Measurer::take(const Block& block, const std::vector<Answer>& answers) try {
  if (pictures_) {
    for (const Answer& answer : answers) (*pictures_)[answer.frame.row.frame] = answer.picture;
    return;
  }
  const FrameKey of = key(block.point, block.scene);
  if (block.scan) {
    std::vector<ScannedFrame> frames;
    for (const Answer& answer : answers)
      frames.push_back(
          {answer.frame.row.frame, answer.frame.row.values.at(0), answer.frame.row.values.at(1)});
    store_.scans.put(of, frames);
    return;
  }
  const PictureKeys keys = picture_keys(block);
  Transaction pictures(store_.database());
  std::vector<MeasuredFrame> frames;
  for (const Answer& answer : answers) {
    frames.push_back(answer.frame);
    const auto keep = [&](const std::string& key, const std::string& picture) {
      if (!picture.empty()) store_.references.put(keys.of(answer.frame.row.frame, key), picture);
    };
    keep(keys.reference, answer.made.reference);
    keep(keys.end, answer.made.end);
    for (std::size_t i = 0; i < answer.made.links.size(); ++i)
      keep(keys.links.at(i), answer.made.links[i]);
  }
  pictures.commit();
  store_.frames.put(of, frames);
  Kept& there = kept(block.point, block.scene);
  for (const MeasuredFrame& frame : frames) {
    insert(block.guard ? there.guard : there.sample, frame.row.frame);
    if (!frame.causes.empty()) insert(there.causes, frame.row.frame);
  }
  measured_ += static_cast<std::int64_t>(frames.size());
} catch (const DiskFull& error) {
  throw error.keeping(fmt::format("{} frames are kept", store_.frames.count(model_)));
}

void Measurer::refuse(int point, const std::string& reason) {
  const std::string& name = plan_.points[static_cast<std::size_t>(point)].point.name;
  failures_[static_cast<std::size_t>(point)] = reason;
  for (int scene = 0; scene < static_cast<int>(plan_.scenes.size()); ++scene)
    store_.failures.put(key(point, scene), reason);
  folder_.keep_failure(name, fmt::format("{}\n{}\n", name, reason));
}

void Measurer::fail(const Block& block, const std::string& reason, const std::string& words) {
  const std::string& name = plan_.points[static_cast<std::size_t>(block.point)].point.name;
  failures_[static_cast<std::size_t>(block.point)] = reason;
  store_.failures.put(key(block.point, block.scene), reason);
  folder_.keep_failure(name,
                       fmt::format("{} on {}\n{}\n{}", name, block.scene_name, reason, words));
}

}  // namespace racebeam
