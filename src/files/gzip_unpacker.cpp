#include "files/unpacker.hpp"

#include <mdm/text/error.hpp>

// The bytes that are unpacked stay as they are.
#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <new>

namespace mdm {
namespace {

/// A file of gzip: members, one after the other, which unpack to the parts of the text.
class GzipUnpacker : public Unpacker {
public:
  GzipUnpacker() {
    constexpr int gzip_alone = 16;
    check_gzip(inflateInit2(&state_, MAX_WBITS + gzip_alone));
  }
  ~GzipUnpacker() override { inflateEnd(&state_); }
  GzipUnpacker(const GzipUnpacker &) = delete;
  GzipUnpacker &operator=(const GzipUnpacker &) = delete;

  void unpack(std::string_view &packed, std::string &text) override {
    constexpr std::size_t at_once = std::size_t{1} << 17;
    if (is_whole_ && packed.empty())
      return;
    if (is_whole_)
      check_gzip(inflateReset(&state_));
    const std::size_t before = text.size(), given = std::min(packed.size(), at_once);
    text.resize(before + at_once);
    state_.next_in = reinterpret_cast<const Bytef *>(packed.data());
    state_.avail_in = static_cast<uInt>(given);
    state_.next_out = reinterpret_cast<Bytef *>(text.data()) + before;
    state_.avail_out = static_cast<uInt>(at_once);
    const int result = inflate(&state_, Z_NO_FLUSH);
    text.resize(before + at_once - state_.avail_out);
    check_gzip(result);
    packed.remove_prefix(given - state_.avail_in);
    is_whole_ = result == Z_STREAM_END;
  }

  bool is_whole() const override { return is_whole_; }

private:
  void check_gzip(int result) const {
    if (result == Z_MEM_ERROR)
      throw std::bad_alloc();
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
      throw InputError(std::string("cannot be unpacked: ") +
                       (state_.msg != nullptr ? state_.msg : "damaged") +
                       ": give a file that gzip wrote, whole");
  }

  z_stream state_{};
  bool is_whole_ = false;
};

} // namespace

std::unique_ptr<Unpacker> gzip_unpacker() {
  return std::make_unique<GzipUnpacker>();
}

} // namespace mdm
