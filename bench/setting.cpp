#include "setting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rgimp/case_file.hpp"

namespace rgimp::bench {
namespace {

const char* name(Integrator integrator) {
  switch (integrator) {
    case Integrator::musl:
      return "musl";
    case Integrator::usl:
      return "usl";
    case Integrator::usf:
      return "usf";
  }
  return "unknown";
}

const char* name(Arrangement arrangement) {
  return arrangement == Arrangement::lattice ? "lattice" : "random";
}

/// A cube with a 45 degree penny, both as wide as the plane's specimen and slot.
void make_cube(Case& settings) {
  settings.dimension = 3;
  Body& body = settings.bodies.front();
  body.size = Vector::Constant(body.size.x());
  Flaw& flaw = settings.flaws.front();
  flaw.shape = FlawShape::penny;
  flaw.normal = Vector(-1.0, 1.0, 0.0);
}

}  // namespace

std::string name(const Setting& setting) {
  return fmt::format("cells:{}/particles:{}/integrator:{}/isa:{}/threads:{}", setting.cells_across,
                     name(setting.arrangement), name(setting.integrator),
                     kernels::name(setting.isa), setting.threads);
}

Case case_of(const Setting& setting) {
  // Failed points take a path of their own: a benchmark that lasts longer must not have more.
  constexpr double kSlowness = 0.01;
  Case settings = read_case(RGIMP_EXAMPLES "/single_flaw.toml");
  if (setting.dimension == 3) {
    make_cube(settings);
  }
  const double cell = settings.bodies.front().size.x() / setting.cells_across;
  settings.grid.cell_size = cell;
  settings.time.integrator = setting.integrator;
  for (Flaw& flaw : settings.flaws) {  // resolved on coarse grids too
    flaw.width = std::max(flaw.width, 3.0 * cell);
    flaw.length = std::max(flaw.length, 3.0 * cell);
  }
  for (Platen& platen : settings.platens) {
    platen.speed *= kSlowness;
  }
  return settings;
}

}  // namespace rgimp::bench
