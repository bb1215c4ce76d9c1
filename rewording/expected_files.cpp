#include "rewording/expected_files.h"

#include "dataset/dataset_card.h"
#include "rewording/written_again.h"

namespace unietp {

Result<DerivedFiles> expected_files(const ManifestRecord& manifest, const Resources& resources,
                                    const std::filesystem::path& licenses) {
  auto written = written_again(kManifest, manifest);
  if (!written) return written.error();
  auto sources = sources_of(written->configuration, resources, licenses);
  if (!sources) return sources.error();
  DerivedFiles files;
  for (const auto& source : *sources) files.sources.push_back({source.source, source.origin, source.license});
  files.benchmark = benchmark_of(written->files, resources.frozen);
  written->sources = std::move(*sources);
  files.card = dataset_card(*written);
  return files;
}

}  // namespace unietp
