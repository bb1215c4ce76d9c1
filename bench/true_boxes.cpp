// Whether the pixels of pictures and channels, and the boxes and lists of what an agent sees, are those of a ray
// through every pixel, over many views of furnished homes:
//   build/release/bench/true_boxes [VIEWS [PIXELS]]     (10000 views of 300 x 300 pixels in 20 homes)
// Every object of which enough is seen (simulation/visible_box.h) has to be listed with the box around its pixels, and
// no other: without a limit of sight, and within that of the profile. Exit code 1 if one is not; each such view is
// printed.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "bench/furnished_views.h"
#include "simulation/channels.h"
#include "simulation/picture.h"
#include "simulation/view.h"
#include "tests/simulation/by_rays.h"

namespace unietp {
namespace {

struct Counts {
  std::size_t views = 0, boxes = 0, through_glass = 0, wrong = 0;
};

/// What a list of what is seen should be, up to a distance.
std::vector<VisibleObject> expected(const Scene& scene, const Profile& profile,
                                    const std::vector<std::optional<PixelBox>>& boxes, double sight_m) {
  const Vec3 eye(scene.agent.position.x(), scene.agent.position.y(), profile.camera_height_m);
  std::vector<VisibleObject> objects;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i] && (scene.nodes[i].pose.position - eye).norm() <= sight_m)
      objects.push_back({scene.nodes[i].id, *boxes[i]});
  }
  std::sort(objects.begin(), objects.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return objects;
}

std::string text_of(const std::vector<VisibleObject>& objects, const std::vector<VisibleObject>& without) {
  std::string text;
  for (const VisibleObject& one : objects) {
    if (std::find(without.begin(), without.end(), one) != without.end()) continue;
    text += " " + one.id + " [" + std::to_string(one.box[0]) + "," + std::to_string(one.box[1]) + "," +
            std::to_string(one.box[2]) + "," + std::to_string(one.box[3]) + "]";
  }
  return text;
}

void check(const FurnishedViews& seen, Counts& counts) {
  Rays rays;
  for (const Scene& scene : seen.scenes) {
    const Segmentation image = segmentation_of(scene, seen.profile, rays);
    const auto boxes = testing::boxes_by_rays(scene, seen.profile, image, rays);
    bool right = channels_of(scene, camera_of(scene.agent, seen.profile)).node == image.node;
    if (!right) std::printf("view %zu: other pixels\n", counts.views);
    for (const double sight_m : {seen.profile.sight_m, kEndless_m}) {
      const auto listed = Viewer(scene).view(viewed(scene), scene.agent, seen.profile, sight_m);
      const auto by_rays = expected(scene, seen.profile, boxes, sight_m);
      if (right && listed != by_rays) {
        std::printf("view %zu: listed%s; by rays%s\n", counts.views, text_of(listed, by_rays).c_str(),
                    text_of(by_rays, listed).c_str());
        std::fflush(stdout);
      }
      right = right && listed == by_rays;
      if (sight_m == kEndless_m) counts.boxes += listed.size();
    }
    counts.through_glass += image.through.empty() ? 0 : 1;
    counts.wrong += right ? 0 : 1;
    ++counts.views;
  }
}

}  // namespace
}  // namespace unietp

int main(int argc, char** argv) {
  using namespace unietp;
  constexpr std::size_t kHomes = 5;  // of each simulator
  const int views = argc > 1 ? std::atoi(argv[1]) : 10000, pixels = argc > 2 ? std::atoi(argv[2]) : 300;
  if (views < 20 || pixels < 16 || pixels > 1024) {
    std::fprintf(stderr, "usage: true_boxes [VIEWS [PIXELS]]; at least 20 views, 16 to 1024 pixels\n");
    return 2;
  }
  Counts counts;
  for (const Simulator simulator : kSimulators)
    check(furnished_views(simulator, kHomes, static_cast<std::size_t>(views) / (4 * kHomes), pixels), counts);
  std::printf("%zu views of 20 homes, %zu of them through glass, %zu boxes: %zu views differ\n", counts.views,
              counts.through_glass, counts.boxes, counts.wrong);
  return counts.wrong == 0 ? 0 : 1;
}
