// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The instances of a crowd, wherever the host keeps them.
#pragma once

#include "lithe/runtime.h"

namespace lithe::runtime {

inline bool instancesAreSound(const lithe_crowd& crowd) {
  const bool strides =
      crowd.instance_stride == 0 || (crowd.instance_stride >= sizeof(lithe_instance) && crowd.instance_stride % 4 == 0);
  return strides && (crowd.instances || !crowd.instance_count);
}

class InstanceCursor {
 public:
  explicit InstanceCursor(const lithe_crowd& crowd)
      : at_(reinterpret_cast<char*>(crowd.instances)),
        stride_(crowd.instance_stride ? crowd.instance_stride : sizeof(lithe_instance)) {}

  lithe_instance* next() {
    lithe_instance* instance = reinterpret_cast<lithe_instance*>(at_);
    at_ += stride_;
    return instance;
  }

 private:
  char* at_;
  size_t stride_;
};

}  // namespace lithe::runtime
