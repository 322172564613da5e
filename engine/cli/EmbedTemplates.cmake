# The case files that `rgimp new` writes are those of examples/: embedded here, so that there are no
# second copies. A case's title is its line in `rgimp new --list`.
function(rgimp_embed_templates output)
  set(entries "")
  foreach(pair ${ARGN})
    string(REPLACE "=" ";" pair ${pair})
    list(GET pair 0 name)
    list(GET pair 1 stem)
    set(file ${PROJECT_SOURCE_DIR}/examples/${stem}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    if(NOT text MATCHES "\ntitle = \"([^\"]*)\"\n")
      message(FATAL_ERROR "${file} has no title")
    endif()
    string(APPEND entries "    {\"${name}\", \"${CMAKE_MATCH_1}\",\n     R\"toml(${text})toml\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT [[
#include "case_templates.hpp"

namespace rgimp::cli {

namespace {

constexpr CaseTemplate kTemplates[] = {
@entries@};

}  // namespace

std::span<const CaseTemplate> case_templates() {
  return kTemplates;
}

}  // namespace rgimp::cli
]])
endfunction()
