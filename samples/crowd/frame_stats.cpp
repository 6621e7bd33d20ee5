// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "frame_stats.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  char line[256];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(line, sizeof line, pattern, arguments);
  va_end(arguments);
  return line;
}

double megabytes(uint64_t bytes) { return static_cast<double>(bytes) / 1e6; }

}  // namespace

std::string grouped(uint64_t value) {
  std::string digits = std::to_string(value);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

void countDraws(const sample::DrawList& list, std::span<const sample::Character> characters, FrameStats& stats) {
  stats.seen = list.size();
  stats.draws = static_cast<uint32_t>(list.draws().size());
  for (uint32_t i = 0; i < list.size(); ++i) {
    const lithe_instance& instance = list.instance(i);
    const sample::Character& character = characters[instance.asset];
    stats.finest_triangles += character.info.triangle_count;
    if (instance.level == LITHE_UNDRAWN) continue;
    if (stats.levels.size() <= instance.level) stats.levels.resize(instance.level + 1u);
    LevelCount& count = stats.levels[instance.level];
    ++count.instances;
    count.triangles += character.levels[instance.level].triangle_count;
  }
  for (const LevelCount& count : stats.levels) stats.triangles += count.triangles;
}

std::vector<std::string> textLines(const FrameStats& stats) {
  return {
      grouped(stats.seen) + " of " + grouped(stats.instances) + " instances seen",
      grouped(stats.triangles) + " triangles, " + std::to_string(stats.draws) + " draws",
      grouped(stats.finest_triangles) + " at the finest levels",
      format("%.2f of %.2f MB streamed at %.1f s", megabytes(stats.streamed_bytes), megabytes(stats.file_bytes),
             stats.seconds),
      format("%.1f MB resident, %.1f MB on the GPU", megabytes(stats.resident_bytes), megabytes(stats.gpu_bytes)),
      std::isfinite(stats.largest_error_px) ? format("errors of at most %.2f pixels", stats.largest_error_px)
                                            : "the coarsest levels, which are more than the budget",
      format("levels chosen in %.3f ms", stats.select_ms + stats.draws_ms),
  };
}

nlohmann::ordered_json toJson(const FrameStats& stats) {
  nlohmann::ordered_json json{{"seconds", stats.seconds},
                              {"instances", stats.instances},
                              {"seen", stats.seen},
                              {"limited", stats.limited},
                              {"triangles", stats.triangles},
                              {"finest_triangles", stats.finest_triangles},
                              {"shadow_triangles", stats.shadow_triangles},
                              {"draws", stats.draws},
                              {"resident_bytes", stats.resident_bytes},
                              {"gpu_bytes", stats.gpu_bytes},
                              {"streamed_bytes", stats.streamed_bytes},
                              {"file_bytes", stats.file_bytes},
                              {"largest_error_px", stats.largest_error_px},
                              {"select_ms", stats.select_ms},
                              {"draws_ms", stats.draws_ms},
                              {"resident_levels", stats.resident}};
  for (const LevelCount& level : stats.levels) {
    json["levels"].push_back({{"instances", level.instances}, {"triangles", level.triangles}});
  }
  return json;
}
