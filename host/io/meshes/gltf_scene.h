#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>

#include "host/io/meshes/gltf_document.h"

namespace offing::meshes {

/// Takes what a reader leaves out: what it is, in the plural, and how many.
using LeaveOut = std::function<void(std::string_view what, std::size_t count)>;

/// The nodes of a glTF's scene, and how they move: translation, rotation, scale and weights of morphs, in
/// steps, linear and by cubics (glTF 2.0, appendix C). Its own copy: the document may go.
class GltfScene {
 public:
  /// `animation` is the name of one; empty: all, and the first one that moves a value counts. Throws
  /// Error(bad_input) where the nodes are no tree, and for an animation that is not there or damaged.
  GltfScene(const GltfDocument& document, const std::string& animation, const LeaveOut& leave_out);

  /// Nodes of the scene, by their index in the document: depth first, children in their order. Without scenes
  /// all nodes.
  const std::vector<std::size_t>& nodes() const { return order_; }
  bool has(std::size_t node) const { return node < nodes_.size() && nodes_[node].is_shown; }
  /// Whether a node or one above it moves; whether its morphs' weights do.
  bool moves(std::size_t node) const { return nodes_[node].moves; }
  bool weights_move(std::size_t node) const { return nodes_[node].moving[weights].width > 0; }
  double end_s() const { return end_s_; }  ///< of the last key; 0 without an animation

  /// From the axes of each node of the document to the world's, at a time or, without one, at rest; those
  /// that the scene does not have are the identity.
  std::vector<glm::dmat4> to_world(std::optional<double> time_s) const;
  /// The first `count` weights of a node's morphs, where an animation moves them; else of those given. Fewer
  /// where there are fewer.
  std::vector<double> weights_at(std::size_t node, std::optional<double> time_s, std::size_t count,
                                 const std::vector<double>& at_rest) const;

 private:
  enum Path : std::size_t { translation, rotation, scale, weights, path_count };
  enum class Kind { step, linear, cubic };

  /// One value through time.
  struct Sampler {
    Kind kind = Kind::linear;
    std::size_t width = 0;                               // numbers of a value; 0: does not move
    std::shared_ptr<const std::vector<double>> times_s;  // never fall
    std::shared_ptr<const std::vector<double>> numbers;  // [keys][width], of cubics [keys][3][width]

    /// The first `count` numbers of the value.
    std::vector<double> at(double time_s, std::size_t count, bool is_rotation) const;
  };

  struct Node {
    bool is_shown = false, moves = false;
    std::optional<std::size_t> parent = {};
    std::optional<glm::dmat4> matrix = {};            // in place of the three vectors
    std::array<std::vector<double>, 3> at_rest = {};  // by path; empty: none
    std::array<Sampler, path_count> moving = {};

    glm::dmat4 at(std::optional<double> time_s) const;
  };

  std::vector<std::size_t> indices(const nlohmann::json& object, const char* key) const;
  std::vector<std::size_t> roots() const;
  void read_nodes();
  void walk();
  void read_animations(const std::string& name, const LeaveOut& leave_out);
  /// Whether all that it moves is free still.
  bool read_animation(std::size_t index, const LeaveOut& leave_out);
  void find_moving();
  Sampler sampler(const nlohmann::json& animation, const nlohmann::json& channel, std::size_t width,
                  const std::string& name);
  std::shared_ptr<const std::vector<double>> numbers(std::size_t accessor, std::string_view type,
                                                     std::size_t width);

  const GltfDocument* document_;  // while it is made
  std::vector<Node> nodes_;       // of the document
  std::vector<std::size_t> order_;
  std::map<std::size_t, std::shared_ptr<const std::vector<double>>> read_;  // by accessor
  std::size_t held_ = 0;                                                    // numbers of animations
  double end_s_ = 0.0;
  std::set<const std::vector<double>*> rising_;  // times of keys that were checked
};

}  // namespace offing::meshes
