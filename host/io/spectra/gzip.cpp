#include "host/io/spectra/gzip.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <zlib.h>

#include "host/base/error.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

/// The state of zlib, which lives as long as this.
class Inflater {
 public:
  Inflater() {
    constexpr int gzip_header = 16;
    if (inflateInit2(&stream, MAX_WBITS + gzip_header) != Z_OK)
      throw Error(ErrorKind::out_of_memory, "gzip: zlib cannot start", "free some memory");
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream); }

  z_stream stream{};
};

}  // namespace

std::filesystem::path unpacked_name(const std::filesystem::path& path) {
  return path.extension() == ".gz" ? path.parent_path() / path.stem() : path;
}

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

std::string unpack_gzip(std::string_view bytes, std::string_view file_name, std::size_t most_bytes) {
  const auto fail = [&](const std::string& what, const char* hint) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", printable_name(file_name), what), hint);
  };
  constexpr std::size_t step = std::size_t{1} << 18;
  Inflater inflater;
  z_stream& stream = inflater.stream;
  std::string text;
  std::size_t used = 0;
  for (;;) {
    const std::string_view rest = bytes.substr(used);
    const auto available =
        static_cast<uInt>(std::min<std::size_t>(rest.size(), std::numeric_limits<uInt>::max()));
    // zlib reads from it alone.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest.data()));
    stream.avail_in = available;
    const std::size_t before = text.size();
    text.resize(before + step);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream.avail_out = step;
    const int status = inflate(&stream, Z_NO_FLUSH);
    used += available - stream.avail_in;
    text.resize(text.size() - stream.avail_out);
    if (text.size() > most_bytes)
      fail(fmt::format("expected at most {} bytes unpacked, got more", most_bytes),
           "unpack it with gunzip and cut it into months");
    if (status == Z_STREAM_END) {
      if (!is_gzip(bytes.substr(used))) return text;  // gunzip ignores what follows, too
      inflateReset(&stream);
    } else if (status != Z_OK) {
      fail(fmt::format("expected a whole gzip file, got one that is damaged or cut short at byte {}", used),
           "check the file with gunzip -t, and get it again");
    }
  }
}

}  // namespace offing::spectra
