#pragma once

/// What a skipped test says: what it needs to run, and how to get that. `./check` lists these at its end.
namespace unietp::needs {

inline constexpr auto* kSimulatorFiles =
    "needs the simulators' own files, which docs/knowledge.md lists; configure with -DUNIETP_UPSTREAM=FOLDER";
inline constexpr auto* kWordNet = "needs WordNet: install wordnet-base";
inline constexpr auto* kChromium = "needs a browser: install chromium";

}  // namespace unietp::needs
