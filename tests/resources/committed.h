#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "resources/resources.h"

namespace unietp {

/// What the checkout holds, read once.
inline const Resources& committed() {
  static const auto kReading =
      load_resources({UNIETP_SOURCE_DIR, std::filesystem::path(::testing::TempDir()) / "unietp-test-cache"});
  EXPECT_TRUE(kReading.errors.empty());
  return kReading.resources;
}

}  // namespace unietp
