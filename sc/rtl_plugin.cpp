// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/rtl_plugin.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* Clock = "clk_i";

std::shared_ptr<void> load(const std::string& path) {
  // A name without a slash would be looked for in the system's folders.
  void* library = dlopen(fs::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library) return {library, dlclose};
  if (!fs::exists(path))
    throw RtlError("there is no plug-in " + path +
                   "; build it: scripts/build, or scripts/verilate");
  throw RtlError(path + " cannot be loaded: " + dlerror());
}

std::unique_ptr<rtl_model, void (*)(rtl_model*)> make(const std::shared_ptr<void>& library,
                                                      const std::string& path) {
  const auto maker = reinterpret_cast<rtl_maker>(dlsym(library.get(), "rtl_make"));
  if (!maker) throw RtlError(path + " is no plug-in; make one with scripts/verilate");
  rtl_model* model = maker();
  return {model, model->destroy};
}

// interval_stack_depth -> IntervalStackDepth
std::string parameter_name(const std::string& knob) {
  std::string name;
  bool capital = true;
  for (const char c : knob) {
    if (c != '_') name += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return name;
}

/// The knobs that RTL knows, by the names of its parameters.
std::vector<std::pair<std::string, int>> parameter_values(const knobs& k) {
  std::vector<std::pair<std::string, int>> values;
  for (const auto& row : knob_table()) values.emplace_back(parameter_name(row.name), k.*row.member);
  values.emplace_back("NavigatorBits", k.navigator_bits);
  values.emplace_back("FreeFlight", k.free_flight);
  values.emplace_back("PortalsPerFace", k.portals_per_face);
  return values;
}

/// "Name=value" of the parameters that RTL was built with and `k` wants otherwise.
std::vector<std::string> other_parameters(const rtl_model& model, const knobs& k) {
  std::map<std::string, int> built;  // the last setting counts
  std::istringstream words(model.parameters);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals != std::string::npos)
      built[word.substr(0, equals)] = std::stoi(word.substr(equals + 1));
  }
  std::vector<std::string> other;
  for (const auto& [name, value] : parameter_values(k))
    if (const auto at = built.find(name); at != built.end() && at->second != value)
      other.push_back(name + "=" + std::to_string(value));
  return other;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string widths(int wanted, int got) {
  return std::to_string(got) + (got == 1 ? " bit" : " bits") + " wide instead of " +
         std::to_string(wanted);
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// The folder with scripts/verilate and rtl/: the sources, or where they are installed.
fs::path project_folder() {
  std::error_code error;
  const fs::path installed = program_folder() / "../share/racebeam";
  return fs::exists(installed / "scripts/verilate", error) ? installed : fs::path(RACEBEAM_ROOT);
}

/// Runs scripts/verilate: the plug-in appears whole or not at all. Throws RtlError.
void verilate(const std::string& switches, const std::string& module, const std::string& options,
              const std::vector<std::string>& sources, const std::string& out) {
  const std::string log = out + ".log", fresh = out + "." + std::to_string(getpid());
  std::string command = quoted((project_folder() / "scripts/verilate").string()) + switches + " " +
                        quoted(module) + " " + quoted(fresh) + options;
  for (const std::string& source : sources) command += " " + quoted(fs::absolute(source).string());
  const int status = std::system((command + " >" + quoted(log) + " 2>&1").c_str());
  std::ifstream in(log);
  const std::string said{std::istreambuf_iterator<char>(in), {}};
  std::error_code ignored;
  fs::remove(log, ignored);
  if (status != 0) {
    fs::remove(fresh, ignored);
    throw RtlError("the RTL of " + module + " (" + joined(sources, ", ") +
                   ") cannot be verilated:\n" + said);
  }
  fs::rename(fresh, out);
}

}  // namespace

std::string rtl_plugin_path(const std::string& unit, const knobs& k) {
  std::error_code error;
  fs::path path = program_folder() / "rtl" / (unit + ".so");
  const fs::path installed = program_folder() / "../lib/racebeam" / (unit + ".so");
  if (!fs::exists(path, error) && fs::exists(installed, error)) path = installed;
  const std::vector<std::string> other = other_parameters(path.string(), k);
  if (other.empty()) return path.string();
  const fs::path variant = path.parent_path() / (unit + "." + joined(other, ".") + ".so");
  if (!fs::exists(variant, error) ||
      fs::last_write_time(variant, error) < fs::last_write_time(path, error))
    build_rtl_plugin(unit, {}, other, variant.string());
  return variant.string();
}

std::vector<std::string> other_parameters(const std::string& plugin, const knobs& k) {
  return other_parameters(rtl_library(plugin).model(), k);
}

void build_rtl_plugin(const std::string& unit, std::vector<std::string> sources,
                      const std::vector<std::string>& parameters, const std::string& out) {
  if (sources.empty()) sources = {(project_folder() / "rtl" / (unit + ".sv")).string()};
  std::string options;
  for (const std::string& parameter : parameters) options += " " + quoted("-G" + parameter);
  verilate("", unit, options, sources, out);
}

void build_chip_plugin(const std::string& top, const std::vector<std::string>& sources,
                       const std::string& out) {
  verilate(" --registered", top, "", sources, out);
}

rtl_library::rtl_library(const std::string& plugin)
    : library_(load(plugin)), model_(make(library_, plugin)) {}

const rtl_port& rtl_port_of(const rtl_model& model, const std::string& name) {
  for (int n = 0; n < model.port_count; ++n)
    if (name == model.ports[n].name) return model.ports[n];
  throw RtlError("the RTL has no port " + name);
}

std::string port_faults(const rtl_model& model, const std::vector<rtl_pin>& wanted) {
  std::string faults;
  const auto fault = [&](const std::string& text) { faults += "\n  port " + text; };
  const auto kind = [](bool is_input) { return is_input ? "input" : "output"; };
  std::map<std::string, const rtl_port*> unknown;
  for (int n = 0; n < model.port_count; ++n) unknown[model.ports[n].name] = &model.ports[n];
  for (const rtl_pin& pin : wanted) {
    const auto at = unknown.find(pin.name);
    if (at == unknown.end()) {
      fault(pin.name + " is missing: " + kind(pin.is_input) + ", " + std::to_string(pin.bits) +
            (pin.bits == 1 ? " bit" : " bits"));
      continue;
    }
    const rtl_port& port = *at->second;
    if (port.is_input != pin.is_input)
      fault(pin.name + " is an " + kind(port.is_input) + " instead of an " + kind(pin.is_input));
    else if (port.bits != pin.bits) fault(pin.name + " is " + widths(pin.bits, port.bits));
    unknown.erase(at);
  }
  for (const auto& [name, port] : unknown) fault(name + " is not a port of the unit");
  return faults;
}

rtl_instance::rtl_instance(const std::string& plugin, const std::string& unit,
                           const std::vector<any_port*>& pins, const knobs& k)
    : library_(plugin) {
  if (unit != model().unit)
    throw RtlError(plugin + " holds the unit " + model().unit + ", not " + unit);
  std::vector<rtl_pin> wanted;
  for (const any_port* pin : pins)
    wanted.push_back({pin->port_name(), pin->is_input(), pin->bits()});
  const std::string faults = port_faults(model(), wanted);
  if (!faults.empty())
    throw RtlError(plugin + " does not fit the unit " + unit + "; sc/" + unit +
                   ".h has its ports:" + faults);
  for (any_port* pin : pins) {
    const rtl_port& rtl = rtl_port_of(model(), pin->port_name());
    if (pin->port_name() == std::string(Clock)) clock_ = static_cast<std::uint8_t*>(rtl.data);
    else if (pin->is_input()) inputs_.push_back({pin, value(rtl)});
    else outputs_.push_back({pin, value(rtl)});
  }
  const auto other = other_parameters(model(), k);
  if (!other.empty())
    throw RtlError(plugin + " was built with other parameters; build it with " +
                   joined(other, ", "));
}

int rtl_instance::value::read() const {
  switch (port_->bytes) {
    case 1: return *static_cast<const std::uint8_t*>(port_->data);
    case 2: return *static_cast<const std::uint16_t*>(port_->data);
    default: return static_cast<int>(*static_cast<const std::uint32_t*>(port_->data));
  }
}

void rtl_instance::value::write(int value) const {
  const int raw = value & low_bits(port_->bits);
  switch (port_->bytes) {
    case 1: *static_cast<std::uint8_t*>(port_->data) = static_cast<std::uint8_t>(raw); break;
    case 2: *static_cast<std::uint16_t*>(port_->data) = static_cast<std::uint16_t>(raw); break;
    default: *static_cast<std::uint32_t*>(port_->data) = static_cast<std::uint32_t>(raw);
  }
}

void rtl_instance::settle() {
  bool moved = !settled_;
  if (!settled_)  // the wires are bound by now
    for (auto* side : {&inputs_, &outputs_})
      for (joint& port : *side) port.wire = port.pin->contents();
  settled_ = true;
  for (joint& in : inputs_) {
    const int now = in.wire.value();
    if (now == in.last) continue;
    in.last = now;
    in.rtl.write(now);
    moved = true;
  }
  if (!moved) return;
  if (clock_) *clock_ = 0;
  evaluate();
}

void rtl_instance::edge() {
  if (!clock_) return;
  if (*clock_) {
    *clock_ = 0;
    evaluate();
  }
  *clock_ = 1;
  evaluate();
}

void rtl_instance::drive() {
  for (joint& out : outputs_) {
    const int now = out.rtl.read();
    if (now == out.last) continue;
    out.last = now;
    out.pin->drive_wire(now);
  }
}

void rtl_instance::seek(int frame) {
  private_edges({{"rst_ni", 0}}, 1);
  private_edges({{"rst_ni", 1}, {"frame_end_i", 1}}, frame);
}

void rtl_instance::place(const vec3& position, int room) {
  private_edges({{"rst_ni", 1},
                 {"nav_reset_i", 1},
                 {"start_x_i", position[0]},
                 {"start_y_i", position[1]},
                 {"start_z_i", position[2]},
                 {"start_room_i", room}},
                1);
}

void rtl_instance::private_edges(const std::vector<std::pair<const char*, int>>& inputs,
                                 int edges) {
  for (const auto& [name, value] : inputs) port(name).write(value);
  for (; edges > 0; --edges) edge();
  for (joint& in : inputs_) in.last = NoValue;
}

rtl_instance::value rtl_instance::signal(const std::string& name) const {
  for (int n = 0; n < model().signal_count; ++n)
    if (name == model().signals[n].name) return value(model().signals[n]);
  throw RtlError(std::string("there is no signal ") + name + " in " + model().unit);
}

void rtl_instance::deposit(const std::string& name, int value) {
  signal(name).write(value);
  for (joint& in : inputs_) in.last = NoValue;
}

rtl_instance::value rtl_instance::port(const std::string& name) const {
  return value(rtl_port_of(model(), name));
}

}  // namespace racebeam
