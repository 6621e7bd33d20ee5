// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "accessor.h"

#include <algorithm>
#include <cstring>

namespace lithe::bake {

namespace {

/// Elements an accessor without data may have: zeros cost nothing in the file but as much as others in memory.
constexpr uint64_t kMaxZeroElements = uint64_t{1} << 20;

template <typename T>
T load(const uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

uint32_t componentBytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_INT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

double loadNumber(const uint8_t* bytes, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return load<int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return load<int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return load<int32_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<uint32_t>(bytes);
    default:
      return load<float>(bytes);
  }
}

/// What stands for 1 (glTF 2.0, section 3.6.2.2).
double integerOne(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255.0;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535.0;
    case TINYGLTF_COMPONENT_TYPE_INT:
      return 2147483647.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return 4294967295.0;
    default:
      return 1.0;
  }
}

/// Whether `count` elements of `size` bytes, `stride` apart from `offset` on, lie within `available` bytes.
bool fits(uint64_t count, uint64_t size, uint64_t stride, uint64_t offset, uint64_t available) {
  if (count == 0) return true;
  if (offset > available || size > available - offset) return false;
  return count - 1 <= (available - offset - size) / std::max<uint64_t>(stride, 1);
}

const uint8_t* checkedRange(const GltfFile& file, std::span<const uint8_t> view, uint64_t count, uint64_t size,
                            uint64_t stride, uint64_t offset, const std::string& place) {
  if (!fits(count, size, stride, offset, view.size())) {
    file.name.fail(place, "its " + std::to_string(count) + " elements reach beyond the " + std::to_string(view.size()) +
                              " bytes of their buffer view; re-export the file");
  }
  return view.data() + (count == 0 ? 0 : offset);
}

}  // namespace

AccessorView AccessorView::open(const GltfFile& file, int64_t accessor, std::initializer_list<int> types,
                                const std::string& place) {
  if (accessor < 0 || accessor >= static_cast<int64_t>(file.document.accessors.size())) {
    file.name.fail(place, "there is no accessor " + std::to_string(accessor) + "; re-export the file");
  }
  const tinygltf::Accessor& stated = file.document.accessors[static_cast<size_t>(accessor)];
  const std::string there = place + " (accessor " + std::to_string(accessor) + ")";
  if (std::find(types.begin(), types.end(), stated.type) == types.end()) {
    file.name.fail(there, "it has the wrong type, as glTF does not allow it there; re-export the file");
  }
  AccessorView view;
  view.components_ = static_cast<uint32_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(stated.type)));
  view.component_type_ = stated.componentType;
  view.normalized_ = stated.normalized;
  view.count_ = stated.count;
  if (componentBytes(stated.componentType) == 0) {
    file.name.fail(there,
                   "its component type " + std::to_string(stated.componentType) + " is not glTF's; re-export it");
  }
  if (view.count_ > UINT32_MAX) file.name.fail(there, "it has more elements than 32 bits count; split the mesh");
  view.openDense(file, stated, there);
  if (stated.sparse.isSparse) view.openSparse(file, stated, there);
  return view;
}

AccessorView AccessorView::ofBytes(const Bytes& bytes, uint64_t count, uint32_t components, int component_type,
                                   bool normalized) {
  AccessorView view;
  view.data_ = bytes.data();
  view.count_ = count;
  view.components_ = components;
  view.component_type_ = component_type;
  view.normalized_ = normalized;
  view.stride_ = view.elementBytes();
  return view;
}

void AccessorView::openDense(const GltfFile& file, const tinygltf::Accessor& accessor, const std::string& place) {
  if (accessor.bufferView < 0) {
    if (count_ > kMaxZeroElements) {
      file.name.fail(place, "it has " + std::to_string(count_) + " elements and no data; re-export the file");
    }
    return;
  }
  const std::span<const uint8_t> bytes = file.viewBytes(accessor.bufferView, place);
  const uint64_t stated = file.document.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
  stride_ = stated == 0 ? elementBytes() : stated;
  if (stride_ < elementBytes()) file.name.fail(place, "its elements overlap in their buffer view; re-export the file");
  data_ = checkedRange(file, bytes, count_, elementBytes(), stride_, accessor.byteOffset, place);
}

void AccessorView::openSparse(const GltfFile& file, const tinygltf::Accessor& accessor, const std::string& place) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    file.name.fail(place, "its sparse part has negative sizes; re-export the file");
  }
  const uint32_t index_bytes = componentBytes(sparse.indices.componentType);
  if (index_bytes == 0 || sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
    file.name.fail(place, "its sparse indices are not integers; re-export the file");
  }
  const uint64_t count = static_cast<uint64_t>(sparse.count);
  const uint8_t* indices =
      checkedRange(file, file.viewBytes(sparse.indices.bufferView, place), count, index_bytes, index_bytes,
                   static_cast<uint64_t>(sparse.indices.byteOffset), place + ", sparse indices");
  sparse_values_ =
      checkedRange(file, file.viewBytes(sparse.values.bufferView, place), count, elementBytes(), elementBytes(),
                   static_cast<uint64_t>(sparse.values.byteOffset), place + ", sparse values");
  for (uint64_t i = 0; i < count; ++i) {
    const double element = loadNumber(indices + i * index_bytes, sparse.indices.componentType);
    const bool ascending = sparse_elements_.empty() || element > sparse_elements_.back();
    if (!(element >= 0.0) || element >= static_cast<double>(count_) || !ascending) {
      file.name.fail(place, "its sparse indices are not ascending or out of range; re-export the file");
    }
    sparse_elements_.push_back(static_cast<uint32_t>(element));
  }
}

uint64_t AccessorView::elementBytes() const { return uint64_t{components_} * componentBytes(component_type_); }

bool AccessorView::isInteger() const { return component_type_ != TINYGLTF_COMPONENT_TYPE_FLOAT; }

const uint8_t* AccessorView::elementAt(uint64_t element) const {
  if (!sparse_elements_.empty()) {
    const auto found = std::lower_bound(sparse_elements_.begin(), sparse_elements_.end(), element);
    if (found != sparse_elements_.end() && *found == element) {
      return sparse_values_ + static_cast<uint64_t>(found - sparse_elements_.begin()) * elementBytes();
    }
  }
  return data_ == nullptr ? nullptr : data_ + element * stride_;
}

double AccessorView::number(uint64_t element, uint32_t component, IntegerMeaning meaning) const {
  const uint8_t* bytes = elementAt(element);
  if (bytes == nullptr) return 0.0;
  const double value = loadNumber(bytes + uint64_t{component} * componentBytes(component_type_), component_type_);
  if (!isInteger() || (!normalized_ && meaning == IntegerMeaning::kAsStated)) return value;
  return std::max(value / integerOne(component_type_), -1.0);
}

uint32_t AccessorView::integer(uint64_t element, uint32_t component) const {
  const uint8_t* bytes = elementAt(element);
  if (bytes == nullptr) return 0;
  const double value = loadNumber(bytes + uint64_t{component} * componentBytes(component_type_), component_type_);
  return value >= 0.0 && value <= 4294967295.0 ? static_cast<uint32_t>(value) : UINT32_MAX;
}

}  // namespace lithe::bake
