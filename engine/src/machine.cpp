#include "rgimp/machine.hpp"

#include "rgimp/kernels/table.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp {

namespace {

/// The smallest case there is: a block of four cells at rest.
Case small_case() {
  Case settings;
  settings.grid.cell_size = 1.0;
  Body block;
  block.size = Vector(2.0, 2.0, 0.0);
  block.material = "any";
  settings.bodies = {block};
  Material& any = settings.materials["any"];
  any.density = 1.0;
  any.youngs_modulus = 1.0;
  settings.time.steps = 1;
  return settings;
}

}  // namespace

Machine describe_machine() {
  const Facts facts = Simulation(small_case()).facts();  // asked, not guessed: it decides
  Machine machine{facts.isa, {}, facts.threads};
  for (const kernels::Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      machine.isas.emplace_back(kernels::name(isa));
    }
  }
  return machine;
}

}  // namespace rgimp
