#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "grounding/scene_statistics.h"
#include "grounding/upstream_homes.h"

namespace unietp {

/// A file of data/layouts.
struct FittedFile {
  std::string name;  // "ai2thor_objects.csv"
  std::string text;
};

/// The tables and reference statistics of data/layouts that follow from real homes and from what is curated: for each
/// simulator its recipe (furniture, rooms, objects, receptacles), and reference_<simulator>.json where there are real
/// homes. `knowledge` holds all simulators' knowledge bases: what the homes of one do not show is taken from the
/// others, for categories of the same name for people (rule `same-word`). Deterministic. Errors: Io, Parse, Schema.
Result<std::vector<FittedFile>> fit_layouts(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                                            std::span<const Knowledge> knowledge);
/// Fits, then writes all files into a folder, or none when the fit fails. Errors: Io too.
Result<Done> fit_layouts_into(const std::filesystem::path& folder, const std::filesystem::path& upstream,
                              const std::filesystem::path& curated, std::span<const Knowledge> knowledge);

/// What is known of one simulator's homes while its tables are fitted.
struct FitInput {
  const Knowledge* knowledge = nullptr;
  UpstreamHomes homes;
  SceneStatistics statistics;  // of homes, with the room types of the whole ones
};

// The four tables of one simulator; `own` is the input of the simulator, `all` those of every simulator.
Result<std::string> fit_rooms(const FitInput& own, const std::filesystem::path& curated);
Result<std::string> fit_furniture(const FitInput& own, const std::filesystem::path& curated);
std::string fit_objects(const FitInput& own, std::span<const FitInput> all);
std::string fit_receptacles(const FitInput& own, std::span<const FitInput> all);

std::string rounded_text(double value, double per_unit = 1000);  // 0.12345 → "0.123"

}  // namespace unietp
