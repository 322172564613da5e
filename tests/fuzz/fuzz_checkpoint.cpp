#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>

#include "targets.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

constexpr std::size_t kWord = sizeof(std::uint64_t);
constexpr std::size_t kTail = 2 * kWord;  // length of the index, checksum
constexpr std::size_t kHead = 4 * kWord;

std::size_t put(const std::string& bytes, std::uint8_t* data, std::size_t max_size) {
  const std::size_t size = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), size, data);
  return size;
}

/// Changes the index and makes its length right.
std::size_t mutate_index(std::uint8_t* data, std::size_t size, std::size_t max_size) {
  std::uint64_t length = 0;
  std::memcpy(&length, data + size - kTail, kWord);
  if (length > size - kHead - kTail) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  const std::size_t begin = size - kTail - length;
  length = LLVMFuzzerMutate(data + begin, length, max_size - begin - kTail);
  std::memcpy(data + begin + length, &length, kWord);
  std::memset(data + begin + length + kWord, 0, kWord);
  return begin + length + kTail;
}

}  // namespace

/// Starts from fresh checkpoints; a corpus need not be there.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  std::minstd_rand random(seed);
  if (size < kHead + kTail) {
    static const std::string fresh[] = {rgimp::fuzz::tiny_checkpoint(0),
                                        rgimp::fuzz::tiny_checkpoint(1),
                                        rgimp::fuzz::tiny_checkpoint(60)};
    return put(fresh[random() % std::size(fresh)], data, max_size);
  }
  return random() % 2 == 0 ? mutate_index(data, size, max_size)
                           : LLVMFuzzerMutate(data, size, max_size);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rgimp::fuzz::try_checkpoint({reinterpret_cast<const char*>(data), size});
  return 0;
}
