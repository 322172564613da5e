#include "case_names.hpp"

#include <array>

namespace rgimp {
namespace {

constexpr std::array kOnExits{Named<OnExit>{OnExit::stop, "stop"},
                              Named<OnExit>{OnExit::remove, "remove"}};
constexpr std::array kBodyShapes{Named<BodyShape>{BodyShape::box, "box"},
                                 Named<BodyShape>{BodyShape::disk, "disk"},
                                 Named<BodyShape>{BodyShape::cylinder, "cylinder"},
                                 Named<BodyShape>{BodyShape::sphere, "sphere"}};
constexpr std::array kFlawShapes{
    Named<FlawShape>{FlawShape::slot, "slot"}, Named<FlawShape>{FlawShape::circle, "circle"},
    Named<FlawShape>{FlawShape::box, "box"}, Named<FlawShape>{FlawShape::sphere, "sphere"},
    Named<FlawShape>{FlawShape::penny, "penny"}};
constexpr std::array kSlotEnds{Named<SlotEnds>{SlotEnds::square, "square"},
                               Named<SlotEnds>{SlotEnds::round, "round"}};
constexpr std::array kCriteria{
    Named<Criterion>{Criterion::mohr_coulomb, "mohr-coulomb"},
    Named<Criterion>{Criterion::hydrostatic_tension, "hydrostatic-tension"},
    Named<Criterion>{Criterion::principal_stress, "principal-stress"},
    Named<Criterion>{Criterion::shear_stress, "shear-stress"},
    Named<Criterion>{Criterion::principal_strain, "principal-strain"},
    Named<Criterion>{Criterion::shear_strain, "shear-strain"}};
constexpr std::array kTreatments{Named<Treatment>{Treatment::no_tension, "no-tension"},
                                 Named<Treatment>{Treatment::stress_free, "stress-free"},
                                 Named<Treatment>{Treatment::pressure_window, "pressure-window"}};
constexpr std::array kSides{Named<Side>{Side::top, "top"},     Named<Side>{Side::bottom, "bottom"},
                            Named<Side>{Side::left, "left"},   Named<Side>{Side::right, "right"},
                            Named<Side>{Side::front, "front"}, Named<Side>{Side::back, "back"}};
constexpr std::array kLaterals{Named<Lateral>{Lateral::slip, "slip"},
                               Named<Lateral>{Lateral::stick, "stick"}};
constexpr std::array kIntegrators{Named<Integrator>{Integrator::musl, "musl"},
                                  Named<Integrator>{Integrator::usl, "usl"},
                                  Named<Integrator>{Integrator::usf, "usf"}};

constexpr FailureKey kCohesion{"cohesion", &Failure::cohesion, "Pa"};
constexpr FailureKey kFrictionAngle{"friction_angle", &Failure::friction_angle, "degrees"};
constexpr FailureKey kTensileStrength{"tensile_strength", &Failure::tensile_strength, "Pa"};
constexpr FailureKey kShearStrength{"shear_strength", &Failure::shear_strength, "Pa"};
constexpr FailureKey kShearStrainLimit{"shear_strain", &Failure::shear_strain, "1, a strain"};
constexpr FailureKey kTensileStrain{"tensile_strain", &Failure::tensile_strain, "1, a strain"};

constexpr std::array kMohrCoulomb{kCohesion, kFrictionAngle, kTensileStrength};
constexpr std::array kTension{kTensileStrength};
constexpr std::array kShearStress{kShearStrength};
constexpr std::array kPrincipalStrain{kTensileStrain};
constexpr std::array kShearStrain{kShearStrainLimit};
constexpr std::array kAllStrengths{kCohesion,      kFrictionAngle, kTensileStrength,
                                   kShearStrength, kTensileStrain, kShearStrainLimit};
constexpr std::array kFractureEnergies{
    FailureKey{"fracture_energy", &Failure::fracture_energy, "J/m2, tension; 0: fails at once"},
    FailureKey{"shear_fracture_energy", &Failure::shear_fracture_energy,
               "J/m2, shear; 0: fails at once"}};
constexpr std::array kPressureWindow{
    FailureKey{"pressure_min", &Failure::pressure_min, "Pa, <= 0: tension"},
    FailureKey{"pressure_max", &Failure::pressure_max, "Pa"}};

constexpr std::array<std::string_view, 4> kSlotKeys{"length", "width", "angle", "ends"};
constexpr std::array<std::string_view, 7> kSolidSlotKeys{"length", "width", "angle", "direction",
                                                         "normal", "depth", "ends"};
constexpr std::array<std::string_view, 3> kPennyKeys{"length", "width", "normal"};
constexpr std::array<std::string_view, 1> kCircleKeys{"length"};
constexpr std::array<std::string_view, 1> kBoxKeys{"size"};

}  // namespace

std::span<const Named<OnExit>> names_of(OnExit) {
  return kOnExits;
}
std::span<const Named<BodyShape>> names_of(BodyShape) {
  return kBodyShapes;
}
std::span<const Named<FlawShape>> names_of(FlawShape) {
  return kFlawShapes;
}
std::span<const Named<SlotEnds>> names_of(SlotEnds) {
  return kSlotEnds;
}
std::span<const Named<Criterion>> names_of(Criterion) {
  return kCriteria;
}
std::span<const Named<Treatment>> names_of(Treatment) {
  return kTreatments;
}
std::span<const Named<Side>> names_of(Side) {
  return kSides;
}
std::span<const Named<Lateral>> names_of(Lateral) {
  return kLaterals;
}
std::span<const Named<Integrator>> names_of(Integrator) {
  return kIntegrators;
}

bool exists_in(int dimension, BodyShape shape) {
  switch (shape) {
    case BodyShape::box:
      return true;
    case BodyShape::disk:
      return dimension == 2;
    case BodyShape::cylinder:
    case BodyShape::sphere:
      return dimension == 3;
  }
  return false;
}

bool exists_in(int dimension, FlawShape shape) {
  switch (shape) {
    case FlawShape::slot:
    case FlawShape::box:
      return true;
    case FlawShape::circle:
      return dimension == 2;
    case FlawShape::sphere:
    case FlawShape::penny:
      return dimension == 3;
  }
  return false;
}

bool exists_in(int dimension, Side side) {
  return dimension == 3 || (side != Side::front && side != Side::back);
}

std::span<const FailureKey> strengths_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::mohr_coulomb:
      return kMohrCoulomb;
    case Criterion::hydrostatic_tension:
    case Criterion::principal_stress:
      return kTension;
    case Criterion::shear_stress:
      return kShearStress;
    case Criterion::principal_strain:
      return kPrincipalStrain;
    case Criterion::shear_strain:
      return kShearStrain;
  }
  return {};
}

std::span<const FailureKey> all_strengths() {
  return kAllStrengths;
}

std::span<const FailureKey> fracture_energies_of(Criterion criterion) {
  const std::span<const FailureKey> all(kFractureEnergies);
  switch (criterion) {
    case Criterion::mohr_coulomb:
      return all;
    case Criterion::principal_stress:
      return all.first(1);
    case Criterion::shear_stress:
      return all.last(1);
    case Criterion::hydrostatic_tension:
    case Criterion::principal_strain:
    case Criterion::shear_strain:
      return {};
  }
  return {};
}

std::span<const FailureKey> limits_of(Treatment treatment) {
  return treatment == Treatment::pressure_window ? std::span<const FailureKey>(kPressureWindow)
                                                 : std::span<const FailureKey>();
}

std::vector<std::string_view> keys_of(std::span<const FailureKey> entries) {
  std::vector<std::string_view> keys;
  for (const FailureKey& entry : entries) {
    keys.push_back(entry.key);
  }
  return keys;
}

std::span<const std::string_view> dimensions_of(FlawShape shape, int dimension) {
  switch (shape) {
    case FlawShape::slot:
      return dimension == 3 ? std::span<const std::string_view>(kSolidSlotKeys) : kSlotKeys;
    case FlawShape::circle:
    case FlawShape::sphere:
      return kCircleKeys;
    case FlawShape::box:
      return kBoxKeys;
    case FlawShape::penny:
      return kPennyKeys;
  }
  return {};
}

}  // namespace rgimp
