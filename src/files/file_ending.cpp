#include "files/file_ending.hpp"

#include "files/zstd_stream.hpp"
#include "text/file_names.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

/// The endings of documents, pictures, workbooks and archives, which hold no text as it is.
const std::vector<std::string> other_endings = {"htm", "html", "xhtml", "md",  "pdf", "ps",   "eps",  "svg",
                                                "png", "jpg",  "jpeg",  "gif", "tif", "tiff", "webp", "bmp",
                                                "xls", "xlsx", "xlsm",  "ods", "doc", "docx", "odt",  "rtf",
                                                "tex", "gz",   "xz",    "bz2", "zip", "7z"};

bool has(const std::vector<std::string> &all, const std::string &one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

/// `.a`, `.a or .b`, `.a, .b or .c`.
std::string listed(const std::vector<std::string> &endings) {
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i)
    text += (i == 0 ? "." : i + 1 < endings.size() ? ", ." : " or .") + endings[i];
  return text;
}

} // namespace

const std::vector<std::string> text_endings = {"txt", "json", "jsonl", "ndjson", "csv",
                                               "tsv", "xml",  "yaml",  "yml"};

std::string ending_of(const std::string &path) {
  std::string name = path.substr(name_begin(path));
  if (names_zstd(name))
    name.resize(name.rfind('.'));
  const std::size_t dot = name.rfind('.');
  std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

void check_ending(const std::string &path, const std::vector<std::string> &own, const std::string &command,
                  const std::string &remedy) {
  const std::string ending = ending_of(path);
  if (!has(own, ending) && (has(text_endings, ending) || has(other_endings, ending)))
    throw InputError(fmt::format("{}: mdm {} writes no .{}: let OUT end in {}{}", printable(path), command,
                                 ending, listed(own), remedy));
}

} // namespace mdm
