// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "surface.h"

#include <algorithm>
#include <cmath>

namespace lithe::bake {

namespace {

constexpr float kFoldCosine = -0.7f;
constexpr uint8_t kUnknown = 128;

/// Same three slots in the same cyclic order.
bool equalFaces(const Face& f, const Face& g) {
  const uint32_t k = g.cornerOf(f.corner[0]);
  return k < 3 && g.corner[(k + 1) % 3] == f.corner[1] && g.corner[(k + 2) % 3] == f.corner[2];
}

glm::vec3 firstPose(const PosedMesh& posed, uint32_t slot) {
  const PosedPoint& p = posed.at(slot)[0];
  return {p.x[0], p.y[0], p.z[0]};
}

glm::vec3 normalInFirstPose(const PosedMesh& posed, const Face& f) {
  const glm::vec3 origin = firstPose(posed, f.corner[0]);
  return glm::cross(firstPose(posed, f.corner[1]) - origin, firstPose(posed, f.corner[2]) - origin);
}

bool foldsBack(const glm::vec3& n, const glm::vec3& m) {
  const float cosine = glm::dot(n, m);
  return cosine < 0.0f && cosine < kFoldCosine * std::sqrt(glm::dot(n, n) * glm::dot(m, m));
}

bool wedgesDiffer(const Face& f, const Face& g, uint32_t slot) {
  return f.wedge[f.knownCornerOf(slot)] != g.wedge[g.knownCornerOf(slot)];
}

std::vector<uint32_t> cornersPerSlot(const Mesh& mesh) {
  std::vector<uint32_t> count(mesh.vertexCount(), 0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    for (uint32_t k = 0; k < 3; ++k) ++count[mesh.corner(t, k)];
  }
  return count;
}

}  // namespace

Surface::Surface(const Mesh& mesh) : at_(cornersPerSlot(mesh)) {
  faces_.reserve(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Face f{{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, mesh.triangles[t], {0, 0, 0}, {}};
    const std::span<const uint32_t> others = facesAt(f.corner[0]);
    if (std::any_of(others.begin(), others.end(), [&](uint32_t g) { return equalFaces(f, faces_[g]); })) continue;
    for (uint32_t slot : f.corner) at_.append(slot, faceCount());
    faces_.push_back(f);
  }
  triangle_count_ = faceCount();
}

bool Surface::hasEdge(uint32_t a, uint32_t b) const {
  const std::span<const uint32_t> ids = facesAt(a);
  return std::any_of(ids.begin(), ids.end(), [&](uint32_t id) { return faces_[id].has(b); });
}

void Surface::classifyEdges(const PosedMesh& posed) {
  for (Face& face : faces_) {
    face.normal = normalInFirstPose(posed, face);
    face.kind = {kUnknown, kUnknown, kUnknown};
  }
  for (const Face& face : faces_) {
    for (uint32_t k = 0; k < 3; ++k) {
      if (face.kind[k] == kUnknown) classify(face.corner[(k + 1) % 3], face.corner[(k + 2) % 3]);
    }
  }
}

bool Surface::wouldOrphan(uint32_t a, uint32_t b) const {
  uint32_t shared = 0;
  for (uint32_t id : facesAt(a)) {
    const Face& f = faces_[id];
    if (!f.has(b)) continue;
    ++shared;
    for (uint32_t third : f.corner) {
      if (third == a || third == b) continue;
      const std::span<const uint32_t> ids = facesAt(third);
      if (std::all_of(ids.begin(), ids.end(), [&](uint32_t g) { return faces_[g].has(a) && faces_[g].has(b); }))
        return true;
    }
  }
  return facesAt(a).size() == shared && facesAt(b).size() == shared;
}

bool Surface::wouldVanish(uint32_t a, uint32_t b) const {
  const std::span<const uint32_t> ids = facesAt(a);
  return ids.size() == triangle_count_ &&
         std::all_of(ids.begin(), ids.end(), [&](uint32_t id) { return faces_[id].has(b); });
}

uint32_t Surface::valenceAfter(uint32_t a, uint32_t b) const {
  const std::span<const uint32_t> ids = facesAt(a);
  const auto shared = std::count_if(ids.begin(), ids.end(), [&](uint32_t id) { return faces_[id].has(b); });
  return static_cast<uint32_t>(facesAt(a).size() + facesAt(b).size() - 2 * static_cast<size_t>(shared));
}

void Surface::collapse(uint32_t a, uint32_t b, std::vector<uint32_t>& thirds) {
  uniteWedges(a, b);
  scratch_.clear();
  thirds.clear();
  for (uint32_t id : facesAt(a)) {
    if (!faces_[id].has(b)) scratch_.push_back(id);
  }
  for (uint32_t id : facesAt(b)) {
    Face& f = faces_[id];
    if (!f.has(a)) {
      f.corner[f.cornerOf(b)] = a;
      scratch_.push_back(id);
      continue;
    }
    for (uint32_t slot : f.corner) {
      if (slot == a || slot == b) continue;
      at_.remove(slot, id);
      thirds.push_back(slot);
    }
    f.wedge[0] = kNone;
    --triangle_count_;
  }
  at_.assign(a, scratch_);
  at_.assign(b, {});
  mergeEqualFaces(a);
}

void Surface::uniteWedges(uint32_t a, uint32_t b) {
  for (uint32_t dying : facesAt(a)) {
    if (!faces_[dying].has(b)) continue;
    const uint32_t kept = faces_[dying].wedge[faces_[dying].cornerOf(a)];
    const uint32_t united = faces_[dying].wedge[faces_[dying].cornerOf(b)];
    if (kept == united) continue;
    for (const uint32_t end : {a, b}) {
      for (uint32_t id : facesAt(end)) {
        for (uint32_t& wedge : faces_[id].wedge) wedge = wedge == united ? kept : wedge;
      }
    }
  }
}

void Surface::mergeEqualFaces(uint32_t slot) {
  others_.clear();
  for (uint32_t i = 0; i < facesAt(slot).size(); ++i) {
    const uint32_t id = facesAt(slot)[i];
    const uint64_t others = uint64_t{faces_[id].nextTo(slot)} << 32 | faces_[id].lastTo(slot);
    if (std::find(others_.begin(), others_.end(), others) == others_.end()) {
      others_.push_back(others);
      continue;
    }
    for (uint32_t corner : faces_[id].corner) at_.remove(corner, id);
    faces_[id].wedge[0] = kNone;
    --triangle_count_;
    --i;
  }
}

void Surface::classifyAround(uint32_t slot, const PosedMesh& posed) {
  for (uint32_t id : facesAt(slot)) {
    faces_[id].kind = {kUnknown, kUnknown, kUnknown};
    faces_[id].normal = normalInFirstPose(posed, faces_[id]);
  }
  for (uint32_t id : facesAt(slot)) {
    const uint32_t next = faces_[id].nextTo(slot), last = faces_[id].lastTo(slot);
    classify(next, last);
    classify(slot, next);
  }
  // Where the triangles around the slot agree on their orientation only borders are left.
  for (uint32_t id : facesAt(slot)) {
    const Face& face = faces_[id];
    if (face.kind[Face::kAfter[face.knownCornerOf(slot)]] == kUnknown) classify(slot, face.lastTo(slot));
  }
}

void Surface::classify(uint32_t from, uint32_t to) {
  findFacesBetween(from, to);
  const uint8_t kind = kindBetween(from, to);
  for (uint32_t id : at_edge_) {
    Face& face = faces_[id];
    face.kind[3 - face.knownCornerOf(from) - face.knownCornerOf(to)] = kind;
  }
}

// Without branches: which triangles they are nobody can guess.
void Surface::findFacesBetween(uint32_t from, uint32_t to) {
  const std::span<const uint32_t> at_from = facesAt(from);
  at_edge_.resize(at_from.size());
  size_t count = 0;
  for (uint32_t id : at_from) {
    at_edge_[count] = id;
    count += faces_[id].has(to) ? 1 : 0;
  }
  at_edge_.resize(count);
}

uint8_t Surface::kindBetween(uint32_t from, uint32_t to) const {
  if (at_edge_.size() == 1) return kBorder;
  if (at_edge_.size() != 2) return 0;
  const Face &f = faces_[at_edge_[0]], &g = faces_[at_edge_[1]];
  const uint8_t seam = wedgesDiffer(f, g, from) || wedgesDiffer(f, g, to) ? kSeam : 0;
  const uint8_t fold = foldsBack(f.normal, g.normal) ? kFold : 0;
  return static_cast<uint8_t>(seam | fold);
}

}  // namespace lithe::bake
