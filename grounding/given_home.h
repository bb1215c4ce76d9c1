#pragma once

#include "grounding/home.h"

namespace unietp {

/// prepare_home of a home that was not generated, in which not all furniture can be used (Home::out_of_reach and
/// stuck).
Home prepare_given_home(Scene scene, const Profile& profile);

}  // namespace unietp
