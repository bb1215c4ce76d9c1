#pragma once

#include <cstdint>
#include <string>

#include "core/typed_id.h"

namespace unietp {

/// Position in Trace::entities. Meaningless in another trace.
using EntityIndex = TypedId<struct EntityTag>;

/// Something that a variable can stand for.
struct Entity {
  enum class Kind : std::uint8_t { Object, Room, Agent };
  Kind kind = Kind::Object;
  std::string id;        // "mug_3"
  std::string category;  // "Mug"; of a room its type ("Kitchen")
  std::string slice_of;  // category of the whole that was cut, for `A/slice`; else empty
  bool operator==(const Entity&) const = default;
};

}  // namespace unietp
