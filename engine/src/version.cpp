#include "rgimp/version.hpp"

namespace rgimp {

std::string_view version() {
  return RGIMP_VERSION;
}

}  // namespace rgimp
