// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <istream>
#include <ostream>

#include "simulate/simulation.h"

/// Files of trajectories, written step by step. Each line is complete, so that an interrupted run continues from its
/// last complete line.
namespace touchstone::simulate {

Json header_of(const Simulation& simulation);
/// JSON lines: a header with the scene, then one line per step with every run's numbers, contacts, energy, momentum,
/// drift of that step (all exact) and hashes, and the cause of any divergence of two runs. docs/simulate.md describes
/// the fields.
void write_header(const Simulation& simulation, std::ostream& out);
void write_step(const Simulation& simulation, std::ostream& out);

/// Comma-separated: one line for each step, run and body.
void write_csv_header(std::ostream& out);
void write_csv_step(const Simulation& simulation, std::ostream& out);

/// The data kept of one step that was read back.
struct Frame {
  std::uint64_t step;
  std::vector<Snapshot> runs;
  std::vector<Drift> drifts;  ///< since the start
  std::vector<Json> partings;
};

/// Reads a trajectory in JSON lines up to its last complete line, calls visit for each step, and sets the simulation to
/// the last one. Returns the length read. Throws InvalidInput if the file holds another scene or other runs, misses a
/// step, or a hash or a sum is not that of its numbers: the field names line and position.
std::uint64_t read_trajectory(std::istream& in, Simulation& simulation, const std::function<void(const Frame&)>& visit);

/// A divergence: runs, contact, and for each run the question and its answer.
Json in_json(const Scene& scene, const Parting& parting);

}  // namespace touchstone::simulate
