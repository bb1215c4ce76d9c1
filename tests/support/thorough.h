#pragma once

#include <cstdlib>

namespace unietp::test {

/// How often to try: `usually` in every run of the tests, and with UNIETP_THOROUGH in the environment as often as
/// docs/trust.md and docs/evidence.md say. `./check accidents` sets it.
inline int tries(int usually, int thoroughly) {
  return std::getenv("UNIETP_THOROUGH") == nullptr ? usually : thoroughly;
}

}  // namespace unietp::test
