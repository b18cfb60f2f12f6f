#include "gradation/archive.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>
#include <zip.h>

#include <array>

namespace mdm {

Archive::Archive(std::string_view bytes, const Source &source) : source_(source), zip_(nullptr, zip_discard) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t *const from = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (from != nullptr) {
    zip_.reset(zip_open_from_source(from, ZIP_RDONLY, &error));
    if (!zip_)
      zip_source_free(from);
  }
  const std::string words = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (!zip_)
    source_.refuse(1,
                   "the workbook is no sound zip archive (" + printable(words) + "): save or copy it again");
}

std::optional<std::string> Archive::read(const std::string &name) {
  if (zip_name_locate(zip_.get(), name.c_str(), ZIP_FL_ENC_GUESS) < 0)
    return std::nullopt;
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t *)> file(zip_fopen(zip_.get(), name.c_str(), 0),
                                                                zip_fclose);
  const auto fail = [&](const char *words) {
    source_.refuse(1,
                   fmt::format("{} in the workbook cannot be unpacked ({}): save it again without a password",
                               in_quotes(name), printable(words)));
  };
  if (!file)
    fail(zip_strerror(zip_.get()));
  std::string content;
  std::array<char, 1 << 16> part{};
  for (;;) {
    const zip_int64_t n = zip_fread(file.get(), part.data(), part.size());
    if (n < 0)
      fail(zip_file_strerror(file.get()));
    if (n == 0)
      return content;
    const auto size = static_cast<std::size_t>(n);
    if (size > left_)
      source_.refuse(1, fmt::format("the workbook unpacks to more than {} MiB: save the one sheet as CSV",
                                    max_unpacked_bytes >> 20));
    left_ -= size;
    content.append(part.data(), size);
  }
}

} // namespace mdm
