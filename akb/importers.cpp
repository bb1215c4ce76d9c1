#include "akb/importers.h"

#include <exception>

namespace unietp {

Result<Tables> import_simulator(Simulator simulator, const std::filesystem::path& upstream,
                                const std::filesystem::path& curated, const AbsurdPlace& absurd) {
  try {
    switch (simulator) {
      case Simulator::Ai2thor:
        return import_ai2thor(upstream, curated, absurd);
      case Simulator::Virtualhome:
        return import_virtualhome(upstream, curated, absurd);
      case Simulator::Habitat:
        return import_habitat(upstream, curated, absurd);
      case Simulator::Behavior:
        return import_behavior(upstream, curated, absurd);
    }
  } catch (const std::exception& failure) {  // nlohmann-json, when a file lacks a field or a field has another type
    return Error{Error::Kind::Schema,
                 (upstream / std::string(name_of(simulator))).string(),
                 {},
                 std::string("metadata not in the expected form: ") + failure.what()};
  }
  return Error{Error::Kind::Usage, {}, {}, "no such simulator; expected ai2thor, virtualhome, habitat or behavior"};
}

Result<Done> import_all(const std::filesystem::path& upstream, const std::filesystem::path& tables,
                        const AbsurdPlaceOf& absurd) {
  std::vector<Tables> all;
  for (const auto simulator : kSimulators) {
    auto imported = import_simulator(simulator, upstream, tables / "curated", absurd(simulator));
    if (!imported) return imported.error();
    all.push_back(std::move(*imported));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto written = write_tables(tables / std::string(name_of(kSimulators[i])), all[i]);
    if (!written) return written;
  }
  return Done{};
}

}  // namespace unietp
