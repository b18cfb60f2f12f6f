#include "gradation/ags4_reader.hpp"
#include "gradation/csv_reader.hpp"
#include "gradation/json_reader.hpp"
#include "text/json_member.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace mdm {
namespace {

/// The content from its first character on that is no white space.
std::string_view without_leading_space(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : content.substr(first);
}

/// At most one byte more than a gradation may have.
std::string content_of(const std::string &path) {
  const auto fail = [&path](int error) {
    throw InputError(printable(path) + ": cannot be read: " + std::generic_category().message(error) +
                     ": name one that can be read");
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file)
    fail(errno);
  std::string content;
  std::array<char, 1 << 16> part{};
  while (content.size() <= max_gradation_bytes) {
    const std::size_t n = std::fread(part.data(), 1, part.size(), file.get());
    content.append(part.data(), n);
    if (n < part.size())
      break;
  }
  if (std::ferror(file.get()) != 0)
    fail(errno);
  return content;
}

std::vector<Rational> decimals(const std::vector<std::string> &texts, const std::string &what) {
  std::vector<Rational> numbers;
  for (const std::string &text : texts) {
    try {
      numbers.push_back(parse_decimal(text));
    } catch (const InputError &e) {
      throw InputError(what + " " + std::to_string(numbers.size() + 1) + ": " + e.what());
    }
  }
  return numbers;
}

} // namespace

bool is_ags4(std::string_view content) {
  return without_leading_space(without_byte_order_mark(content)).starts_with("\"GROUP\"");
}

Gradation read_gradation(std::string_view content, const std::string &file,
                         const std::optional<std::string> &specimen, PhiReading phi) {
  const Source source(file);
  source.check_length(content, max_gradation_bytes);
  const std::string_view text = without_byte_order_mark(content);
  if (is_ags4(content)) {
    source.check_line_ends(text);
    return read_ags4(text, source, stem(file), specimen);
  }
  if (specimen)
    source.refuse(1, "--specimen-id is for AGS4 files; this one holds a single gradation");
  source.check_text(text, max_gradation_bytes);
  if (without_leading_space(text).starts_with('{'))
    return read_json(text, source, stem(file));
  return read_csv(text, source, stem(file), phi);
}

Gradation read_gradation_file(const std::string &path, const std::optional<std::string> &specimen,
                              PhiReading phi) {
  return read_gradation(content_of(path), path, specimen, phi);
}

std::vector<UnreadGradation> gradations_in(std::string content, const std::string &file) {
  if (is_ags4(content)) {
    const Source source(file);
    source.check_length(content, max_gradation_bytes);
    const std::string_view text = without_byte_order_mark(content);
    source.check_line_ends(text);
    return ags4_specimens(text, file, stem(file));
  }
  return {{stem(file), [content = std::move(content), file] { return read_gradation(content, file); }}};
}

Gradation gradation_of(const std::vector<std::string> &sizes, const std::vector<std::string> &masses,
                       SizeUnit unit, const std::string &id) {
  return Gradation(decimals(sizes, "size"), decimals(masses, "mass"), unit, id);
}

Gradation read_json_gradation(std::string_view content, const std::string &where,
                              const std::string &fallback_id) {
  const Source source(where, false);
  std::string_view text = without_byte_order_mark(content);
  if (text.ends_with('\r')) // the line's LF was there and was taken
    text.remove_suffix(1);
  source.check_text(text, max_gradation_bytes);
  return read_json(text, source, fallback_id);
}

std::optional<std::string> json_gradation_id(std::string_view content) {
  return json_member(content, "id");
}

} // namespace mdm
