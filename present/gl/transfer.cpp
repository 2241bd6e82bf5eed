#include "present/gl/transfer.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/ocl/imported_buffer.h"

namespace offing::present {

class Transfer::Way {
 public:
  Way() = default;
  Way(const Way&) = delete;
  Way& operator=(const Way&) = delete;
  virtual ~Way() = default;
  virtual void upload(std::span<const Upload> uploads) = 0;
};

namespace {

/// Binds a buffer for texels while it lives.
class UnpackBinding {
 public:
  explicit UnpackBinding(const GlBuffer& buffer) { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer.name()); }
  UnpackBinding(const UnpackBinding&) = delete;
  UnpackBinding& operator=(const UnpackBinding&) = delete;
  ~UnpackBinding() { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0); }
};

std::size_t bytes_of(const Upload& upload) {
  return upload.source.size() * sizeof(float);
}

void specify(const TextureArray& target, std::span<const float> texels, const GlCapabilities& capabilities) {
  if (capabilities.is_software) {
    target.specify_levels(texels);
  } else {
    target.specify(texels.data());
  }
}

class MappedPointer : public Transfer::Way {
 public:
  explicit MappedPointer(const GlCapabilities& capabilities) : capabilities_(capabilities) {}

  void upload(std::span<const Upload> uploads) override {
    for (const Upload& upload : uploads) {
      const auto view = upload.source.map();
      specify(*upload.target, view.span(), capabilities_);
    }
  }

 private:
  GlCapabilities capabilities_;
};

class BlockingRead : public Transfer::Way {
 public:
  explicit BlockingRead(const GlCapabilities& capabilities) : capabilities_(capabilities) {}

  void upload(std::span<const Upload> uploads) override {
    for (const Upload& upload : uploads) {
      staging_.resize(upload.source.size());
      upload.source.read(staging_);
      specify(*upload.target, staging_, capabilities_);
    }
  }

 private:
  GlCapabilities capabilities_;
  std::vector<float> staging_;
};

class OrphanedPbo : public Transfer::Way {
 public:
  void upload(std::span<const Upload> uploads) override {
    const UnpackBinding binding(buffer_);
    for (const Upload& upload : uploads) {
      const auto bytes = static_cast<GLsizeiptr>(bytes_of(upload));
      glBufferData(GL_PIXEL_UNPACK_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
      void* memory =
          glMapBufferRange(GL_PIXEL_UNPACK_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
      if (memory == nullptr) throw Error(ErrorKind::device, "OpenGL: a pixel buffer cannot be mapped");
      upload.source.read(std::span(static_cast<float*>(memory), upload.source.size()));
      if (glUnmapBuffer(GL_PIXEL_UNPACK_BUFFER) != GL_TRUE) {
        throw Error(ErrorKind::device, "OpenGL: the content of a pixel buffer was lost");
      }
      upload.target->specify(nullptr);
    }
  }

 private:
  GlBuffer buffer_ = GlBuffer::make();
};

/// A pixel buffer, and whether OpenGL still reads from it.
class FencedPbo {
 public:
  explicit FencedPbo(std::size_t bytes) : bytes_(bytes), buffer_(GlBuffer::make()) {}
  FencedPbo(const FencedPbo&) = delete;
  FencedPbo& operator=(const FencedPbo&) = delete;
  ~FencedPbo() { glDeleteSync(fence_); }

  std::size_t bytes() const { return bytes_; }
  const GlBuffer& buffer() const { return buffer_; }

  /// Waits until OpenGL has read what specify() passed on.
  void wait() {
    if (fence_ == nullptr) return;
    constexpr GLuint64 patience_ns = 10'000'000'000;
    const GLenum end = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, patience_ns);
    if (end == GL_WAIT_FAILED || end == GL_TIMEOUT_EXPIRED) {
      throw Error(ErrorKind::device, "OpenGL: a texture upload does not end");
    }
    glDeleteSync(std::exchange(fence_, nullptr));
  }
  void specify(const TextureArray& target) {
    const UnpackBinding binding(buffer_);
    target.specify(nullptr);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }

 private:
  std::size_t bytes_;
  GlBuffer buffer_;
  GLsync fence_ = nullptr;
};

/// A pixel buffer that stays mapped.
class PersistentPbo : public FencedPbo {
 public:
  PersistentPbo(const ocl::Device&, std::size_t bytes) : FencedPbo(bytes) {
    const UnpackBinding binding(buffer());
    constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const auto size = static_cast<GLsizeiptr>(bytes);
    glBufferStorage(GL_PIXEL_UNPACK_BUFFER, size, nullptr, access);
    memory_ = glMapBufferRange(GL_PIXEL_UNPACK_BUFFER, 0, size, access);
    if (memory_ == nullptr) throw Error(ErrorKind::device, "OpenGL: a pixel buffer cannot stay mapped");
  }

  void* memory() const { return memory_; }

 private:
  void* memory_ = nullptr;
};

/// A pixel buffer that OpenCL writes.
class SharedPbo : public FencedPbo {
 public:
  SharedPbo(const ocl::Device& device, std::size_t bytes) : FencedPbo(bytes), imported_(imported(device)) {}

  void copy_from(const ocl::FloatSpan& source) { imported_.copy_from(source); }

 private:
  ocl::ImportedBuffer imported(const ocl::Device& device) {
    const UnpackBinding binding(buffer());
    glBufferData(GL_PIXEL_UNPACK_BUFFER, static_cast<GLsizeiptr>(bytes()), nullptr, GL_STREAM_DRAW);
    glFinish();  // OpenCL takes over a buffer that exists
    return ocl::ImportedBuffer(device, buffer().name());
  }

  ocl::ImportedBuffer imported_;
};

/// Pixel buffers of the frame that is drawn, the one that is made, and one between; one a map.
template <class Pbo>
class Ring {
 public:
  explicit Ring(const ocl::Device& device) : device_(device) {}

  /// Buffers for these maps that OpenGL is done with.
  std::vector<std::unique_ptr<Pbo>>& next(std::span<const Upload> uploads) {
    std::vector<std::unique_ptr<Pbo>>& slots = frames_[next_];
    next_ = (next_ + 1) % frames_.size();
    slots.resize(std::max(slots.size(), uploads.size()));
    for (std::size_t i = 0; i < uploads.size(); ++i) {
      if (!slots[i] || slots[i]->bytes() != bytes_of(uploads[i])) {
        slots[i] = std::make_unique<Pbo>(device_, bytes_of(uploads[i]));
      }
      slots[i]->wait();
    }
    return slots;
  }

 private:
  ocl::Device device_;
  std::array<std::vector<std::unique_ptr<Pbo>>, 3> frames_;
  std::size_t next_ = 0;
};

class PboRing : public Transfer::Way {
 public:
  explicit PboRing(const ocl::Device& device) : ring_(device) {}

  void upload(std::span<const Upload> uploads) override {
    auto& slots = ring_.next(uploads);
    std::vector<ocl::Event> reads;
    for (std::size_t i = 0; i < uploads.size(); ++i) {
      reads.push_back(uploads[i].source.begin_read(static_cast<float*>(slots[i]->memory())));
    }
    // Each map is passed on while the next ones are still read.
    for (std::size_t i = 0; i < uploads.size(); ++i) {
      reads[i].wait();
      slots[i]->specify(*uploads[i].target);
    }
  }

 private:
  Ring<PersistentPbo> ring_;
};

class GlSharing : public Transfer::Way {
 public:
  explicit GlSharing(const ocl::Device& device) : ring_(device) {}

  void upload(std::span<const Upload> uploads) override {
    auto& slots = ring_.next(uploads);
    for (std::size_t i = 0; i < uploads.size(); ++i) {
      slots[i]->copy_from(uploads[i].source);
      slots[i]->specify(*uploads[i].target);
    }
  }

 private:
  Ring<SharedPbo> ring_;
};

/// Why a transfer path cannot be used; empty if it can.
std::string obstacle(TransferPath path, const GlCapabilities& capabilities, const ocl::Device& device) {
  switch (path) {
    case TransferPath::gl_sharing:
      return device.shares_gl() ? "" : "the OpenCL device does not share buffers with OpenGL";
    case TransferPath::mapped_pointer:
      return device.info().type == ocl::DeviceType::cpu ? ""
                                                        : "the OpenCL device does not compute in host memory";
    case TransferPath::pbo_ring:
      return capabilities.has_persistent_mapping ? "" : "OpenGL has no persistent mapping";
    default:
      return "";
  }
}

std::unique_ptr<Transfer::Way> make_way(TransferPath path, const GlCapabilities& capabilities,
                                        const ocl::Device& device) {
  switch (path) {
    case TransferPath::gl_sharing:
      return std::make_unique<GlSharing>(device);
    case TransferPath::mapped_pointer:
      return std::make_unique<MappedPointer>(capabilities);
    case TransferPath::pbo_ring:
      return std::make_unique<PboRing>(device);
    case TransferPath::orphaned_pbo:
      return std::make_unique<OrphanedPbo>();
    default:
      return std::make_unique<BlockingRead>(capabilities);
  }
}

void require_equal_sizes(std::span<const Upload> uploads) {
  for (const Upload& upload : uploads) {
    if (upload.source.size() == upload.target->count()) continue;
    throw Error(ErrorKind::bad_usage, fmt::format("texture upload: expected {} floats, found {}",
                                                  upload.target->count(), upload.source.size()));
  }
}

}  // namespace

std::string_view to_string(TransferPath path) {
  switch (path) {
    case TransferPath::gl_sharing:
      return "gl-sharing";
    case TransferPath::mapped_pointer:
      return "mapped-pointer";
    case TransferPath::pbo_ring:
      return "pbo-ring";
    case TransferPath::orphaned_pbo:
      return "orphaned-pbo";
    default:
      return "blocking-read";
  }
}

Transfer::Transfer(const GlContext& context, const ocl::Device& device, std::optional<TransferPath> forced)
    : is_forced_(forced.has_value()),
      capabilities_(context.capabilities()),
      device_(device),
      path_(forced.value_or(all_transfer_paths.front())) {
  if (const std::string reason = obstacle(path_, capabilities_, device_); !reason.empty()) {
    if (is_forced_) {
      throw Error(ErrorKind::bad_usage, fmt::format("--transfer {}: {}", to_string(path_), reason),
                  "leave it out for the best one");
    }
    climb_down(path_);
  } else {
    way_ = make_way(path_, capabilities_, device_);
  }
}

Transfer::Transfer(Transfer&&) noexcept = default;
Transfer& Transfer::operator=(Transfer&&) noexcept = default;
Transfer::~Transfer() = default;

TransferPath Transfer::path() const {
  return path_;
}

void Transfer::climb_down(TransferPath from) {
  device_.finish();  // reads into buffers that go now
  auto next = static_cast<std::size_t>(from) + 1;
  while (!obstacle(all_transfer_paths[next], capabilities_, device_).empty()) ++next;
  path_ = all_transfer_paths[next];
  way_ = make_way(path_, capabilities_, device_);
}

void Transfer::upload(std::span<const Upload> uploads) {
  require_equal_sizes(uploads);
  while (true) {
    try {
      way_->upload(uploads);
      require_no_gl_error("texture upload");
      return;
    } catch (const Error& error) {
      if (is_forced_ || path_ == all_transfer_paths.back()) throw;
      const TransferPath failed = path_;
      climb_down(failed);
      spdlog::warn("transfer {} failed, continuing with {}: {}", to_string(failed), to_string(path_),
                   error.what());
    }
  }
}

}  // namespace offing::present
