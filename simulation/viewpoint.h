#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "scene/scene.h"
#include "simulation/camera.h"
#include "simulation/channels.h"
#include "simulation/picture.h"
#include "simulation/profile.h"
#include "simulation/rays.h"

namespace unietp {

/// From where a picture is taken: the agent's own eye; a camera that follows it from behind; one above the whole home.
enum class Viewpoint : std::uint8_t { Agent, Behind, Above };
inline constexpr std::array kViewpoints{Viewpoint::Agent, Viewpoint::Behind, Viewpoint::Above};
std::string_view name_of(Viewpoint viewpoint);  // "agent", "behind", "above"
/// nullopt for an unknown name.
std::optional<Viewpoint> viewpoint_named(std::string_view name);

/// A scene as a camera finds it.
struct Shot {
  Scene scene;
  Camera camera;
};

/// The scene with the agent as a body that can be seen: a last node `agent`, as wide and high as the profile says. What
/// it holds is where its hand is.
Scene with_agent(const Scene& scene, const Profile& profile);

/// Of the picture size of the profile.
/// Agent: the scene as it is, through camera_of.
/// Behind: with_agent, 2.2 m behind the agent and above it, as low as nothing is in between, with 60 degrees from top
/// to bottom; where there is no room for that, nearer.
/// Above: with_agent, all rooms from straight above, north (+y) up, with 25 degrees from top to bottom, so that walls
/// hide little. There are no ceilings.
/// `rays` is scratch space. Deterministic.
Shot shot_of(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Rays& rays);

/// The picture from there: the agent's own is that of picture_of.
Picture picture_from(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Rays& rays);
/// The same pixels as numbers. Of `node`, the size of scene.nodes stands for the agent's body.
Channels channels_from(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Rays& rays);

}  // namespace unietp
