#include "gradation/number_gradation.hpp"

#include "gradation/csv_reader.hpp"
#include "gradation/table.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

bool is_number_gradation(std::string_view content) {
  return is_number_csv(without_byte_order_mark(content));
}

Gradation read_number_gradation(std::string_view content, const std::string &file) {
  const Source source(file);
  const std::string_view text = without_byte_order_mark(content);
  source.check_length(content, max_gradation_bytes);
  source.check_text(text, max_gradation_bytes);
  return to_gradation(read_number_csv(text, source, stem(file)), source);
}

} // namespace mdm
