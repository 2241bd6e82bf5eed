#include "host/io/meshes/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "host/base/error.h"

namespace offing::meshes {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 4> path_names{"translation", "rotation", "scale", "weights"};

glm::dquat quaternion(const std::vector<double>& xyzw) {
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

/// An object's string; "" for none.
std::string text_of(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || !found->is_string() ? std::string() : found->get<std::string>();
}

}  // namespace

GltfScene::GltfScene(const GltfDocument& document, const std::string& animation, const LeaveOut& leave_out)
    : document_(&document) {
  read_nodes();
  walk();
  read_animations(animation, leave_out);
  find_moving();
  document_ = nullptr;
  read_.clear();
  rising_.clear();
}

std::vector<std::size_t> GltfScene::indices(const json& object, const char* key) const {
  std::vector<std::size_t> indices;
  const auto list = object.find(key);
  if (list == object.end()) return indices;
  if (!list->is_array()) document_->fail(fmt::format("a list \"{}\"", key), list->type_name());
  for (const json& index : *list) {
    if (!index.is_number_unsigned()) document_->fail(fmt::format("numbers in {}", key), shown(index));
    indices.push_back(index.get<std::size_t>());
  }
  return indices;
}

/// Nodes of the scene, or without scenes those that are no other's child.
std::vector<std::size_t> GltfScene::roots() const {
  if (document_->count("scenes") > 0) {
    return indices(document_->object("scenes", document_->whole(document_->root(), "scene", 0)), "nodes");
  }
  const std::size_t count = document_->count("nodes");
  std::vector<std::uint8_t> is_child(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t child : indices(document_->object("nodes", i), "children")) {
      if (child < count) is_child[child] = 1;
    }
  }
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_child[i] == 0) nodes.push_back(i);
  }
  return nodes;
}

void GltfScene::read_nodes() {
  nodes_.resize(document_->count("nodes"));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const json& object = document_->object("nodes", i);
    if (const std::vector<double> matrix = document_->numbers(object, "matrix", 16); !matrix.empty())
      nodes_[i].matrix = glm::make_mat4(matrix.data());  // columns first, as in glTF
    nodes_[i].at_rest = {document_->numbers(object, "translation", 3),
                         document_->numbers(object, "rotation", 4), document_->numbers(object, "scale", 3)};
  }
}

/// A node has one parent at most, so none comes twice.
void GltfScene::walk() {
  struct Visit {
    std::size_t node;
    std::optional<std::size_t> parent;
  };
  std::vector<Visit> stack;
  const auto push = [&](std::vector<std::size_t> nodes, std::optional<std::size_t> parent) {
    std::reverse(nodes.begin(), nodes.end());  // the first is taken first
    for (const std::size_t node : nodes) stack.push_back({node, parent});
  };
  push(roots(), {});
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const json& object = document_->object("nodes", visit.node);
    Node& node = nodes_[visit.node];
    if (std::exchange(node.is_shown, true))
      document_->fail("a tree of nodes", fmt::format("two ways to node {}", visit.node));
    node.parent = visit.parent;
    order_.push_back(visit.node);
    push(indices(object, "children"), visit.node);
  }
}

void GltfScene::read_animations(const std::string& name, const LeaveOut& leave_out) {
  std::vector<std::string> names;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < document_->count("animations"); ++i) {
    names.push_back(text_of(document_->object("animations", i), "name"));
    if (!name.empty() && names.back() != name) continue;
    if (!read_animation(i, leave_out)) ++covered;
    if (!name.empty()) return;
  }
  leave_out("animations that move what an earlier one moves", covered);
  if (name.empty()) return;
  for (std::string& each : names) each = '"' + each + '"';
  document_->fail(fmt::format("an animation \"{}\"", one_line(name)),
                  names.empty() ? "none" : one_line(fmt::format("{}", fmt::join(names, ", "))),
                  names.empty() ? "leave out the name: the file has no animation"
                                : "give one of these names, or none for all");
}

bool GltfScene::read_animation(std::size_t index, const LeaveOut& leave_out) {
  const std::string name = fmt::format("animations[{}]", index);
  const json& animation = document_->object("animations", index);
  const auto channels = animation.find("channels");
  if (channels == animation.end() || !channels->is_array())
    document_->fail(fmt::format("channels in {}", name), "none");
  bool is_free = true;
  for (const json& channel : *channels) {
    const auto target = channel.is_object() ? channel.find("target") : channel.end();
    if (!channel.is_object() || target == channel.end() || !target->is_object())
      document_->fail(fmt::format("a target of each channel in {}", name), "none");
    const std::string path = text_of(*target, "path");
    const auto known = std::find(path_names.begin(), path_names.end(), path);
    if (known == path_names.end() || !target->contains("node")) {
      leave_out("animation channels of things other than nodes", 1);
      continue;
    }
    const auto which = static_cast<std::size_t>(known - path_names.begin());
    const std::size_t at = document_->whole(*target, "node", std::nullopt);
    if (at >= nodes_.size())
      document_->fail(fmt::format("nodes below {} in {}", nodes_.size(), name), fmt::format("{}", at));
    Node& node = nodes_[at];
    if (node.matrix && which != weights) {
      leave_out("animation channels of nodes with a matrix", 1);
    } else if (node.moving[which].width > 0) {
      is_free = false;
    } else {
      constexpr std::array<std::size_t, path_count> widths{3, 4, 3, 0};
      node.moving[which] = sampler(animation, channel, widths[which], name);
    }
  }
  return is_free;
}

/// Of a channel. A width of 0 is what the numbers give, as of the weights of morphs.
GltfScene::Sampler GltfScene::sampler(const json& animation, const json& channel, std::size_t width,
                                      const std::string& name) {
  const std::size_t index = document_->whole(channel, "sampler", std::nullopt);
  const auto samplers = animation.find("samplers");
  if (samplers == animation.end() || !samplers->is_array() || index >= samplers->size() ||
      !(*samplers)[index].is_object()) {
    document_->fail(fmt::format("a sampler {} in {}", index, name), "none");
  }
  const json& object = (*samplers)[index];
  Sampler made;
  const std::string kind = object.contains("interpolation") ? text_of(object, "interpolation") : "LINEAR";
  if (kind == "STEP") {
    made.kind = Kind::step;
  } else if (kind == "CUBICSPLINE") {
    made.kind = Kind::cubic;
  } else if (kind != "LINEAR") {
    document_->fail(fmt::format("STEP, LINEAR or CUBICSPLINE in {}", name), shown(object["interpolation"]));
  }
  made.times_s = numbers(document_->whole(object, "input", std::nullopt), "SCALAR", 1);
  const char* const type = width == 3 ? "VEC3" : width == 4 ? "VEC4" : "SCALAR";
  made.numbers =
      numbers(document_->whole(object, "output", std::nullopt), type, std::max<std::size_t>(width, 1));
  const std::vector<double>& times_s = *made.times_s;
  const bool is_known = !rising_.insert(&times_s).second;  // channels share them
  const auto rise = [&] { return std::is_sorted(times_s.begin(), times_s.end()) && times_s.front() >= 0.0; };
  if (times_s.empty() || !(is_known || rise()))
    document_->fail(fmt::format("times that rise from 0 in {}", name), times_s.empty() ? "none" : "others");
  const std::size_t values = (made.kind == Kind::cubic ? 3 : 1) * times_s.size();
  made.width = width > 0 ? width : made.numbers->size() / values;
  if (made.width == 0 || made.numbers->size() != values * made.width)
    document_->fail(fmt::format("{} values in {}", values, name),
                    fmt::format("{} numbers", made.numbers->size()));
  end_s_ = std::max(end_s_, times_s.back());
  return made;
}

/// Each accessor is kept once, however many channels share it.
std::shared_ptr<const std::vector<double>> GltfScene::numbers(std::size_t accessor, std::string_view type,
                                                              std::size_t width) {
  std::shared_ptr<const std::vector<double>>& known = read_[accessor];
  if (known && known->size() != document_->element_count(accessor) * width)
    document_->fail(fmt::format("one type of accessors[{}]", accessor), "two");
  if (known) return known;
  std::vector<double> values = document_->components(accessor, type, width);
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    document_->fail(fmt::format("finite numbers in accessors[{}]", accessor), "others");
  held_ += values.size();
  if (held_ > 4 * document_->bytes()) document_->fail("animations of fewer than 4 numbers per byte", "more");
  known = std::make_shared<const std::vector<double>>(std::move(values));
  return known;
}

std::vector<double> GltfScene::Sampler::at(double time_s, std::size_t count, bool is_rotation) const {
  const std::vector<double>& times = *times_s;
  const auto value = [&](std::size_t key, std::size_t part = 0) {
    const std::size_t first = kind == Kind::cubic ? (3 * key + part) * width : key * width;
    return numbers->data() + first;
  };
  constexpr std::size_t tangent_in = 0, point = 1, tangent_out = 2;  // of a cubic
  const std::size_t middle = kind == Kind::cubic ? point : 0;
  const auto after =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time_s) - times.begin());
  std::vector<double> result(count);
  if (after == 0 || after == times.size() || kind == Kind::step) {
    std::copy_n(value(after == 0 ? 0 : after - 1, middle), count, result.begin());
    return result;
  }
  const std::size_t before = after - 1;
  const double step_s = times[after] - times[before], t = (time_s - times[before]) / step_s;
  const double *const a = value(before, middle), *const b = value(after, middle);
  if (kind == Kind::cubic) {
    const double t2 = t * t, t3 = t2 * t;
    const double *const out = value(before, tangent_out), *const in = value(after, tangent_in);
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * a[i] + step_s * (t3 - 2.0 * t2 + t) * out[i] +
                  (3.0 * t2 - 2.0 * t3) * b[i] + step_s * (t3 - t2) * in[i];
    }
  } else if (is_rotation) {
    const glm::dquat turn = glm::slerp(glm::normalize(glm::dquat(a[3], a[0], a[1], a[2])),
                                       glm::normalize(glm::dquat(b[3], b[0], b[1], b[2])), t);
    result = {turn.x, turn.y, turn.z, turn.w};
  } else {
    for (std::size_t i = 0; i < count; ++i) result[i] = std::lerp(a[i], b[i], t);
  }
  return result;
}

glm::dmat4 GltfScene::Node::at(std::optional<double> time_s) const {
  if (matrix) return *matrix;
  const auto value = [&](Path path) {
    const Sampler& sampler = moving[path];
    return time_s && sampler.width > 0 ? sampler.at(*time_s, sampler.width, path == rotation) : at_rest[path];
  };
  glm::dmat4 transform(1.0);
  if (const std::vector<double> t = value(translation); !t.empty())
    transform = glm::translate(transform, glm::dvec3(t[0], t[1], t[2]));
  if (const std::vector<double> q = value(rotation); !q.empty()) {
    const bool is_moving = time_s && moving[rotation].width > 0;
    transform *= glm::mat4_cast(is_moving ? glm::normalize(quaternion(q)) : quaternion(q));
  }
  if (const std::vector<double> s = value(scale); !s.empty())
    transform = glm::scale(transform, glm::dvec3(s[0], s[1], s[2]));
  return transform;
}

void GltfScene::find_moving() {
  for (const std::size_t index : order_) {  // parents come first
    Node& node = nodes_[index];
    node.moves = (node.parent && nodes_[*node.parent].moves) ||
                 std::any_of(node.moving.begin(), node.moving.begin() + weights,
                             [](const Sampler& each) { return each.width > 0; });
  }
}

std::vector<glm::dmat4> GltfScene::to_world(std::optional<double> time_s) const {
  std::vector<glm::dmat4> matrices(nodes_.size(), glm::dmat4(1.0));
  for (const std::size_t node : order_) {  // parents come first
    const std::optional<std::size_t> parent = nodes_[node].parent;
    matrices[node] = (parent ? matrices[*parent] : glm::dmat4(1.0)) * nodes_[node].at(time_s);
  }
  return matrices;
}

std::vector<double> GltfScene::weights_at(std::size_t node, std::optional<double> time_s, std::size_t count,
                                          const std::vector<double>& at_rest) const {
  const Sampler& moving = nodes_[node].moving[weights];
  if (!time_s || moving.width == 0) {
    const auto kept = static_cast<std::ptrdiff_t>(std::min(count, at_rest.size()));
    return {at_rest.begin(), at_rest.begin() + kept};
  }
  return moving.at(*time_s, std::min(count, moving.width), false);
}

}  // namespace offing::meshes
