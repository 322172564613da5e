#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rgimp {

/// The values that "KEY=START:STOP:STEP" or "KEY=A|B|C" give, as TOML texts; one alone where it is
/// a plain override. Throws CaseError for a range that is none.
std::vector<std::string> range_values(const std::string& change);

/// Of "KEY=VALUE", without blanks around it.
std::string range_key(std::string_view change);

}  // namespace rgimp
