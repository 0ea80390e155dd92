// A file of port traffic: what one unit's ports had in every clock of a run, to be replayed.
//
//   racebeam-traffic 1         text: what the traffic is of, ended by "end"
//   ...
//   end
//   block, block, ...          clocks of all ports, compressed
//   index                      where the blocks are, and which clock began which frame
//   foot                       where the index is
//
// Every byte belongs to a part with a checksum. A file appears when it is whole (OutputFile).
// Private clocks are those in which the unit is put to a place of the show through its own pins:
// RTL gets them, its outputs mean nothing, and they are not counted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tb/base/output_file.h"
#include "tb/twin/port_traffic.h"

namespace racebeam {

/// What traffic is of.
struct TrafficHead {
  std::string program;  ///< version of the program whose models made it
  std::string unit, engine;
  std::string scene, scene_hash;                   ///< Show::name() and hash()
  std::string source;                              ///< "chip", "random" or "walk"
  std::vector<std::pair<std::string, int>> knobs;  ///< all, in the engine's order
  std::vector<PortTraffic::Port> ports;
};

/// The first clock of a frame, or of a picture.
struct TrafficMark {
  std::uint64_t clock;
  std::int64_t frame;
};

/// Consecutive clocks, all private or none.
struct TrafficBlock {
  std::uint64_t first = 0;  ///< clocks that are not private before it
  bool is_private = false;
  std::vector<std::uint64_t> values;  ///< by clock, then by port
  /// Registers inside the whole chip, by name, that get a value first; never in a file.
  std::vector<std::pair<std::string, std::uint64_t>> deposits{};
};

/// Whoever takes traffic, clock by clock.
class TrafficSink {
 public:
  virtual ~TrafficSink() = default;
  /// The next clock: a value for each port.
  virtual void add(const std::uint64_t* row, bool is_private) = 0;
  /// The clock to come begins a frame.
  virtual void mark(std::int64_t frame) = 0;
};

/// Whoever gives traffic, block by block.
class TrafficSource {
 public:
  virtual ~TrafficSource() = default;
  virtual const TrafficHead& head() const = 0;
  /// The next block; false: there is none.
  virtual bool next(TrafficBlock& block) = 0;
  /// From the start once more.
  virtual void rewind() = 0;
  /// Those of all of it, and its clocks that are not private.
  virtual std::vector<TrafficMark> marks() const = 0;
  virtual std::uint64_t clocks() const = 0;
};

class TrafficWriter : public TrafficSink {
 public:
  static constexpr std::size_t BlockClocks = 32768;

  /// Throws OutputError.
  TrafficWriter(const std::string& path, const TrafficHead& head);
  void add(const std::uint64_t* row, bool is_private) override;
  void mark(std::int64_t frame) override { marks_.push_back({clocks_, frame}); }
  /// Clocks that are not private so far.
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t bytes() const { return bytes_; }
  /// The file is whole. Throws OutputError.
  void commit();

 private:
  void flush();
  void write(const std::string& bytes);

  OutputFile file_;
  const std::size_t ports_;
  TrafficBlock block_;
  std::string index_;
  std::vector<TrafficMark> marks_;
  std::uint64_t clocks_ = 0, bytes_ = 0, blocks_ = 0;
};

class TrafficFile : public TrafficSource {
 public:
  /// Reads the index, and checks every block's sum. Throws UsageError, which says what is wrong
  /// with the file.
  explicit TrafficFile(const std::string& path);
  ~TrafficFile() override;
  TrafficFile(const TrafficFile&) = delete;
  TrafficFile& operator=(const TrafficFile&) = delete;

  const TrafficHead& head() const override { return head_; }
  std::vector<TrafficMark> marks() const override { return marks_; }
  std::uint64_t clocks() const override { return clocks_; }

  bool next(TrafficBlock& block) override;
  void rewind() override { next_ = 0; }
  /// next() then gives the block with this clock.
  void seek(std::uint64_t clock);

 private:
  struct Entry {
    std::uint64_t offset, first;
    std::uint32_t clocks, is_private;
  };
  void map();
  void read_head();
  void read_index();
  void check_blocks() const;
  [[noreturn]] void refuse(const std::string& why) const;

  const std::string path_;
  const char* data_ = nullptr;
  std::size_t size_ = 0, head_end_ = 0, index_at_ = 0, next_ = 0;
  TrafficHead head_;
  std::vector<Entry> blocks_;
  std::vector<TrafficMark> marks_;
  std::uint64_t clocks_ = 0;
};

}  // namespace racebeam
