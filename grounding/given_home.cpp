#include "grounding/given_home.h"

#include "grounding/reach.h"
#include "grounding/reachability.h"

namespace unietp {

Home prepare_given_home(Scene scene, const Profile& profile) {
  Home home = prepare_home(std::move(scene), profile);
  home.out_of_reach.assign(home.scene.nodes.size(), false);
  home.stuck = home.out_of_reach;
  for (const std::size_t i : unreached_furniture(home.scene, home.physics, profile, *home.walk))
    home.out_of_reach[i] = true;
  for (std::size_t i = 0; i < home.stuck.size(); ++i)
    home.stuck[i] = what_blocks(home.scene, home.physics, i).has_value();
  return home;
}

}  // namespace unietp
