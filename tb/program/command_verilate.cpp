// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_verilate.h"

#include <filesystem>

#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/program/common_options.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

RtlSources sources_of(const VerilateOptions& options) {
  const auto add = [](std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  std::vector<std::string> files = options.files;
  if (files.empty()) files = {rtl_file(options.unit)};
  RtlSources all{options.unit};
  for (const std::string& file : files) {
    const RtlSources some = read_source_list(options.unit, file);
    add(all.files, some.files);
    add(all.include_folders, some.include_folders);
    add(all.defines, some.defines);
    add(all.parameters, some.parameters);
    add(all.libraries, some.libraries);
  }
  add(all.include_folders, options.include_folders);
  add(all.defines, options.defines);
  add(all.parameters, options.parameters);
  add(all.libraries, options.libraries);
  all.signals = options.signals;
  return all;
}

void copy_whole(const std::string& from, const std::string& to) {
  const std::string bytes = whole_file(from);
  OutputFile out(to);
  out.write(bytes.data(), bytes.size());
  out.commit();
}

/// A name as make, ninja and cmake read it in rules.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == ' ' || c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
  }
  return text;
}

/// "OUT: FILE FILE".
std::string rule(const std::string& out, const std::vector<std::string>& files) {
  std::string text = escaped(out) + ":";
  for (const std::string& file : files) text += " " + escaped(file);
  return text + "\n";
}

}  // namespace

int command_verilate(const VerilateOptions& options) {
  const RtlSources sources = sources_of(options);
  copy_whole(rtl_plugin(sources), options.plugin);
  if (!options.dependencies.empty())
    write_text(options.dependencies, rule(options.plugin, read_rtl_syntax(sources).files));
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, VerilateOptions& options) {
  command.add_option("unit", options.unit, "Module; its ports are in UNIT.h below sc/")
      .required()
      .type_name("UNIT");
  const auto words = [&](const char* name, std::vector<std::string>& to, const char* type,
                         const char* help) {
    return command.add_option(name, to, help).type_name(type).check(not_empty);
  };
  words("file", options.files, "FILE", ".sv, .v, a list .f, or a folder; none: the unit's own RTL");
  command.add_option("-o,--output", options.plugin, "Plug-in, for UNIT=OUT.so")
      .required()
      .type_name("OUT.so")
      .check(not_empty);
  words("-D,--define", options.defines, "NAME[=VALUE]", "Define a macro; repeatable").repeatable();
  words("-G,--parameter", options.parameters, "NAME=VALUE", "Set a parameter; repeatable")
      .repeatable();
  words("-I,--include", options.include_folders, "DIR", "Folder of includes; repeatable")
      .repeatable();
  words("-y,--library", options.libraries, "PATH",
        "File or folder with modules that no file defines; repeatable")
      .repeatable();
  command.add_flag("--signals", options.signals,
                   "Registers inside can be read, for waveforms; slower");
  command.add_option("--depfile", options.dependencies, "Also write all files read, as for make")
      .type_name("FILE.d")
      .check(not_empty);
}

}  // namespace

Command verilate_row() {
  return make_command<VerilateOptions>(
      "verilate",
      "Make a plug-in of a unit's RTL: for build systems; elsewhere it is made by itself", "Verify",
      "verilate stacks mine.sv -o stacks.so", add_options, command_verilate);
}

}  // namespace racebeam
