#include "files/zstd_stream.hpp"

#include "files/unpacker.hpp"

#include <mdm/text/error.hpp>

#include <zstd.h>
#include <zstd_errors.h>

#include <new>

namespace mdm {
namespace {

constexpr int compression_level = 1;

void check_zstd(std::size_t result) {
  if (ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation)
    throw std::bad_alloc();
  if (ZSTD_isError(result) != 0)
    throw InputError(std::string("cannot be unpacked: ") + ZSTD_getErrorName(result) +
                     ": give a file that zstd wrote, whole");
}

} // namespace

bool names_zstd(std::string_view path) {
  return path.ends_with(".zst");
}

struct Compressor::State {
  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx *)> context{ZSTD_createCCtx(), ZSTD_freeCCtx};
  std::string piece = std::string(ZSTD_CStreamOutSize(), '\0');

  State() {
    if (!context)
      throw std::bad_alloc();
    check_zstd(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, compression_level));
    check_zstd(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1));
  }

  void compress(std::string_view text, ZSTD_EndDirective mode, const Sink &to) {
    ZSTD_inBuffer in{text.data(), text.size(), 0};
    for (bool is_done = false; !is_done;) {
      ZSTD_outBuffer out{piece.data(), piece.size(), 0};
      const std::size_t left = ZSTD_compressStream2(context.get(), &out, &in, mode);
      check_zstd(left);
      to(std::string_view(piece).substr(0, out.pos));
      is_done = mode == ZSTD_e_end ? left == 0 : in.pos == in.size;
    }
  }
};

Compressor::Compressor() : state_(std::make_unique<State>()) {}
Compressor::~Compressor() = default;

void Compressor::add(std::string_view text, const Sink &to) {
  state_->compress(text, ZSTD_e_continue, to);
}

void Compressor::end(const Sink &to) {
  state_->compress({}, ZSTD_e_end, to);
}

namespace {

class ZstdUnpacker : public Unpacker {
public:
  ZstdUnpacker() {
    constexpr int most_window_log = 27; // 128 MiB
    if (!context_)
      throw std::bad_alloc();
    check_zstd(ZSTD_DCtx_setParameter(context_.get(), ZSTD_d_windowLogMax, most_window_log));
  }

  void unpack(std::string_view &packed, std::string &text) override {
    const std::size_t before = text.size();
    text.resize(before + ZSTD_DStreamOutSize());
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{text.data() + before, text.size() - before, 0};
    const std::size_t left = ZSTD_decompressStream(context_.get(), &out, &in);
    text.resize(before + out.pos);
    check_zstd(left);
    packed.remove_prefix(in.pos);
    is_whole_ = left == 0;
  }

  bool is_whole() const override { return is_whole_; }

private:
  std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx *)> context_{ZSTD_createDCtx(), ZSTD_freeDCtx};
  bool is_whole_ = false;
};

} // namespace

std::unique_ptr<Unpacker> zstd_unpacker() {
  return std::make_unique<ZstdUnpacker>();
}

} // namespace mdm
