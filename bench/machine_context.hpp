#pragma once

namespace rgimp::bench {

/// Adds to the context of the results what they depend on: processor, memory, instruction sets,
/// compiler and flags, version.
void add_machine_context();

}  // namespace rgimp::bench
