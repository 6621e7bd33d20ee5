// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writes the files that the tests keep: make_test_files TESTS_FOLDER. Run by the build target make_test_files_again.
///     golden/*.lithe, golden/hashes.txt    what every later reader must decode to the same bytes
///     fuzz/corpus/fuzz_*/                  seeds, each a small sound input
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <cstdio>

#include "bounded_allocator.h"
#include "gltf_draft.h"
#include "golden_files.h"
#include "page_editor.h"
#include "split_input.h"

namespace lithe::test {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const FileBytes& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!out) throw std::runtime_error("cannot write " + path.string());
}

void writeGolden(const fs::path& folder) {
  std::string hashes;
  for (const GoldenFile& golden : goldenFiles()) {
    const FileBytes bytes = encodeSmallFile(golden.shape);
    write(folder / (std::string(golden.name) + ".lithe"), bytes);
    hashes += hashLines(golden.name, bytes);
  }
  write(folder / "hashes.txt", FileBytes(hashes.begin(), hashes.end()));
}

// ---- Seeds of the runtime's targets --------------------------------------------------------------------------------

void writePageSeed(const fs::path& path, LitheFile& file, uint32_t page) {
  FileBytes seed(5);
  seed[0] = static_cast<uint8_t>(page);
  std::copy_n(file.record(format::page::kId, page) + format::page::kValuesAt, 4, seed.begin() + 1);
  seed.insert(seed.end(), file.pages[page].begin(), file.pages[page].end());
  write(path, seed);
}

uint32_t countAt(LitheFile& file, uint32_t page, uint32_t at) {
  return format::loadU32(file.record(format::page::kId, page) + at);
}

/// A page as the integers that fuzz_splits takes; `choice` names the cut that it is applied to.
void writeSplitSeed(const fs::path& path, LitheFile& file, uint32_t page, uint32_t choice) {
  using namespace format;
  PageEditor editor(file, page);
  auto grown = [&](uint32_t at) { return countAt(file, page, at) - (page ? countAt(file, page - 1, at) : 0); };
  SplitOutput out;
  out.byte(choice);
  out.byte((page ? grown(page::kNodeCountAt) / 2 : grown(page::kNodeCountAt)) - 1);
  out.byte(grown(page::kWedgeCountAt));
  out.byte(grown(page::kFaceCountAt));
  out.byte(countAt(file, page, page::kMaxFanAt));
  out.byte(editor.data.hidden.empty() ? 0 : 1);
  if (page > 0)
    for (const uint8_t parameter : editor.data.parameters) out.byte(parameter);
  for (const bake::StreamData& stream : editor.data.streams) {
    if (stream.attributes.empty()) continue;
    out.byte(stream.records());
    for (const auto& attribute : stream.attributes)
      for (const int32_t value : attribute.values) out.value(value, attribute.spec.is_unsigned);
  }
  // The fuzzer gives every kind the same bits.
  for (const auto& bits : editor.data.low_bits) out.bytes.insert(out.bytes.end(), bits.begin(), bits.end());
  write(path, out.bytes);
}

/// A head whose first page's hash lies over its own size; a page of eight bytes is there to be hashed.
FileBytes headWithPagesOverHeader() {
  using namespace format;
  LitheFile file(encodeSmallFile(tinyShape()));
  const uint32_t pages_at = header::kHeadBytesAt - page::kChecksumAt, page_bytes = 8;
  storeU32(file.head.data() + file.chunk(page::kId).entry + directory::kOffsetAt, pages_at);
  storeU32(file.head.data() + pages_at + page::kSizeAt, page_bytes);
  file.head.resize(file.head.size() + page_bytes);
  return file.head;
}

void writeRuntimeSeeds(const fs::path& corpus) {
  for (const GoldenFile& golden : goldenFiles()) {
    const FileBytes bytes = encodeSmallFile(golden.shape);
    write(corpus / "fuzz_open" / golden.name, LitheFile(bytes).head);
    write(corpus / "fuzz_file" / golden.name, bytes);
  }
  write(corpus / "fuzz_open" / "pages_over_header", headWithPagesOverHeader());
  LitheFile small(encodeSmallFile(smallRichShape()));
  for (uint32_t page = 0; page < small.pages.size(); ++page)
    writePageSeed(corpus / "fuzz_page" / ("page" + std::to_string(page)), small, page);
  LitheFile rich(encodeSmallFile(richShape()));
  writeSplitSeed(corpus / "fuzz_splits" / "base", rich, 0, 3);
  writeSplitSeed(corpus / "fuzz_splits" / "after1", rich, 1, 0);
  writeSplitSeed(corpus / "fuzz_splits" / "after4", rich, 4, 1);
  writeSplitSeed(corpus / "fuzz_splits" / "after5", rich, 5, 2);
}

// ---- Seeds of the import -------------------------------------------------------------------------------------------

using bake::Ribbon;

void animate(Ribbon& ribbon) {
  const int times = ribbon.accessor<float>("SCALAR", {0, 1});
  const int turns = ribbon.accessor<float>("VEC4", {0, 0, 0, 1, 0, 0, 1, 0});
  ribbon.add("animations", {{"name", "turn"},
                            {"samplers", {{{"input", times}, {"output", turns}, {"interpolation", "LINEAR"}}}},
                            {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}}}}});
}

void compressIndices(Ribbon& ribbon) {
  const uint32_t indices[6] = {0, 2, 1, 1, 2, 3};
  FileBytes coded(meshopt_encodeIndexBufferBound(6, 4));
  coded.resize(meshopt_encodeIndexBuffer(coded.data(), coded.size(), indices, 6));
  const int view = ribbon.view(coded.data(), coded.size());
  nlohmann::json& stated =
      ribbon.json["bufferViews"][ribbon.json["accessors"][ribbon.indices]["bufferView"].get<size_t>()];
  stated["extensions"]["EXT_meshopt_compression"] = ribbon.json["bufferViews"][static_cast<size_t>(view)];
  stated["extensions"]["EXT_meshopt_compression"].update({{"byteStride", 2}, {"count", 6}, {"mode", "TRIANGLES"}});
  ribbon.json["extensionsRequired"] = {"EXT_meshopt_compression"};
}

void compressPositions(Ribbon& ribbon) {
  const float corners[2][3][3] = {{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {2, 0, 0}, {2, 1, 0}}};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (uint32_t t = 0; t < 2; ++t)
    builder.SetAttributeValuesForFace(id, draco::FaceIndex(t), corners[t][0], corners[t][1], corners[t][2]);
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::ExpertEncoder encoder(*mesh);
  draco::EncoderBuffer coded;
  if (!encoder.EncodeToBuffer(&coded).ok()) throw std::runtime_error("Draco cannot encode two triangles");
  const int view = ribbon.view(coded.data(), coded.size());
  ribbon.primitive()["attributes"] = {{"POSITION", ribbon.position}};
  ribbon.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                                    {"attributes", {{"POSITION", 0}}}};
  ribbon.json["nodes"][2].erase("skin");
  ribbon.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
}

void makeSparse(Ribbon& ribbon) {
  const uint16_t at[1] = {3};
  const float value[3] = {2, 1.5f, 0};
  const int indices = ribbon.view(at, sizeof at), values = ribbon.view(value, sizeof value);
  ribbon.json["accessors"][static_cast<size_t>(ribbon.position)]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
}

void writeImportSeeds(const fs::path& folder) {
  const struct {
    const char* name;
    void (*change)(Ribbon&);
  } kSeeds[] = {{"plain", [](Ribbon&) {}},
                {"animated", animate},
                {"sparse", makeSparse},
                {"meshopt", compressIndices},
                {"draco", compressPositions}};
  for (const auto& seed : kSeeds) {
    Ribbon ribbon;
    seed.change(ribbon);
    const FileBytes glb = ribbon.glb();
    write(folder / (std::string(seed.name) + ".glb"), glb);
    bake::importGltf(folder / (std::string(seed.name) + ".glb"));  // a seed is sound
  }
  const std::string text = Ribbon().text();
  write(folder / "text.gltf", FileBytes(text.begin(), text.end()));
}

}  // namespace
}  // namespace lithe::test

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: make_test_files TESTS_FOLDER\n"), 2;
  const std::filesystem::path tests = argv[1];
  try {
    lithe::test::writeGolden(tests / "golden");
    lithe::test::writeRuntimeSeeds(tests / "fuzz" / "corpus");
    lithe::test::writeImportSeeds(tests / "fuzz" / "corpus" / "fuzz_import");
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
  return 0;
}
