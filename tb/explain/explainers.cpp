// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/explainers.h"

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/explain/block_explanation.h"
#include "tb/explain/explain_json.h"
#include "tb/explain/explain_text.h"
#include "tb/explain/sphere_explanation.h"
#include "tb/explain/voxel_explanation.h"

namespace racebeam {

namespace {

Explainer::Size beam_size(const Run&, int) { return {VisibleColumns, VisibleRows}; }

std::string beam_text(const Run& run, const ExplainedPixel& p, const std::string& repeat) {
  return explain_text({run.show, run.k, p.frame, p.column, p.row}, repeat);
}

std::string beam_json(const Run& run, const ExplainedPixel& p, const std::string& repeat) {
  return explain_json({run.show, run.k, p.frame, p.column, p.row}, run.k, repeat);
}

}  // namespace

const std::vector<Explainer>& explainers() {
  static const std::vector<Explainer> table = {
      {beam_engine(), beam_size, beam_text, beam_json},
      {sphere_engine(), sphere_size, sphere_explain_text, sphere_explain_json},
      {block_engine(), block_size_of, block_explain_text, block_explain_json},
      {voxel_engine(), voxel_size_of, voxel_explain_text, voxel_explain_json}};
  return table;
}

const Explainer* explainer_of(const engine& built) {
  for (const Explainer& row : explainers())
    if (&row.engine == &built) return &row;
  return nullptr;
}

}  // namespace racebeam
