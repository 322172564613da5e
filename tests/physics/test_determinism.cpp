#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"
#include "state_hash.hpp"

namespace rgimp::tests {
namespace {

struct Outcome {
  std::uint64_t hash;
  HistoryRow row;
};

Outcome crack(const Case& settings, int threads, kernels::Isa isa) {
  Model model(settings, threads, isa);
  for (int part = 0; part < 10; ++part) {
    model.steps(200);
    model.solver.rebin();
  }
  return {state_hash(model.solver.particles()), model.solver.history()};
}

Outcome crack_in_space(const Case& settings, int threads, kernels::Isa isa) {
  ModelIn<3> model(settings, threads, isa);
  for (int part = 0; part < 4; ++part) {
    model.steps(200);
    model.solver.rebin();
  }
  return {state_hash(model.solver.particles()), model.solver.history()};
}

Outcome crack(int threads, kernels::Isa isa) {
  return crack(cracking_block(), threads, isa);
}

HistoryRow elastic_row(Case settings) {
  settings.materials["rock"].failure.reset();
  settings.local_damping = 0.0;
  Model model(settings, 2, kernels::best_isa());
  model.steps(1000);
  return model.solver.history();
}

}  // namespace

TEST_CASE("no tuning changes a bit of a cracking run") {
  const std::uint64_t expected = crack(1, kernels::best_isa()).hash;
  Case settings = cracking_block();
  for (const int bands : {1, 2, 3, 5, 8, 64}) {  // of 1 to 64
    settings.tuning.bands_per_task = bands;
    for (const int threads : {1, 2, 3, 7}) {
      INFO(bands << " bands a task, " << threads << " threads");
      REQUIRE(crack(settings, threads, kernels::best_isa()).hash == expected);
    }
  }
}

// Before the first failure, and without local damping, as below.
TEST_CASE("numerics change an elastic run by less than 1e-10") {
  Case settings = cracking_block();
  const HistoryRow expected = elastic_row(settings);
  for (const int height : {2, 3, 8, 64}) {
    settings.numerics.band_height = height;
    const HistoryRow row = elastic_row(settings);
    INFO("bands of " << height << " rows");
    REQUIRE(row.strain_energy == Approx(expected.strain_energy).epsilon(1e-10));
    REQUIRE(row.reaction == Approx(expected.reaction).epsilon(1e-10));
    REQUIRE(row.external_work == Approx(expected.external_work).epsilon(1e-10));
  }
}

TEST_CASE("1, 2, 3 and 7 threads give the same bits in a cracking case with re-binning") {
  const Outcome one = crack(1, kernels::best_isa());
  REQUIRE(one.row.failed_tension > 20);
  for (const int threads : {2, 3, 7}) {
    const Outcome more = crack(threads, kernels::best_isa());
    INFO(threads << " threads");
    REQUIRE(more.hash == one.hash);
    REQUIRE(more.row.external_work == one.row.external_work);
    REQUIRE(more.row.released_energy == one.row.released_energy);
  }
}

TEST_CASE("a softening run has the same bits on any number of threads, and on AVX2 and AVX-512") {
  const Outcome one = crack(softening_block(), 1, kernels::best_isa());
  REQUIRE(one.row.failed_tension > 20);
  REQUIRE(one.row.failed_shear > 0);
  for (const int threads : {2, 3}) {
    INFO(threads << " threads");
    REQUIRE(crack(softening_block(), threads, kernels::best_isa()).hash == one.hash);
  }
  if (kernels::available(kernels::Isa::avx512)) {
    REQUIRE(crack(softening_block(), 2, kernels::Isa::avx2).hash == one.hash);
  }
}

TEST_CASE("a penny cracks to the same bits on any number of threads, and on AVX2 and AVX-512") {
  Case settings = cracking_block_in_space();
  const Outcome one = crack_in_space(settings, 1, kernels::best_isa());
  REQUIRE(one.row.failed_tension > 20);
  for (const int threads : {2, 3, 7}) {
    settings.tuning.bands_per_task = threads % 3 + 1;
    const Outcome more = crack_in_space(settings, threads, kernels::best_isa());
    INFO(threads << " threads");
    REQUIRE(more.hash == one.hash);
    REQUIRE(more.row.external_work == one.row.external_work);
    REQUIRE(more.row.released_energy == one.row.released_energy);
  }
  if (kernels::available(kernels::Isa::avx512)) {
    REQUIRE(crack_in_space(settings, 2, kernels::Isa::avx2).hash == one.hash);
  }
}

TEST_CASE("the scalar twins give the same bits on any number of threads") {
  REQUIRE(crack(1, kernels::Isa::reference).hash == crack(3, kernels::Isa::reference).hash);
}

TEST_CASE("AVX2 and AVX-512 give the same bits") {
  if (kernels::available(kernels::Isa::avx512)) {
    REQUIRE(crack(2, kernels::Isa::avx2).hash == crack(2, kernels::Isa::avx512).hash);
  }
}

// Without local damping: the sign of a velocity that is round-off is round-off too, so damping
// makes 1e-16 grow to 1e-7 within a thousand steps.
TEST_CASE("an elastic run agrees on all ISAs within 1e-12") {
  Case settings = cracking_block();
  settings.materials["rock"].failure.reset();
  settings.local_damping = 0.0;
  Model reference(settings, 1, kernels::Isa::reference);
  reference.steps(1000);
  const HistoryRow expected = reference.solver.history();
  for (const kernels::Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      Model model(settings, 2, isa);
      model.steps(1000);
      const HistoryRow row = model.solver.history();
      INFO(kernels::name(isa));
      REQUIRE(row.strain_energy == Approx(expected.strain_energy).epsilon(1e-12));
      REQUIRE(row.reaction == Approx(expected.reaction).epsilon(1e-12));
      REQUIRE(row.external_work == Approx(expected.external_work).epsilon(1e-12));
    }
  }
}

}  // namespace rgimp::tests
