#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "targets.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

/// Random bytes rarely make one number of a case extreme and leave all others right.
constexpr std::array<std::string_view, 28> kNumbers{"0",
                                                    "-1",
                                                    "1",
                                                    "-0.0",
                                                    "0.5",
                                                    "2",
                                                    "3",
                                                    "4",
                                                    "1e-3",
                                                    "1e-9",
                                                    "1e-30",
                                                    "1e-160",
                                                    "1e-300",
                                                    "1e-320",
                                                    "5e-324",
                                                    "1e9",
                                                    "1e30",
                                                    "1e160",
                                                    "1e300",
                                                    "-1e300",
                                                    "1.7e308",
                                                    "nan",
                                                    "-inf",
                                                    "2147483647",
                                                    "2147483648",
                                                    "9223372036854775807",
                                                    "-9223372036854775808",
                                                    "9223372036854775808"};

bool is_in_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e';
}

bool starts_number(const std::string& text, std::size_t at) {
  return text[at] >= '0' && text[at] <= '9' && (at == 0 || !is_in_number(text[at - 1]));
}

/// One of the numbers in `text` becomes one of kNumbers.
void replace_a_number(std::string& text, std::minstd_rand& random) {
  const std::size_t start = random() % text.size();
  for (std::size_t offset = 0; offset < text.size(); ++offset) {
    const std::size_t at = (start + offset) % text.size();
    if (starts_number(text, at)) {
      const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(),
                                        is_in_number);
      text.replace(text.begin() + static_cast<std::ptrdiff_t>(at), end,
                   kNumbers[random() % kNumbers.size()]);
      return;
    }
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  std::minstd_rand random(seed);
  if (size == 0 || random() % 2 == 0) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  std::string text(data, data + size);
  replace_a_number(text, random);
  const std::size_t kept = std::min(text.size(), max_size);
  std::copy_n(text.begin(), kept, data);
  return kept;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rgimp::fuzz::try_case({reinterpret_cast<const char*>(data), size});
  return 0;
}
