#pragma once

#include <span>
#include <string_view>

namespace rgimp::cli {

/// A case file to start from.
struct CaseTemplate {
  std::string_view name;   ///< "single-flaw"
  std::string_view title;  ///< the case's own
  std::string_view text;   ///< of the whole file
};

/// Those of examples/, see EmbedTemplates.cmake.
std::span<const CaseTemplate> case_templates();

}  // namespace rgimp::cli
