#pragma once

#include <string>
#include <vector>

#include "dataset/manifest.h"

namespace unietp {

/// README.md of a data set: what is in it, how it was made and how to read it, with the metadata block that Hugging
/// Face reads. Pure.
std::string dataset_card(const RunConfiguration& configuration, const DatasetCounts& counts,
                         const std::vector<SourceLicence>& sources);

}  // namespace unietp
