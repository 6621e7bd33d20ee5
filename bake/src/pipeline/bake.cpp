// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/bake.h"

#include <algorithm>
#include <chrono>

#include "attribute_choice.h"
#include "levels.h"
#include "lithe/bake/hierarchy.h"
#include "lithe/bake/simplify.h"
#include "lithe/bake/weld.h"
#include "weight_bits.h"

namespace lithe::bake {
namespace {

void checkRange(const char* option, uint32_t value, uint32_t least, uint32_t greatest) {
  if (value < least || value > greatest)
    throw Error(std::string(option) + " is " + std::to_string(value) + ": it must be " + std::to_string(least) +
                " to " + std::to_string(greatest));
}

void checkOptions(const BakeOptions& options) {
  checkRange("--max-influences", options.max_influences, 1, 8);
  checkRange("--position-bits", options.position_bits, 8, 16);
  checkRange("--normal-bits", options.normal_bits, 4, 15);
  checkRange("--uv-bits", options.uv_bits, 4, 16);
  if (options.weight_bits != 0) checkRange("--weight-bits", options.weight_bits, 4, 16);
  checkRange("--precision", options.precision, 0, 31);
  for (double share : options.levels)
    if (!(share > 0.0 && share <= 1.0)) throw Error("--levels: every share must be above 0 and at most 1");
}

/// Runs the stages, timing each.
class Pipeline {
 public:
  Pipeline(const Model& model, const BakeOptions& options, BakeReport& report)
      : model_(model), options_(options), report_(report) {}

  std::vector<uint8_t> run() {
    stage("poses", [&] { poses_ = choosePoses(model_, options_.poses); });
    stage("weld", [&] { mesh_ = weld(model_, poses_, weldOptions(), report_.warnings); });
    stage("simplify", [&] { sequence_ = simplify(mesh_, model_.joints, poses_, simplifyOptions()); });
    stage("hierarchy", [&] { hierarchy_ = buildHierarchy(mesh_, sequence_, options_.precision); });
    stage("measure", [&] {
      levels_ = planLevels(sequence_, mesh_, options_.levels);
      measureLevels(model_, mesh_, sequence_, poses_, options_.threads, levels_, progressOf("measure"));
    });
    std::vector<uint8_t> bytes;
    EncodeReport encoded;
    const double posed_diagonal = posedDiagonal(model_, poses_);
    stage("encode", [&] {
      bytes = encodeFile({model_, mesh_, hierarchy_, levels_, options_.precision, posed_diagonal}, &encoded);
    });
    fillReport(encoded, posed_diagonal);
    return bytes;
  }

 private:
  template <typename Work>
  void stage(const char* name, const Work& work) {
    if (options_.progress) options_.progress(name, 0.0);
    const auto begin = std::chrono::steady_clock::now();
    work();
    report_.stages.push_back({name, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
    if (options_.progress) options_.progress(name, 1.0);
  }

  std::function<void(double)> progressOf(const char* name) const {
    if (!options_.progress) return {};
    return [this, name](double progress) { options_.progress(name, progress); };
  }

  WeldOptions weldOptions() {
    WeldOptions weld;
    weld.position_bits = options_.position_bits;
    weld.weight_bits =
        options_.weight_bits ? options_.weight_bits : chooseWeightBits(model_, poses_, options_.position_bits);
    report_.weight_bits = weld.weight_bits;
    weld.normal_bits = options_.normal_bits;
    weld.uv_bits = options_.uv_bits;
    weld.max_influences = options_.max_influences;
    weld.attributes = chooseAttributes(model_, options_.attributes, report_.warnings);
    return weld;
  }

  SimplifyOptions simplifyOptions() const {
    SimplifyOptions simplify;
    simplify.metric = options_.metric;
    simplify.placement_shift = options_.precision;
    simplify.threads = options_.threads;
    simplify.refit = options_.refit;
    simplify.min_triangles = mesh_.triangleCount();
    for (double share : options_.levels) {
      simplify.levels.push_back(trianglesOf(share, mesh_));
      simplify.min_triangles = std::min(simplify.min_triangles, simplify.levels.back());
    }
    simplify.progress = progressOf("simplify");
    return simplify;
  }

  void fillReport(const EncodeReport& encoded, double posed_diagonal) {
    report_.poses = static_cast<uint32_t>(poses_.size());
    report_.source_triangles = static_cast<uint32_t>(model_.triangles.size());
    report_.source_vertices = static_cast<uint32_t>(model_.positions.size());
    report_.rest_diagonal = model_.rest_diagonal;
    report_.posed_diagonal = posed_diagonal;
    report_.kinds = encoded.kinds;
    report_.head_bytes = encoded.head_bytes;
    report_.file_bytes = encoded.file_bytes;
    for (size_t i = 0; i < levels_.size(); ++i)
      report_.levels.push_back({static_cast<double>(encoded.levels[i].triangles) / encoded.levels.back().triangles,
                                encoded.levels[i].triangles, encoded.levels[i].vertices, encoded.levels[i].bytes_end,
                                levels_[i].error, levels_[i].error_rms});
  }

  const Model& model_;
  const BakeOptions& options_;
  BakeReport& report_;
  std::vector<Pose> poses_;
  Mesh mesh_;
  CollapseSequence sequence_;
  Hierarchy hierarchy_;
  std::vector<LevelPlan> levels_;
};

}  // namespace

std::vector<uint8_t> bake(const Model& model, const BakeOptions& options, BakeReport* report) {
  checkOptions(options);
  BakeReport unused;
  BakeReport& out = report ? *report : unused;
  out = {};
  out.warnings = model.warnings;
  return Pipeline(model, options, out).run();
}

}  // namespace lithe::bake
