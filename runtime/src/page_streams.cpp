// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_streams.h"

namespace lithe::runtime {

namespace {

struct StreamTable {
  uint32_t count;  ///< streams of this kind of page
  uint32_t bytes[kMaxStreams];
  uint32_t attribute_count[kMaxStreams];
  ColumnSpec columns[kMaxStreams][kMaxAttributesPerStream];
  uint32_t low_bytes[format::kLowBitsKinds];

  uint64_t streamBytes() const {
    uint64_t sum = 0;
    for (uint32_t s = 0; s < count; ++s) sum += bytes[s];
    return sum;
  }
  uint64_t lowBytes() const {
    uint64_t sum = 0;
    for (const uint32_t low : low_bytes) sum += low;
    return sum;
  }
};

/// How many records a stream may have: what the tables' counts allow.
uint64_t recordBound(const PagePlan& plan, const Decoded& before, const PageFormat& format, uint32_t stream) {
  const uint64_t nodes = plan.node_count - before.node_count, wedges = plan.wedge_count - before.wedge_count,
                 faces = plan.face_count - before.face_count, splits = nodes / 2;
  if (plan.level == 0) {
    switch (stream) {
      case format::kBaseNodes:
        return nodes;
      case format::kBaseInfluences:
        return nodes * format.max_influences;
      case format::kBaseWedges:
        return wedges;
      default:
        return faces;
    }
  }
  switch (stream) {
    case format::kFlagsOld:
    case format::kFlagsNew:
      return uint64_t{plan.node_count} * (plan.ended_levels ? plan.ended_levels : 1);
    case format::kGeneral:
    case format::kClassPicks:
    case format::kClassChoices:
    case format::kMemberPicks:
    case format::kMemberChoices:
    case format::kThirdPicks:
    case format::kThirdChoices:
      return format::listedBound(splits, plan.face_count);
    case format::kClassesBoth:
    case format::kClassesOne:
    case format::kClassesNone:
      return 2 * uint64_t{plan.wedge_count};
    case format::kColors:
      return wedges * format.has.color_sets;
    case format::kExtras:
      return wedges * format.layout.stride;
    case format::kSkinD:
    case format::kSkinE:
    case format::kSkinNew:
      return splits * format::kMaxSkinJoints;
    case format::kExtraMasks:
    case format::kNormals:
    case format::kTangents:
      return wedges;
    default:
      return stream >= format::kUv0 ? wedges : splits;
  }
}

void describeStreams(const PageFormat& format, bool base, StreamTable* table) {
  table->count =
      base ? static_cast<uint32_t>(format::kBaseStreamCount) : static_cast<uint32_t>(format::kSplitStreamCount);
  for (uint32_t s = 0; s < table->count; ++s) {
    format::StreamAttribute attributes[format::kMaxStreamAttributes];
    table->attribute_count[s] = base ? format::baseStreamAttributes(s, format.has, attributes)
                                     : format::splitStreamAttributes(s, format.has, attributes);
    for (uint32_t a = 0; a < table->attribute_count[s]; ++a)
      table->columns[s][a] = {attributes[a].components,
                              attributes[a].is_unsigned ? ColumnKind::kUnsigned : ColumnKind::kSigned};
  }
}

bool parametersValid(const PageFormat& format, const uint8_t* parameters, bool base) {
  // A base page predicts nothing, and its biases are the numbers of low bits.
  const uint8_t strength = base ? 0 : 32, bias = base ? format::kLowBitsMax : 31;
  uint8_t most[format::kParameterBytes] = {};
  most[format::kPositionMean] = most[format::kPlacement] = most[format::kSkinGradient] = strength;
  most[format::kPositionBias] = bias;
  most[format::kHeightBias] = most[format::kSkinBias] = base ? 0 : bias;
  if (format.has.normals) {
    most[format::kNormalGradient] = most[format::kNormalGeometry] = strength;
    most[format::kNormalBias] = bias;
    most[format::kExtraNormalShift] = base ? 0 : format::kLowBitsMax;
  }
  if (format.has.tangents) {
    most[format::kTangentGradient] = strength;
    most[format::kTangentBias] = bias;
    most[format::kExtraTangentShift] = base ? 0 : format::kLowBitsMax;
  }
  for (uint32_t s = 0; s < format.has.uv_sets; ++s) {
    most[format::kUvGradient0 + s] = strength;
    most[format::kUvBias0 + s] = bias;
    most[format::kExtraUvShift] = base ? 0 : format::kLowBitsMax;
  }
  for (uint32_t i = 0; i < format::kParameterBytes; ++i)
    if (parameters[i] > most[i]) return false;
  return true;
}

/// Reads the table and gives every stream its share of the page's integers.
bool readTable(const PageFormat& format, const PagePlan& plan, const Decoded& before, const uint8_t** at,
               const uint8_t* end, int32_t* values, StreamTable* table, PageStreams* streams) {
  uint64_t used = 0;
  for (uint32_t s = 0; s < table->count; ++s) {
    uint32_t records = 0;
    table->bytes[s] = 0;
    if (!readVarint(at, end, &records)) return false;
    if (records > 0 && (!readVarint(at, end, &table->bytes[s]) || table->attribute_count[s] == 0)) return false;
    if (records > recordBound(plan, before, format, s) || records > kMaxCloudRecords) return false;
    streams->records[s] = records;
    for (uint32_t a = 0; a < table->attribute_count[s]; ++a) {
      const uint64_t count = static_cast<uint64_t>(records) * table->columns[s][a].components;
      if (used + count > plan.values) return false;
      streams->values[s][a] = {values + used, values + used + count, false};
      used += count;
    }
  }
  for (uint32_t& bytes : table->low_bytes)
    if (!readVarint(at, end, &bytes)) return false;
  return used == plan.values;
}

/// All clouds in one call, so that their entropy decoders may run side by side.
/// page  where it begins: all of a page that lies before a cloud may be looked at
bool decodeStreams(const StreamTable& table, const uint8_t* page, const uint8_t* payload, const DecodeScratch& scratch,
                   PageStreams* streams, uint32_t* failed_stream) {
  CloudJob jobs[kMaxStreams];
  uint32_t stream_of[kMaxStreams];
  int32_t* outs[kMaxStreams][kMaxAttributesPerStream];
  uint32_t count = 0;
  for (uint32_t s = 0; s < table.count; ++s) {
    if (streams->records[s] == 0) continue;
    for (uint32_t a = 0; a < table.attribute_count[s]; ++a) outs[s][a] = const_cast<int32_t*>(streams->values[s][a].at);
    stream_of[count] = s;
    const size_t bytes = table.bytes[s], lead = static_cast<size_t>(payload - page);
    jobs[count++] = {payload, bytes, lead, streams->records[s], table.columns[s], table.attribute_count[s], outs[s]};
    payload += bytes;
  }
  uint32_t failed = 0;
  if (count == 0 || decodeClouds(jobs, count, scratch, &failed) == CloudResult::kOk) return true;
  *failed_stream = stream_of[failed];
  return false;
}

}  // namespace

bool readVarint(const uint8_t** at, const uint8_t* end, uint32_t* value) {
  uint64_t result = 0;
  for (uint32_t shift = 0; shift < 35; shift += 7) {
    if (*at == end) return false;
    const uint8_t byte = *(*at)++;
    result |= static_cast<uint64_t>(byte & 0x7f) << shift;
    if (byte & 0x80) continue;
    *value = static_cast<uint32_t>(result);
    return result <= 0xffffffffu && (shift == 0 || byte != 0);
  }
  return false;
}

uint32_t readStreams(const PageFormat& format, const PagePlan& plan, const Decoded& before, const uint8_t* bytes,
                     size_t size, int32_t* values, const DecodeScratch& scratch, PageStreams* streams, size_t* offset) {
  const uint8_t* const end = bytes + size;
  const uint8_t* at = bytes + 1 + format::kParameterBytes;
  const bool base = plan.level == 0;
  *offset = 0;
  if (size < 1 + format::kParameterBytes || bytes[0] != (base ? format::kBasePage : format::kSplitPage))
    return kCheckKind;
  *offset = 1;
  streams->parameters = bytes + 1;
  if (!parametersValid(format, streams->parameters, base)) return kCheckParameters;

  StreamTable table;
  describeStreams(format, base, &table);
  const bool table_read = readTable(format, plan, before, &at, end, values, &table, streams);
  *offset = static_cast<size_t>(at - bytes);
  if (!table_read) return kCheckTable;
  if (table.streamBytes() + table.lowBytes() > static_cast<uint64_t>(end - at)) return kCheckTable;

  uint32_t failed_stream = 0;
  if (!decodeStreams(table, bytes, at, scratch, streams, &failed_stream)) {
    for (uint32_t s = 0; s < failed_stream; ++s) *offset += table.bytes[s];
    return kCheckCloud;
  }
  at += table.streamBytes();
  for (uint32_t k = 0; k < format::kLowBitsKinds; ++k) {
    streams->low_bits[k] = {at, 0, uint64_t{table.low_bytes[k]} * 8, false};
    at += table.low_bytes[k];
  }
  streams->hidden = at;
  streams->hidden_end = end;
  return 0;
}

bool streamsExhausted(const PageStreams& streams) {
  for (uint32_t s = 0; s < kMaxStreams; ++s)
    for (uint32_t a = 0; a < kMaxAttributesPerStream; ++a)
      if (streams.values[s][a].at != streams.values[s][a].end || streams.values[s][a].overrun) return false;
  for (const BitReader& low : streams.low_bits)
    if (!low.exhausted()) return false;
  return true;
}

}  // namespace lithe::runtime
