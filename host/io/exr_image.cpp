#include "host/io/exr_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <thread>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVersion.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/exr_rows.h"

namespace offing {
namespace {

constexpr const char* hint_of_damage = "make or copy the file again: it is cut short or damaged";

/// Lets OpenEXR write into an AtomicFile.
class AtomicStream : public Imf::OStream {
 public:
  explicit AtomicStream(AtomicFile& file) : Imf::OStream(file.target().c_str()), file_(file) {}
  void write(const char bytes[], int count) override { file_.write(bytes, static_cast<std::size_t>(count)); }
  uint64_t tellp() override { return file_.position(); }
  void seekp(uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

/// Compression runs on OpenEXR's own pool, one for the process; line blocks are still written in order.
void start_compression_threads() {
  static std::once_flag once;
  std::call_once(once, [] {
    const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (Imf::globalThreadCount() < threads) Imf::setGlobalThreadCount(threads);
  });
}

Imf::Compression imf_compression(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::none:
      return Imf::NO_COMPRESSION;
    case ExrCompression::zips:
      return Imf::ZIPS_COMPRESSION;
    case ExrCompression::piz:
      return Imf::PIZ_COMPRESSION;
    default:
      return Imf::ZIP_COMPRESSION;
  }
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what,
                         const std::string& hint) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", path.string(), what), hint);
}

void check(const std::filesystem::path& path, const ExrImage& image) {
  if (image.width < 1 || image.height < 1 || image.channels.empty()) {
    refuse(path,
           fmt::format("cannot write an image of {}x{} pixels with {} channels", image.width, image.height,
                       image.channels.size()),
           "give at least one pixel and one channel");
  }
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::set<std::string> names;
  for (const ImageChannel& channel : image.channels) {
    if (channel.name.empty() || channel.name.size() > 255 || !names.insert(channel.name).second) {
      refuse(path, fmt::format("channel name \"{}\" is empty, too long or used twice", channel.name),
             "give each channel a name of its own of at most 255 letters");
    }
    if (channel.values.size() != pixels) {
      refuse(
          path,
          fmt::format("channel {}: expected {} values, got {}", channel.name, pixels, channel.values.size()),
          "give width x height values");
    }
    const auto nan =
        std::find_if(channel.values.begin(), channel.values.end(), [](float v) { return std::isnan(v); });
    if (nan != channel.values.end()) {
      const long place = nan - channel.values.begin();
      refuse(path,
             fmt::format("channel {}: NaN at row {}, column {}", channel.name, place / image.width,
                         place % image.width),
             "find where the simulation made values that are not finite, and discard this frame");
    }
  }
}

Imf::Header header_of(const std::filesystem::path& path, const ExrImage& image, PixelType pixel_type,
                      ExrCompression compression) {
  Imf::Header header(image.width, image.height);
  header.compression() = imf_compression(compression);
  header.lineOrder() = Imf::INCREASING_Y;  // the one order whose bytes do not depend on how threads finish
  for (const ImageChannel& channel : image.channels) {
    header.channels().insert(channel.name,
                             Imf::Channel(pixel_type == PixelType::half_16 ? Imf::HALF : Imf::FLOAT));
  }
  for (const auto& [name, value] : image.attributes) {
    if (name.empty() || header.find(name) != header.end()) {
      refuse(path, fmt::format("attribute name \"{}\" is empty, used twice or one of EXR's own", name),
             "choose another attribute name");
    }
    if (const auto* text = std::get_if<std::string>(&value)) {
      header.insert(name, Imf::StringAttribute(*text));
    } else if (const auto* number = std::get_if<double>(&value)) {
      header.insert(name, Imf::DoubleAttribute(*number));
    } else {
      header.insert(name, Imf::IntAttribute(std::get<int>(value)));
    }
  }
  return header;
}

/// Whether a name is longer than the first versions of EXR allowed, which the file has to say.
bool has_long_names(const Imf::Header& header) {
  constexpr std::size_t short_name = 31;
  const auto is_long = [](const char* name) { return std::string_view(name).size() > short_name; };
  const Imf::ChannelList& channels = header.channels();
  for (auto entry = channels.begin(); entry != channels.end(); ++entry) {
    if (is_long(entry.name())) return true;
  }
  for (auto entry = header.begin(); entry != header.end(); ++entry) {
    if (is_long(entry.name()) || is_long(entry.attribute().typeName())) return true;
  }
  return false;
}

std::vector<std::uint16_t> halves_of(std::span<const float> values) {
  std::vector<std::uint16_t> halves(values.size());
  std::transform(values.begin(), values.end(), halves.begin(), half_bits);
  return halves;
}

/// OpenEXR takes no const pointers, though it only reads what it writes to a file.
char* slice_base(const void* values) {
  return const_cast<char*>(static_cast<const char*>(values));
}

void write_by_library(AtomicFile& file, const Imf::Header& header, const ExrImage& image,
                      PixelType pixel_type) {
  start_compression_threads();
  const std::size_t columns = static_cast<std::size_t>(image.width);
  std::vector<std::vector<std::uint16_t>> halves;
  Imf::FrameBuffer frame;
  for (const ImageChannel& channel : image.channels) {
    if (pixel_type == PixelType::half_16) {
      halves.push_back(halves_of(channel.values));
      frame.insert(channel.name, Imf::Slice(Imf::HALF, slice_base(halves.back().data()),
                                            sizeof(std::uint16_t), sizeof(std::uint16_t) * columns));
    } else {
      frame.insert(channel.name, Imf::Slice(Imf::FLOAT, slice_base(channel.values.data()), sizeof(float),
                                            sizeof(float) * columns));
    }
  }
  AtomicStream stream(file);
  Imf::OutputFile output(stream, header);
  output.setFrameBuffer(frame);
  output.writePixels(image.height);
}

void write_by_rows(AtomicFile& file, const Imf::Header& header, const ExrImage& image, PixelType pixel_type,
                   ExrCompression compression) {
  header.sanityCheck();
  AtomicStream stream(file);
  const std::array<std::int32_t, 2> mark = {
      Imf::MAGIC, Imf::EXR_VERSION | (has_long_names(header) ? Imf::LONG_NAMES_FLAG : 0)};
  file.write(mark.data(), sizeof(mark));
  header.writeTo(stream);
  std::map<std::string_view, std::span<const float>> channels;
  for (const ImageChannel& channel : image.channels) channels.emplace(channel.name, channel.values);
  ExrRows rows{.columns = image.width,
               .rows = image.height,
               .channels = {},
               .pixel_type = pixel_type,
               .compression = compression};
  for (const auto& [name, values] : channels) rows.channels.push_back(values);
  write_exr_rows(file, rows);
}

ExrAttributes attributes_of(const Imf::Header& header) {
  ExrAttributes attributes;
  for (auto entry = header.begin(); entry != header.end(); ++entry) {
    const Imf::Attribute& attribute = entry.attribute();
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute)) {
      attributes.emplace_back(entry.name(), text->value());
    } else if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute)) {
      attributes.emplace_back(entry.name(), number->value());
    } else if (const auto* single = dynamic_cast<const Imf::FloatAttribute*>(&attribute)) {
      attributes.emplace_back(entry.name(), double{single->value()});
    } else if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&attribute)) {
      attributes.emplace_back(entry.name(), integer->value());
    }
  }
  return attributes;
}

/// Bytes that the library reads for an attribute of this type, whatever the file says; none for types that
/// end where the file says.
std::optional<std::int64_t> fixed_bytes(std::string_view type) {
  static const std::map<std::string_view, std::int64_t> bytes{{"box2f", 16},
                                                              {"box2i", 16},
                                                              {"chromaticities", 32},
                                                              {"compression", 1},
                                                              {"deepImageState", 1},
                                                              {"double", 8},
                                                              {"envmap", 1},
                                                              {"float", 4},
                                                              {"int", 4},
                                                              {"keycode", 28},
                                                              {"lineOrder", 1},
                                                              {"m33d", 72},
                                                              {"m33f", 36},
                                                              {"m44d", 128},
                                                              {"m44f", 64},
                                                              {"rational", 8},
                                                              {"tiledesc", 9},
                                                              {"timecode", 8},
                                                              {"v2d", 16},
                                                              {"v2f", 8},
                                                              {"v2i", 8},
                                                              {"v3d", 24},
                                                              {"v3f", 12},
                                                              {"v3i", 12}};
  const auto found = bytes.find(type);
  return found == bytes.end() ? std::nullopt : std::optional(found->second);
}

/// Where a list of channels ends: names with 16 bytes each, then an empty one.
std::int64_t end_of_channels(std::ifstream& file) {
  constexpr std::streamoff bytes = 16;
  for (std::string name; std::getline(file, name, '\0') && !name.empty();) file.seekg(bytes, std::ios::cur);
  return file.tellg();
}

/// Throws unless the file is one part whose attributes lie within it: the library takes memory for an
/// attribute before it reads it. The library reports all other faults.
void require_attributes(const std::filesystem::path& path) {
  const auto file_bytes = static_cast<std::int64_t>(std::filesystem::file_size(path));
  std::ifstream file(path, std::ios::binary);
  const auto whole = [&] {
    std::array<unsigned char, 4> bytes{};
    file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
  };
  constexpr std::uint32_t magic = 20000630, many_parts = 0x1000;
  if (whole() != magic) return;
  if ((whole() & many_parts) != 0)
    refuse(path, "expected one part, found several", "write a file of one part");
  std::string name, type;
  while (std::getline(file, name, '\0') && !name.empty() && std::getline(file, type, '\0')) {
    const std::int64_t bytes = whole();
    if (!file) return;
    if (bytes > file_bytes - file.tellg()) {
      refuse(path,
             fmt::format("not a whole EXR file: expected at most {} bytes in an attribute, found {}",
                         file_bytes - file.tellg(), bytes),
             hint_of_damage);
    }
    const std::int64_t end = file.tellg() + bytes;
    const bool is_wrong =
        type == "chlist" ? end_of_channels(file) != end : fixed_bytes(type).value_or(bytes) != bytes;
    if (is_wrong) {
      refuse(path,
             fmt::format(
                 "not a whole EXR file: expected an attribute of type {}, found {} bytes of something else",
                 one_line(type), bytes),
             hint_of_damage);
    }
    file.clear();
    file.seekg(end);
  }
}

/// Runs `read` on the opened file; what OpenEXR throws becomes an Error that names the file.
template <typename Read>
auto with_input(const std::filesystem::path& path, Read read) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: cannot read: no such file", path.string()),
                "check the path");
  }
  try {
    require_attributes(path);
    Imf::MultiPartInputFile file(path.c_str());
    return read(file);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    refuse(path, fmt::format("not a whole EXR file: {}", one_line(error.what())), hint_of_damage);
  }
}

/// Throws where a header promises more than its file can hold, before memory is taken for it. Half floats
/// become twice as large; deflate shrinks to a 1032nd, and DWA to one number for 64 pixels before that.
void require_room(const std::filesystem::path& path, const Imf::Header& header) {
  const Imath::Box2i window = header.dataWindow();
  double channels = 0.0;
  for (auto entry = header.channels().begin(); entry != header.channels().end(); ++entry) channels += 1.0;
  const double wanted =
      sizeof(float) * channels * (1.0 + window.max.x - window.min.x) * (1.0 + window.max.y - window.min.y);
  const bool is_dwa =
      header.compression() == Imf::DWAA_COMPRESSION || header.compression() == Imf::DWAB_COMPRESSION;
  const double most =
      2.0 * 1032.0 * (is_dwa ? 64.0 : 1.0) * static_cast<double>(std::filesystem::file_size(path));
  if (wanted <= most) return;
  refuse(
      path,
      fmt::format("not a whole EXR file: expected at most {:.0f} bytes of pixels, found a header for {:.0f}",
                  most, wanted),
      hint_of_damage);
}

ExrContent content_of(const std::filesystem::path& path, Imf::MultiPartInputFile& file) {
  const Imf::Header& header = file.header(0);
  require_room(path, header);
  const Imath::Box2i window = header.dataWindow();
  ExrContent content;
  content.width = window.max.x - window.min.x + 1;
  content.height = window.max.y - window.min.y + 1;
  content.attributes = attributes_of(header);
  const std::size_t columns = static_cast<std::size_t>(content.width);
  Imf::FrameBuffer frame;
  const Imf::ChannelList& channels = header.channels();
  for (auto entry = channels.begin(); entry != channels.end(); ++entry) {
    if (entry.channel().xSampling != 1 || entry.channel().ySampling != 1) {
      refuse(path, fmt::format("channel {} is subsampled", entry.name()), "store every channel at full size");
    }
    content.channels.push_back(
        {entry.name(), std::vector<float>(columns * static_cast<std::size_t>(content.height))});
    // OpenEXR addresses pixels from the data window's origin, so the base lies before the array.
    const std::ptrdiff_t origin = window.min.x + std::ptrdiff_t{window.min.y} * content.width;
    char* const base =
        slice_base(content.channels.back().values.data()) - origin * std::ptrdiff_t{sizeof(float)};
    frame.insert(entry.name(), Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * columns));
  }
  Imf::InputPart part(file, 0);
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y, window.max.y);
  return content;
}

}  // namespace

const std::vector<float>& ExrContent::channel(const std::string& name) const {
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const Channel& channel) { return channel.name == name; });
  if (found == channels.end()) {
    throw Error(ErrorKind::bad_input, fmt::format("the EXR image has no channel {}", name),
                "list its channels with exrheader");
  }
  return found->values;
}

float rounded_to_half(float value) {
  return imath_half_to_float(half_bits(value));
}

void write_exr(const std::filesystem::path& path, const ExrImage& image, PixelType pixel_type,
               ExrCompression compression, Existing existing) {
  check(path, image);
  const Imf::Header header = header_of(path, image, pixel_type, compression);
  AtomicFile file(path, existing);
  try {
    if (compression == ExrCompression::none || compression == ExrCompression::zips) {
      write_by_rows(file, header, image, pixel_type, compression);
    } else {
      write_by_library(file, header, image, pixel_type);
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot write an EXR file: {}", path.string(), error.what()),
                "check the space left on the disk, or choose another compression");
  }
  file.commit();
}

ExrContent read_exr(const std::filesystem::path& path) {
  return with_input(path, [&](Imf::MultiPartInputFile& file) { return content_of(path, file); });
}

ExrAttributes read_exr_attributes(const std::filesystem::path& path) {
  return with_input(path, [](Imf::MultiPartInputFile& file) { return attributes_of(file.header(0)); });
}

}  // namespace offing
