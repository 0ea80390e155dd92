// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/constant_bits.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "sc/base/fixed_point.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

using Json = nlohmann::json;

constexpr const char* Recipe = "4";  ///< another one whenever the answer may be another
constexpr const char* Dut = "dut";
constexpr int Tries = 4096;

/// A module around the RTL whose inputs are tied, so that its own bits are what is asked about.
std::string wrapper_of(const RtlSources& sources, const RtlSyntax& syntax,
                       const std::map<std::string, TiedBits>& tied) {
  std::string ports, pins, parameters;
  for (const RtlSyntax::Port& port : syntax.ports) {
    ports += fmt::format("{}  {} wire [{}:0] {}", ports.empty() ? "" : ",\n", port.direction,
                         port.bits - 1, port.name);
    const auto at = tied.find(port.name);
    std::string pin = port.name;
    if (at != tied.end()) {
      std::string bits;
      for (int bit = port.bits; bit-- > 0;)
        bits += fmt::format("{}{}", bits.empty() ? "" : ", ",
                            at->second.zeros >> bit & 1  ? "1'b0"
                            : at->second.ones >> bit & 1 ? "1'b1"
                                                         : fmt::format("{}[{}]", port.name, bit));
      pin = "{" + bits + "}";
    }
    pins += fmt::format("{}    .{}({})", pins.empty() ? "" : ",\n", port.name, pin);
  }
  for (const std::string& parameter : sources.parameters) {
    const std::size_t split = parameter.find('=');
    parameters += fmt::format("{}.{}({})", parameters.empty() ? "" : ", ",
                              parameter.substr(0, split), parameter.substr(split + 1));
  }
  return fmt::format("module signoff_tied (\n{}\n);\n  {} #({}) {} (\n{}\n  );\nendmodule\n", ports,
                     sources.top, parameters, Dut, pins);
}

/// Each "FILE:LINE" of "FILE:9.4-9.60|FILE:87.3-87.9": where a signal is declared and, in any
/// order, where the instances around it are.
std::vector<std::string> places_of(const std::string& source) {
  std::vector<std::string> places;
  std::istringstream parts(source);
  for (std::string one; std::getline(parts, one, '|');)
    places.push_back(one.substr(0, one.find('.', one.rfind(':'))));
  return places;
}

/// The last part of a name after flattening: of "dut.g_x[0].u_x.sp_q" "sp_q", of "dut.tags_q[3]"
/// "tags_q[3]".
std::string last_part(const std::string& name) { return name.substr(name.rfind('.') + 1); }

/// Bits that are "x" have lost their driver, which says nothing. A signal counts at all its places:
/// no other one of that name is declared where an instance is.
std::vector<std::string> constants_in(const Json& netlist) {
  std::set<std::string> constant, moving;
  for (const auto& [module, contents] : netlist.at("modules").items())
    for (const auto& [name, signal] : contents.at("netnames").items()) {
      if (signal.value("hide_name", 0) != 0 || name.rfind(std::string(Dut) + ".", 0) != 0) continue;
      const Json& attributes = signal.at("attributes");
      if (!attributes.contains("src")) continue;
      const Json& bits = signal.at("bits");
      const int offset = signal.value("offset", 0);
      for (const std::string& place : places_of(attributes.at("src").get<std::string>())) {
        const std::string stem = place + " " + last_part(name);
        for (std::size_t n = 0; n < bits.size(); ++n) {
          auto& bin = bits[n] == "0" || bits[n] == "1" ? constant : moving;
          bin.insert(stem + "[" + std::to_string(static_cast<int>(n) + offset) + "]");
          if (bits.size() == 1) bin.insert(stem);
        }
      }
    }
  std::vector<std::string> all;
  std::set_difference(constant.begin(), constant.end(), moving.begin(), moving.end(),
                      std::back_inserter(all));
  return all;
}

void find_constants(const RtlSources& sources, const RtlSyntax& syntax, const std::string& wrapper,
                    const std::string& out) {
  const WorkFolder work;
  work.write("tied.sv", wrapper);
  std::vector<std::string> packages, modules;
  for (const std::string& file : syntax.files) {
    const std::string stem = std::filesystem::path(file).stem().string();
    const bool package = stem.size() > 4 && stem.compare(stem.size() - 4, 4, "_pkg") == 0;
    (package ? packages : modules).push_back(file);
  }
  // The base package comes first: others name it.
  std::stable_partition(packages.begin(), packages.end(), [](const std::string& file) {
    return file.find("racebeam_pkg") != std::string::npos;
  });
  std::string script;
  for (const auto* files : {&packages, &modules})
    for (const std::string& file : *files) script += "read_verilog -sv " + file + "\n";
  script += "read_verilog -sv " + work.file("tied.sv") +
            "\nprep -flatten -top signoff_tied\nmemory_map\nopt -full\nwrite_json " +
            work.file("netlist.json") + "\n";
  work.write("script.ys", script);
  const ToolResult result = run_tool({{"yosys", "-q", "-s", work.file("script.ys")}, "", {}, {}});
  if (!result.good)
    throw RtlError("yosys cannot read the RTL of " + sources.top + ":\n" + result.said);
  const Json found = constants_in(Json::parse(whole_file(work.file("netlist.json"))));
  OutputFile file(out);
  const std::string text = found.dump();
  file.write(text.data(), text.size());
  file.commit();
}

}  // namespace

std::map<std::string, TiedBits> tied_inputs(const LegalInputs& legal,
                                            const std::vector<RtlSyntax::Port>& ports) {
  std::map<std::string, TiedBits> tied;
  std::mt19937_64 random(1);
  for (const RtlSyntax::Port& port : ports) {
    if (port.direction != "input" || port.bits > 64) continue;
    std::uint64_t seen_one = 0, seen_zero = 0;
    const auto look = [&](std::uint64_t raw) {
      const std::uint64_t value = legal.of(port.name, raw_bits(raw, port.bits));
      seen_one |= value;
      seen_zero |= ~value;
    };
    for (int bit = 0; bit < port.bits; ++bit) {
      look(std::uint64_t{1} << bit);
      look(~(std::uint64_t{1} << bit));
    }
    for (int n = 0; n < Tries; ++n) look(random());
    const TiedBits bits{raw_bits(~seen_one, port.bits), raw_bits(~seen_zero, port.bits)};
    if (bits.zeros != 0 || bits.ones != 0) tied[port.name] = bits;
  }
  return tied;
}

ConstantBits::ConstantBits(const RtlSources& sources, const std::map<std::string, TiedBits>& tied) {
  if (!has_tool("yosys")) throw MissingTool("yosys is not installed; install the package `yosys`");
  const RtlSyntax syntax = read_rtl_syntax(sources);
  const std::string wrapper = wrapper_of(sources, syntax, tied);
  std::vector<std::string> parts = {Recipe, wrapper};
  for (const std::string& file : syntax.files) parts.insert(parts.end(), {file, file_key(file)});
  const std::string path =
      cached("constant-" + content_key(parts) + ".json",
             [&](const std::string& out) { find_constants(sources, syntax, wrapper, out); });
  for (const Json& bit : Json::parse(whole_file(path))) bits_.insert(bit.get<std::string>());
}

bool ConstantBits::has(const std::string& file, int line, const std::string& bit) const {
  return bits_.count(fmt::format("{}:{} {}", file, line, bit)) != 0;
}

}  // namespace racebeam
