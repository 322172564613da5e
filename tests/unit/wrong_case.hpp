#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "case_text.hpp"
#include "rgimp/rgimp.hpp"

namespace rgimp::testing {

struct WrongCase {
  std::string from;     // replaced in the right case ...
  std::string to;       // ... by this
  std::string message;  // after "FILE:"
};

/// What reading `text` is refused with, after "FILE:".
inline std::string message_of(const std::string& text) {
  const ScratchDirectory scratch;
  const auto path = scratch.write(text);
  try {
    read_case(path);
  } catch (const CaseError& error) {
    const std::string what = error.what();
    const std::string file = path.string() + ":";
    return what.starts_with(file) ? what.substr(file.size()) : "without its file: " + what;
  }
  return "accepted";
}

inline void check_rows(const std::vector<WrongCase>& rows, const std::string& right = kRightCase) {
  for (const WrongCase& row : rows) {
    INFO(row.from << " -> " << row.to);
    CHECK(message_of(with(row.from, row.to, right)) == row.message);
  }
}

}  // namespace rgimp::testing
