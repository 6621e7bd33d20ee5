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

constexpr double kStep = 1.0 / 30;        ///< simulated seconds from one choice of levels to the next
constexpr uint32_t kStepsPerMoment = 10;  ///< of the timeline in crowd.json

std::string pictureName(uint32_t index, const char* suffix = "") {
  char name[48];
  std::snprintf(name, sizeof name, "crowd_%03u%s.png", index, suffix);
  return name;
}

/// The pictures lie evenly on the path, its first and last point included.
double pictureTime(uint32_t index, uint32_t count) { return count < 2 ? 0 : cameraPathSeconds() * index / (count - 1); }

/// The crowd's way along the path, and what crowd.json keeps of it.
class Journey {
 public:
  explicit Journey(Viewer& viewer) : viewer_(viewer) {}

  /// Simulated time runs in even steps whatever the number of pictures, so each picture sees the same pages arrive.
  void advanceTo(double seconds) {
    do {
      const double step = std::min(kStep, seconds - now_);
      now_ += step;
      viewer_.advance(step, cameraAt(now_), true);
      if (steps_++ % kStepsPerMoment == 0) noteMoment();
    } while (now_ < seconds);
  }

  sample::Camera camera() const { return cameraAt(now_); }
  const nlohmann::ordered_json& timeline() const { return timeline_; }

 private:
  void noteMoment() {
    const FrameStats& stats = viewer_.stats();
    timeline_.push_back({{"seconds", stats.seconds},
                         {"triangles", stats.triangles},
                         {"limited", stats.limited},
                         {"streamed_bytes", stats.streamed_bytes},
                         {"gpu_bytes", stats.gpu_bytes}});
  }

  Viewer& viewer_;
  double now_ = 0;
  uint32_t steps_ = 0;
  nlohmann::ordered_json timeline_ = nlohmann::ordered_json::array();
};

void printFrame(const std::string& name, const FrameStats& stats) {
  std::printf("%s\n", name.c_str());
  for (const std::string& line : textLines(stats)) std::printf("  %s\n", line.c_str());
  std::printf("  instances per level:");
  for (const LevelCount& level : stats.levels) std::printf(" %u", level.instances);
  std::printf("\n");
  std::fflush(stdout);
}

/// What the camera sees now, as one picture or as two.
nlohmann::ordered_json writePicture(Viewer& viewer, const sample::Camera& camera, uint32_t index,
                                    const Options& options) {
  viewer.draw(camera, options.level_colors);
  sample::writePng(viewer.target().read(), options.output / pictureName(index));
  printFrame(pictureName(index), viewer.stats());
  nlohmann::ordered_json json{{"picture", pictureName(index)}};
  if (options.both) {
    viewer.draw(camera, true);
    sample::writePng(viewer.target().read(), options.output / pictureName(index, "_levels"));
    json["levels_picture"] = pictureName(index, "_levels");
  }
  json.update(toJson(viewer.stats()));
  return json;
}

void writePictures(const Options& options) {
  const sample::Headless context;
  Viewer viewer(options);
  std::filesystem::create_directories(options.output);
  nlohmann::ordered_json json{{"threshold_px", options.threshold_px}, {"bytes_per_second", options.bytes_per_second}};
  Journey journey(viewer);
  for (uint32_t i = 0; i < options.frames; ++i) {
    journey.advanceTo(pictureTime(i, options.frames));
    json["pictures"].push_back(writePicture(viewer, journey.camera(), i, options));
  }
  json["timeline"] = journey.timeline();
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
