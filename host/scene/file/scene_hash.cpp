#include "host/scene/file/scene_hash.h"

#include <filesystem>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#define XXH_INLINE_ALL  // the header is the library
#include <xxhash.h>

#include "host/io/hydrodynamics/read_hydrodynamics.h"
#include "host/io/meshes/mesh_sequence.h"
#include "host/io/whole_file.h"
#include "host/scene/file/version.h"
#include "host/scene/model/named_file.h"
#include "host/scene/prepare/scene_bodies.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {

namespace {

void append_numbers(fmt::memory_buffer& text, std::string_view name, const std::vector<double>& numbers) {
  fmt::format_to(std::back_inserter(text), "{}[{}]", name, numbers.size());
  for (const double number : numbers) {
    fmt::format_to(std::back_inserter(text), " {:.17g}", number);
  }
  text.push_back('\n');
}

std::string digits_of(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// Files may change under the name by which the scene has them.
void append_content(fmt::memory_buffer& text, const Scene& scene, const ValueKey& key, const char* kind,
                    const std::string& name, const std::vector<std::filesystem::path>& files) {
  read_named(scene, key, kind, name, [&] {
    for (const std::filesystem::path& file : files) {
      const std::string bytes = read_whole_file(file, {.kind = kind, .most_bytes = std::size_t{1} << 36});
      fmt::format_to(std::back_inserter(text), "content {}\n",
                     digits_of(XXH3_128bits(bytes.data(), bytes.size())));
    }
  });
}

void append_files_of_bodies(fmt::memory_buffer& text, const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::size_t mesh = mesh_of_body(scene, i);
    if (const std::string& file = scene.meshes[mesh].file; !file.empty()) {
      const std::vector<std::filesystem::path> sequence = files_of_mesh_sequence(file);
      const std::string hull = sequence.empty() ? file : sequence.front().string();
      append_content(text, scene, {"mesh.file", {mesh, 0}}, "a mesh", hull, {hull});
    }
    if (const std::string& data = scene.bodies[i].hydrodynamics; !data.empty()) {
      append_content(text, scene, {"body.hydrodynamics", {i, 0}}, "a file of hydrodynamic data", data,
                     hydrodynamic_files(data));
    }
  }
}

}  // namespace

std::string scene_hash(const Scene& scene, const Sea& sea, std::string_view output_settings, Affects what) {
  const ocean::Wind wind = wind_of_sea(scene);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "offing {}\noutput {}\n", version(), output_settings);
  for (const Parameter& row : parameter_table()) {
    if (!share_a_bit(row.affects, what)) continue;
    const std::string value = row.group == ParameterGroup::wind ? text_in(&wind, row, Digits::exact)
                                                                : value_text(scene, row, Digits::exact);
    fmt::format_to(out, "{} = {}\n", row.key, value);
  }
  for (const auto& [key, track] : scene.tracks) {
    const Parameter* row = find_parameter(key.key);
    if (row == nullptr || !share_a_bit(row->affects, what)) continue;
    fmt::format_to(out, "{} {} {} {} keys {}", key.key, key.element.outer, key.element.inner, key.number,
                   static_cast<int>(track.interpolation));
    for (const Keyframe& each : track.keys) fmt::format_to(out, " {:.17g} {:.17g}", each.time_s, each.value);
    text.push_back('\n');
  }
  // A wind that was asked for sets the wave age of spreading where none makes the waves; the default one does
  // not.
  if (sea.measured || ocean::is_by_height(scene.ocean.spectrum))
    fmt::format_to(out, "own wind {}\n", scene.ocean.wind_speed_mps.has_value());
  fmt::format_to(out, "depth {:.17g}\n", sea.spectrum.dispersion.depth_m);
  fmt::format_to(out, "foam {:.17g}\n", sea.parameters.foam.fraction.value_or(0.0));
  fmt::format_to(out, "spectrum {}\n", spectrum_name(scene, sea));
  for (const ocean::Cascade& cascade : sea.parameters.cascades) {
    fmt::format_to(out, "cascade {:.17g} {:.17g} {:.17g}\n", cascade.patch_length_m, cascade.k_min_radpm,
                   cascade.k_max_radpm);
  }
  if (sea.measured) {
    append_numbers(text, "frequencies_hz", sea.measured->frequencies_hz);
    append_numbers(text, "energy", sea.measured->energy);
    append_numbers(text, "directions_rad", sea.measured->directions_rad);
    append_numbers(text, "spreading", sea.measured->spreading);
  }
  if (sea.parameters.modes) {
    const std::vector<SeaMode>& modes = sea.parameters.modes->modes;
    std::vector<double> numbers;
    for (const SeaMode& mode : modes) {
      numbers.insert(numbers.end(), {mode.amplitude_m, mode.kx_radpm, mode.kz_radpm, mode.omega_radps,
                                     mode.phase_rad, static_cast<double>(mode.patch)});
    }
    const XXH128_hash_t of_modes = XXH3_128bits(numbers.data(), numbers.size() * sizeof(double));
    fmt::format_to(out, "modes {}\n", digits_of(of_modes));
  }
  if (share_a_bit(what, Affects::bodies)) append_files_of_bodies(text, scene);
  return digits_of(XXH3_128bits(text.data(), text.size()));
}

}  // namespace offing::scene
