#include "peak_loops_of.hpp"

namespace rgimp::bench {

const PeakLoops kAvx2Loops = loops_of<xsimd::batch<double, xsimd::fma3<xsimd::avx2>>>();

}  // namespace rgimp::bench
