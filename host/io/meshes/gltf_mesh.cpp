#include "host/io/meshes/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/io/meshes/gltf_document.h"
#include "host/io/meshes/gltf_scene.h"
#include "host/io/meshes/polygon_soup.h"
#include "host/io/meshes/text_lines.h"

namespace offing::meshes {
namespace {

using nlohmann::json;

/// A document may show a mesh again and again: so many times its own bytes is enough.
constexpr std::size_t most_corners_a_byte = 1000;

// Modes of primitives, glTF 2.0, 5.24.
constexpr std::size_t triangles = 4, triangle_strip = 5, triangle_fan = 6;

/// Sets of four joints that a vertex may go with: files have one, or two.
constexpr std::size_t most_joint_sets = 8;

/// What moves a vertex of a skin.
struct Influence {
  std::uint32_t joint;  ///< of the skin
  float weight;         ///< those of a vertex sum to 1
};

/// What a morph adds at a weight of 1, where that is not zero: vertex and way.
using Ways = std::vector<std::pair<std::uint32_t, glm::dvec3>>;
struct Morph {
  Ways positions_m, normals;
};

struct Skin {
  std::vector<std::size_t> joints;    // nodes
  std::vector<glm::dmat4> from_mesh;  // [joints], to the axes of each joint as the mesh was bound
};

/// Vertices of the primitives that share them, as the file has them.
struct Vertices {
  std::vector<glm::dvec3> positions_m, normals;
  std::vector<Morph> morphs;
  std::vector<std::uint32_t> first_influences;  // [vertices + 1]; empty: no skin
  std::vector<Influence> influences;
};

/// Vertices where one node shows them.
struct ShownVertices {
  std::optional<std::size_t> node;  // none: in the world's axes
  std::shared_ptr<const Vertices> vertices;
  std::shared_ptr<const Skin> skin;                    // none: they go with the node
  std::shared_ptr<const std::vector<double>> weights;  // of the morphs, at rest
};

/// The directions that planes' normals go to: the cofactors are the inverse's transpose without its division,
/// that is for flat scalings, too.
glm::dmat3 normals_of(const glm::dmat4& transform) {
  const glm::dmat3 m(transform);
  const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
  return {sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]), sign * glm::cross(m[0], m[1])};
}

/// All vertices of a glTF at any time: morphs first, then skin or node (glTF 2.0, 3.7.2.2 and 3.7.3).
class MovingVertices {
 public:
  MovingVertices(GltfScene scene, std::string file_name)
      : scene_(std::move(scene)), file_name_(std::move(file_name)) {}

  const GltfScene& scene() const { return scene_; }
  void add(ShownVertices shown) { parts_.push_back(std::move(shown)); }

  bool move() const {
    std::set<const Skin*> still;  // skins that parts share are looked at once
    return std::any_of(parts_.begin(), parts_.end(), [&](const ShownVertices& part) {
      if (!part.node) return false;
      if (!part.vertices->morphs.empty() && scene_.weights_move(*part.node)) return true;
      if (!part.skin) return scene_.moves(*part.node);
      if (!still.insert(part.skin.get()).second) return false;
      const std::vector<std::size_t>& joints = part.skin->joints;
      return std::any_of(joints.begin(), joints.end(),
                         [this](std::size_t node) { return scene_.moves(node); });
    });
  }

  /// Without a time at rest. Throws Error(bad_input) for positions that are not usable.
  MeshForm form_at(std::optional<double> time_s, bool has_normals) const {
    const std::vector<glm::dmat4> to_world = scene_.to_world(time_s);
    std::map<const Skin*, std::vector<glm::dmat4>> joints;  // of skins, which parts share
    MeshForm form;
    for (const ShownVertices& part : parts_) {
      const std::size_t first = form.positions_m.size();
      const Vertices& vertices = *part.vertices;
      form.positions_m.insert(form.positions_m.end(), vertices.positions_m.begin(),
                              vertices.positions_m.end());
      if (has_normals)
        form.normals.insert(form.normals.end(), vertices.normals.begin(), vertices.normals.end());
      const std::size_t morph_count = vertices.morphs.size();
      const std::vector<double> weights =
          part.node ? scene_.weights_at(*part.node, time_s, morph_count, *part.weights) : *part.weights;
      for (std::size_t i = 0; i < std::min(weights.size(), morph_count); ++i) {
        if (weights[i] == 0.0) continue;
        for (const auto& [vertex, way] : vertices.morphs[i].positions_m)
          form.positions_m[first + vertex] += weights[i] * way;
        if (!has_normals) continue;
        for (const auto& [vertex, way] : vertices.morphs[i].normals)
          form.normals[first + vertex] += weights[i] * way;
      }
      if (part.skin && !joints.contains(part.skin.get()))
        joints[part.skin.get()] = joints_of(*part.skin, to_world);
      move(part, to_world, joints[part.skin.get()], first, form);
    }
    for (const glm::dvec3& p : form.positions_m) {
      const bool is_usable = std::abs(p.x) <= farthest_vertex_m && std::abs(p.y) <= farthest_vertex_m &&
                             std::abs(p.z) <= farthest_vertex_m;  // false of NaN
      if (!is_usable) throw mesh_error(file_name_, 0, "finite positions within 1e30", "others");
    }
    return form;
  }

 private:
  /// From the mesh as it was bound to the world, for each joint.
  static std::vector<glm::dmat4> joints_of(const Skin& skin, const std::vector<glm::dmat4>& to_world) {
    std::vector<glm::dmat4> joints;
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
      joints.push_back(to_world[skin.joints[i]] * skin.from_mesh[i]);
    return joints;
  }

  /// Those from `first` on, which are those of a part in its axes, to the world. `joints` are of its skin.
  static void move(const ShownVertices& part, const std::vector<glm::dmat4>& to_world,
                   const std::vector<glm::dmat4>& joints, std::size_t first, MeshForm& form) {
    const auto place = [&](std::size_t vertex, const glm::dmat4& transform) {
      form.positions_m[vertex] = transform * glm::dvec4(form.positions_m[vertex], 1.0);
    };
    const std::size_t count = form.positions_m.size() - first;
    const bool has_normals = !form.normals.empty();
    if (!part.skin) {
      const glm::dmat4 transform = part.node ? to_world[*part.node] : glm::dmat4(1.0);
      const glm::dmat3 turn = normals_of(transform);
      for (std::size_t i = 0; i < count; ++i) {
        place(first + i, transform);
        if (has_normals) form.normals[first + i] = turn * form.normals[first + i];
      }
      return;
    }
    const Vertices& vertices = *part.vertices;
    for (std::size_t i = 0; i < count; ++i) {
      glm::dmat4 transform(0.0);
      for (std::uint32_t k = vertices.first_influences[i]; k < vertices.first_influences[i + 1]; ++k) {
        const Influence& influence = vertices.influences[k];
        transform += static_cast<double>(influence.weight) * joints[influence.joint];
      }
      place(first + i, transform);
      if (has_normals) form.normals[first + i] = normals_of(transform) * form.normals[first + i];
    }
  }

  GltfScene scene_;
  std::string file_name_;
  std::vector<ShownVertices> parts_;
};

class GltfParser {
 public:
  GltfParser(std::string_view bytes, const std::filesystem::path& path, Trust trust,
             const std::string& animation)
      : document_(bytes, path, trust),
        soup_(path.string()),
        has_mesh_been_shown_(document_.count("meshes"), 0) {
    soup_.report.format = document_.is_binary() ? "glTF, binary" : "glTF";
    check_extensions();
    const auto leave_out = [this](std::string_view what, std::size_t count) { soup_.leave_out(what, count); };
    vertices_ = std::make_shared<MovingVertices>(GltfScene(document_, animation, leave_out), path.string());
  }

  MeshFile parse() {
    if (document_.count("nodes") == 0) {
      for (std::size_t i = 0; i < document_.count("meshes"); ++i) add_mesh(i, json::object(), {});
    }
    rest_ = vertices_->scene().to_world({});
    for (const std::size_t node : vertices_->scene().nodes()) {
      const json& object = document_.object("nodes", node);
      if (object.contains("mesh")) add_mesh(document_.whole(object, "mesh", std::nullopt), object, node);
    }
    const auto hidden = std::count(has_mesh_been_shown_.begin(), has_mesh_been_shown_.end(), 0);
    soup_.leave_out("meshes that the scene does not show", static_cast<std::size_t>(hidden));
    soup_.leave_out("bytes after the end", document_.bytes_over());
    if (!have_all_normals_) {
      soup_.leave_out("normals, since some vertices have none or several", normal_count_);
    } else if (!have_morphs_normals_) {
      soup_.leave_out("normals, since some morphs have none", normal_count_);
      have_all_normals_ = false;
    }
    MeshForm form = vertices_->form_at({}, have_all_normals_);
    soup_.positions_m = std::move(form.positions_m);
    soup_.normals = std::move(form.normals);
    MeshFile file = std::move(soup_).finish();
    if (vertices_->move()) {
      file.deformation = {.form_at = [vertices = std::shared_ptr<const MovingVertices>(vertices_),
                                      has_normals = !file.mesh.normals.empty()](
                                         double time_s) { return vertices->form_at(time_s, has_normals); },
                          .end_s = vertices_->scene().end_s()};
    }
    return file;
  }

 private:
  void check_extensions() const {
    constexpr std::array<std::string_view, 5> harmless = {"KHR_mesh_quantization", "KHR_materials_",
                                                          "KHR_texture_", "EXT_texture_", "KHR_lights_"};
    const auto required = document_.root().find("extensionsRequired");
    if (required == document_.root().end()) return;
    for (const json& extension : *required) {
      const std::string name = shown(extension);
      const bool is_harmless = std::any_of(harmless.begin(), harmless.end(),
                                           [&](std::string_view prefix) { return name.starts_with(prefix); });
      if (!is_harmless) document_.fail("a glTF without compression and other extensions", name);
    }
  }

  /// `node` is the object of the node that shows it, number `index`; without nodes there is none.
  void add_mesh(std::size_t mesh_index, const json& node, std::optional<std::size_t> index) {
    const json& mesh = document_.object("meshes", mesh_index);
    has_mesh_been_shown_[mesh_index] = 1;
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      document_.fail("primitives of each mesh", "none");
    const std::shared_ptr<const Skin> skin =
        node.contains("skin") ? skin_of(document_.whole(node, "skin", std::nullopt)) : nullptr;
    std::shared_ptr<const std::vector<double>>& of_mesh = weights_of_[mesh_index];
    if (!of_mesh && !node.contains("weights")) of_mesh = weights_of(mesh);
    const std::shared_ptr<const std::vector<double>> weights =
        node.contains("weights") ? weights_of(node) : of_mesh;
    std::map<std::size_t, std::size_t> first_vertices;  // of this node, by the number of their key
    for (const json& primitive : *primitives)
      add_primitive(primitive, {.node = index, .vertices = {}, .skin = skin, .weights = weights},
                    first_vertices);
  }

  std::shared_ptr<const std::vector<double>> weights_of(const json& object) const {
    const auto weights = object.find("weights");
    if (weights == object.end()) return std::make_shared<const std::vector<double>>();
    if (!weights->is_array()) document_.fail("a list \"weights\"", weights->type_name());
    return std::make_shared<const std::vector<double>>(document_.numbers(object, "weights", weights->size()));
  }

  /// nullptr for one whose joints the scene does not have.
  std::shared_ptr<const Skin> skin_of(std::size_t index) {
    const auto [entry, is_new] = skins_.try_emplace(index);
    if (!is_new) return entry->second;
    const json& object = document_.object("skins", index);
    const auto joints = object.find("joints");
    if (joints == object.end() || !joints->is_array() || joints->empty())
      document_.fail(fmt::format("joints in skins[{}]", index), "none");
    Skin skin;
    for (const json& joint : *joints) {
      if (!joint.is_number_unsigned()) document_.fail("numbers in joints", shown(joint));
      skin.joints.push_back(joint.get<std::size_t>());
      if (!vertices_->scene().has(skin.joints.back())) {
        soup_.leave_out("skins with joints that the scene does not have");
        return nullptr;
      }
    }
    skin.from_mesh.assign(skin.joints.size(), glm::dmat4(1.0));
    if (object.contains("inverseBindMatrices")) {
      const std::vector<double> numbers =
          document_.components(document_.whole(object, "inverseBindMatrices", std::nullopt), "MAT4", 16);
      grow(numbers.size() / 16);
      if (numbers.size() / 16 < skin.joints.size())
        document_.fail(fmt::format("{} matrices of skins[{}]", skin.joints.size(), index),
                       fmt::format("{}", numbers.size() / 16));
      for (std::size_t i = 0; i < skin.joints.size(); ++i)
        skin.from_mesh[i] = glm::make_mat4(numbers.data() + 16 * i);
    }
    return entry->second = std::make_shared<const Skin>(std::move(skin));
  }

  /// Numbers of the accessors that make vertices what they are.
  using Key = std::vector<std::size_t>;

  /// The number of a primitive's key. Nodes that show it ask for it again, so each is made once.
  std::size_t number_of_key(const json& primitive, const json& attributes, const Skin* skin) {
    const std::size_t joints = skin == nullptr ? 0 : skin->joints.size();
    const auto [number, is_new] = key_numbers_.try_emplace({&primitive, joints}, 0);
    if (is_new)
      number->second = keys_.try_emplace(key_of(primitive, attributes, skin), keys_.size()).first->second;
    return number->second;
  }

  void add_primitive(const json& primitive, ShownVertices shown,
                     std::map<std::size_t, std::size_t>& first_vertices) {
    if (!primitive.is_object()) document_.fail("objects as primitives", primitive.type_name());
    const std::size_t mode = document_.whole(primitive, "mode", triangles);
    if (mode > triangle_fan) document_.fail("a mode of 0 to 6", fmt::format("{}", mode));
    if (mode < triangles) {
      soup_.leave_out("sets of points or lines");
      return;
    }
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) {
      document_.fail("positions of each primitive", "none");
    }
    const std::size_t key = number_of_key(primitive, *attributes, shown.skin.get());
    const auto [entry, is_new] = first_vertices.try_emplace(key, vertex_count_);
    const std::size_t count = document_.element_count(document_.whole(*attributes, "POSITION", std::nullopt));
    if (is_new) grow(count + targets_of(primitive).size());
    std::shared_ptr<const Vertices>& vertices = vertices_of_[key];
    if (!vertices)
      vertices = std::make_shared<const Vertices>(vertices_with(primitive, *attributes, shown.skin.get()));
    if (is_new) {
      if (attributes->contains("COLOR_0")) soup_.leave_out("colours of vertices", count);
      if (attributes->contains("TEXCOORD_0")) soup_.leave_out("texture coordinates of vertices", count);
      vertex_count_ += count;
      if (vertex_count_ > most_vertices)
        document_.fail(fmt::format("at most {} vertices", most_vertices), "more");
      normal_count_ += vertices->normals.size();
      if (vertices->normals.size() != count) have_all_normals_ = false;
    }
    std::vector<std::uint32_t> corners;
    if (primitive.contains("indices")) {
      corners = document_.indices(document_.whole(primitive, "indices", std::nullopt));
    } else {
      corners.resize(count);
      for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
    }
    grow(corners.size());
    for (std::uint32_t& corner : corners) {
      if (corner >= count) document_.fail(fmt::format("indices below {}", count), fmt::format("{}", corner));
      corner += static_cast<std::uint32_t>(entry->second);
    }
    shown.vertices = vertices;
    add_faces(corners, mode, is_mirrored(shown));
    if (is_new) vertices_->add(std::move(shown));
  }

  /// Whether faces turn over at rest. Those of a skin go with their first joint.
  bool is_mirrored(const ShownVertices& shown) const {
    glm::dmat3 turn(1.0);
    if (shown.skin) {
      turn = glm::dmat3(rest_[shown.skin->joints.front()] * shown.skin->from_mesh.front());
    } else if (shown.node) {
      turn = glm::dmat3(rest_[*shown.node]);
    }
    return glm::determinant(turn) < 0.0;
  }

  Key key_of(const json& primitive, const json& attributes, const Skin* skin) const {
    constexpr std::size_t none = SIZE_MAX;
    Key key{document_.whole(attributes, "POSITION", std::nullopt),
            document_.whole(attributes, "NORMAL", none)};
    for (const json& target : targets_of(primitive)) {
      if (!target.is_object()) document_.fail("objects as targets", target.type_name());
      key.push_back(document_.whole(target, "POSITION", none));
      key.push_back(document_.whole(target, "NORMAL", none));
    }
    key.push_back(none);  // the end of the targets
    if (skin == nullptr) return key;
    for (std::size_t set = 0; attributes.contains(fmt::format("JOINTS_{}", set)); ++set) {
      key.push_back(document_.whole(attributes, fmt::format("JOINTS_{}", set).c_str(), std::nullopt));
      key.push_back(document_.whole(attributes, fmt::format("WEIGHTS_{}", set).c_str(), std::nullopt));
    }
    key.push_back(skin->joints.size());  // that joints are checked against
    return key;
  }

  const json& targets_of(const json& primitive) const {
    static const json none = json::array();
    const auto targets = primitive.find("targets");
    if (targets == primitive.end()) return none;
    if (!targets->is_array()) document_.fail("a list \"targets\"", targets->type_name());
    return *targets;
  }

  Vertices vertices_with(const json& primitive, const json& attributes, const Skin* skin) {
    Vertices vertices;
    vertices.positions_m = document_.vectors(document_.whole(attributes, "POSITION", std::nullopt));
    const std::size_t count = vertices.positions_m.size();
    if (attributes.contains("NORMAL"))
      vertices.normals = document_.vectors(document_.whole(attributes, "NORMAL", std::nullopt));
    for (const json& target : targets_of(primitive)) {
      Morph& morph = vertices.morphs.emplace_back();
      if (target.contains("POSITION")) morph.positions_m = ways(target, "POSITION", count);
      if (target.contains("NORMAL")) morph.normals = ways(target, "NORMAL", count);
      if (!morph.positions_m.empty() && !target.contains("NORMAL")) have_morphs_normals_ = false;
    }
    if (skin != nullptr) set_influences(attributes, skin->joints.size(), vertices);
    return vertices;
  }

  Ways ways(const json& target, const char* key, std::size_t count) {
    const std::size_t accessor = document_.whole(target, key, std::nullopt);
    if (document_.element_count(accessor) != count)
      document_.fail(fmt::format("{} elements in accessors[{}]", count, accessor),
                     fmt::format("{}", document_.element_count(accessor)));
    grow(count);
    Ways ways;
    const std::vector<glm::dvec3> vectors = document_.vectors(accessor);
    for (std::uint32_t i = 0; i < vectors.size(); ++i) {
      if (vectors[i] != glm::dvec3(0.0)) ways.emplace_back(i, vectors[i]);
    }
    way_count_ += ways.size();
    if (way_count_ > 4 * document_.bytes())
      document_.fail("morphs of fewer than 4 vertices per byte", "more");
    return ways;
  }

  /// Of JOINTS_0 and WEIGHTS_0 and on; a vertex without weights goes with the first joint.
  void set_influences(const json& attributes, std::size_t joint_count, Vertices& vertices) {
    const std::size_t count = vertices.positions_m.size();
    std::vector<std::vector<double>> joints, weights;  // [sets][vertices][4]
    for (std::size_t set = 0; attributes.contains(fmt::format("JOINTS_{}", set)); ++set) {
      if (set == most_joint_sets) document_.fail(fmt::format("at most {} sets of joints", set), "more");
      grow(4 * count);
      const auto read = [&](const char* name) {
        const std::string key = fmt::format("{}_{}", name, set);
        std::vector<double> values =
            document_.components(document_.whole(attributes, key.c_str(), std::nullopt), "VEC4", 4);
        if (values.size() != 4 * count)
          document_.fail(fmt::format("{} vectors {}", count, key), fmt::format("{}", values.size() / 4));
        return values;
      };
      joints.push_back(read("JOINTS"));
      weights.push_back(read("WEIGHTS"));
    }
    vertices.first_influences.push_back(0);
    for (std::size_t i = 0; i < 4 * count; i += 4) {
      double sum = 0.0;
      const std::size_t first = vertices.influences.size();
      for (std::size_t k = i; k < i + 4; ++k) {
        for (std::size_t set = 0; set < joints.size(); ++set) {
          const double weight = weights[set][k], joint = joints[set][k];
          if (!(weight > 0.0)) continue;
          if (!(joint >= 0.0 && joint < static_cast<double>(joint_count)))
            document_.fail(fmt::format("joints below {}", joint_count), fmt::format("{}", joint));
          sum += weight;
          vertices.influences.push_back({static_cast<std::uint32_t>(joint), static_cast<float>(weight)});
        }
      }
      if (!(sum > 0.0)) {
        vertices.influences.push_back({0, 1.0f});
        sum = 1.0;
      }
      for (std::size_t k = first; k < vertices.influences.size(); ++k)
        vertices.influences[k].weight =
            static_cast<float>(static_cast<double>(vertices.influences[k].weight) / sum);
      if (vertices.influences.size() > most_vertices)
        document_.fail(fmt::format("at most {} joints of vertices", most_vertices), "more");
      vertices.first_influences.push_back(static_cast<std::uint32_t>(vertices.influences.size()));
    }
  }

  /// Throws Error where instances of meshes and skins grow out of proportion.
  void grow(std::size_t count) {
    corners_ += count;
    if (corners_ / most_corners_a_byte > document_.bytes()) {
      document_.fail("a scene of fewer than 1000 corners per byte", "more");
    }
  }

  void add_faces(std::span<const std::uint32_t> corners, std::size_t mode, bool is_mirrored) {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      soup_.add_face(is_mirrored ? std::array{a, c, b} : std::array{a, b, c});
    };
    if (mode == triangles) {
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3) add(corners[i], corners[i + 1], corners[i + 2]);
      if (corners.size() % 3 != 0) soup_.add_face(corners.last(corners.size() % 3));
      return;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      // glTF 2.0, 3.7.2.1: every second triangle of a strip is turned over.
      const std::size_t turn = i % 2;
      if (mode == triangle_strip) {
        add(corners[i], corners[i + 1 + turn], corners[i + 2 - turn]);
      } else {
        add(corners[i + 1], corners[i + 2], corners[0]);
      }
    }
  }

  GltfDocument document_;
  PolygonSoup soup_;
  std::vector<std::uint8_t> has_mesh_been_shown_;
  std::shared_ptr<MovingVertices> vertices_;
  std::vector<glm::dmat4> rest_;                                            // of nodes, to the world
  std::map<Key, std::size_t> keys_;                                         // their numbers
  std::map<std::pair<const json*, std::size_t>, std::size_t> key_numbers_;  // of a primitive and joints
  std::map<std::size_t, std::shared_ptr<const Vertices>> vertices_of_;      // by the number of their key
  std::map<std::size_t, std::shared_ptr<const std::vector<double>>> weights_of_;  // of meshes
  std::map<std::size_t, std::shared_ptr<const Skin>> skins_;
  bool have_all_normals_ = true, have_morphs_normals_ = true;
  std::size_t corners_ = 0, vertex_count_ = 0, normal_count_ = 0, way_count_ = 0;
};

}  // namespace

MeshFile parse_gltf(std::string_view bytes, const std::filesystem::path& path, Trust trust,
                    const std::string& animation) {
  return GltfParser(bytes, path, trust, animation).parse();
}

}  // namespace offing::meshes
