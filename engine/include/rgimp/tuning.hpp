#pragma once

namespace rgimp {

/// Settings of speed that never change a bit of the result. Measured on example 1, AMD EPYC, two
/// cores, AVX-512. There is no prefetch distance: 1 to 8 slots ahead changed nothing, as a step in
/// the plane is bound by computing.
struct Tuning {
  /// 0 to 1024; 0: all the machine has. Two are 1.97 times as fast as one.
  int threads = 0;
  /// 1 to 64: bands of rows that a thread takes at a time. More cost fewer handshakes between the
  /// threads, and leave them less even.
  int bands_per_task = 1;
};

/// Settings of the order in which sums are added: they change results by round-off, hence belong to
/// a case, and never follow from the number of threads. There is no margin of drift at which
/// particles are sorted into bins anew: it follows from the weights, and in example 1 none drifts
/// as far in 222,440 steps. Nor is the instruction set here: a case runs on any machine, AVX2 and
/// AVX-512 have the same bits, and the environment variable RGIMP_ISA chooses for comparisons.
struct Numerics {
  /// 2 to 64 rows of nodes, in three dimensions planes. A band of rows is worked on by one thread
  /// at a time. At 8 two threads are 1.82 times as fast as one, at 4 1.97 times: example 1 has 27
  /// bands of 8, too few to share out evenly.
  int band_height = 4;
};

}  // namespace rgimp
