#include "files/file_totals.hpp"

#include "files/line_hash.hpp"
#include "files/paths.hpp"

#include <fmt/core.h>

namespace mdm {

void check_bytes(const PartFile &file) {
  check_readable(file.path);
  if (const std::optional<std::uint64_t> bytes = file_bytes(file.path); bytes != file.totals.bytes)
    throw file_error(file.path, fmt::format("{} bytes, where its totals have {}: solve the shard again",
                                            bytes.value_or(0), file.totals.bytes));
}

std::optional<FileTotals> file_totals(const std::string &path) {
  if (!file_bytes(path))
    return std::nullopt;
  ByteSource source(path);
  source.keep_digest();
  for (std::string text; source.read_some(text); text.clear())
    ;
  return FileTotals{source.digest().bytes(), source.digest().sha256()};
}

SuiteTotals suite_totals(const std::string &path) {
  FileLines lines(path);
  lines.bytes().keep_digest();
  LineHash hash;
  LineSum sum;
  std::uint64_t number = 0;
  for (std::vector<FileLines::Line> some = lines.next(512); !some.empty(); some = lines.next(512))
    for (const FileLines::Line &line : some)
      if (!FileLines::is_blank(line))
        sum.add(hash.of(++number, line));
  return {{lines.bytes().digest().bytes(), lines.bytes().digest().sha256()}, sum};
}

} // namespace mdm
