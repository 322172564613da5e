#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "rgimp/kernels/views.hpp"

namespace rgimp::kernels::reference {

/// A symmetric stress, Pa, tension positive, in the order of the columns; in plane strain
/// yz = xz = 0.
template <int Dim>
struct Stress {
  double value[kStressComponents<Dim>] = {};
};

template <int Dim>
Stress<Dim> load_stress(const ParticleView<Dim>& particles, std::size_t p) {
  Stress<Dim> s;
  for (int c = 0; c < kStressComponents<Dim>; ++c) {
    s.value[c] = particles.stress[c][p];
  }
  return s;
}

template <int Dim>
void store_stress(const ParticleView<Dim>& particles, std::size_t p, const Stress<Dim>& s) {
  for (int c = 0; c < kStressComponents<Dim>; ++c) {
    particles.stress[c][p] = s.value[c];
  }
}

template <int Dim>
double trace(const Stress<Dim>& s) {
  return s.value[0] + s.value[1] + s.value[2];
}

/// s : s.
template <int Dim>
double square(const Stress<Dim>& s) {
  double sum = 0.0;
  for (int c = 0; c < kStressComponents<Dim>; ++c) {
    sum += (c < 3 ? 1.0 : 2.0) * s.value[c] * s.value[c];
  }
  return sum;
}

/// Principal stresses, largest first.
struct Principal {
  double major;
  double middle;
  double minor;
};

inline Principal principal_stresses(const Stress<2>& s) {
  const double xx = s.value[0];
  const double yy = s.value[1];
  const double zz = s.value[2];
  const double xy = s.value[3];
  const double centre = 0.5 * (xx + yy);
  const double radius = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  const double high = centre + radius;
  const double low = centre - radius;
  return {std::max(high, zz), std::max(low, std::min(high, zz)), std::min(low, zz)};
}

/// Turns the axes a and b so that their product vanishes (a step of Jacobi's method).
inline void turn(double (&s)[3][3], int a, int b) {
  if (s[a][b] == 0.0) {
    return;
  }
  const int c = 3 - a - b;
  const double difference = s[b][b] - s[a][a];
  const double twice = 2.0 * s[a][b];
  const double tangent = std::copysign(1.0, difference) * twice /
                         (std::abs(difference) + std::hypot(difference, twice));
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  const double sine = tangent * cosine;
  s[a][a] -= tangent * s[a][b];
  s[b][b] += tangent * s[a][b];
  s[a][b] = s[b][a] = 0.0;
  const double ac = s[a][c];
  const double bc = s[b][c];
  s[a][c] = s[c][a] = cosine * ac - sine * bc;
  s[b][c] = s[c][b] = sine * ac + cosine * bc;
}

/// Jacobi's method, as exact for equal principal stresses as for any.
inline Principal principal_stresses(const Stress<3>& stress) {
  double s[3][3];
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      s[a][b] = stress.value[kStressColumn[a][b]];
    }
  }
  for (int sweep = 0; sweep < 8; ++sweep) {
    turn(s, 0, 1);
    turn(s, 1, 2);
    turn(s, 0, 2);
  }
  double value[3] = {s[0][0], s[1][1], s[2][2]};
  std::sort(value, value + 3);
  return {value[2], value[1], value[0]};
}

}  // namespace rgimp::kernels::reference
