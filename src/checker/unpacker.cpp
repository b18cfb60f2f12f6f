#include "unpacker.hpp"

#include <zstd.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace mdm::checker {

struct Unpacker::State {
  std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx *)> context{ZSTD_createDCtx(), ZSTD_freeDCtx};
  std::vector<char> memory = std::vector<char>(ZSTD_DStreamOutSize());
  bool is_whole = false;
};

Unpacker::Unpacker() : state_(std::make_unique<State>()) {
  constexpr int most_window_log = 27; // 128 MiB
  if (!state_->context)
    throw std::bad_alloc();
  ZSTD_DCtx_setParameter(state_->context.get(), ZSTD_d_windowLogMax, most_window_log);
}

Unpacker::~Unpacker() = default;

std::string_view Unpacker::unpack(std::string_view &packed) {
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  ZSTD_outBuffer out{state_->memory.data(), state_->memory.size(), 0};
  const std::size_t left = ZSTD_decompressStream(state_->context.get(), &out, &in);
  if (ZSTD_isError(left) != 0)
    throw std::runtime_error(std::string("cannot be unpacked: ") + ZSTD_getErrorName(left) +
                             ": give a file that zstd wrote, whole");
  packed.remove_prefix(in.pos);
  state_->is_whole = left == 0;
  return {state_->memory.data(), out.pos};
}

bool Unpacker::is_whole() const {
  return state_->is_whole;
}

} // namespace mdm::checker
