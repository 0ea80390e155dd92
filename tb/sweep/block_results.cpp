// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/block_results.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tb/base/counted.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// How a line of a plan begins; the rest is as a worker on this machine says it.
std::string head_of(const std::string& plan) { return "{\"of\":\"" + plan + "\","; }

/// "3.17.0.jsonl": of this rung and block.
bool parse_name(const std::string& name, int& rung, int& block) {
  int number = 0, end = 0;
  return std::sscanf(name.c_str(), "%d.%d.%d.jsonl%n", &rung, &block, &number, &end) == 3 &&
         end == static_cast<int>(name.size());
}

}  // namespace

ResultFile::ResultFile(const std::string& folder, const RungPlan& plan, int block)
    : plan_(plan.hash) {
  make_folder(folder + "/results");
  for (int number = 0; file_ < 0; ++number) {
    path_ = fmt::format("{}/results/{}.{}.{}.jsonl", folder, plan.rung, block, number);
    file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0 && errno != EEXIST) throw OutputError(path_, errno, "");
  }
}

ResultFile::~ResultFile() { close(file_); }

void ResultFile::append(const std::string& lines) {
  std::string text;
  for (std::size_t begin = 0, end; begin < lines.size(); begin = end + 1) {
    end = lines.find('\n', begin);
    text += head_of(plan_) + lines.substr(begin + 1, end - begin);
  }
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t wrote = write(file_, text.data() + done, text.size() - done);
    if (wrote < 0 && errno != EINTR) throw OutputError(path_, errno, "");
    if (wrote > 0) done += static_cast<std::size_t>(wrote);
  }
  if (fsync(file_) != 0) throw OutputError(path_, errno, "");
}

ResultReader::ResultReader(const std::string& folder, const RungPlan& plan, int block)
    : folder_(folder + "/results"), plan_(plan), block_(block) {}

void ResultReader::read(const Take& take) {
  std::error_code error;
  for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    int rung = 0, block = 0;
    if (!parse_name(name, rung, block) || rung != plan_.rung || (block_ >= 0 && block != block_))
      continue;
    File& file = files_[name];
    file.block = block;
    read(name, file, take);
  }
}

void ResultReader::read(const std::string& name, File& file, const Take& take) {
  std::ifstream in(folder_ + "/" + name, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(file.offset));
  const std::string text = next_bytes(in, std::string::npos);
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    take_line(text.substr(begin, end - begin), file, take);
  file.offset += begin;
}

void ResultReader::take_line(const std::string& line, File& file, const Take& take) {
  const std::string head = head_of(plan_.hash);
  if (line.rfind(head, 0) != 0) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_object() && json.contains("of") && json["of"].is_string()) {
      file.of_others++;
      file.other = json["of"];
    } else {
      file.damaged++;
    }
    return;
  }
  const std::string own = "{" + line.substr(head.size());
  const auto json = nlohmann::json::parse(own, nullptr, false);
  const int number = json.is_object() ? json.value("block", -1) : -1;
  if (number < 0) {
    file.damaged++;
    return;
  }
  const std::size_t block = static_cast<std::size_t>(file.block);
  const PlannedWork* work = nullptr;
  if (block < plan_.blocks.size())
    for (const PlannedWork& one : plan_.blocks[block])
      if (one.work.number == number) work = &one;
  AnswerLine read = read_answer(own, number);
  if (read.kind == AnswerLine::Garbage) {
    file.damaged++;
    return;
  }
  const auto asked = [&](int frame) {
    return std::count(work->work.frames.begin(), work->work.frames.end(), frame) > 0;
  };
  if (!work ||
      (read.kind == AnswerLine::Frame &&
       (!asked(read.answer.frame.row.frame) || read.answer.frame.row.guard != work->work.guard)))
    file.not_asked++;
  else take(file.block, *work, std::move(read));
}

std::string ResultReader::refused() const {
  std::string text;
  for (const auto& [name, file] : files_) {
    const auto add = [&text, &name = name](int lines, const std::string& what) {
      if (lines > 0)
        text += fmt::format("results/{}: {} refused: {}\n", name, counted(lines, "line"), what);
    };
    add(file.of_others,
        fmt::format("of another model or sweep, {}; this plan is {}", file.other, plan_.hash));
    add(file.damaged, "damaged");
    add(file.not_asked, "the plan asks this block for no such frame");
  }
  return text;
}

}  // namespace racebeam
