// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/judging/judge_logs.h"
#include "program/commands/recorded/judge.h"

namespace touchstone::program {

/// `judge --pairs OP FILES` and `judge --columns OP FILES`: existing files as questions to an engine. Pairs are all
/// pairs of the mesh files, or of the geometries in files of WKT (one per line) and GeoJSON; columns are numbers, one
/// row for each question. Call sites are the files of a question. Throws UsageError and InvalidInput naming file and
/// line.
audit::JudgedLogs judge_files(const JudgeCommand& command, EngineNotes& notes);

}  // namespace touchstone::program
