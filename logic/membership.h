#pragma once

#include <algorithm>

#include "logic/entity.h"
#include "logic/formula.h"

namespace unietp {

/// Whether an entity is of a domain's kind and category; the domain's `:where` is left aside.
inline bool is_of(const Entity& entity, const Domain& domain) {
  switch (domain.kind) {
    case Domain::Kind::Object:
      return entity.kind == Entity::Kind::Object;
    case Domain::Kind::Room:
      return entity.kind == Entity::Kind::Room;
    case Domain::Kind::Agent:
      return entity.kind == Entity::Kind::Agent;
    case Domain::Kind::Categories:
      break;
  }
  if (entity.kind == Entity::Kind::Agent) return false;
  return std::any_of(domain.members.begin(), domain.members.end(), [&](const Domain::Member& member) {
    return (member.slice ? entity.slice_of : entity.category) == member.category;
  });
}

}  // namespace unietp
