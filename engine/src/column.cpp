#include "column.hpp"

#include <sys/mman.h>

namespace rgimp {

void advise_huge_pages(void* memory, std::size_t bytes) {
  madvise(memory, bytes, MADV_HUGEPAGE);  // advice: what it answers changes nothing
}

}  // namespace rgimp
