#include <catch2/catch.hpp>

#include "format.hpp"
#include "progress_display.hpp"

using namespace rgimp;
using namespace rgimp::cli;

TEST_CASE("numbers are grouped by thousands") {
  CHECK(with_separators(0) == "0");
  CHECK(with_separators(999) == "999");
  CHECK(with_separators(79618) == "79,618");
  CHECK(with_separators(-1234567) == "-1,234,567");
}

TEST_CASE("durations have the unit that suits them") {
  CHECK(format_duration(0.04) == "0.0 s");
  CHECK(format_duration(9.94) == "9.9 s");
  CHECK(format_duration(9.96) == "10 s");
  CHECK(format_duration(59.6) == "1 min 00 s");
  CHECK(format_duration(75.0) == "1 min 15 s");
  CHECK(format_duration(4000.0) == "1 h 07 min");
}

TEST_CASE("memory has the unit that suits it") {
  CHECK(format_bytes(0) == "0 B");
  CHECK(format_bytes(1023) == "1023 B");
  CHECK(format_bytes(7340032) == "7.0 MiB");
}

TEST_CASE("a progress line has speed, time left and failed points") {
  const Progress progress{500, 0, 2000, 80000, 0.2, 12};
  CHECK(line_of(progress).figures ==
        "500/2,000 steps  200.0 M particle-steps/s  0.6 s left  12 failed");
  CHECK(line_of(Progress{0, 0, 2000, 80000, 0.0, 0}).figures == "0/2,000 steps  0 failed");
}

TEST_CASE("a run that goes on from a checkpoint counts its own steps for speed and time left") {
  const Progress progress{1500, 1000, 2000, 80000, 0.2, 12};
  CHECK(line_of(progress).figures ==
        "1,500/2,000 steps  200.0 M particle-steps/s  0.2 s left  12 failed");
}

TEST_CASE("a progress line fits its terminal") {
  const Progress progress{1999, 0, 2000, 80000, 0.2, 12};
  for (std::size_t columns = 1; columns < 200; ++columns) {
    CHECK(draw_progress(line_of(progress), columns).size() <= columns);
  }
  CHECK_THAT(draw_progress(line_of(progress), 120), Catch::StartsWith(" 99 % [####"));
  CHECK_THAT(draw_progress(line_of(progress), 60), Catch::StartsWith(" 99 % 1,999/2,000 steps"));
}
