// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "cloud_bytes.h"

#include <draco/compression/attributes/linear_sequencer.h>
#include <draco/compression/attributes/sequential_attribute_decoders_controller.h>
#include <draco/compression/attributes/sequential_integer_attribute_decoder.h>
#include <draco/compression/point_cloud/point_cloud_sequential_decoder.h>

#include <memory>

#include "draco_cloud.h"
#include "lithe/bake/model.h"

namespace lithe::tool {
namespace {

/// Bytes that each attribute has been seen to take, by its id.
using Seen = std::vector<uint64_t>;

class WatchedAttribute : public draco::SequentialIntegerAttributeDecoder {
 public:
  explicit WatchedAttribute(Seen& seen) : seen_(seen) {}

  bool DecodePortableAttribute(const std::vector<draco::PointIndex>& points, draco::DecoderBuffer* buffer) override {
    const int64_t before = buffer->decoded_size();
    if (!SequentialIntegerAttributeDecoder::DecodePortableAttribute(points, buffer)) return false;
    seen_.resize(std::max(seen_.size(), static_cast<size_t>(attribute_id()) + 1));
    seen_[static_cast<size_t>(attribute_id())] = static_cast<uint64_t>(buffer->decoded_size() - before);
    return true;
  }

 private:
  Seen& seen_;
};

class WatchedAttributes : public draco::SequentialAttributeDecodersController {
 public:
  WatchedAttributes(std::unique_ptr<draco::PointsSequencer> sequencer, Seen& seen)
      : SequentialAttributeDecodersController(std::move(sequencer)), seen_(seen) {}

 protected:
  std::unique_ptr<draco::SequentialAttributeDecoder> CreateSequentialDecoder(uint8_t type) override {
    if (type != draco::SEQUENTIAL_ATTRIBUTE_ENCODER_INTEGER) return nullptr;
    return std::make_unique<WatchedAttribute>(seen_);
  }

 private:
  Seen& seen_;
};

class WatchedCloud : public draco::PointCloudSequentialDecoder {
 public:
  Seen seen;

 protected:
  bool CreateAttributesDecoder(int32_t id) override {
    auto sequencer = std::make_unique<draco::LinearSequencer>(point_cloud()->num_points());
    return SetAttributesDecoder(id, std::make_unique<WatchedAttributes>(std::move(sequencer), seen));
  }
};

std::vector<uint8_t> wholeCloud(const PageTable::Stream& stream, std::span<const format::StreamAttribute> attributes) {
  std::vector<uint8_t> components;
  for (const format::StreamAttribute& attribute : attributes) components.push_back(attribute.components);
  std::vector<uint8_t> cloud = bake::cloudBeginning(stream.records, components);
  cloud.insert(cloud.end(), stream.bytes.begin(), stream.bytes.end());
  return cloud;
}

}  // namespace

CloudBytes measureCloud(const PageTable::Stream& stream, std::span<const format::StreamAttribute> attributes,
                        const std::string& place) {
  const std::vector<uint8_t> bytes = wholeCloud(stream, attributes);
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  WatchedCloud decoder;
  draco::PointCloud cloud;
  const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, &cloud);
  if (!status.ok() || buffer.remaining_size() != 0)
    throw bake::Error(place + ": is no cloud of integers; copy the file again or bake it again");
  CloudBytes measured;
  for (int32_t id = 0; id < cloud.num_attributes(); ++id)
    measured.attributes.push_back(decoder.seen[static_cast<size_t>(id)]);
  return measured;
}

}  // namespace lithe::tool
