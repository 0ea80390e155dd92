// The command line's options, and what their help says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command_bench.h"
#include "tb/program/command_explain.h"
#include "tb/program/command_render.h"
#include "tb/program/command_scene.h"
#include "tb/program/command_trace.h"
#include "tb/program/command_verify.h"
#include "tb/program/command_verilate.h"
#include "tb/program/command_view.h"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace racebeam {

/// Each adds the command of that name to `app`; its options go to `options`, which outlive it.
void add_render(CLI::App& app, RenderOptions& options);
void add_bench(CLI::App& app, BenchOptions& options);
void add_verify(CLI::App& app, VerifyOptions& options);
void add_verilate(CLI::App& app, VerilateOptions& options);
void add_scene(CLI::App& app, SceneOptions& options);
void add_view(CLI::App& app, ViewOptions& options);
void add_explain(CLI::App& app, ExplainOptions& options);
void add_trace(CLI::App& app, TraceOptions& options);

/// The options of a Tiny Tapeout chip, of a command that can run one.
void add_tt_options(CLI::App& command, TtOptions& options);

/// Refuses an empty name.
const CLI::Validator& not_empty();

}  // namespace racebeam
