// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The `lithe` command: reads the arguments, runs one command, turns what goes wrong into one sentence and an exit
/// code.
#include <cstdio>
#include <exception>
#include <new>

#include "command.h"
#include "lithe/bake/model.h"

namespace {

using namespace lithe::tool;

void describeApp(CLI::App& app) {
  app.description(
      "lithe: continuous level of detail for skinned characters.\n"
      "Exit codes: 0 done, 1 bad input or failed check (one sentence on stderr), 2 bad usage.");
  app.set_version_flag("--version", "lithe " LITHE_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
}

/// --help and --version are answered on stdout; everything else that the parser refuses is bad usage, in one line.
ExitCode answerParser(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error);
    return kDone;
  }
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string help = chosen.empty() ? "lithe --help" : "lithe " + chosen.front()->get_name() + " --help";
  std::fprintf(stderr, "lithe: %s (see %s)\n", error.what(), help.c_str());
  return kBadUsage;
}

/// The parser would only say that a command is missing.
bool isUnknownCommand(const CLI::App& app, const std::string& word) {
  const auto isNamedSo = [&](const CLI::App* command) { return command->get_name() == word; };
  return !word.empty() && word[0] != '-' && app.get_subcommands(isNamedSo).empty();
}

ExitCode run(const Action& action) {
  try {
    return action();
  } catch (const lithe::bake::Error& error) {
    std::fprintf(stderr, "lithe: %s\n", error.what());
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "lithe: out of memory\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lithe: internal error: %s\n", error.what());
  }
  return kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("", "lithe");
  Action action;
  describeApp(app);
  addBakeCommand(app, action);
  addInfoCommand(app, action);
  addExportCommand(app, action);
  addCompareCommand(app, action);
  addVerifyCommand(app, action);
  addGenerateCommand(app, action);
  if (argc > 1 && isUnknownCommand(app, argv[1])) {
    std::fprintf(stderr, "lithe: there is no command '%s' (see lithe --help)\n", argv[1]);
    return kBadUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answerParser(app, error);
  }
  return run(action);
}
