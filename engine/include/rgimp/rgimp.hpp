#pragma once

#include "rgimp/case.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/crack_clusters.hpp"
#include "rgimp/cracks.hpp"
#include "rgimp/error.hpp"
#include "rgimp/machine.hpp"
#include "rgimp/results.hpp"
#include "rgimp/run.hpp"
#include "rgimp/simulation.hpp"
#include "rgimp/specimen.hpp"
#include "rgimp/sweep.hpp"
#include "rgimp/tuning.hpp"
