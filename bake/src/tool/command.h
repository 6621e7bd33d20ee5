// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The tool's commands. Each file of this folder named *_command.cpp defines one of them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace lithe::tool {

/// What the process answers. Anything else is a bug.
enum ExitCode { kDone = 0, kFailed = 1, kBadUsage = 2 };

/// The work of the command that was chosen, run after all arguments have been read. Returns the exit code; throws
/// bake::Error for bad input.
using Action = std::function<ExitCode()>;

void addBakeCommand(CLI::App& app, Action& action);
void addInfoCommand(CLI::App& app, Action& action);
void addExportCommand(CLI::App& app, Action& action);
void addCompareCommand(CLI::App& app, Action& action);
void addVerifyCommand(CLI::App& app, Action& action);
void addGenerateCommand(CLI::App& app, Action& action);

}  // namespace lithe::tool
