#include "serve/http_origin.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

constexpr const char* kOwn = "127.0.0.1";

TEST(HttpOrigin, ProgramsAndTheServersOwnPagesMayAsk) {
  for (const char* host : {"127.0.0.1:8080", "127.0.0.1", "localhost:8080", "LocalHost", "[::1]:8080", "[::1]"}) {
    EXPECT_FALSE(foreign(host, std::nullopt, kOwn)) << host;
    EXPECT_FALSE(foreign(host, std::string("http://") + host, kOwn)) << host;
  }
  EXPECT_FALSE(foreign("10.0.0.7:8080", std::nullopt, "0.0.0.0"));
}

TEST(HttpOrigin, ANameThatSomeoneMayHavePointedHereIsForeign) {
  for (const char* host : {"", "evil.example", "evil.example:8080", "127.0.0.1.evil.example:8080", "localhost.evil:80",
                           "127.0.0.1:80@evil.example", "[::1]evil", "[::1", "127.0.0.1:80:80", ":8080", "1.2.3"}) {
    EXPECT_TRUE(foreign(host, std::nullopt, kOwn)) << host;
    EXPECT_TRUE(foreign(host, std::string("http://") + host, kOwn)) << host;
  }
}

TEST(HttpOrigin, APageOfAnotherOriginIsForeign) {
  for (const char* origin : {"", "null", "http://evil.example", "http://127.0.0.1:8081", "https://127.0.0.1:8080",
                             "http://localhost:8080", "http://127.0.0.1:8080/", "127.0.0.1:8080"}) {
    EXPECT_TRUE(foreign("127.0.0.1:8080", origin, kOwn)) << origin;
  }
}

TEST(HttpOrigin, OnlyThisMachineReachesALoopbackAddress) {
  for (const char* address : {"127.0.0.1", "127.8.9.1", "::1"}) EXPECT_TRUE(is_loopback(address)) << address;
  for (const char* address : {"0.0.0.0", "10.0.0.127", "::", "::ffff:10.0.0.1"}) EXPECT_FALSE(is_loopback(address));
}

}  // namespace
}  // namespace unietp
