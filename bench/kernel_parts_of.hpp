#pragma once

#include "kernel_parts.hpp"
#include "src/pass.hpp"

/// All parts of one ISA. Include a lanes_*.hpp first. All internal to the unit that includes it:
/// units compiled for different ISAs must share no code.
namespace rgimp::kernels {
namespace {

template <int Columns>
double* place_in(double* out, std::size_t slot_mask, std::size_t slot, int part) {
  return out + (slot & slot_mask) * Columns * kGroupWidth + part * kLanes;
}

/// Calls visit(place, slots, part) for every part of every group that has slots.
template <typename Visit>
void for_each_part(const bench::PartInput& input, Visit visit) {
  const GridView<2>& grid = input.grid;
  for (std::ptrdiff_t row = input.bins.first; row < input.bins.last; ++row) {
    const std::uint32_t* begin = input.particles.group_begin + row * grid.groups_in_row;
    for (std::ptrdiff_t column = 0; column < grid.groups_in_row; ++column) {
      const Slots slots{begin[column], begin[column + 1]};
      if (slots.count() > 0) {
        const GroupPlace<2> place(grid, row, column);
        for (int part = 0; part < kParts; ++part) {
          visit(place, slots, part);
        }
      }
    }
  }
}

/// Calls visit(slot, part) for all slots of the rows.
template <typename Visit>
void for_each_slot(const bench::PartInput& input, Visit visit) {
  const std::uint32_t* begin = input.particles.group_begin;
  const std::size_t last = begin[input.bins.last * input.grid.groups_in_row];
  for (std::size_t slot = begin[input.bins.first * input.grid.groups_in_row]; slot < last; ++slot) {
    for (int part = 0; part < kParts; ++part) {
      visit(slot, part);
    }
  }
}

[[gnu::flatten]] void find_weights(const bench::PartInput& input, double* out,
                                   std::size_t slot_mask) {
  const ShapeConstants<2> shape(input.grid);
  for_each_part(input, [&](const GroupPlace<2>& place, Slots slots, int part) {
    const BinOffsets<2> offsets = place.offsets(shape, part);
    for (std::size_t slot = slots.first; slot < slots.last; ++slot) {
      const std::size_t index = slot * kGroupWidth + part * kLanes;
      const Places<2> places(input.particles, index, offsets, shape);
      double* to = place_in<bench::kWeightColumns>(out, slot_mask, slot, part);
      for (const AxisPlace& along_axis : places.axis) {
        AxisWeights weights;
        find_axis_weights<2>(along_axis, shape, weights);
        for (int k = 0; k < 3; ++k) {
          weights.value[k].store_aligned(to + k * kGroupWidth);
          weights.slope[k].store_aligned(to + (3 + k) * kGroupWidth);
        }
        to += 6 * kGroupWidth;
      }
    }
  });
}

[[gnu::flatten]] void gather_force(const bench::PartInput& input, double* out,
                                   std::size_t slot_mask) {
  const ShapeConstants<2> shape(input.grid);
  for_each_part(input, [&](const GroupPlace<2>& place, Slots slots, int part) {
    VectorCoefficients<2> field;
    load_coefficients(input.grid.force, place, part, field);
    const BinOffsets<2> offsets = place.offsets(shape, part);
    for (std::size_t slot = slots.first; slot < slots.last; ++slot) {
      const std::size_t index = slot * kGroupWidth + part * kLanes;
      const Places<2> places(input.particles, index, offsets, shape);
      const Basis<2> basis(places, shape);
      double* to = place_in<bench::kGatherColumns>(out, slot_mask, slot, part);
      value_at(field.component[0], basis).store_aligned(to);
      value_at(field.component[1], basis).store_aligned(to + kGroupWidth);
    }
  });
}

inline Increment<2> increment_of(const bench::PartInput& input, std::size_t index) {
  const Batch scale(input.strain_per_velocity);
  const Batch xx = scale * Batch::load_aligned(input.particles.velocity[0] + index);
  const Batch yy = scale * Batch::load_aligned(input.particles.velocity[1] + index);
  return {xx, yy, xx + yy, xx - yy};
}

[[gnu::flatten]] void update_stress(const bench::PartInput& input, double* out,
                                    std::size_t slot_mask) {
  const StepMaterial<2> material(*input.material, 1.0);
  for_each_slot(input, [&](std::size_t slot, int part) {
    const std::size_t index = slot * kGroupWidth + part * kLanes;
    const Increment<2> increment = increment_of(input, index);
    const Stress<2> stress = elastic_stress(load_stress(input.particles, index), increment,
                                            trace(increment), material.elasticity);
    double* to = place_in<bench::kStressColumns>(out, slot_mask, slot, part);
    stress.xx.store_aligned(to);
    stress.yy.store_aligned(to + kGroupWidth);
    stress.zz.store_aligned(to + 2 * kGroupWidth);
    stress.xy.store_aligned(to + 3 * kGroupWidth);
  });
}

[[gnu::flatten]] void test_failure(const bench::PartInput& input, double* out,
                                   std::size_t slot_mask) {
  const FailureTest<2> test(input.material->limits);
  for_each_slot(input, [&](std::size_t slot, int part) {
    const Stress<2> stress = load_stress(input.particles, slot * kGroupWidth + part * kLanes);
    const Mask fails = may_fail(stress, test);
    xsimd::select(fails, Batch(1.0), Batch(0.0))
        .store_aligned(place_in<bench::kFailureColumns>(out, slot_mask, slot, part));
  });
}

constexpr bench::KernelParts make_parts() {
  return {find_weights, gather_force, update_stress, test_failure};
}

}  // namespace
}  // namespace rgimp::kernels
