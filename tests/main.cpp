#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "floating_point_traps.hpp"

int main(int argc, char** argv) {
  rgimp::tests::trap_floating_point_errors();
  return Catch::Session().run(argc, argv);
}
