#pragma once

#include <string>

#include "dataset/manifest.h"

namespace unietp {

/// README.md of a data set: what is in it, how it was made and how to read it, with the metadata block that Hugging
/// Face reads. Takes version, configuration, counts and sources of the manifest. Pure.
std::string dataset_card(const Manifest& manifest);

}  // namespace unietp
