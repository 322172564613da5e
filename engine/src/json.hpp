#pragma once

#include <nlohmann/json.hpp>

#include "rgimp/case.hpp"

namespace rgimp {

using Json = nlohmann::ordered_json;  ///< keys stay in the order in which they are written

inline Json vector_json(const Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

}  // namespace rgimp
