#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>

/// Files that are written whole or not at all, and what becomes of those that are there already.
namespace offing {

/// What becomes of an existing file, or folder, of an output's name.
enum class Existing { keep, replace };

/// A file that appears under its final name whole or not at all, also after kill -9 or a power cut.
///
/// Bytes go to a temporary name in the target's own folder (`.ocean.0003.exr.<16 hex digits>.partial`),
/// locked for as long as this object lives; commit() flushes, syncs the file, renames it over the target and
/// syncs the folder. Destroying the object without commit() removes the temporary. Libraries that want a name
/// write to temporary(). Every failure throws Error(file) that names the target and what the system said,
/// also if the target is a folder, a device or anything else that a rename must not replace; the hint says
/// the fix, such as room on a full disk. With Existing::keep, commit() throws Error(bad_usage) where the name
/// has been taken since.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target, Existing existing = Existing::replace);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& temporary() const { return temporary_; }

  void write(const void* data, std::size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Position of the next write, bytes from the start; for formats whose tables are filled in last.
  std::uint64_t position();
  void seek(std::uint64_t position);

  /// Publishes the file. Call once, last.
  void commit();

 private:
  [[noreturn]] void fail(std::string_view action, int error_number);
  void publish();
  void discard() noexcept;

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  Existing existing_;
  std::FILE* file_ = nullptr;
  int first_error_ = 0;  ///< errno of the first failure
};

/// Writes `bytes` to `target` in one go, as AtomicFile does.
void write_file_atomically(const std::filesystem::path& target, std::string_view bytes,
                           Existing existing = Existing::replace);

/// Makes sure, before long work, that `target` can be written: throws what AtomicFile would throw. Nothing is
/// left behind.
void require_writable(const std::filesystem::path& target);

/// The folder of a file: "." where only its name is given.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Throws Error(bad_usage): the name of an output is taken, and what has it is to be kept. `hint` says how the
/// caller's user can have it replaced.
[[noreturn]] void refuse_existing(const std::filesystem::path& output,
                                  const char* hint = "name another file, or ask for it to be replaced");

/// Removes temporaries that killed runs left in `folder` for targets whose name begins with `name_prefix`
/// (empty: all). Those of living writers, in this or any other process, are locked and stay. Returns how many
/// were removed; a folder that does not exist holds none. Files that cannot be opened or removed are left
/// alone.
std::size_t remove_stale_partials(const std::filesystem::path& folder, std::string_view name_prefix = {});

}  // namespace offing
