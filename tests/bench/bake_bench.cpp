// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// How fast characters are simplified, with and without refit, and how much memory that takes.
//
//     bench_bake [50k|200k|1M|figure ...] [--threads N]
//
// Prints markdown: the named characters in 16 poses; when none is named all of them, and then the first in 4 to 32.
// ktris are thousands of the finest level's triangles, from there to the coarsest of the default levels. Seconds are
// the processor's, of all threads together and the best of three runs: what else the machine does matters less then.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "counted_heap.h"
#include "dense_figure.h"
#include "lithe/bake/bake.h"
#include "lithe/bake/poses.h"
#include "lithe/bake/simplify.h"
#include "lithe/bake/weld.h"
#include "timing.h"

namespace lithe::bench {
namespace {

constexpr uint32_t kRuns = 3;
constexpr uint32_t kPoses = 16;

struct Case {
  bake::Model model;
  bake::Mesh mesh;
  std::vector<bake::Pose> poses;

  Case(const std::string& name, uint32_t pose_count) : model(denseFigure(name)) {
    bake::PoseOptions options;
    options.count = pose_count;
    poses = bake::choosePoses(model, options);
    std::vector<std::string> warnings;
    mesh = bake::weld(model, poses, {}, warnings);
  }
};

struct Cost {
  double cpu_seconds = std::numeric_limits<double>::infinity();
  double wall_seconds = std::numeric_limits<double>::infinity();
  uint64_t peak_bytes = 0;  ///< beyond what was there before, the result included
};

double cpuSeconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

bake::SimplifyOptions optionsFor(const bake::Mesh& mesh, bool refit, uint32_t threads) {
  bake::SimplifyOptions options;
  options.refit = refit;
  options.threads = threads;
  for (double share : bake::BakeOptions().levels)
    options.levels.push_back(static_cast<uint32_t>(share * mesh.triangleCount()));
  options.min_triangles = options.levels.back();
  return options;
}

Cost costOf(const Case& of, bool refit, uint32_t threads) {
  const bake::SimplifyOptions options = optionsFor(of.mesh, refit, threads);
  Cost best;
  for (uint32_t run = 0; run < kRuns; ++run) {
    const uint64_t before = startPeak();
    const double cpu = cpuSeconds();
    const double wall = secondsOf([&] { bake::simplify(of.mesh, of.model.joints, of.poses, options); });
    best.cpu_seconds = std::min(best.cpu_seconds, cpuSeconds() - cpu);
    best.wall_seconds = std::min(best.wall_seconds, wall);
    best.peak_bytes = peakBytes() - before;
  }
  return best;
}

void printHead() {
  std::printf(
      "| character | triangles | vertices | poses | no refit: s | ktris/s per core | refit: s | wall s | ktris/s per "
      "core | peak bytes per vertex |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
}

void printRow(const std::string& name, uint32_t pose_count, uint32_t threads) {
  const Case of(name, pose_count);
  const Cost plain = costOf(of, false, threads), refit = costOf(of, true, threads);
  const double ktris = 1e-3 * of.mesh.triangleCount();
  std::printf("| %s | %u | %u | %zu | %.2f | %.0f | %.2f | %.2f | %.1f | %.0f |\n", name.c_str(),
              of.mesh.triangleCount(), of.mesh.vertexCount(), of.poses.size(), plain.cpu_seconds,
              ktris / plain.cpu_seconds, refit.cpu_seconds, refit.wall_seconds, ktris / refit.cpu_seconds,
              static_cast<double>(refit.peak_bytes) / of.mesh.vertexCount());
  std::fflush(stdout);
}

void run(const std::vector<std::string>& named, uint32_t threads) {
  const std::vector<std::string> names = named.empty() ? denseFigureNames() : named;
  printHead();
  for (const std::string& name : names) printRow(name, kPoses, threads);
  if (!named.empty()) return;
  std::printf("\n");
  printHead();
  for (uint32_t pose_count : {4u, 8u, 16u, 32u}) printRow(names.front(), pose_count, threads);
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) try {
  std::vector<std::string> names;
  uint32_t threads = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--threads" && i + 1 < argc) {
      threads = static_cast<uint32_t>(std::atoi(argv[++i]));
    } else {
      names.push_back(argument);
    }
  }
  lithe::bench::run(names, threads);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
