#include "host/io/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host/base/error.h"
#include "host/base/process.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view partial_suffix = ".partial";
constexpr std::size_t random_digits = 16;

std::string hint_for(int error_number, const fs::path& target) {
  const std::string folder = folder_of(target).string();
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return fmt::format("the disk is full: free space on the file system of {}, or write to another folder",
                         folder);
    case EFBIG:
      return "raise the file size limit (ulimit -f), or write smaller files";
    case ENOENT:
    case ENOTDIR: {
      std::error_code ignored;
      const fs::file_type type = fs::status(folder, ignored).type();
      if (type == fs::file_type::not_found) {
        return fmt::format("create the folder {} first, or write to an existing one", folder);
      }
      return fmt::format("{} {}: write to another folder", folder,
                         type == fs::file_type::directory ? "takes no new files" : "is no folder");
    }
    case EACCES:
    case EPERM:
    case EROFS:
      return fmt::format("make {} writable, or write to another folder", folder);
    case ENAMETOOLONG:
      return "use a shorter file name";
    case EMFILE:
    case ENFILE:
      return "raise the limit of open files (ulimit -n)";
    default:
      return fmt::format("check the folder {} and its file system", folder);
  }
}

std::string random_name() {
  std::random_device device;
  const std::uint64_t value = (std::uint64_t{device()} << 32) | device();
  return fmt::format("{:016x}", value);
}

/// True when `name` is `.<target><dot><16 hex digits>.partial` for a target that begins with `name_prefix`.
bool is_partial_name(std::string_view name, std::string_view name_prefix) {
  const std::size_t tail = 1 + random_digits + partial_suffix.size();
  if (!name.starts_with('.') || !name.ends_with(partial_suffix) || name.size() < 2 + tail) return false;
  const std::string_view target = name.substr(1, name.size() - 1 - tail);
  const std::string_view random = name.substr(name.size() - tail + 1, random_digits);
  return name[name.size() - tail] == '.' && target.starts_with(name_prefix) &&
         std::all_of(random.begin(), random.end(),
                     [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

/// True when `descriptor` is still the file under `path`: a cleaner may have removed it before it was locked.
bool still_named(int descriptor, const fs::path& path) {
  struct stat open_file {};
  struct stat named_file {};
  return fstat(descriptor, &open_file) == 0 && stat(path.c_str(), &named_file) == 0 &&
         open_file.st_dev == named_file.st_dev && open_file.st_ino == named_file.st_ino;
}

/// Waits for the lock; file systems without locks are used without.
void lock(int descriptor) {
  while (flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
  }
}

/// 0, or the errno of giving `from` the name `to`, which must be free.
int rename_to_free_name(const fs::path& from, const fs::path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) return errno;
  // Network file systems have no such rename, but links, which never replace either.
  if (link(from.c_str(), to.c_str()) == 0) return unlink(from.c_str()) == 0 ? 0 : errno;
  if (errno == EEXIST) return errno;
  // Neither: what is left is to look just before.
  struct stat status {};
  if (lstat(to.c_str(), &status) == 0) return EEXIST;
  return rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

/// 0, or the errno of syncing the folder's entries; file systems that cannot sync a folder are taken as they
/// are.
int sync_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES ? 0 : errno;  // a folder may be writable without being readable
  const int error_number = fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
  close(descriptor);
  return error_number;
}

}  // namespace

fs::path folder_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

void refuse_existing(const fs::path& output, const char* hint) {
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected a new file, found an existing one", one_line(output.string())), hint);
}

AtomicFile::AtomicFile(fs::path target, Existing existing) : target_(std::move(target)), existing_(existing) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target_, ignored);
  if (!target_.has_filename() || (fs::exists(status) && !fs::is_regular_file(status))) {
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot write: expected a file name, found {}", target_.string(),
                            fs::is_directory(status) ? "a folder" : "something that is not a regular file"),
                "name a regular file inside a folder");
  }
  // A cleaner in another process can win the moment between creation and lock; its victim is simply made
  // again.
  for (;;) {
    temporary_ = folder_of(target_) /
                 fmt::format(".{}.{}{}", target_.filename().string(), random_name(), partial_suffix);
    const int descriptor = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      if (errno == EEXIST || errno == EINTR) continue;
      fail("cannot create", errno);
    }
    lock(descriptor);
    if (!still_named(descriptor, temporary_)) {
      close(descriptor);
      continue;
    }
    file_ = fdopen(descriptor, "w+b");
    if (file_ == nullptr) {
      const int error_number = errno;
      close(descriptor);
      unlink(temporary_.c_str());
      fail("cannot open", error_number);
    }
    mark_unfinished(temporary_.c_str());
    return;
  }
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::discard() noexcept {
  if (file_ == nullptr) return;
  unlink(temporary_.c_str());  // before the close, which gives up the lock
  unmark_unfinished(temporary_.c_str());
  std::fclose(file_);
  file_ = nullptr;
}

void AtomicFile::fail(std::string_view action, int error_number) {
  first_error_ = error_number;
  const std::string reason = std::error_code(error_number, std::generic_category()).message();
  throw Error(ErrorKind::file, fmt::format("{}: {}: {}", target_.string(), action, reason),
              hint_for(error_number, target_));
}

void AtomicFile::write(const void* data, std::size_t bytes) {
  if (bytes != 0 && std::fwrite(data, 1, bytes, file_) != bytes) fail("cannot write", errno);
}

std::uint64_t AtomicFile::position() {
  const off_t position = ftello(file_);
  if (position < 0) fail("cannot tell the position", errno);
  return static_cast<std::uint64_t>(position);
}

void AtomicFile::seek(std::uint64_t position) {
  if (fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail("cannot seek", errno);
}

void AtomicFile::commit() {
  if (first_error_ != 0) fail("cannot write", first_error_);
  if (std::fflush(file_) != 0) fail("cannot write", errno);
  if (fsync(fileno(file_)) != 0) fail("cannot sync", errno);
  publish();
  unmark_unfinished(temporary_.c_str());
  std::FILE* const file = std::exchange(file_, nullptr);  // published: nothing left to remove
  if (std::fclose(file) != 0) fail("cannot close", errno);
  if (const int error_number = sync_folder(folder_of(target_)); error_number != 0) {
    fail("cannot sync the folder", error_number);
  }
}

void AtomicFile::publish() {
  if (existing_ == Existing::replace) {
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot rename", errno);
    return;
  }
  const int error_number = rename_to_free_name(temporary_, target_);
  if (error_number == EEXIST) refuse_existing(target_);
  if (error_number != 0) fail("cannot rename", error_number);
}

void write_file_atomically(const fs::path& target, std::string_view bytes, Existing existing) {
  AtomicFile file(target, existing);
  file.write(bytes);
  file.commit();
}

void require_writable(const fs::path& target) {
  const AtomicFile removed_at_once(target);
}

std::size_t remove_stale_partials(const fs::path& folder, std::string_view name_prefix) {
  std::size_t removed = 0;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (!is_partial_name(entry->path().filename().string(), name_prefix)) continue;
    const int descriptor = open(entry->path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && unlink(entry->path().c_str()) == 0) ++removed;
    close(descriptor);
  }
  return removed;
}

}  // namespace offing
