# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# How every target of the project is compiled: warnings, determinism, sanitizers.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
find_program(LITHE_CCACHE ccache)
if(LITHE_CCACHE AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${LITHE_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${LITHE_CCACHE})
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_EXTENSIONS OFF)

# Same input, same bytes on every machine: no contraction of a*b+c into one rounding.
function(lithe_compile_options target)
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wshadow -Wno-psabi
    $<$<BOOL:${LITHE_WARNINGS_AS_ERRORS}>:-Werror>
    # GCC 12 sees overlapping copies inside std::string's operator+ (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
  if(LITHE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${LITHE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${LITHE_SANITIZE})
  endif()
  if(LITHE_BUILD_FUZZERS)
    # Coverage feedback for libFuzzer; the fuzz targets themselves add libFuzzer's main.
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    target_link_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# format and runtime: C++17, no exceptions, no RTTI, no thread-safe statics.
function(lithe_runtime_options target)
  lithe_compile_options(${target})
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON C_STANDARD 99 POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions -fno-rtti -fno-threadsafe-statics>
    -ffunction-sections -fdata-sections -fvisibility=hidden)
endfunction()

function(lithe_bake_options target)
  lithe_compile_options(${target})
  set_target_properties(${target} PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON)
endfunction()
