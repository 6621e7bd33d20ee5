// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What the runtime makes of a file, as bytes for another reader to compare with.
//
//     dump_buffers FILE.lithe LEVELS OUT      LEVELS: how many levels, from the coarsest on; 0 for all
//
// OUT is a sequence of blocks: a name and a line feed, the number of bytes as decimal digits and a line feed, the
// bytes. All numbers in them are little-endian and 32 bits wide, but for joints of a vertex (u16).
//     scene nodes       per node: parent, translation xyz, rotation xyzw, scale xyz
//     joints            per joint: node, inverse bind matrix as 3 rows of 4
//     node positions    per node of the hierarchy: xyz on the grid (u16)
//     node parents      per node of the hierarchy, LITHE_NO_INDEX for none
//     node children     per node of the hierarchy, the first one; LITHE_NO_INDEX for none
//     wedge nodes, wedge parents, wedge parts      per wedge
//     vertices          per wedge: position xyz, 8 joints, 8 weights, then what the asset has of normal xyz, tangent
//     xyzw,
//                       uv of each set, colour rgba of each set
//     level N indices, level N ranges (first index and number of indices per part), level N morph sources (from 1 on)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "lithe/runtime.h"
#include "widest_layout.h"

namespace {

void* allocate(void*, size_t size, size_t alignment) {
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void release(void*, void* memory, size_t) { std::free(memory); }

void demand(lithe_result result, const char* what, const lithe_diagnosis& diagnosis = {0, 0}) {
  if (result == LITHE_OK) return;
  std::fprintf(stderr, "dump_buffers: %s: %s, check %u\n", what, lithe_result_name(result), diagnosis.check);
  std::exit(1);
}

class Blocks {
 public:
  explicit Blocks(const char* path) : out_(path, std::ios::binary) {}

  template <typename T>
  void write(const std::string& name, const T* values, size_t count) {
    out_ << name << '\n' << count * sizeof(T) << '\n';
    out_.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(T)));
  }
  template <typename T>
  void write(const std::string& name, const std::vector<T>& values) {
    write(name, values.data(), values.size());
  }
  bool close() {
    out_.close();
    return !out_.fail();
  }

 private:
  std::ofstream out_;
};

/// Values of 32 bits, whatever they are.
class Words {
 public:
  void add(uint32_t value) { append(&value, 1); }
  void add(const float* values, size_t count) { append(values, count); }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  void append(const void* values, size_t count) {
    const uint8_t* from = static_cast<const uint8_t*>(values);
    bytes_.insert(bytes_.end(), from, from + 4 * count);
  }
  std::vector<uint8_t> bytes_;
};

void writeSkeleton(const lithe_asset* asset, const lithe_asset_info& info, Blocks& out) {
  Words nodes, joints;
  for (uint32_t i = 0; i < info.node_count; ++i) {
    lithe_node node;
    demand(lithe_asset_node(asset, i, &node), "a scene node");
    nodes.add(node.parent);
    nodes.add(node.translation, 3);
    nodes.add(node.rotation, 4);
    nodes.add(node.scale, 3);
  }
  for (uint32_t i = 0; i < info.joint_count; ++i) {
    lithe_joint joint;
    demand(lithe_asset_joint(asset, i, &joint), "a joint");
    joints.add(joint.node);
    joints.add(joint.inverse_bind, 12);
  }
  out.write("scene nodes", nodes.bytes());
  out.write("joints", joints.bytes());
}

void writeHierarchy(const lithe_asset* asset, Blocks& out) {
  lithe_hierarchy h;
  lithe_asset_hierarchy(asset, &h);
  out.write("node positions", h.node_position, size_t{3} * h.node_count);
  out.write("node parents", h.node_parent, h.node_count);
  out.write("node children", h.node_first_child, h.node_count);
  out.write("wedge nodes", h.wedge_node, h.wedge_count);
  out.write("wedge parents", h.wedge_parent, h.wedge_count);
  out.write("wedge parts", std::vector<uint32_t>(h.wedge_part, h.wedge_part + h.wedge_count));
}

void writeVertices(const lithe_asset* asset, const lithe_asset_info& info, uint32_t count, Blocks& out) {
  const lithe_vertex_layout layout = lithe::test::widestLayout(info);
  std::vector<uint8_t> vertices(size_t{layout.stride} * count);
  demand(lithe_asset_write_vertices(asset, &layout, 0, count, vertices.data(), vertices.size()), "vertices");
  out.write("vertices", vertices);
}

void writeLevel(const lithe_asset* asset, const lithe_asset_info& info, uint32_t number, Blocks& out) {
  lithe_level level;
  demand(lithe_asset_level(asset, number, &level), "a level");
  std::vector<uint32_t> indices(level.index_count), sources(level.vertex_count);
  std::vector<lithe_range> ranges(info.part_count);
  demand(lithe_asset_write_indices(asset, number, LITHE_INDEX_U32, indices.data(), 4 * indices.size(), ranges.data()),
         "indices");
  const std::string name = "level " + std::to_string(number) + " ";
  out.write(name + "indices", indices);
  out.write(name + "ranges", ranges);
  if (number == 0) return;
  demand(lithe_asset_write_morph_sources(asset, number, sources.data(), sources.size()), "morph sources");
  out.write(name + "morph sources", sources);
}

void supply(lithe_asset* asset, const std::vector<char>& file, uint32_t level) {
  lithe_request request;
  lithe_diagnosis diagnosis = {0, 0};
  while (lithe_asset_next_request(asset, level, &request) == LITHE_OK) {
    const uint64_t there =
        std::min<uint64_t>(request.size, file.size() - std::min<uint64_t>(request.offset, file.size()));
    demand(lithe_asset_supply(asset, request.page, file.data() + (there ? request.offset : 0), there, &diagnosis),
           "a page", diagnosis);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "use dump_buffers FILE.lithe LEVELS OUT\n");
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file(std::istreambuf_iterator<char>(in), {});
  const lithe_allocator allocator = {nullptr, allocate, release};
  lithe_asset* asset = nullptr;
  lithe_diagnosis diagnosis = {0, 0};
  demand(lithe_asset_open(&allocator, file.data(), file.size(), &diagnosis, &asset), argv[1], diagnosis);
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  const uint32_t wanted = static_cast<uint32_t>(std::atoi(argv[2]));
  const uint32_t levels = wanted ? std::min(wanted, info.level_count) : info.level_count;
  supply(asset, file, levels - 1);

  Blocks out(argv[3]);
  writeSkeleton(asset, info, out);
  writeHierarchy(asset, out);
  lithe_hierarchy resident;
  lithe_asset_hierarchy(asset, &resident);
  writeVertices(asset, info, resident.wedge_count, out);
  for (uint32_t level = 0; level < levels; ++level) writeLevel(asset, info, level, out);
  lithe_asset_close(asset);
  if (out.close()) return 0;
  std::fprintf(stderr, "dump_buffers: %s cannot be written\n", argv[3]);
  return 1;
}
