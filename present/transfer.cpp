#include "present/transfer.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/base/log.h"

namespace offing::present {

class TransferLadder::Way {
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
  return upload.source->size() * sizeof(float);
}

const void* buffer_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // how OpenGL takes offsets
}

class MappedPointer : public TransferLadder::Way {
 public:
  void upload(std::span<const Upload> uploads) override {
    for (const Upload& upload : uploads) {
      const auto view = upload.source->map();
      upload.target->specify(view.span().data());
    }
  }
};

class BlockingRead : public TransferLadder::Way {
 public:
  void upload(std::span<const Upload> uploads) override {
    for (const Upload& upload : uploads) {
      staging_.resize(upload.source->size());
      upload.source->read(staging_);
      upload.target->specify(staging_.data());
    }
  }

 private:
  std::vector<float> staging_;
};

class OrphanedPbo : public TransferLadder::Way {
 public:
  void upload(std::span<const Upload> uploads) override {
    const UnpackBinding binding(buffer_);
    for (const Upload& upload : uploads) {
      const auto bytes = static_cast<GLsizeiptr>(bytes_of(upload));
      glBufferData(GL_PIXEL_UNPACK_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
      void* memory =
          glMapBufferRange(GL_PIXEL_UNPACK_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
      if (memory == nullptr) throw Error(ErrorKind::device, "OpenGL: a pixel buffer cannot be mapped");
      upload.source->read(std::span(static_cast<float*>(memory), upload.source->size()));
      if (glUnmapBuffer(GL_PIXEL_UNPACK_BUFFER) != GL_TRUE) {
        throw Error(ErrorKind::device, "OpenGL: the content of a pixel buffer was lost");
      }
      upload.target->specify(nullptr);
    }
  }

 private:
  GlBuffer buffer_ = GlBuffer::make();
};

/// A pixel buffer that stays mapped, and whether OpenGL still reads from it.
class PersistentPbo {
 public:
  explicit PersistentPbo(std::size_t bytes) : bytes_(bytes), buffer_(GlBuffer::make()) {
    const UnpackBinding binding(buffer_);
    constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    const auto size = static_cast<GLsizeiptr>(bytes);
    glBufferStorage(GL_PIXEL_UNPACK_BUFFER, size, nullptr, access);
    memory_ = glMapBufferRange(GL_PIXEL_UNPACK_BUFFER, 0, size, access);
    if (memory_ == nullptr) throw Error(ErrorKind::device, "OpenGL: a pixel buffer cannot stay mapped");
  }
  PersistentPbo(const PersistentPbo&) = delete;
  PersistentPbo& operator=(const PersistentPbo&) = delete;
  ~PersistentPbo() { glDeleteSync(fence_); }

  std::size_t bytes() const { return bytes_; }
  const GlBuffer& buffer() const { return buffer_; }
  void* memory() const { return memory_; }

  void wait() {
    if (fence_ == nullptr) return;
    constexpr GLuint64 patience_ns = 10'000'000'000;
    const GLenum end = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, patience_ns);
    if (end == GL_WAIT_FAILED || end == GL_TIMEOUT_EXPIRED) {
      throw Error(ErrorKind::device, "OpenGL: a texture upload does not end");
    }
    glDeleteSync(std::exchange(fence_, nullptr));
  }
  void set_fence() { fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0); }

 private:
  std::size_t bytes_;
  GlBuffer buffer_;
  void* memory_ = nullptr;
  GLsync fence_ = nullptr;
};

class PboRing : public TransferLadder::Way {
 public:
  void upload(std::span<const Upload> uploads) override {
    auto& slots = ring_[next_];
    next_ = (next_ + 1) % ring_.size();
    slots.resize(std::max(slots.size(), uploads.size()));
    std::vector<ocl::Event> reads;
    for (std::size_t i = 0; i < uploads.size(); ++i) {
      if (slots[i] && slots[i]->bytes() != bytes_of(uploads[i])) slots[i].reset();
      if (!slots[i]) slots[i] = std::make_unique<PersistentPbo>(bytes_of(uploads[i]));
      slots[i]->wait();
      reads.push_back(uploads[i].source->begin_read(static_cast<float*>(slots[i]->memory())));
    }
    // Each map is passed on while the next ones are still read.
    for (std::size_t i = 0; i < uploads.size(); ++i) {
      reads[i].wait();
      const UnpackBinding binding(slots[i]->buffer());
      uploads[i].target->specify(buffer_offset(0));
      slots[i]->set_fence();
    }
  }

 private:
  // The frame that is drawn, the one that is read, and one between.
  std::array<std::vector<std::unique_ptr<PersistentPbo>>, 3> ring_;
  std::size_t next_ = 0;
};

/// Why a rung cannot be used; empty if it can.
std::string obstacle(TransferRung rung, const GlCapabilities& capabilities, ocl::DeviceType device_type) {
  switch (rung) {
    case TransferRung::mapped_pointer:
      return device_type == ocl::DeviceType::cpu ? "" : "the OpenCL device does not compute in host memory";
    case TransferRung::pbo_ring:
      return capabilities.has_persistent_mapping ? "" : "OpenGL has no persistent mapping";
    default:
      return "";
  }
}

std::unique_ptr<TransferLadder::Way> make_way(TransferRung rung) {
  switch (rung) {
    case TransferRung::mapped_pointer:
      return std::make_unique<MappedPointer>();
    case TransferRung::pbo_ring:
      return std::make_unique<PboRing>();
    case TransferRung::orphaned_pbo:
      return std::make_unique<OrphanedPbo>();
    default:
      return std::make_unique<BlockingRead>();
  }
}

void require_equal_sizes(std::span<const Upload> uploads) {
  for (const Upload& upload : uploads) {
    if (upload.source->size() == upload.target->count()) continue;
    throw Error(ErrorKind::bad_usage, fmt::format("texture upload: expected {} floats, found {}",
                                                  upload.target->count(), upload.source->size()));
  }
}

}  // namespace

std::string_view to_string(TransferRung rung) {
  switch (rung) {
    case TransferRung::mapped_pointer:
      return "mapped-pointer";
    case TransferRung::pbo_ring:
      return "pbo-ring";
    case TransferRung::orphaned_pbo:
      return "orphaned-pbo";
    default:
      return "blocking-read";
  }
}

TransferRung transfer_rung(std::string_view name) {
  std::vector<std::string_view> names;
  for (const TransferRung rung : all_transfer_rungs) {
    if (to_string(rung) == name) return rung;
    names.push_back(to_string(rung));
  }
  throw Error(
      ErrorKind::bad_usage,
      fmt::format("--transfer: expected one of {}, got \"{}\"", fmt::join(names, ", "), name.substr(0, 60)),
      "leave it out for the best one");
}

TransferLadder::TransferLadder(const GlContext& context, const ocl::Device& device,
                               std::optional<TransferRung> forced)
    : is_forced_(forced.has_value()),
      capabilities_(context.capabilities()),
      device_type_(device.info().type),
      rung_(forced.value_or(all_transfer_rungs.front())) {
  if (const std::string reason = obstacle(rung_, capabilities_, device_type_); !reason.empty()) {
    if (is_forced_) {
      throw Error(ErrorKind::bad_usage, fmt::format("--transfer {}: {}", to_string(rung_), reason),
                  "leave it out for the best one");
    }
    climb_down(rung_);
  } else {
    way_ = make_way(rung_);
  }
}

TransferLadder::TransferLadder(TransferLadder&&) noexcept = default;
TransferLadder& TransferLadder::operator=(TransferLadder&&) noexcept = default;
TransferLadder::~TransferLadder() = default;

TransferRung TransferLadder::rung() const {
  return rung_;
}

void TransferLadder::climb_down(TransferRung from) {
  auto next = static_cast<std::size_t>(from) + 1;
  while (!obstacle(all_transfer_rungs[next], capabilities_, device_type_).empty()) ++next;
  rung_ = all_transfer_rungs[next];
  way_ = make_way(rung_);
}

void TransferLadder::upload(std::span<const Upload> uploads) {
  require_equal_sizes(uploads);
  while (true) {
    try {
      way_->upload(uploads);
      require_no_gl_error("texture upload");
      return;
    } catch (const Error& error) {
      if (is_forced_ || rung_ == all_transfer_rungs.back()) throw;
      const TransferRung failed = rung_;
      climb_down(failed);
      spdlog::warn("transfer {} failed, going on with {}: {}", to_string(failed), to_string(rung_),
                   error.what());
    }
  }
}

}  // namespace offing::present
