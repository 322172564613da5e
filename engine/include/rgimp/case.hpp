#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rgimp/tuning.hpp"

/// A case: everything one simulation is made of, as plain values in SI units (m, kg, s, Pa).
/// Vectors always have three components; in two dimensions the third is zero.
/// y is up: top is +y, bottom -y, right +x, left -x, front +z, back -z. Tension is positive.
namespace rgimp {

/// A position, velocity or the like; in two dimensions the third component is zero.
using Vector = Eigen::Vector3d;

/// What becomes of a particle that leaves the grid: the run stops, or goes on without it.
enum class OnExit { stop, remove };

/// Background grid. Grid lines pass through the bodies' lower bounding corner, or through
/// `min` where it is given.
struct GridSettings {
  double cell_size = 0.0;     ///< m, edge of a square or cubic cell
  std::optional<Vector> min;  ///< m, lower corner; default: the bodies and five cells more
  std::optional<Vector> max;  ///< m, upper corner, rounded up to whole cells; default likewise
  /// What becomes of a particle that leaves the grid.
  OnExit on_exit = OnExit::stop;
};

/// Disks are of two dimensions; cylinders and spheres of three.
enum class BodyShape { box, disk, cylinder, sphere };

/// What is filled with particles of one material. Bodies do not overlap.
struct Body {
  /// What `size` means.
  BodyShape shape = BodyShape::box;
  Vector center = Vector::Zero();  ///< m
  /// m; box: edges; disk, sphere: size.x() is the diameter; cylinder: size.y() its height besides
  Vector size = Vector::Zero();
  Vector axis = Vector::UnitY();     ///< cylinder only: its direction, of any length
  std::string material;              ///< a key of Case::materials
  int particles_per_cell = 2;        ///< per axis, 2 to 4, the same for all bodies
  Vector velocity = Vector::Zero();  ///< m/s, initial
};

/// Circles are of two dimensions, spheres and pennies (flat round cracks) of three.
enum class FlawShape { slot, circle, box, sphere, penny };
/// How a slot ends at its tips.
enum class SlotEnds { square, round };

/// A hole: particles whose centre lies inside are left out of every body.
struct Flaw {
  /// Which of the following it reads.
  FlawShape shape = FlawShape::slot;
  Vector center = Vector::Zero();    ///< m
  double length = 0.0;               ///< m, slot: tip to tip; circle, sphere, penny: the diameter
  double width = 0.0;                ///< m, slot and penny: between the faces
  double angle = 0.0;                ///< degrees from +x, counterclockwise; slot only
  SlotEnds ends = SlotEnds::square;  ///< slot only
  Vector size = Vector::Zero();      ///< m, box only: edges
  // In three dimensions only; directions are of any length and, in a slot, at right angles.
  /// Of a slot, along its length; none: in the plane of x and y, by `angle`.
  std::optional<Vector> direction = std::nullopt;
  /// Of a slot with a direction, and of a penny: across the width.
  std::optional<Vector> normal = std::nullopt;
  /// m, of a slot, at right angles to both; none: all through.
  std::optional<double> depth = std::nullopt;
};

/// The paper's section 3.1. Equations are given in failure_limits.hpp.
enum class Criterion {
  mohr_coulomb,
  hydrostatic_tension,
  principal_stress,
  shear_stress,
  principal_strain,
  shear_strain
};

/// What a failed point still carries, the paper's section 3.2: pressure but no tension, nothing,
/// or a pressure kept inside a window.
enum class Treatment { no_tension, stress_free, pressure_window };

/// Failure of a material; each criterion reads only the strengths it names.
struct Failure {
  /// Which strengths it reads.
  Criterion criterion = Criterion::mohr_coulomb;
  double cohesion = 0.0;          ///< Pa, mohr_coulomb
  double friction_angle = 0.0;    ///< degrees, mohr_coulomb
  double tensile_strength = 0.0;  ///< Pa, mohr_coulomb, hydrostatic_tension, principal_stress
  double shear_strength = 0.0;    ///< Pa, shear_stress
  double tensile_strain = 0.0;    ///< 1, principal_strain
  double shear_strain = 0.0;      ///< 1, shear_strain
  /// J/m2, mode I and mode II; 0: the point fails at once, the paper's rule. Read by mohr_coulomb,
  /// the first by principal_stress too and the second by shear_stress.
  double fracture_energy = 0.0;
  /// J/m2, mode II, likewise.
  double shear_fracture_energy = 0.0;
  /// What it still carries once it has failed.
  Treatment treatment = Treatment::no_tension;
  double pressure_min = 0.0;  ///< Pa, <= 0 (tension), pressure_window only
  double pressure_max = 0.0;  ///< Pa, >= 0, pressure_window only
};

/// A linear elastic solid, isotropic, that may fail.
struct Material {
  double density = 0.0;                           ///< kg/m3
  double youngs_modulus = 0.0;                    ///< Pa
  double poisson_ratio = 0.0;                     ///< 1
  std::optional<Failure> failure = std::nullopt;  ///< none: never fails
};

/// Front and back in three dimensions only.
enum class Side { top, bottom, left, right, front, back };
/// Whether nodes at a platen may move along it.
enum class Lateral { slip, stick };

/// A rigid plate that prescribes the normal velocity of all nodes at or beyond the bodies' end.
struct Platen {
  /// Of the specimen.
  Side side = Side::top;
  double speed = 0.0;               ///< m/s, towards the specimen; negative pulls, 0 holds
  double ramp = 0.0;                ///< s, smooth step from rest to `speed`
  Lateral lateral = Lateral::slip;  ///< stick: the other components are zero
  /// m, contact only within it of the bodies' centre along x (left and right: along y); none: the
  /// whole end
  std::optional<double> half_width = std::nullopt;
};

/// Explicit schemes, by when stresses are updated: last with velocities mapped back to the nodes,
/// last without, or first.
enum class Integrator { musl, usl, usf };

/// Exactly one of `steps` and `duration` is given.
struct TimeSettings {
  /// How many; or `duration`.
  std::optional<std::int64_t> steps;
  std::optional<double> duration;  ///< s
  double step_factor = 0.1;        ///< alpha of Eq. 24, 0 < alpha < 1
  /// Of the three schemes.
  Integrator integrator = Integrator::musl;
};

/// What a run writes when; see run_case.
struct OutputSettings {
  std::int64_t history_every = 100;              ///< steps; first and last step always
  std::optional<std::int64_t> snapshot_every;    ///< steps
  std::vector<std::int64_t> snapshot_steps;      ///< besides; step 0 and the last always
  std::optional<std::int64_t> checkpoint_every;  ///< steps; none: every ten minutes
};

/// Where a case came from, so that errors can name the line of a key ("flaw[0].width") or the
/// override that set it.
struct CaseSource {
  std::filesystem::path path;                     ///< empty for a case built in code
  std::map<std::string, std::size_t> line;        ///< key path -> line in the file
  std::map<std::string, std::string> overridden;  ///< key path -> override, "key=value"
};

/// Everything a simulation is made of. check_case says what it may be.
struct Case {
  /// For people: on pictures and in reports.
  std::string title;
  /// 2, plane strain, or 3.
  int dimension = 2;
  /// Cells and extent.
  GridSettings grid;
  /// At least one.
  std::vector<Body> bodies;
  /// Holes in all bodies.
  std::vector<Flaw> flaws;
  /// By the name that bodies use.
  std::map<std::string, Material> materials;
  /// At most one a side.
  std::vector<Platen> platens;
  /// Steps and their length.
  TimeSettings time;
  double local_damping = 0.0;                 ///< 1, Cundall's beta, 0 <= beta < 1; our addition
  double quadratic_viscosity = 1.5;           ///< 1, c0 of the bulk viscosity
  double linear_viscosity = 0.06;             ///< 1, c1 of the bulk viscosity
  Vector body_acceleration = Vector::Zero();  ///< m/s2
  /// Read by run_case alone.
  OutputSettings output;
  /// The order of sums: round-off.
  Numerics numerics;
  /// Speed only: never a bit.
  Tuning tuning;
  /// For messages only.
  CaseSource source;
};

}  // namespace rgimp
