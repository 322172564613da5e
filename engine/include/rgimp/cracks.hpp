#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/simulation.hpp"

/// Cracks measured on the particles. A crack is what leaves the layer of one cell around a flaw as
/// a chain of failed particles, and gets two cells from the flaw or to another one's crack.
/// Everything is measured where the particles were at step 0, so that a crack that opens stays one,
/// and follows from the steps at which particles failed: one state at the end of a run holds the
/// history of every step before.
namespace rgimp {

/// A failed particle of a wing.
struct CrackParticle {
  std::int64_t step = 0;             ///< at which it had failed and hung together with its flaw
  Vector position = Vector::Zero();  ///< m, at step 0
};

/// A crack that starts at one place of a flaw: at a tip of a slot, at its middle, or at the nearest
/// of eight points around a circle or box. Those that leave a place more than two cells apart are
/// different cracks: A, A2.
struct Wing {
  std::string name;  ///< tips of slots: A, B, ... in the order of the case; else "flaw[1] 45 deg"
  std::size_t flaw = 0;                  ///< index in Case::flaws
  Vector tip = Vector::Zero();           ///< m, the place
  std::vector<CrackParticle> particles;  ///< in the order of `step`; the first is where it starts
};

/// What can happen to cracks.
enum class CrackEventKind { first_failure, coalescence, arrival };

/// Something that happened to the cracks.
struct CrackEvent {
  /// At its end.
  std::int64_t step = 0;
  /// Which of the following it has.
  CrackEventKind kind = CrackEventKind::first_failure;
  /// Of Cracks::wings, by name.
  std::string wing;
  std::optional<std::string>
      other_wing;                    ///< coalescence: the wing, or the flaw's place, that it met
  std::optional<Side> side;          ///< arrival: the bodies' side, within one cell
  Vector position = Vector::Zero();  ///< m
};

/// All that is known about the cracks of one state.
struct Cracks {
  std::vector<Wing> wings;  ///< of every slot tip, cracked or not; of other places if cracked
  std::vector<CrackEvent> events;  ///< in order of step
  std::size_t outline = 0;         ///< failed along faces of flaws, in no crack
  std::size_t elsewhere = 0;       ///< failed, connected to no flaw
  std::optional<int> load_axis;    ///< 0 x, 1 y: the platens' direction; none without platens
};

/// How far a wing has come.
struct CrackFront {
  /// From which on it was here.
  std::int64_t step = 0;
  Vector position = Vector::Zero();  ///< m
  double length = 0.0;               ///< m, straight from the wing's first particle
};

/// The lengths over which the initial direction of a wing is measured, m.
inline constexpr std::array<double, 2> kWingSpans{2e-3, 5e-3};

/// The cracks in `particles`, a state of the case `settings`. Throws CaseError where the particles
/// are not those of the case.
Cracks trace_cracks(const Case& settings, const ParticleTable& particles);

/// The cracks of an output directory of run_case, from its last snapshot; of the state at step
/// `until` where that is given. Throws CaseError where it is no output directory or `until` lies
/// past its last snapshot, FileError where a file cannot be read or is damaged.
Cracks trace_cracks(const std::filesystem::path& directory,
                    std::optional<std::int64_t> until = std::nullopt);

/// The wing's farthest particle over the steps: an entry each time that it moved on.
std::vector<CrackFront> trace_front(const Wing& wing);

/// Direction in which a wing starts, degrees from +x, -180 to 180: of the line fitted to its
/// particles when it became `span` m long. (Seen from the first particle, a straight crack of two
/// particles across would lean by 7 degrees over 2 mm at cells of 0.5 mm.) None while it is
/// shorter.
std::optional<double> wing_angle(const Wing& wing, double span);

/// The acute angle between a direction, degrees from +x, and the load; none without platens.
std::optional<double> angle_to_load(const Cracks& cracks, double angle);

/// "first failure at A", "A and C meet", "A reaches the top side".
std::string describe(const CrackEvent& event);

/// Wings, their fronts over the steps, angles and events as JSON; lengths in m.
std::string json_text(const Cracks& cracks);

/// Writes json_text(). Throws FileError.
void write_cracks(const std::filesystem::path& path, const Cracks& cracks);

}  // namespace rgimp
