#include "host/io/meshes/mesh_sequence.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/base/error.h"
#include "host/io/frame_name.h"
#include "host/io/meshes/read_mesh.h"

namespace offing {
namespace {

constexpr std::size_t most_kept_bytes = std::size_t{256} << 20;

/// By their numbers.
std::map<int, std::filesystem::path> numbered_files(const std::filesystem::path& name) {
  std::map<int, std::filesystem::path> files;
  if (!is_mesh_sequence(name)) return files;
  const FrameName names("mesh.file", name.filename().string(), "mesh_%04d.ply");
  const std::filesystem::path folder = name.has_parent_path() ? name.parent_path() : ".";
  std::error_code failure;
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::optional<int> number = names.frame_of(entry->path().filename().string());
    if (number) files.emplace(*number, name.parent_path() / entry->path().filename());
  }
  return files;
}

class MeshSequence {
 public:
  MeshSequence(std::vector<std::filesystem::path> files, double frames_per_s, Trust trust,
               const TriangleMesh& first)
      : files_(std::move(files)), frames_per_s_(frames_per_s), trust_(trust), faces_(first.faces) {
    keep(0, {first.positions_m, first.normals});
  }

  double end_s() const { return static_cast<double>(files_.size() - 1) / frames_per_s_; }

  MeshForm form_at(double time_s) {
    const double place = std::clamp(time_s * frames_per_s_, 0.0, static_cast<double>(files_.size() - 1));
    const auto before = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(before);
    const std::lock_guard lock(mutex_);
    const std::shared_ptr<const MeshForm> a = frame(before);
    // Times of frames are rounded.
    constexpr double same_share = 1e-9;
    if (share <= same_share) return *a;
    const std::shared_ptr<const MeshForm> b = frame(before + 1);
    MeshForm form = *a;
    for (std::size_t i = 0; i < form.positions_m.size(); ++i)
      form.positions_m[i] = glm::mix(a->positions_m[i], b->positions_m[i], share);
    if (b->normals.empty()) form.normals.clear();
    for (std::size_t i = 0; i < form.normals.size(); ++i)
      form.normals[i] = glm::mix(a->normals[i], b->normals[i], share);
    return form;
  }

 private:
  std::shared_ptr<const MeshForm> frame(std::size_t index) {
    if (const auto known = kept_.find(index); known != kept_.end()) return known->second;
    MeshFile file = read_mesh_file(files_[index], trust_);
    if (file.mesh.positions_m.size() != vertices_ || file.mesh.faces != faces_) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected the {} vertices and the faces of {}, got {} vertices{}",
                              one_line(files_[index].string()), vertices_, files_.front().filename().string(),
                              file.mesh.positions_m.size(),
                              file.mesh.positions_m.size() == vertices_ ? " with other faces" : ""),
                  "export all meshes of the sequence from one mesh that deforms");
    }
    return keep(index, {std::move(file.mesh.positions_m), std::move(file.mesh.normals)});
  }

  std::shared_ptr<const MeshForm> keep(std::size_t index, MeshForm form) {
    vertices_ = form.positions_m.size();
    const std::size_t bytes = sizeof(glm::dvec3) * 2 * vertices_;
    while (order_.size() > 1 && (order_.size() + 1) * bytes > most_kept_bytes) {
      kept_.erase(order_.front());
      order_.pop_front();
    }
    order_.push_back(index);
    return kept_[index] = std::make_shared<const MeshForm>(std::move(form));
  }

  std::vector<std::filesystem::path> files_;
  double frames_per_s_;
  Trust trust_;
  std::vector<TriangleIndices> faces_;
  std::size_t vertices_ = 0;
  std::mutex mutex_;  // of what follows
  std::map<std::size_t, std::shared_ptr<const MeshForm>> kept_;
  std::deque<std::size_t> order_;  // of reading
};

}  // namespace

bool is_mesh_sequence(const std::filesystem::path& name) {
  constexpr std::size_t longest_name = 255;  // of a file, and of what FrameName takes
  const std::string text = name.filename().string();
  std::string_view rest = text;
  const std::size_t at = rest.find('%');
  if (text.size() > longest_name || at == std::string_view::npos || rest.find('%', at + 1) != rest.npos)
    return false;
  rest.remove_prefix(at + 1);
  if (rest.starts_with('0')) rest.remove_prefix(1);
  if (!rest.empty() && rest.front() >= '1' && rest.front() <= '9') rest.remove_prefix(1);
  std::error_code failure;
  return rest.starts_with('d') && !std::filesystem::exists(name, failure);
}

std::vector<std::filesystem::path> files_of_mesh_sequence(const std::filesystem::path& name) {
  std::vector<std::filesystem::path> files;
  for (auto& [number, file] : numbered_files(name)) files.push_back(file);
  return files;
}

MeshFile read_mesh_sequence(const std::filesystem::path& name, double frames_per_s, Trust trust) {
  const std::map<int, std::filesystem::path> numbered = numbered_files(name);
  const auto fail = [&](const std::string& got, const char* hint) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a mesh for each number, got {}", one_line(name.string()), got),
                hint);
  };
  if (numbered.empty()) fail("no file", "check the name: %04d stands for numbers of four digits");
  std::vector<std::filesystem::path> files;
  for (const auto& [number, file] : numbered) {
    if (const int expected = numbered.begin()->first + static_cast<int>(files.size()); number != expected)
      fail(fmt::format("none for {}", expected),
           "export the missing files, or move the later ones to another folder");
    require_beside(name, file, trust);
    files.push_back(file);
  }
  MeshFile first = read_mesh_file(files.front(), trust);
  const auto sequence = std::make_shared<MeshSequence>(std::move(files), frames_per_s, trust, first.mesh);
  first.deformation = {.form_at = [sequence](double time_s) { return sequence->form_at(time_s); },
                       .end_s = sequence->end_s()};
  return first;
}

}  // namespace offing
