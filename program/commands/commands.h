// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"
#include "audit/engines/notes.h"
#include "audit/meshes/prepared.h"
#include "catalogue/operation/operation.h"
#include "program/runs/audit_gate.h"
#include "program/terminal/each_line.h"
#include "program/terminal/names.h"

/// The commands, each a function of its parsed options: output goes to `out`, complaints to `err`, and the exit code is
/// returned.
namespace touchstone::program {

struct AuditCommand {
  std::string program = "touchstone";  ///< the name by which it was called
  std::string engine;                  ///< command; empty: our reference in double
  std::string against;                 ///< command of a second engine, to compare both; empty: none
  std::string operations = "all";      ///< "all" or names separated by commas
  std::string families;                ///< names separated by commas; empty: all
  std::uint64_t cases = 20000, seed = 1;
  bool by_cost = false;  ///< fewer cases for expensive operations
  double seconds = 0, timeout = usual_timeout;
  int jobs = 0;       ///< 0: as many as the machine has
  std::string shard;  ///< "I/N"; empty: from the launcher, if one started this
  std::string json_file, report_directory;
  double report_seconds = 0;
  std::string before;         ///< file of an earlier audit (--json) to compare with this one in the report
  std::string range = "all";  ///< "ordinary": only questions of ordinary magnitude
  std::string ordinary = "0x1p-100,0x1p100";  ///< LEAST,MOST: the ordinary range
  bool summary = false;                       ///< a row for each operation, no families and no examples
  std::size_t width = 120;                    ///< of a question or an answer on the screen; 0: never truncated
  bool verbose = false;                       ///< on a terminal, too, all families and findings, not one screen
  GateCommand gate;
};

struct AskCommand {
  std::string operation, file = "-";
  bool as_typed = false;
  bool truth = false;  ///< only the truth and its margin
  std::string as;      ///< one of test_frameworks: regression tests instead of JSON lines; empty: JSON
  std::string engine;  ///< command of an engine that is also asked; empty: none
  double timeout = usual_timeout;
  std::vector<std::string> meshes;    ///< "field=FILE": a mesh field of every line, from a file
  Preparation preparation;            ///< applied to those meshes
  bool verbose = false;               ///< prints how they were read
  bool wkt = false, geojson = false;  ///< the input's format instead of JSON
};

struct CertifyCommand {
  std::string file = "-";
  std::vector<std::string> meshes;  ///< "field=FILE": the mesh that every claim must be about
  Preparation preparation;          ///< applied to those meshes
};

struct ExhaustCommand {
  std::string program = "touchstone";
  std::string operation;
  int grid = 3;
  std::string shard, json_file;  ///< as for an audit
  bool decisions = false;
  std::string engine;  ///< command of an engine to ask instead of our reference; empty: none
  double timeout = usual_timeout;
  int jobs = 0;                 ///< 0: as many as the machine has, or one with an engine
  std::size_t list_length = 0;  ///< elements of each list; 0: the number in Metadata
};

/// Duration in seconds of a soak without another limit, and a number of cases that no soak reaches.
inline constexpr double usual_soak = 60;
inline constexpr std::uint64_t most_cases = 1'000'000'000'000;

struct SoakCommand {
  std::string operations = "all";
  double seconds = 0;       ///< 0: until all cases are asked
  std::uint64_t cases = 0;  ///< per operation, in all shards together; 0: until the time is over
  std::uint64_t seed = 1;
  std::string shard, json_file;  ///< as for an audit
  int jobs = 0;
};

struct MergeCommand {
  std::vector<std::string> files;
  std::string json_file;
};

struct VectorsCheckCommand {
  std::string program = "touchstone";  ///< the name by which it was called
  std::string operations = "all";      ///< "all" or names separated by commas
  std::string directory;
  std::string engine;  ///< command of an engine that is also asked; empty: none
  double timeout = usual_timeout;
  std::string json_file, junit_file;  ///< the engine's answers, as for an audit
  bool verbose = false;               ///< every finding, instead of ten per file
};

struct CheckEngineCommand {
  std::string engine;
  double timeout = usual_timeout;
};

struct DrawCommand {
  std::string operation;
  std::string families;  ///< names separated by commas; empty: all
  std::uint64_t cases = 100, seed = 1;
  std::string range = "all";  ///< or "ordinary": only those are printed
  bool binary32 = false;      ///< rounds numbers to float before the truth is computed
};

struct SimulateCommand {
  std::string file;
  std::optional<std::uint64_t> steps;  ///< empty: the scene's number
  std::string runs = "float,double,robust";
  std::string trajectory;  ///< file; empty: none
  bool resume = false;
  std::string page;                  ///< file of the HTML page; empty: none
  std::vector<std::string> engines;  ///< commands of engines that also make the steps
  double timeout = usual_timeout;
};

struct DeckCommand {
  std::string page;          ///< file of the HTML page
  std::string scenes;        ///< directory of the scenes to play; empty: none
  std::uint64_t cases = 40;  ///< per operation, searched for one that breaks it
  int jobs = 0;              ///< 0: as many as the machine has
};

struct MeshCommand {
  std::vector<std::string> files;
  Preparation preparation;
  std::string repair, page;  ///< files; empty: none
  bool json = false;
};

int ops_command(bool json, std::ostream& out);
/// The operations nearest to these words, with their questions. Throws UsageError if no word matches.
int ops_search_command(const std::vector<std::string>& words, std::ostream& out);
/// docs/operations.md: each operation's C++ signature, JSON fields and enumerators.
int operations_page_command(std::ostream& out);
int ask_command(const AskCommand& command, std::ostream& out, std::ostream& err);
int audit_command(const AuditCommand& command, std::ostream& out, std::ostream& err);
/// Questions within the contract, spread over the families in turn, each with its truth, as JSON lines for test suites
/// in any language: op, family, index, input, truth (exact), rounded (nearest doubles), margin, touch (open and closed
/// sets answer differently).
int draw_command(const DrawCommand& command, std::ostream& out);
int exhaust_command(const ExhaustCommand& command, std::ostream& out, std::ostream& err);
/// Robust against the oracle alone, at full speed.
int soak_command(const SoakCommand& command, std::ostream& out, std::ostream& err);
int merge_command(const MergeCommand& command, std::ostream& out, std::ostream& err);
/// Writes vectors from recorded calls, for the operations named, separated by commas, or for all.
int vectors_from_command(const std::string& directory, const std::vector<std::string>& logs,
                         const std::string& operations, int jobs, std::ostream& out);
int vectors_write_command(const std::string& directory, const std::string& operations, std::uint64_t seed,
                          std::ostream& out, std::ostream& err);
/// Asks an engine a few easy questions about each of its operations to check its connection.
int check_engine_command(const CheckEngineCommand& command, std::ostream& out, std::ostream& err);
int vectors_check_command(const VectorsCheckCommand& command, std::ostream& out, std::ostream& err);
int certify_command(const CertifyCommand& command, std::ostream& out, std::ostream& err);

/// Describes meshes, their defects and possible repairs: one in words, several as a table.
int mesh_command(const MeshCommand& command, std::ostream& out, std::ostream& err);

/// The lecture deck as one page: ideas, formulas, figures to drag, failures of the formulas, scenes.
int deck_command(const DeckCommand& command, std::ostream& err);

int simulate_command(const SimulateCommand& command, std::ostream& out, std::ostream& err);

}  // namespace touchstone::program
