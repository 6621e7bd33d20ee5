// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lithe/bake/compare.h"

namespace lithe::bake {

namespace {

using Json = nlohmann::ordered_json;

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  char line[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  return line;
}

std::string frameLine(const std::string& name, const SurfaceError& e, double silhouette, bool has_uv) {
  std::string line = formatted("%-24.24s %10.3e %10.3e %10.3e %10.3e %8.2f %8.3f %10.3f", name.c_str(), e.rms, e.mean,
                               e.p999, e.max, e.normal_degrees, 100.0 * e.flipped, 100.0 * silhouette);
  if (has_uv) line += formatted(" %10.3e %10.3e %10.4f", e.uv_rms, e.uv_median, e.uv_stretch);
  return line + "\n";
}

std::string nameOf(const FrameReport& frame, size_t index) {
  return frame.clip.empty() ? "pose " + std::to_string(index) : frame.clip + formatted(" %.3f s", frame.time);
}

/// Which figures a report has.
struct Measured {
  bool uv, beyond;
};

Json lengthsAndShares(const SurfaceError& e, Measured measured) {
  Json json = {
      {"rms", e.rms},        {"mean", e.mean}, {"max", e.max}, {"p999", e.p999}, {"normal_degrees", e.normal_degrees},
      {"flipped", e.flipped}};
  if (measured.uv) {
    json["uv_rms"] = e.uv_rms;
    json["uv_median"] = e.uv_median;
    json["uv_stretch"] = e.uv_stretch;
  }
  if (measured.beyond) json["beyond"] = e.beyond;
  return json;
}

Json frameJson(const FrameReport& frame, Measured measured) {
  return {{"clip", frame.clip},
          {"time", frame.time},
          {"original_to_simplified", lengthsAndShares(frame.original_to_simplified, measured)},
          {"simplified_to_original", lengthsAndShares(frame.simplified_to_original, measured)},
          {"symmetric", lengthsAndShares(frame.symmetric, measured)},
          {"silhouette", frame.silhouette},
          {"seam_gap", frame.seam.gap},
          {"seam_opened", frame.seam.opened}};
}

Json meshJson(uint32_t triangles, uint32_t vertices) { return {{"triangles", triangles}, {"vertices", vertices}}; }

}  // namespace

std::string compareText(const CompareReport& r) {
  std::string text = formatted("original    %9u triangles %9u vertices\n", r.original_triangles, r.original_vertices);
  text += formatted("simplified  %9u triangles %9u vertices (%.2f %% of the triangles)\n", r.simplified_triangles,
                    r.simplified_vertices, 100.0 * r.simplified_triangles / r.original_triangles);
  text += formatted("%zu frames, %u samples each way; lengths as fractions of the rest diagonal, %.6g\n\n",
                    r.frames.size(), r.samples, r.rest_diagonal);
  text += formatted("%-24s %10s %10s %10s %10s %8s %8s %10s", "frame", "rms", "mean", "99.9 %", "max", "normal",
                    "flipped", "silhouette");
  text += r.has_uv ? formatted(" %10s %10s %10s\n", "uv rms", "uv median", "uv stretch") : "\n";
  text += formatted("%-24s %10s %10s %10s %10s %8s %8s %10s", "", "", "", "", "", "degrees", "% area", "% area");
  text += r.has_uv ? formatted(" %10s %10s %10s\n", "", "", "mean ln") : "\n";
  for (size_t i = 0; i < r.frames.size(); ++i)
    text += frameLine(nameOf(r.frames[i], i), r.frames[i].symmetric, r.frames[i].silhouette, r.has_uv);
  text += frameLine("mean of frames", r.mean, r.mean_silhouette, r.has_uv);
  text += frameLine("worst frame", r.worst, r.worst_silhouette, r.has_uv);
  text += formatted("\nrms_mean %.4e (%.6g units), largest distance %.4e (%.6g units)\n", r.mean.rms,
                    r.mean.rms * r.rest_diagonal, r.worst.max, r.worst.max * r.rest_diagonal);
  if (r.beyond) {
    text += formatted("farther than %.6g units: %.3f %% of the samples, %.3f %% in the worst frame\n", *r.beyond,
                      100.0 * r.mean.beyond, 100.0 * r.worst.beyond);
  }
  text += formatted("seams: widest gap %.3e, opened against the original %.3e; weights off one by at most %.1e\n",
                    r.seam.gap, r.seam.opened, r.weight_sum_error);
  return text;
}

std::string compareJson(const CompareReport& r) {
  const Measured measured{r.has_uv, r.beyond.has_value()};
  Json json;
  json["original"] = meshJson(r.original_triangles, r.original_vertices);
  json["simplified"] = meshJson(r.simplified_triangles, r.simplified_vertices);
  json["rest_diagonal"] = r.rest_diagonal;
  json["samples"] = r.samples;
  if (r.beyond) json["beyond_absolute"] = *r.beyond;
  json["rms_mean"] = r.mean.rms;
  json["rms_mean_absolute"] = r.mean.rms * r.rest_diagonal;
  json["max"] = r.worst.max;
  json["max_absolute"] = r.worst.max * r.rest_diagonal;
  json["mean_of_frames"] = lengthsAndShares(r.mean, measured);
  json["worst_frame"] = lengthsAndShares(r.worst, measured);
  json["mean_of_frames"]["silhouette"] = r.mean_silhouette;
  json["worst_frame"]["silhouette"] = r.worst_silhouette;
  json["seam_gap"] = r.seam.gap;
  json["seam_opened"] = r.seam.opened;
  json["weight_sum_error"] = r.weight_sum_error;
  for (const FrameReport& frame : r.frames) json["frames"].push_back(frameJson(frame, measured));
  return json.dump(2) + "\n";
}

}  // namespace lithe::bake
