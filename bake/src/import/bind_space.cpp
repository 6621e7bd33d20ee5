// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "bind_space.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "box.h"
#include "transform.h"

namespace lithe::bake {

namespace {

/// Two maps are the same if they take the vertices concerned to places closer than this part of their box.
constexpr double kSamePlace = 1e-5;
/// Groups whose scales differ by less share a grid well enough.
constexpr double kSameScale = 2.0;
/// So do parts spread over a box larger than the rest pose's by less.
constexpr double kSameSpread = 2.0;

/// Joints of one skin that influence common vertices, directly or through others.
struct Group {
  std::vector<uint32_t> joints;  // heaviest first
  Box box;
  uint32_t space = 0;
  glm::dmat4 to_space{1.0};  // from the group's coordinates to those of its space
  glm::dmat4 move{1.0};      // what is done to its vertices in the end

  uint32_t heaviest() const { return joints.front(); }
};

/// Groups that were brought together through nodes they share.
struct Space {
  std::map<uint32_t, glm::dmat4> inverse_binds;  // by node, for positions in coordinates of the space
  glm::dmat4 to_rest{1.0};                       // to the rest-posed world, by way of the heaviest joint
  double weight = 0.0;                           // of that joint
};

class Grouping {
 public:
  explicit Grouping(size_t joints) : parent_(joints) { std::iota(parent_.begin(), parent_.end(), 0u); }

  uint32_t find(uint32_t joint) {
    while (parent_[joint] != joint) joint = parent_[joint] = parent_[parent_[joint]];
    return joint;
  }
  void unite(uint32_t a, uint32_t b) {
    const uint32_t first = find(a), second = find(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<uint32_t> parent_;
};

class BindSpace {
 public:
  BindSpace(Draft& draft, const SceneTree& tree) : draft_(draft), tree_(tree) {}

  void unify() {
    weighJoints();
    formGroups();
    relateGroups();
    findRestMaps();
    chooseMoves();
    moveVertices();
    adjustInverseBinds();
  }

 private:
  void weighJoints();
  void formGroups();
  void adoptIdleJoints();
  void relateGroups();
  bool joinSpace(Group& group, uint32_t space);
  void enterSpace(Group& group, uint32_t space, const glm::dmat4& to_space);
  void findRestMaps();
  bool sharesOneSpace() const;
  void chooseMoves();
  void moveVertices();
  void adjustInverseBinds();

  glm::dmat4 restOf(uint32_t joint) const {
    return tree_.world[draft_.joints[joint].node] * draft_.joints[joint].inverse_bind;
  }
  bool rigid(const Group& group) const { return draft_.joints[group.heaviest()].rigid(); }
  /// The space whose heaviest joint is the heaviest of all; kNone without skinned parts.
  uint32_t mainSpace() const;

  Draft& draft_;
  const SceneTree& tree_;
  std::vector<double> weight_;      // per joint, over all vertices
  std::vector<uint32_t> group_of_;  // per joint
  std::vector<Group> groups_;
  std::vector<Space> spaces_;
};

void BindSpace::weighJoints() {
  weight_.assign(draft_.joints.size(), 0.0);
  for (const FileSkin& skin : draft_.skins) {
    for (uint32_t k = 0; k < skin.count; ++k) weight_[skin.joint[k]] += static_cast<double>(skin.weight[k]);
  }
}

void BindSpace::formGroups() {
  Grouping grouping(draft_.joints.size());
  for (const FileSkin& skin : draft_.skins) {
    for (uint32_t k = 1; k < skin.count; ++k) grouping.unite(skin.joint[0], skin.joint[k]);
  }
  group_of_.assign(draft_.joints.size(), kNone);
  for (uint32_t joint = 0; joint < draft_.joints.size(); ++joint) {
    if (!(weight_[joint] > 0.0)) continue;
    const uint32_t first = grouping.find(joint);
    if (first == joint) {
      group_of_[joint] = static_cast<uint32_t>(groups_.size());
      groups_.emplace_back();
    } else {
      group_of_[joint] = group_of_[first];
    }
    groups_[group_of_[joint]].joints.push_back(joint);
  }
  for (Group& group : groups_) {
    std::stable_sort(group.joints.begin(), group.joints.end(),
                     [&](uint32_t a, uint32_t b) { return weight_[a] > weight_[b]; });
  }
  for (size_t v = 0; v < draft_.skins.size(); ++v) {
    groups_[group_of_[draft_.skins[v].joint[0]]].box.add(glm::dvec3(draft_.model.positions[v]));
  }
  adoptIdleJoints();
}

/// Joints without vertices go with their skin's heaviest group: their inverse binds belong to some space too.
void BindSpace::adoptIdleJoints() {
  std::map<uint32_t, uint32_t> main_group;  // by skin
  for (uint32_t g = 0; g < groups_.size(); ++g) {
    const uint32_t skin = draft_.joints[groups_[g].heaviest()].skin;
    const auto [entry, first] = main_group.try_emplace(skin, g);
    if (!first && weight_[groups_[g].heaviest()] > weight_[groups_[entry->second].heaviest()]) entry->second = g;
  }
  for (uint32_t joint = 0; joint < draft_.joints.size(); ++joint) {
    if (group_of_[joint] == kNone) group_of_[joint] = main_group.at(draft_.joints[joint].skin);
  }
}

void BindSpace::relateGroups() {
  for (Group& group : groups_) {
    if (rigid(group)) continue;
    bool joined = false;
    for (uint32_t space = 0; space < spaces_.size() && !joined; ++space) joined = joinSpace(group, space);
    if (joined) continue;
    spaces_.emplace_back();
    enterSpace(group, static_cast<uint32_t>(spaces_.size() - 1), glm::dmat4(1.0));
  }
}

/// Brings a group into a space through the heaviest node that both know, if all other nodes they share agree.
bool BindSpace::joinSpace(Group& group, uint32_t space) {
  const std::map<uint32_t, glm::dmat4>& known = spaces_[space].inverse_binds;
  const auto shared = [&](uint32_t joint) { return known.find(draft_.joints[joint].node); };
  const auto bridge = std::find_if(group.joints.begin(), group.joints.end(), [&](uint32_t joint) {
    return shared(joint) != known.end() && invertible(shared(joint)->second);
  });
  if (bridge == group.joints.end()) return false;
  glm::dmat4 to_space = glm::inverse(shared(*bridge)->second) * draft_.joints[*bridge].inverse_bind;
  for (const uint32_t joint : group.joints) {
    if (shared(joint) == known.end()) continue;
    const glm::dmat4& own = draft_.joints[joint].inverse_bind;
    const double tolerance = kSamePlace * lengthScale(own) * group.box.diagonal();
    if (largestDifference(shared(joint)->second * to_space, own, group.box) > tolerance) return false;
  }
  const double tolerance = kSamePlace * group.box.diagonal();
  if (largestDifference(to_space, glm::dmat4(1.0), group.box) <= tolerance) to_space = glm::dmat4(1.0);
  if (!invertible(to_space)) return false;
  enterSpace(group, space, to_space);
  return true;
}

void BindSpace::enterSpace(Group& group, uint32_t space, const glm::dmat4& to_space) {
  group.space = space;
  group.to_space = to_space;
  const glm::dmat4 back = glm::inverse(to_space);
  for (const uint32_t joint : group.joints) {
    spaces_[space].inverse_binds.try_emplace(draft_.joints[joint].node, draft_.joints[joint].inverse_bind * back);
  }
}

/// Joints scaled to nothing at rest (a hidden prop) say nothing about where a space lies.
void BindSpace::findRestMaps() {
  for (const Group& group : groups_) {
    if (rigid(group)) continue;
    Space& space = spaces_[group.space];
    for (const uint32_t joint : group.joints) {
      const glm::dmat4 to_rest = restOf(joint) * glm::inverse(group.to_space);
      if (!invertible(to_rest)) continue;
      if (weight_[joint] > space.weight) {
        space.weight = weight_[joint];
        space.to_rest = to_rest;
      }
      break;
    }
  }
}

uint32_t BindSpace::mainSpace() const {
  const auto heaviest = std::max_element(spaces_.begin(), spaces_.end(),
                                         [](const Space& a, const Space& b) { return a.weight < b.weight; });
  return heaviest == spaces_.end() ? kNone : static_cast<uint32_t>(heaviest - spaces_.begin());
}

bool BindSpace::sharesOneSpace() const {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (const Space& space : spaces_) {
    if (space.weight == 0.0) continue;
    smallest = std::min(smallest, lengthScale(space.to_rest));
    largest = std::max(largest, lengthScale(space.to_rest));
  }
  if (largest > kSameScale * smallest) return false;
  Box untouched, moved;
  for (const Group& group : groups_) {
    if (rigid(group)) continue;
    if (group.to_space != glm::dmat4(1.0)) return false;
    for (const glm::dvec3& corner : group.box.corners()) {
      untouched.add(corner);
      moved.add(glm::dvec3(spaces_[group.space].to_rest * glm::dvec4(corner, 1.0)));
    }
  }
  return untouched.diagonal() * largest <= kSameSpread * moved.diagonal();
}

void BindSpace::chooseMoves() {
  const uint32_t main = mainSpace();
  const bool untouched = main == kNone || sharesOneSpace();
  const glm::dmat4 rest_to_common = main != kNone && untouched ? glm::inverse(spaces_[main].to_rest) : glm::dmat4(1.0);
  for (Group& group : groups_) {
    if (rigid(group)) {
      const glm::dmat4 move = rest_to_common * restOf(group.heaviest());
      if (invertible(move)) group.move = move;
    } else if (!untouched) {
      group.move = spaces_[group.space].to_rest * group.to_space;
    }
  }
}

void BindSpace::moveVertices() {
  Model& model = draft_.model;
  std::vector<glm::dmat3> normal_moves;
  for (const Group& group : groups_) normal_moves.push_back(glm::transpose(glm::inverse(glm::dmat3(group.move))));
  for (size_t v = 0; v < draft_.skins.size(); ++v) {
    const uint32_t g = group_of_[draft_.skins[v].joint[0]];
    const glm::dmat4& move = groups_[g].move;
    if (move == glm::dmat4(1.0)) continue;
    model.positions[v] = glm::vec3(move * glm::dvec4(glm::dvec3(model.positions[v]), 1.0));
    model.normals[v] = glm::vec3(glm::normalize(normal_moves[g] * glm::dvec3(model.normals[v])));
    if (!model.attributes.tangent) continue;
    const glm::dvec3 tangent = glm::normalize(glm::dmat3(move) * glm::dvec3(model.tangents[v]));
    model.tangents[v] = glm::vec4(glm::vec3(tangent), model.tangents[v].w);
  }
}

void BindSpace::adjustInverseBinds() {
  for (uint32_t joint = 0; joint < draft_.joints.size(); ++joint) {
    const glm::dmat4& move = groups_[group_of_[joint]].move;
    if (move != glm::dmat4(1.0))
      draft_.joints[joint].inverse_bind = draft_.joints[joint].inverse_bind * glm::inverse(move);
  }
}

}  // namespace

void unifyBindSpace(Draft& draft, const SceneTree& tree) { BindSpace(draft, tree).unify(); }

}  // namespace lithe::bake
