// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A crowd of skinned characters that streams in while the camera moves. Without --window it writes pictures.
#include <cstdio>
#include <fstream>

#include "camera_path.h"
#include "error.h"
#include "headless.h"
#include "options.h"
#include "viewer.h"
#include "window.h"

namespace {

constexpr double kStep = 1.0 / 30;  ///< simulated seconds from one choice of levels to the next

std::string pictureName(uint32_t index) {
  char name[32];
  std::snprintf(name, sizeof name, "crowd_%03u.png", index);
  return name;
}

/// The pictures lie evenly on the path, its first and last point included.
double pictureTime(uint32_t index, uint32_t count) { return count < 2 ? 0 : cameraPathSeconds() * index / (count - 1); }

/// Simulated time runs in even steps whatever the number of pictures, so each picture sees the same pages arrive.
void advanceTo(Viewer& viewer, double& now, double seconds) {
  do {
    const double step = std::min(kStep, seconds - now);
    now += step;
    viewer.advance(step, cameraAt(now), true);
  } while (now < seconds);
}

void printFrame(const std::string& name, const FrameStats& stats) {
  std::printf("%s\n", name.c_str());
  for (const std::string& line : textLines(stats)) std::printf("  %s\n", line.c_str());
  std::printf("  instances per level:");
  for (const LevelCount& level : stats.levels) std::printf(" %u", level.instances);
  std::printf("\n");
  std::fflush(stdout);
}

void writePictures(const Options& options) {
  const sample::Headless context;
  Viewer viewer(options);
  std::filesystem::create_directories(options.output);
  nlohmann::ordered_json json{{"threshold_px", options.threshold_px}, {"bytes_per_second", options.bytes_per_second}};
  double now = 0;
  for (uint32_t i = 0; i < options.frames; ++i) {
    advanceTo(viewer, now, pictureTime(i, options.frames));
    viewer.draw(cameraAt(now), options.level_colors);
    sample::writePng(viewer.target().read(), options.output / pictureName(i));
    printFrame(pictureName(i), viewer.stats());
    nlohmann::ordered_json picture = toJson(viewer.stats());
    picture["picture"] = pictureName(i);
    json["pictures"].push_back(std::move(picture));
  }
  std::ofstream(options.output / "crowd.json") << json.dump(2) << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = readOptions(argc, argv);
  try {
    if (options.window)
      runWindow(options);
    else
      writePictures(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lithe_crowd: %s\n", error.what());
    return 1;
  }
}
