// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Damaged and malicious files: one sentence each, never a crash, never much memory.
#include "gltf_draft.h"

namespace lithe::bake {
namespace {

using Change = std::function<void(Ribbon&)>;

/// What importing a ribbon says after a change.
std::string complaintAfter(const Change& change) {
  Ribbon ribbon;
  change(ribbon);
  return complaintAbout(ribbon.glb());
}

nlohmann::json& accessorAt(Ribbon& ribbon, int accessor) {
  return ribbon.json["accessors"][static_cast<size_t>(accessor)];
}

struct Case {
  const char* fragment;  // of the sentence
  Change change;
};

void expectComplaints(const std::vector<Case>& cases) {
  for (const Case& hostile : cases) {
    const std::string complaint = complaintAfter(hostile.change);
    EXPECT_NE(complaint.find(hostile.fragment), std::string::npos)
        << "wanted: " << hostile.fragment << "\ngot: " << complaint;
  }
}

TEST(ImportHostile, TheUnchangedFileIsFine) {
  EXPECT_EQ(complaintAfter([](Ribbon&) {}), "nothing");
}

TEST(ImportHostile, AccessorsOutOfRange) {
  expectComplaints({
      {"mesh 0 'ribbon', primitive 0, POSITION (accessor 0): its 5 elements reach beyond the 48 bytes",
       [](Ribbon& r) { accessorAt(r, r.position)["count"] = 5; }},
      {"reach beyond", [](Ribbon& r) { accessorAt(r, r.position)["byteOffset"] = 4; }},
      {"reach beyond", [](Ribbon& r) { accessorAt(r, r.position)["byteOffset"] = 18446744073709551608u; }},
      {"reach beyond", [](Ribbon& r) { accessorAt(r, r.position)["count"] = 4294967295u; }},
      {"more elements than 32 bits count",
       [](Ribbon& r) { accessorAt(r, r.position)["count"] = 1537228672809129302u; }},
      {"it has 1000000000 elements and no data",
       [](Ribbon& r) {
         accessorAt(r, r.position)["count"] = 1000000000;
         accessorAt(r, r.position).erase("bufferView");
       }},
      {"there is no accessor 99", [](Ribbon& r) { r.primitive()["attributes"]["POSITION"] = 99; }},
      {"there is no accessor -7", [](Ribbon& r) { r.primitive()["attributes"]["WEIGHTS_0"] = -7; }},
      {"there is no buffer view 50", [](Ribbon& r) { accessorAt(r, r.position)["bufferView"] = 50; }},
      {"there is no buffer 3", [](Ribbon& r) { r.json["bufferViews"][0]["buffer"] = 3; }},
      {"buffer view 0: it reaches beyond", [](Ribbon& r) { r.json["bufferViews"][0]["byteLength"] = 1000000; }},
      {"buffer view 0: it reaches beyond",
       [](Ribbon& r) { r.json["bufferViews"][0]["byteOffset"] = 18446744073709551600u; }},
      {"its elements overlap", [](Ribbon& r) { r.json["bufferViews"][0]["byteStride"] = 4; }},
      {"wrong type", [](Ribbon& r) { accessorAt(r, r.position)["type"] = "MAT4"; }},
      {"wrong type", [](Ribbon& r) { accessorAt(r, r.inverse_binds)["type"] = "VEC4"; }},
      {"its component type 5130 is not glTF's", [](Ribbon& r) { accessorAt(r, r.position)["componentType"] = 5130; }},
      {"JOINTS_0: it has 3 elements for 4 vertices", [](Ribbon& r) { accessorAt(r, r.joints)["count"] = 3; }},
  });
}

TEST(ImportHostile, SparseAccessors) {
  const auto sparse = [](std::vector<uint16_t> elements, int64_t count, int component_type = 5123) {
    return [=](Ribbon& r) {
      const std::vector<float> values(elements.size() * 3, 1.0f);
      accessorAt(r, r.position)["sparse"] = {
          {"count", count},
          {"indices",
           {{"bufferView", r.view(elements.data(), elements.size() * 2)}, {"componentType", component_type}}},
          {"values", {{"bufferView", r.view(values.data(), values.size() * 4)}}}};
    };
  };
  expectComplaints({
      {"not ascending or out of range", sparse({0, 4}, 2)},
      {"not ascending or out of range", sparse({2, 2}, 2)},
      {"sparse indices: its 3 elements reach beyond", sparse({0, 1}, 3)},
      {"sparse part has negative sizes", sparse({0, 1}, -2)},
      {"sparse indices are not integers", sparse({0, 1}, 1, 5126)},
  });
}

TEST(ImportHostile, IndicesAndReferences) {
  expectComplaints({
      {"index 4 is 9, there are 4 vertices",
       [](Ribbon& r) {
         r.primitive()["indices"] = r.accessor<uint16_t>("SCALAR", {0, 2, 1, 1, 9, 3});
       }},
      {"index 0 is 65535",
       [](Ribbon& r) {
         r.primitive()["mode"] = 5;
         r.primitive()["indices"] = r.accessor<uint16_t>("SCALAR", {65535, 2, 1});
       }},
      {"its indices are not integers",
       [](Ribbon& r) {
         r.primitive()["indices"] = r.accessor<float>("SCALAR", {0, 1, 2});
       }},
      {"there is no material 3", [](Ribbon& r) { r.primitive()["material"] = 3; }},
      {"node 2 'shows': there is no mesh 8", [](Ribbon& r) { r.json["nodes"][2]["mesh"] = 8; }},
      {"node 2 'shows': there is no skin 5", [](Ribbon& r) { r.json["nodes"][2]["skin"] = 5; }},
      {"skin 0: there is no node 33",
       [](Ribbon& r) {
         r.json["skins"][0]["joints"] = {0, 33};
       }},
      {"skin 0: it has no joints", [](Ribbon& r) { r.json["skins"][0]["joints"] = nlohmann::json::array(); }},
      {"it has 2 inverse bind matrices for 3 joints",
       [](Ribbon& r) {
         r.json["skins"][0]["joints"] = {0, 1, 2};
       }},
      {"there is no scene 2", [](Ribbon& r) { r.json["scene"] = 2; }},
      {"scene 0: there is no node 12", [](Ribbon& r) { r.json["scenes"][0]["nodes"] = {12}; }},
      {"mesh 0: a primitive lacks its attributes", [](Ribbon& r) { r.primitive().erase("attributes"); }},
  });
}

TEST(ImportHostile, NumbersThatAreNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const std::vector<float> flat{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  std::vector<float> binds = flat;
  binds.insert(binds.end(), flat.begin(), flat.end());
  binds[20] = nan;
  expectComplaints({
      {"POSITION: a value of vertex 2 is not a finite number",
       [&](Ribbon& r) {
         r.primitive()["attributes"]["POSITION"] =
             r.accessor<float>("VEC3", {0, 0, 0, 0, 1, 0, 2, infinite, 0, 2, 1, 0});
       }},
      {"a weight of vertex 1 is not a number",
       [&](Ribbon& r) {
         r.primitive()["attributes"]["WEIGHTS_0"] =
             r.accessor<float>("VEC4", {1, 0, 0, 0, 1, nan, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
       }},
      {"TEXCOORD_0: a value of vertex 0",
       [&](Ribbon& r) {
         r.primitive()["attributes"]["TEXCOORD_0"] = r.accessor<float>("VEC2", {nan, 0, 0, 0, 0, 0, 0, 0});
       }},
      {"skin 0, inverse bind matrices: matrix 1 has an entry that is no number",
       [&](Ribbon& r) { r.json["skins"][0]["inverseBindMatrices"] = r.accessor<float>("MAT4", binds); }},
  });
}

TEST(ImportHostile, NumbersBeyondAllMeasure) {
  const auto clip = [](std::vector<float> values, const char* path, const char* interpolation = "LINEAR") {
    return [=](Ribbon& r) {
      const int times = r.accessor<float>("SCALAR", {0, 1}), output = r.accessor("VEC3", values);
      r.add("animations", {{"samplers", {{{"input", times}, {"output", output}, {"interpolation", interpolation}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}});
    };
  };
  std::vector<float> binds{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  binds.insert(binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1e30f, 0, 0, 1});
  expectComplaints({
      {"vertices are farther than 1e15 units away",
       [](Ribbon& r) {
         r.primitive()["attributes"]["POSITION"] = r.accessor<float>("VEC3", {0, 0, 0, 0, 1, 0, 1e38f, 0, 0, 2, 1, 0});
       }},
      {"node 'a': its transforms",
       [](Ribbon& r) {
         r.json["nodes"][0]["scale"] = {1e300, 1e300, 1e300};
       }},
      {"node 'a': its transforms",
       [](Ribbon& r) {
         r.json["nodes"][0]["translation"] = {0, 1e300, 0};
       }},
      {"node 'b': its transforms",
       [](Ribbon& r) {  // neither is too large alone
         r.json["nodes"][0]["scale"] = {1, 1e10, 1};
         r.json["nodes"][1]["translation"] = {1e10, 0, 0};
       }},
      {"node 'b': its transforms",
       [&](Ribbon& r) { r.json["skins"][0]["inverseBindMatrices"] = r.accessor<float>("MAT4", binds); }},
      {"node 'a': its transforms", clip({0, 0, 0, 0, 1e20f, 0}, "translation")},
      {"node 'a': its transforms", clip({1, 1, 1, 1, 1e20f, 1}, "scale")},
      {"node 'a': its transforms",
       clip({0, 0, 0, 0, 0, 0, 0, 0, 1e20f, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "translation", "CUBICSPLINE")},
      {"nothing", clip({0, 0, 0, 0, 1e12f, 0}, "translation")},
  });
}

TEST(ImportHostile, NodesThatAreNoTree) {
  expectComplaints({
      {"it is its own ancestor", [](Ribbon& r) { r.json["nodes"][1]["children"] = {0}; }},
      {"it is its own ancestor", [](Ribbon& r) { r.json["nodes"][0]["children"] = {0}; }},
      {"it is the child of node 0 and of node 2", [](Ribbon& r) { r.json["nodes"][2]["children"] = {1}; }},
      {"there is no node 70", [](Ribbon& r) { r.json["nodes"][0]["children"] = {70}; }},
      {"there is no node -3", [](Ribbon& r) { r.json["nodes"][0]["children"] = {-3}; }},
      {"its matrix has 15 numbers", [](Ribbon& r) { r.json["nodes"][0]["matrix"] = std::vector<double>(15, 1.0); }},
      {"its rotation has 3 numbers",
       [](Ribbon& r) {
         r.json["nodes"][0]["rotation"] = {0, 0, 1};
       }},
      {"its scale has 1 numbers", [](Ribbon& r) { r.json["nodes"][0]["scale"] = {2}; }},
  });
}

TEST(ImportHostile, FilesWithoutAnythingToBake) {
  expectComplaints({
      {"the scene shows no triangles",
       [](Ribbon& r) {
         r.primitive()["indices"] = r.accessor<uint16_t>("SCALAR", {0, 1});
       }},
      {"the scene shows no triangles", [](Ribbon& r) { r.json["scenes"][0]["nodes"] = {0}; }},
      {"the scene shows no triangles", [](Ribbon& r) { r.primitive()["mode"] = 1; }},
      {"the scene shows no triangles", [](Ribbon& r) { r.json["meshes"][0]["primitives"] = nlohmann::json::array(); }},
      {"the scene shows no triangles", [](Ribbon& r) { r.primitive()["attributes"].erase("POSITION"); }},
      {"the scene shows no triangles",
       [](Ribbon& r) {
         for (const int accessor : {r.position, r.joints, r.weights, r.indices}) accessorAt(r, accessor)["count"] = 0;
       }},
      {"the scene shows no triangles",
       [](Ribbon& r) {
         r.json = {{"asset", {{"version", "2.0"}}}};
       }},
  });
}

TEST(ImportHostile, SmallFilesDoNotExpandWithoutEnd) {
  expectComplaints({
      {"show its meshes so often",
       [](Ribbon& r) {  // 4,096 nodes show 1,024 vertices each
         const int position = r.accessor("VEC3", std::vector<float>(3 * 1024, 0.5f));
         const int mesh = r.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", position}}}}}}});
         for (int i = 0; i < 4096; ++i) r.json["scenes"][0]["nodes"].push_back(r.add("nodes", {{"mesh", mesh}}));
       }},
      {"too many keys",
       [](Ribbon& r) {  // 4,096 channels share 1,024 keys
         std::vector<float> times(1024);
         for (size_t i = 0; i < times.size(); ++i) times[i] = static_cast<float>(i);
         const int input = r.accessor("SCALAR", times), output = r.accessor("VEC3", std::vector<float>(3 * 1024));
         nlohmann::json clip = {{"samplers", {{{"input", input}, {"output", output}}}}};
         for (int i = 0; i < 4096; ++i) {
           clip["channels"].push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}});
         }
         r.add("animations", clip);
       }},
  });
}

TEST(ImportHostile, DocumentsThatAreNone) {
  const auto complaint = [](const std::string& text) { return complaintAbout({text.begin(), text.end()}); };
  EXPECT_EQ(complaint(""), "the file is empty");
  EXPECT_NE(complaint("Kaydara FBX Binary").find("not glTF: its JSON is invalid"), std::string::npos);
  EXPECT_NE(complaint("[]").find("not a glTF document"), std::string::npos);
  EXPECT_NE(complaint("{}").find("does not state its glTF version"), std::string::npos);
  EXPECT_NE(complaint(R"({"asset": {"version": "1.0"}})").find("glTF version '1.0' is not read"), std::string::npos);
  EXPECT_NE(complaint(R"({"asset": {"version": "2.0"}, "nodes": [7]})").find("not a valid glTF document"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"asset": {"version": "2.0"}, "buffers": [7]})").find("buffer 0: it is not an object"),
            std::string::npos);
  EXPECT_NE(complaint("{\"asset\": {\"version\": \"2.0\"}, \"x\": \"\xff\xfe\"}").find("its JSON is invalid"),
            std::string::npos);
  const std::string deep = "{\"asset\": {\"version\": \"2.0\"}, \"nodes\": [{\"extras\": ";
  EXPECT_NE(complaint(deep + std::string(100000, '[')).find("nested too deeply"), std::string::npos);
}

TEST(ImportHostile, BuffersThatAreMissing) {
  const auto buffer = [](nlohmann::json stated) {
    return [=](Ribbon& r) { r.json["buffers"] = nlohmann::json::array({stated}); };
  };
  const auto count = Ribbon().binary.size();
  expectComplaints({
      {"buffer 0: it should have 100000 bytes and has", buffer({{"byteLength", 100000}})},
      {"buffer 0: its byteLength is missing", buffer(nlohmann::json::object())},
      {"its file 'no such.bin' is missing", buffer({{"byteLength", count}, {"uri", "no%20such.bin"}})},
      {"is on a network", buffer({{"byteLength", count}, {"uri", "https://example.org/a.bin"}})},
      {"is not base64", buffer({{"byteLength", count}, {"uri", "data:text/plain,hello"}})},
      {"it should have", buffer({{"byteLength", count}, {"uri", "data:text/plain;base64,!!!!"}})},
      {"its uri is not a string", buffer({{"byteLength", count}, {"uri", 5}})},
  });
  EXPECT_THROW(importGltf("no/such/file.glb"), Error);
  EXPECT_THROW(importGltf(::testing::TempDir()), Error);
}

TEST(ImportHostile, BinaryHeaders) {
  const std::vector<uint8_t> good = Ribbon().glb();
  const auto complaint = [&](size_t at, uint8_t value) {
    std::vector<uint8_t> bad = good;
    bad[at] = value;
    return complaintAbout(bad);
  };
  EXPECT_NE(complaint(4, 1).find("binary glTF version 1"), std::string::npos);
  EXPECT_NE(complaint(11, 1).find("the header announces"), std::string::npos);
  EXPECT_NE(complaint(15, 1).find("is cut off after"), std::string::npos);
  EXPECT_NE(complaint(16, 'X').find("the first chunk is not JSON"), std::string::npos);
}

TEST(ImportHostile, EveryPrefixIsRefusedOrWhole) {
  const std::vector<uint8_t> whole = Ribbon().glb();
  const Model expected = importBytes(whole);
  for (size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(complaintAbout({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "nothing") << size;
  }
  std::vector<uint8_t> longer = whole;
  longer.resize(whole.size() + 100, 0xcd);
  EXPECT_EQ(importBytes(longer).positions, expected.positions) << "what the header does not announce is not read";
}

TEST(ImportHostile, PrefixesWithMendedHeadersAreRefusedOrValid) {
  const std::vector<uint8_t> whole = Ribbon().glb();
  for (size_t size = 12; size < whole.size(); ++size) {
    std::vector<uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    for (size_t i = 0; i < 4; ++i) cut[8 + i] = static_cast<uint8_t>(size >> (8 * i));
    EXPECT_NE(complaintAbout(cut), "") << size;
  }
}

TEST(ImportHostile, FlippedBytesAreRefusedOrValid) {
  const std::vector<uint8_t> whole = Ribbon().glb();
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const uint8_t flip : {0x01, 0x10, 0x80}) {
      std::vector<uint8_t> damaged = whole;
      damaged[at] ^= flip;
      const std::string complaint = complaintAbout(damaged);
      if (complaint != "nothing") continue;
      const Model model = importBytes(damaged);
      for (const auto& triangle : model.triangles) {
        for (const uint32_t corner : triangle) ASSERT_LT(corner, model.positions.size());
      }
      for (const Skin& skin : model.skins) {
        float sum = 0.0f;
        for (uint32_t k = 0; k < skin.count; ++k) {
          ASSERT_LT(skin.joint[k], model.joints.size());
          sum += skin.weight[k];
        }
        ASSERT_NEAR(sum, 1.0f, 1e-5f);
      }
    }
  }
}

}  // namespace
}  // namespace lithe::bake
