#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace rgimp {

/// Bytes from which a column lies on huge pages, where the machine has them: three-dimensional
/// columns span more small pages than a core keeps the addresses of.
inline constexpr std::size_t kHugeColumn = std::size_t{4} << 20;
inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Asks for huge pages; does nothing where there are none.
void advise_huge_pages(void* memory, std::size_t bytes);

/// Allocates on cache lines, so that whole groups load aligned on every ISA, and large columns on
/// huge pages. Elements that are given no value have none. All large columns start at the same
/// place in a page; starting each some cache lines farther on was tried for its steps, and made
/// 0.89 to 1.08 of the speed in several runs: noise.
template <typename T>
struct ColumnAllocator {
  using value_type = T;

  ColumnAllocator() = default;
  template <typename U>
  ColumnAllocator(const ColumnAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignment_of(bytes));
    if (bytes >= kHugeColumn) {
      advise_huge_pages(memory, bytes);
    }
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete(memory, alignment_of(count * sizeof(T)));
  }
  /// Without a value an element is left as it is: what fills a column, on all threads, touches its
  /// memory first.
  template <typename Element>
  void construct(Element* element) noexcept {
    ::new (static_cast<void*>(element)) Element;
  }
  template <typename Element, typename... Values>
  void construct(Element* element, Values&&... values) {
    ::new (static_cast<void*>(element)) Element(std::forward<Values>(values)...);
  }
  bool operator==(const ColumnAllocator&) const { return true; }

 private:
  static std::align_val_t alignment_of(std::size_t bytes) {
    constexpr std::size_t kCacheLine = 64;
    return std::align_val_t{bytes >= kHugeColumn ? kHugePage : kCacheLine};
  }
};

template <typename T>
using Column = std::vector<T, ColumnAllocator<T>>;

}  // namespace rgimp
