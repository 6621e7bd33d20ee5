// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How the samples fail: one sentence, printed by main, exit code 1.
#pragma once

#include <stdexcept>
#include <string>

#include "lithe/runtime.h"

namespace sample {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws when lithe refused something; `what` names the file or the call.
inline void check(lithe_result result, const std::string& what) {
  if (result != LITHE_OK) throw Error(what + ": " + lithe_result_name(result));
}

}  // namespace sample
