#pragma once

#include <string>
#include <vector>

namespace rgimp {

/// What simulations use on this machine unless they are told otherwise.
struct Machine {
  std::string isa;                ///< the instruction set in use, by RGIMP_ISA or the fastest
  std::vector<std::string> isas;  ///< those RGIMP_ISA may name here
  int threads = 0;                ///< all the machine lets this process use
};

/// Throws CaseError for an RGIMP_ISA the machine lacks.
Machine describe_machine();

}  // namespace rgimp
