#include "peak_loops_of.hpp"

namespace rgimp::bench {

const PeakLoops kAvx512Loops = loops_of<xsimd::batch<double, xsimd::avx512dq>>();

}  // namespace rgimp::bench
