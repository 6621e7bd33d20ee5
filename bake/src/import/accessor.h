// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Typed, bounds-checked access to a file's arrays (glTF 2.0, section 3.6.2), without copying them.
#pragma once

#include <initializer_list>

#include "gltf_file.h"

namespace lithe::bake {

/// How integers become numbers.
enum class IntegerMeaning {
  kAsStated,    ///< normalised if the accessor says so
  kNormalized,  ///< always: weights and colours, which have no other meaning
};

/// An array of elements of `components` components each. Everything it can reach was checked when it was made.
class AccessorView {
 public:
  /// Opens an accessor of the file. Throws Error if it does not exist, is none of the types (TINYGLTF_TYPE_*), reaches
  /// outside its buffer view, or its sparse part is invalid. `place` names it in the sentence.
  static AccessorView open(const GltfFile& file, int64_t accessor, std::initializer_list<int> types,
                           const std::string& place);
  /// Tightly packed elements that outlive the view.
  static AccessorView ofBytes(const Bytes& bytes, uint64_t count, uint32_t components, int component_type,
                              bool normalized);

  uint64_t count() const { return count_; }
  uint32_t components() const { return components_; }

  /// A component as a number. The element and the component must exist.
  double number(uint64_t element, uint32_t component, IntegerMeaning meaning = IntegerMeaning::kAsStated) const;
  /// A component of an unsigned integer type; throws away what a float type would have behind the point.
  uint32_t integer(uint64_t element, uint32_t component) const;
  bool isInteger() const;

 private:
  const uint8_t* elementAt(uint64_t element) const;
  void openDense(const GltfFile& file, const tinygltf::Accessor& accessor, const std::string& place);
  void openSparse(const GltfFile& file, const tinygltf::Accessor& accessor, const std::string& place);
  uint64_t elementBytes() const;

  const uint8_t* data_ = nullptr;  // null: all zero
  uint64_t count_ = 0, stride_ = 0;
  uint32_t components_ = 0;
  int component_type_ = 0;
  bool normalized_ = false;
  std::vector<uint32_t> sparse_elements_;  // ascending
  const uint8_t* sparse_values_ = nullptr;
};

}  // namespace lithe::bake
