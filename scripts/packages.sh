# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# What lithe needs, by Debian 12 package name, in one place. Source this file, then call lithe_need:
#
#     source "$(dirname "${BASH_SOURCE[0]}")/../scripts/packages.sh"
#     lithe_need build display
#
# Groups: build    compiler, CMake and the bake's libraries; enough for the library, the tool and the tests
#         display  EGL and OpenGL (software rendering included) for the samples that draw
#         check    clang, its sanitizer and fuzzer runtimes, clang-format; only .ci/run uses them
#         ruler    what lithe is held against: MeshLab and a display for it, Python 3 for the second reader; only .ci/run uses them
# A group whose packages are all there costs nothing and needs no network.

lithe_packages_of() {
  case $1 in
    build)
      echo g++ cmake ninja-build ccache pkgconf binutils \
        libdraco-dev libmeshoptimizer-dev libtinygltf-dev libglm-dev libxxhash-dev nlohmann-json3-dev libcli11-dev libstb-dev \
        libgtest-dev libbenchmark-dev ;;
    display) echo libegl-dev libegl1 libgl-dev libopengl-dev libgl1-mesa-dri libglfw3-dev ;;
    check) echo clang clang-format libclang-rt-14-dev ;;
    ruler) echo meshlab xvfb xauth python3 ;;
    *) echo "scripts/packages.sh: no group named '$1' (build, display, check, ruler)" >&2; return 1 ;;
  esac
}

lithe_is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# Root installs as it is; anyone else goes through sudo.
lithe_as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# lithe_need GROUP...: installs the packages of these groups that are missing, and says so first.
lithe_need() {
  local group packages=() missing=() package
  for group in "$@"; do
    local names
    names=$(lithe_packages_of "$group") || return 1
    read -r -a names <<<"$names"
    packages+=("${names[@]}")
  done
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is not Debian: taking it that you have the equivalents of ${packages[*]}" >&2
    return 0
  fi
  for package in "${packages[@]}"; do
    lithe_is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "Installing ${#missing[@]} missing packages: ${missing[*]}" >&2
  local wait_for_lock=(-o DPkg::Lock::Timeout=600)
  lithe_as_root env DEBIAN_FRONTEND=noninteractive apt-get "${wait_for_lock[@]}" -qq update >&2
  lithe_as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get "${wait_for_lock[@]}" -qq install -y --no-install-recommends "${missing[@]}" >&2 </dev/null
}
