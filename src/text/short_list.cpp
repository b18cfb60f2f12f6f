#include "text/short_list.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

void ShortList::add(std::string_view item) {
  if (first_.size() < kept)
    first_.push_back(in_quotes(item));
  ++total_;
}

std::string ShortList::text() const {
  std::string text;
  for (const std::string &item : first_)
    text += (text.empty() ? "" : ", ") + item;
  if (total_ > first_.size())
    text += fmt::format(" and {} more", total_ - first_.size());
  return text;
}

} // namespace mdm
