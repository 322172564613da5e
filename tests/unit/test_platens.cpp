#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"
#include "platens.hpp"

// What platens do to nodes, against closed forms.
namespace rgimp::tests {
namespace {

Platen platen_on(Side side, double speed, Lateral lateral = Lateral::slip) {
  Platen platen;
  platen.side = side;
  platen.speed = speed;
  platen.lateral = lateral;
  return platen;
}

/// A block whose centre is not the origin, its grid, and platens at a time past every ramp.
template <int Dim>
struct HeldIn {
  explicit HeldIn(const std::vector<Platen>& platens)
      : settings(case_with(platens)),
        grid(grid_extent(settings), 2, 0.7),
        held(settings, grid),
        view(grid.view()) {
    held.set_time(1.0);
  }

  static Case case_with(const std::vector<Platen>& platens) {
    Case settings = Dim == 2 ? free_block(5.0, 4.0) : free_block_in_space(Vector(5.0, 4.0, 3.0));
    settings.bodies.front().center = Vector(3e-3, -1e-3, Dim == 2 ? 0.0 : 2e-3);
    settings.platens = platens;
    return settings;
  }

  std::ptrdiff_t node_at(double x_mm, double y_mm, double z_mm = 0.0) const {
    const GridExtent& extent = grid.extent();
    const auto index = [&](int axis, double mm) {
      return std::lround((1e-3 * mm - extent.origin[axis]) / extent.spacing[axis]);
    };
    const std::ptrdiff_t row = index(2, z_mm) * extent.nodes[1] + index(1, y_mm);
    return row * grid.row_stride() + index(0, x_mm);
  }

  /// Whether a component of a node's velocity is prescribed.
  bool is_held(int component, std::ptrdiff_t node) {
    view.second_field[component][node] = 99.0;
    held.impose_on_second_field(view, {0, grid.rows()});
    return view.second_field[component][node] != 99.0;
  }

  Case settings;
  Grid<Dim> grid;
  Platens<Dim> held;
  kernels::GridView<Dim> view;
};
using Held = HeldIn<2>;

}  // namespace

TEST_CASE("a platen's speed rises without a jump or a kink, and its travel is the integral") {
  const double speed = 0.4;
  Platen platen = platen_on(Side::top, speed);
  platen.ramp = 2.0;
  const double h = 1e-5;
  const auto slope = [&](double time) {
    return (platen_speed(platen, time + h) - platen_speed(platen, time - h)) / (2.0 * h);
  };
  CHECK(platen_speed(platen, 0.0) == 0.0);
  CHECK(platen_speed(platen, 1.0) == Approx(0.5 * speed).epsilon(1e-14));
  CHECK(platen_speed(platen, 2.0) == speed);
  CHECK(slope(h) == Approx(0.0).margin(1e-4));
  CHECK(slope(2.0) == Approx(0.0).margin(1e-4));
  CHECK(platen_travel(platen, 0.0) == 0.0);
  for (const double time : {0.1, 0.7, 1.3, 1.99, 2.01, 5.0}) {
    INFO("time " << time);
    const double rate =
        (platen_travel(platen, time + h) - platen_travel(platen, time - h)) / (2.0 * h);
    CHECK(rate == Approx(platen_speed(platen, time)).epsilon(1e-8));
  }
  CHECK(platen_travel(platen, 5.0) - platen_travel(platen, 2.0) == Approx(3.0 * speed));
}

TEST_CASE("at a corner the normal velocity of one platen wins over the other's sticking") {
  for (const bool top_first : {true, false}) {
    std::vector<Platen> platens = {platen_on(Side::top, 0.5, Lateral::stick),
                                   platen_on(Side::right, 0.25, Lateral::stick)};
    if (!top_first) {
      std::swap(platens[0], platens[1]);
    }
    Held block(platens);
    const std::ptrdiff_t corner = block.node_at(5.5, 1.0);
    CHECK(block.is_held(0, corner));
    CHECK(block.view.second_field[0][corner] == -0.25);
    CHECK(block.is_held(1, corner));
    CHECK(block.view.second_field[1][corner] == -0.5);
    const std::ptrdiff_t along = block.node_at(3.0, 1.0);
    CHECK(block.is_held(0, along));
    CHECK(block.view.second_field[0][along] == 0.0);
    CHECK(block.view.damping[corner] == 0.0);
    CHECK(block.view.damping[block.node_at(3.0, 0.5)] == 0.7);
  }
}

TEST_CASE("a strip is as wide as told about the specimen's middle, its edges included") {
  std::vector<Platen> platens = {platen_on(Side::top, 0.5)};
  platens[0].half_width = 1e-3;
  Held block(platens);
  for (const double x : {2.0, 3.0, 4.0}) {
    CHECK(block.is_held(1, block.node_at(x, 1.0)));
  }
  for (const double x : {0.5, 1.5, 4.5}) {
    CHECK_FALSE(block.is_held(1, block.node_at(x, 1.0)));
  }
  CHECK_FALSE(block.is_held(1, block.node_at(3.0, 0.5)));  // the row below the end
  CHECK(block.is_held(1, block.node_at(3.0, 1.5)));        // and all beyond it
  CHECK_FALSE(block.is_held(0, block.node_at(3.0, 1.0)));  // slips
}

TEST_CASE("in space each of the six sides holds its end of the block and what is beyond") {
  struct End {
    Side side;
    int axis;
    Vector at;  // mm, the middle of the end
    Vector inwards;
  };
  const End ends[] = {{Side::left, 0, {0.5, -1.0, 2.0}, Vector::UnitX()},
                      {Side::right, 0, {5.5, -1.0, 2.0}, -Vector::UnitX()},
                      {Side::bottom, 1, {3.0, -3.0, 2.0}, Vector::UnitY()},
                      {Side::top, 1, {3.0, 1.0, 2.0}, -Vector::UnitY()},
                      {Side::back, 2, {3.0, -1.0, 0.5}, Vector::UnitZ()},
                      {Side::front, 2, {3.0, -1.0, 3.5}, -Vector::UnitZ()}};
  for (const End& end : ends) {
    INFO("side " << static_cast<int>(end.side));
    HeldIn<3> block({platen_on(end.side, 0.25)});
    const auto node = [&](double cells_inwards) {
      const Vector at = end.at + 0.5 * cells_inwards * end.inwards;
      return block.node_at(at.x(), at.y(), at.z());
    };
    for (int a = 0; a < 3; ++a) {
      CHECK(block.is_held(a, node(0.0)) == (a == end.axis));
      CHECK(block.is_held(a, node(-1.0)) == (a == end.axis));
      CHECK_FALSE(block.is_held(a, node(1.0)));
    }
    CHECK(block.view.second_field[end.axis][node(0.0)] == 0.25 * end.inwards[end.axis]);
    CHECK(block.view.damping[node(0.0)] == 0.0);
    CHECK(block.view.damping[node(1.0)] == 0.7);
  }
}

TEST_CASE("in space a strip runs through along the third axis, across x, or y for left and right") {
  std::vector<Platen> platens = {platen_on(Side::top, 0.5), platen_on(Side::right, 0.5),
                                 platen_on(Side::front, 0.5)};
  for (Platen& platen : platens) {
    platen.half_width = 1e-3;
  }
  HeldIn<3> block(platens);
  for (const double z : {0.5, 2.0, 3.5}) {
    CHECK(block.is_held(1, block.node_at(4.0, 1.0, z)));
    CHECK_FALSE(block.is_held(1, block.node_at(4.5, 1.0, z)));
    CHECK(block.is_held(0, block.node_at(5.5, 0.0, z)));
    CHECK_FALSE(block.is_held(0, block.node_at(5.5, 0.5, z)));
  }
  for (const double y : {-3.0, 1.0}) {
    CHECK(block.is_held(2, block.node_at(2.0, y, 3.5)));
    CHECK_FALSE(block.is_held(2, block.node_at(1.5, y, 3.5)));
  }
}

TEST_CASE("where three platens that stick meet, each wins along its own axis") {
  HeldIn<3> block({platen_on(Side::top, 0.5, Lateral::stick),
                   platen_on(Side::left, 0.25, Lateral::stick),
                   platen_on(Side::front, 0.125, Lateral::stick)});
  const std::ptrdiff_t corner = block.node_at(0.5, 1.0, 3.5);
  const double expected[3] = {0.25, -0.5, -0.125};
  for (int a = 0; a < 3; ++a) {
    CHECK(block.is_held(a, corner));
    CHECK(block.view.second_field[a][corner] == expected[a]);
  }
  const std::ptrdiff_t edge = block.node_at(0.5, 1.0, 2.0);
  CHECK(block.is_held(2, edge));
  CHECK(block.view.second_field[2][edge] == 0.0);
}

TEST_CASE("in space only nodes on the axis of the load are without damping") {
  HeldIn<3> block({platen_on(Side::top, 0.5), platen_on(Side::front, 0.0)});
  CHECK(block.view.damping[block.node_at(3.0, 1.0, 2.0)] == 0.0);
  CHECK(block.view.damping[block.node_at(3.0, 1.0, 3.5)] == 0.0);
  CHECK(block.view.damping[block.node_at(3.0, -1.0, 3.5)] == 0.7);
}

TEST_CASE("reaction and work are those of the force that a prescribed velocity takes") {
  Held block({platen_on(Side::top, 0.5, Lateral::stick)});
  const kernels::GridView<2>& view = block.view;
  const std::ptrdiff_t node = block.node_at(3.0, 1.0);
  const std::ptrdiff_t row = node / block.grid.row_stride();
  const double mass = 2.0;
  const double dt = 0.1;
  const kernels::NodeUpdate<2> update{dt, 1e-9, {6.0, -7.0}};
  const double acceleration[2] = {3.0, 4.0};
  const double velocity[2] = {0.7, -0.2};  // at the end of the step, if nothing held the node
  const double target[2] = {0.0, -0.5};
  std::vector<PlatenSums> sums(static_cast<std::size_t>(block.grid.rows()), {5.0, {5.0}});
  view.mass[node] = mass;
  double work = 0.0;
  for (int a = 0; a < 2; ++a) {
    view.momentum[a][node] = velocity[a];
    view.force[a][node] = acceleration[a];
    const double before = velocity[a] - dt * acceleration[a];
    // The reaction's, and the body force's on the velocity that the node does not get.
    work += mass * (target[a] - velocity[a]) * 0.5 * (before + target[a]) +
            mass * update.body_acceleration[a] * 0.5 * dt * (target[a] - velocity[a]);
  }
  block.held.impose(view, update, {0, block.grid.rows()}, sums);
  for (int a = 0; a < 2; ++a) {
    CHECK(view.momentum[a][node] == target[a]);
    CHECK(view.force[a][node] ==
          Approx(acceleration[a] + (target[a] - velocity[a]) / dt).epsilon(1e-13));
  }
  CHECK(sums[row].work == Approx(work).epsilon(1e-13));
  CHECK(sums[row].reaction[0] == Approx(mass * (0.5 - 0.2) / dt).epsilon(1e-13));
  CHECK(sums[row - 1].work == 0.0);
  CHECK(sums[row - 1].reaction[0] == 0.0);
}

}  // namespace rgimp::tests
