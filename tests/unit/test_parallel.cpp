#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "bands.hpp"
#include "floating_point_traps.hpp"
#include "rgimp/error.hpp"
#include "workers.hpp"

namespace rgimp::tests {

TEST_CASE("bands cover every row once, and bands of a colour never touch the same row") {
  const std::ptrdiff_t height = GENERATE(2, 3, 4, 8, 16);
  for (const std::ptrdiff_t layers : {1, 7, 8, 9, 15, 16, 17, 24, 25, 33, 211}) {
    const Bands bands(layers, 1, height);
    std::vector<int> covered(static_cast<std::size_t>(layers), 0);
    for (int colour = 0; colour < 2; ++colour) {
      std::vector<int> touched(static_cast<std::size_t>(layers), 0);
      for (std::ptrdiff_t i = 0; i < bands.count_of(colour); ++i) {
        const kernels::RowRange rows = bands.rows(Bands::band_of(colour, i));
        for (std::ptrdiff_t row = rows.first; row < rows.last; ++row) {
          ++covered[row];
        }
        for (std::ptrdiff_t row = std::max<std::ptrdiff_t>(rows.first - 1, 0);
             row < std::min(rows.last + 1, layers); ++row) {
          ++touched[row];
        }
      }
      REQUIRE(*std::max_element(touched.begin(), touched.end()) <= 1);
    }
    REQUIRE(covered == std::vector<int>(static_cast<std::size_t>(layers), 1));
  }
}

TEST_CASE("a scatter clears every row once, before anything is added to it") {
  const std::ptrdiff_t height = GENERATE(2, 3, 4, 8, 16);
  for (const std::ptrdiff_t layers : {1, 8, 9, 16, 17, 24, 31, 32, 211}) {
    const Bands bands(layers, 1, height);
    std::vector<int> cleared(static_cast<std::size_t>(layers), 0);
    for (int colour = 0; colour < 2; ++colour) {
      for (std::ptrdiff_t i = 0; i < bands.count_of(colour); ++i) {
        const std::ptrdiff_t band = Bands::band_of(colour, i);
        const kernels::RowRange clear = bands.cleared_rows(band);
        for (std::ptrdiff_t row = clear.first; row < clear.last; ++row) {
          ++cleared[row];
        }
        const kernels::RowRange rows = bands.rows(band);
        for (std::ptrdiff_t row = std::max<std::ptrdiff_t>(rows.first - 1, 0);
             row < std::min(rows.last + 1, layers); ++row) {
          INFO("layers " << layers << ", band " << band << ", row " << row);
          REQUIRE(cleared[row] == 1);
        }
      }
    }
    REQUIRE(cleared == std::vector<int>(static_cast<std::size_t>(layers), 1));
  }
}

TEST_CASE("every row is completed once, by the last band that adds to it") {
  const std::ptrdiff_t height = GENERATE(2, 3, 4, 8, 16);
  for (const std::ptrdiff_t layers : {1, 8, 9, 16, 17, 24, 31, 32, 211}) {
    const Bands bands(layers, 1, height);
    std::vector<int> completed(static_cast<std::size_t>(layers), 0);
    for (int colour = 0; colour < 2; ++colour) {
      for (std::ptrdiff_t i = 0; i < bands.count_of(colour); ++i) {
        const std::ptrdiff_t band = Bands::band_of(colour, i);
        const kernels::RowRange rows = bands.rows(band);
        for (std::ptrdiff_t row = std::max<std::ptrdiff_t>(rows.first - 1, 0);
             row < std::min(rows.last + 1, layers); ++row) {
          INFO("layers " << layers << ", band " << band << ", row " << row);
          REQUIRE(completed[row] == 0);
        }
        const kernels::RowRange complete = bands.completed_rows(band);
        for (std::ptrdiff_t row = complete.first; row < complete.last; ++row) {
          ++completed[row];
        }
      }
    }
    REQUIRE(completed == std::vector<int>(static_cast<std::size_t>(layers), 1));
  }
}

TEST_CASE("bands of planes cover all rows of a plane") {
  const Bands bands(10, 7, 4);
  REQUIRE(bands.rows(1).first == 28);
  REQUIRE(bands.rows(1).last == 56);
  REQUIRE(bands.rows(2).last == 70);
}

TEST_CASE("every index is visited once, with fewer and with more threads than cores") {
  for (const int threads : {1, 2, 3, 7}) {
    Workers workers(threads);
    REQUIRE(workers.threads() == threads);
    std::vector<std::atomic<int>> visits(1000);
    workers.region([&] {
      for (int phase = 0; phase < 500; ++phase) {
        workers.for_each(phase * 2, [&](std::ptrdiff_t i) { ++visits[i]; });
      }
    });
    for (int i = 0; i < 1000; ++i) {
      REQUIRE(visits[i] == 499 - i / 2);
    }
  }
}

TEST_CASE("a phase sees all writes of the phase before it") {
  Workers workers(2);
  std::vector<int> value(64, 0);
  int sum = 0;
  workers.region([&] {
    for (int phase = 0; phase < 1000; ++phase) {
      workers.for_each(64, [&](std::ptrdiff_t i) { ++value[i]; });
      workers.for_each(1, [&](std::ptrdiff_t) {
        for (const int v : value) {
          sum += v - phase;
        }
      });
    }
  });
  REQUIRE(sum == 64 * 1000);
}

TEST_CASE("work outside a region runs on the caller, and errors leave a region") {
  Workers workers(2);
  int calls = 0;
  workers.for_each(10, [&](std::ptrdiff_t) { ++calls; });
  REQUIRE(calls == 10);
  REQUIRE_THROWS_AS(workers.region([] { throw std::runtime_error("stop"); }), std::runtime_error);
  workers.region([&] { workers.for_each(10, [&](std::ptrdiff_t) {}); });
}

TEST_CASE("floating-point errors are trapped on every thread, unless a test says otherwise") {
  Workers workers(3);
  std::vector<std::atomic<int>> traps(1000);
  workers.region([&] {
    for (int phase = 0; phase < 100; ++phase) {
      workers.for_each(1000, [&](std::ptrdiff_t i) { traps[i] = fegetexcept(); });
    }
  });
  REQUIRE(std::all_of(traps.begin(), traps.end(),
                      [](const auto& t) { return t == kFloatingPointTraps; }));
  {
    const WithoutTraps none;
    REQUIRE(fegetexcept() == 0);
  }
  REQUIRE(fegetexcept() == kFloatingPointTraps);
}

TEST_CASE("an error of a visit reaches the caller as what it is, the lowest index first") {
  for (const int threads : {1, 2, 3, 7}) {
    Workers workers(threads);
    for (int repeat = 0; repeat < 100; ++repeat) {
      const auto fail = [&] {
        workers.for_each(64, [](std::ptrdiff_t index) {
          if (index % 7 == 3) {
            throw PhysicsError(std::to_string(index));
          }
        });
      };
      REQUIRE_THROWS_AS(workers.region(fail), PhysicsError);
      REQUIRE_THROWS_WITH(workers.region(fail), "3");
      REQUIRE_THROWS_WITH(fail(), "3");
    }
    const auto exhaust = [&] {
      workers.for_each(8, [](std::ptrdiff_t) { throw std::bad_alloc(); });
    };
    REQUIRE_THROWS_AS(workers.region(exhaust), std::bad_alloc);
    int visits = 0;
    workers.region([&] { workers.for_each(1, [&](std::ptrdiff_t) { ++visits; }); });
    REQUIRE(visits == 1);
  }
}

}  // namespace rgimp::tests
