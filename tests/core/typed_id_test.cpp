#include "core/typed_id.h"

#include <gtest/gtest.h>

#include <concepts>
#include <unordered_set>

namespace unietp {
namespace {

using CupId = TypedId<struct CupTag>;
using PlateId = TypedId<struct PlateTag>;

static_assert(!std::convertible_to<CupId, PlateId> && !std::constructible_from<CupId, PlateId>);
static_assert(!std::convertible_to<std::size_t, CupId> && !std::convertible_to<CupId, std::size_t>);
static_assert(!std::equality_comparable_with<CupId, PlateId> && !std::equality_comparable_with<CupId, std::size_t>);

TEST(TypedId, IsAPositionAndComparesAsOne) {
  EXPECT_EQ(CupId(7).index(), 7U);
  EXPECT_LT(CupId(7), CupId(8));
  CupId next(7);
  EXPECT_EQ(++next, CupId(8));
  EXPECT_EQ((std::unordered_set<CupId>{CupId(1), CupId(2), CupId(1)}).size(), 2U);
}

TEST(TypedId, APositionThatDoesNotFitIsAnError) {
  EXPECT_EQ(CupId(0xFFFF'FFFE).index(), 0xFFFF'FFFEU);
  EXPECT_THROW(CupId(0xFFFF'FFFF), std::length_error);
  EXPECT_THROW(CupId(std::size_t{1} << 32), std::length_error);
  CupId last(0xFFFF'FFFE);
  EXPECT_LT(last, CupId::none());
  EXPECT_THROW(++last, std::length_error);
}

}  // namespace
}  // namespace unietp
