#include "peak_loops_of.hpp"

namespace rgimp::bench {

const PeakLoops kBaselineLoops = loops_of<xsimd::batch<double, xsimd::sse2>>();

}  // namespace rgimp::bench
