// Runs a case and prints the hash of its final state. Usage: outside CASE.toml
#include <iomanip>
#include <iostream>

#include "rgimp/rgimp.hpp"

int main(int, char** argv) {
  rgimp::Simulation simulation(rgimp::read_case(argv[1]));
  simulation.run_until(simulation.facts().total_steps);
  std::cout << std::hex << std::setfill('0') << std::setw(16) << simulation.state_hash() << '\n';
}
