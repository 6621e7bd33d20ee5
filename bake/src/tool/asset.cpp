// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset.h"

#include <algorithm>
#include <cstdlib>

#include "files.h"
#include "lithe/bake/model.h"
#include "lithe/format/file.h"

namespace lithe::tool {
namespace {

void* allocate(void*, size_t size, size_t alignment) {
  // aligned_alloc wants a size that the alignment divides.
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void release(void*, void* memory, size_t) { std::free(memory); }

constexpr lithe_allocator kAllocator{nullptr, allocate, release};

const char* reasonOf(lithe_result result) {
  switch (result) {
    case LITHE_ERROR_TRUNCATED:
      return "ends before the bytes that its tables state";
    case LITHE_ERROR_NOT_THIS_FORMAT:
      return "is not a .lithe file";
    case LITHE_ERROR_VERSION_TOO_NEW:
      return "was written by a newer lithe";
    case LITHE_ERROR_CORRUPT:
      return "is damaged";
    case LITHE_ERROR_LIMIT:
      return "states counts beyond the format's limits";
    case LITHE_ERROR_OUT_OF_MEMORY:
      return "needs more memory than there is";
    default:
      return "was refused";
  }
}

const char* adviceFor(lithe_result result) {
  switch (result) {
    case LITHE_ERROR_NOT_THIS_FORMAT:
      return "make one with `lithe bake`";
    case LITHE_ERROR_VERSION_TOO_NEW:
      return "update lithe or bake it again";
    case LITHE_ERROR_OUT_OF_MEMORY:
      return "close other programs or use a larger machine";
    default:
      return "copy it again or bake it again";
  }
}

/// Whether so few bytes that the reader wants more could still be the beginning of a .lithe file.
bool startsLikeAsset(std::span<const uint8_t> bytes) {
  const size_t count = std::min(bytes.size(), sizeof format::kMagic);
  return std::equal(bytes.begin(), bytes.begin() + count, format::kMagic);
}

/// Calls one of the runtime's getters, whose only error is an index out of range: a bug of the caller.
template <typename Record>
Record get(lithe_result (*getter)(const lithe_asset*, uint32_t, Record*), const lithe_asset* asset, uint32_t index) {
  Record record{};
  if (getter(asset, index, &record) != LITHE_OK) throw std::logic_error("index out of range");
  return record;
}

}  // namespace

Asset Asset::open(const std::filesystem::path& path) { return openBytes(readFile(path), path.string()); }

Asset Asset::openBytes(std::vector<uint8_t> bytes, std::string name) {
  Asset asset;
  asset.name_ = std::move(name);
  asset.bytes_ = std::move(bytes);
  lithe_diagnosis diagnosis{};
  lithe_result result = lithe_peek(asset.bytes_.data(), asset.bytes_.size(), &asset.head_bytes_);
  if (result == LITHE_PENDING)
    result = startsLikeAsset(asset.bytes_) ? LITHE_ERROR_TRUNCATED : LITHE_ERROR_NOT_THIS_FORMAT;
  if (result != LITHE_OK) asset.refuse(result, diagnosis, "header");
  lithe_asset* opened = nullptr;
  result = lithe_asset_open(&kAllocator, asset.bytes_.data(), asset.bytes_.size(), &diagnosis, &opened);
  if (result != LITHE_OK) asset.refuse(result, diagnosis, "head");
  asset.asset_.reset(opened);
  lithe_asset_describe(opened, &asset.info_);
  return asset;
}

void Asset::load(uint32_t level) {
  lithe_request request;
  while (lithe_asset_next_request(get(), level, &request) == LITHE_OK) {
    const std::string place = "page " + std::to_string(request.page);
    lithe_diagnosis diagnosis{0, request.offset};
    if (request.offset + request.size > bytes_.size()) refuse(LITHE_ERROR_TRUNCATED, diagnosis, place);
    const lithe_result result =
        lithe_asset_supply(asset_.get(), request.page, bytes_.data() + request.offset, request.size, &diagnosis);
    if (result != LITHE_OK) refuse(result, diagnosis, place);
  }
}

void Asset::refuse(lithe_result result, const lithe_diagnosis& diagnosis, const std::string& place) const {
  std::string sentence = name_ + ": " + reasonOf(result) + " (" + place;
  if (diagnosis.check != 0) {
    sentence +=
        ", check " + std::to_string(diagnosis.check) + " of docs/format.md at byte " + std::to_string(diagnosis.offset);
  }
  throw bake::Error(sentence + "); " + adviceFor(result));
}

lithe_level Asset::level(uint32_t index) const { return tool::get(lithe_asset_level, get(), index); }
lithe_page Asset::page(uint32_t index) const { return tool::get(lithe_asset_page, get(), index); }
lithe_part Asset::part(uint32_t index) const { return tool::get(lithe_asset_part, get(), index); }
lithe_node Asset::node(uint32_t index) const { return tool::get(lithe_asset_node, get(), index); }
lithe_joint Asset::joint(uint32_t index) const { return tool::get(lithe_asset_joint, get(), index); }

}  // namespace lithe::tool
