// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_library.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

#include "sc/swap/built_in_plugin.h"
#include "sc/swap/rtl_power_up.h"
#include "sc/swap/rtl_run.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

using Maker = std::function<rtl_model*()>;

// Verilator's run time keeps some names for as long as it is loaded, which LeakSanitizer knows only
// while it is.
#ifdef __SANITIZE_ADDRESS__
constexpr int Loading = RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE;
#else
constexpr int Loading = RTLD_NOW | RTLD_LOCAL;
#endif

std::map<std::string, Maker>& built_in() {
  static std::map<std::string, Maker> all;
  return all;
}

std::shared_ptr<void> load(const std::string& path) {
  if (built_in().count(path)) return nullptr;
  // A name without a slash would be looked for in the system's folders.
  void* library = dlopen(fs::absolute(path).c_str(), Loading);
  if (library) return {library, dlclose};
  if (!fs::exists(path))
    throw RtlError("there is no plug-in " + path + "; make one with `racebeam verilate`");
  throw RtlError(path + " cannot be loaded: " + dlerror());
}

std::unique_ptr<rtl_model, void (*)(rtl_model*)> make(const std::shared_ptr<void>& library,
                                                      const std::string& path) {
  if (const auto own = built_in().find(path); own != built_in().end()) {
    rtl_model* model = own->second();
    return {model, model->destroy};
  }
  const auto maker = reinterpret_cast<rtl_maker>(dlsym(library.get(), "rtl_make_7"));
  if (!maker)
    throw RtlError(path + " is no plug-in of this racebeam; make one with `racebeam verilate`");
  const rtl_power_up start = RtlPowerUp::now();
  if (const auto set =
          reinterpret_cast<rtl_power_up_setter>(dlsym(library.get(), "rtl_power_up_1")))
    set(start);
  else if (start.registers != RtlZeros)
    throw RtlError(path + " was built before there was a choice of power-up; build it again");
  rtl_model* model = maker(&rtl_run_host());
  return {model, model->destroy};
}

std::string widths(int wanted, int got) {
  return std::to_string(got) + (got == 1 ? " bit" : " bits") + " wide instead of " +
         std::to_string(wanted);
}

}  // namespace

built_in_plugin::built_in_plugin(std::function<rtl_model*()> make) {
  static int number = 0;
  name_ = "built in: " + std::to_string(++number);
  built_in()[name_] = std::move(make);
}
built_in_plugin::~built_in_plugin() { built_in().erase(name_); }

rtl_library::rtl_library(const std::string& plugin)
    : library_(load(plugin)), model_(make(library_, plugin)) {}

void rtl_library::evaluate(void (*step)(void*)) { run_rtl(*model_, clocks_, step); }

bool has_rtl_port(const rtl_model& model, const std::string& name) {
  return std::any_of(model.ports, model.ports + model.port_count,
                     [&](const rtl_port& port) { return name == port.name; });
}

const rtl_port& rtl_port_of(const rtl_model& model, const std::string& name) {
  for (int n = 0; n < model.port_count; ++n)
    if (name == model.ports[n].name) return model.ports[n];
  throw RtlError("the RTL has no port " + name);
}

std::string rtl_place(const rtl_model& model) {
  std::istringstream words(model.remarks);  // the top is the first
  std::string kind, place;
  words >> kind;
  std::getline(words >> std::ws, place);
  return place.substr(0, place.rfind(' '));
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
      if (pin.is_optional) continue;
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

}  // namespace racebeam
