#include <catch2/catch.hpp>
#include <fstream>
#include <functional>
#include <memory>

#include "models.hpp"
#include "rgimp/error.hpp"
#include "temporary_directory.hpp"

// Checkpoints whose checksum is right and whose particles are none of the case: kernels would read
// outside the columns.
namespace rgimp::tests {
namespace {

using Change = std::function<void(Particles<2>&)>;

/// What restoring says of a checkpoint of particles changed so.
std::string refusal_of(const Change& change) {
  const TemporaryDirectory directory;
  Model model(cracking_block());
  change(model.solver.particles());
  CheckpointWriter writer(directory / "changed", 0);
  model.solver.save(writer);
  writer.finish({"", ""});
  Model other(cracking_block());
  const CheckpointReader reader("changed", std::make_unique<std::ifstream>(directory / "changed"));
  try {
    other.solver.restore(reader);
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

std::size_t first_particle(const Particles<2>& p) {
  std::size_t lane = 0;
  while (p.is_padding(lane)) {
    ++lane;
  }
  return lane;
}

}  // namespace

TEST_CASE("a state whose particles are not those of the case is refused") {
  CHECK(refusal_of([](Particles<2>&) {}) == "accepted");
  CHECK_THAT(refusal_of([](Particles<2>& p) { p.slot_material[3] = 1; }),
             Catch::Contains("material 1 of 1"));
  CHECK_THAT(refusal_of([](Particles<2>& p) {
               const std::size_t lane = first_particle(p);
               p.id[lane] = p.id[lane] == 0 ? 1 : 0;
             }),
             Catch::Contains("is not there once"));
  CHECK_THAT(refusal_of([](Particles<2>& p) {
               p.id[first_particle(p)] = static_cast<std::uint32_t>(p.count);
             }),
             Catch::Contains("is not there once"));
  CHECK_THAT(refusal_of([](Particles<2>& p) { p.id[first_particle(p)] = Particles<2>::kNoId; }),
             Catch::Contains("holds"));
}

TEST_CASE("a state whose groups are not those of the case is refused") {
  const auto slots = [](const Particles<2>& p) { return p.group_begin.back(); };
  for (const Change& change : std::vector<Change>{
           [&](Particles<2>& p) { p.group_begin[p.group_begin.size() / 2] = slots(p) + 1; },
           [&](Particles<2>& p) { p.group_begin[p.group_begin.size() / 2] = 0; },
           [&](Particles<2>& p) { p.group_begin.front() = 1; },
           [&](Particles<2>& p) { ++p.group_begin.back(); },
           [&](Particles<2>& p) { p.group_begin.push_back(slots(p)); }}) {
    CHECK_THAT(refusal_of(change), Catch::Contains("its groups are not those of this case"));
  }
  CHECK_THAT(refusal_of([](Particles<2>& p) { p.mass.pop_back(); }),
             Catch::Contains("not of one length"));
}

}  // namespace rgimp::tests
