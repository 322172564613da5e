#include "kernel_parts.hpp"
#include "reference/pass.hpp"

namespace rgimp::bench {
namespace {

using namespace kernels::reference;
using kernels::kGroupWidth;

/// Column 0 of a particle's lane.
template <int Columns>
double* place_in(double* out, std::size_t slot_mask, std::size_t slot, std::size_t particle) {
  return out + (slot & slot_mask) * Columns * kGroupWidth + particle % kGroupWidth;
}

void find_weights(const PartInput& input, double* out, std::size_t slot_mask) {
  const Shape<2> shape(input.grid);
  for_each_particle(input.particles, input.grid, input.bins,
                    [&](std::size_t p, const BinNode<2>& bin, std::size_t slot) {
                      double* to = place_in<kWeightColumns>(out, slot_mask, slot, p);
                      const Stencil<2> stencil = stencil_of(input.particles, p, bin, shape);
                      for (int a = 0; a < 2; ++a) {
                        const AxisWeights& weights = stencil.axis[a];
                        for (int k = 0; k < 3; ++k) {
                          to[k * kGroupWidth] = weights.value[k];
                          to[(3 + k) * kGroupWidth] = weights.slope[k] * input.grid.spacing[a];
                        }
                        to += 6 * kGroupWidth;
                      }
                    });
}

void gather_force(const PartInput& input, double* out, std::size_t slot_mask) {
  const Shape<2> shape(input.grid);
  for_each_particle(input.particles, input.grid, input.bins,
                    [&](std::size_t p, const BinNode<2>& bin, std::size_t slot) {
                      const Stencil<2> stencil = stencil_of(input.particles, p, bin, shape);
                      const Gathered<2> sum = gather_acceleration(stencil, shape, input.grid);
                      double* to = place_in<kGatherColumns>(out, slot_mask, slot, p);
                      to[0] = sum.value[0];
                      to[kGroupWidth] = sum.value[1];
                    });
}

void update_stress(const PartInput& input, double* out, std::size_t slot_mask) {
  for_each_particle(input.particles, input.grid, input.bins,
                    [&](std::size_t p, const BinNode<2>&, std::size_t slot) {
                      const double xx = input.strain_per_velocity * input.particles.velocity[0][p];
                      const double yy = input.strain_per_velocity * input.particles.velocity[1][p];
                      const Stress<2> stress =
                          elastic_stress(load_stress(input.particles, p),
                                         {xx, yy, xx + yy, 0.5 * (xx - yy)}, *input.material);
                      double* to = place_in<kStressColumns>(out, slot_mask, slot, p);
                      for (int c = 0; c < kernels::kStressComponents<2>; ++c) {
                        to[c * kGroupWidth] = stress.value[c];
                      }
                    });
}

void test_failure(const PartInput& input, double* out, std::size_t slot_mask) {
  for_each_particle(
      input.particles, input.grid, input.bins,
      [&](std::size_t p, const BinNode<2>&, std::size_t slot) {
        const double mode = failure_mode(load_stress(input.particles, p), input.material->limits);
        *place_in<kFailureColumns>(out, slot_mask, slot, p) = mode == kernels::kIntact ? 0.0 : 1.0;
      });
}

}  // namespace

const KernelParts kReferenceParts = {find_weights, gather_force, update_stress, test_failure};

}  // namespace rgimp::bench
