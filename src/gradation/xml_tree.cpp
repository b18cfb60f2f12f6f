#include "gradation/xml_tree.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::ptrdiff_t max_tags = std::ptrdiff_t{1} << 20;

/// The node after `node` in the order of the text, below `top`.
pugi::xml_node next(pugi::xml_node node, pugi::xml_node top, bool skip_children) {
  if (!skip_children && node.first_child())
    return node.first_child();
  for (; node != top; node = node.parent())
    if (node.next_sibling())
      return node.next_sibling();
  return {};
}

} // namespace

XmlTree::XmlTree(std::string text, const Source &source, std::string_view what) : text_(std::move(text)) {
  if (std::count(text_.begin(), text_.end(), '<') > max_tags)
    source.refuse(1, fmt::format("{} has more than {} XML tags: save what is wanted alone", what, max_tags));
  const std::size_t size = text_.size();
  const pugi::xml_parse_result result = document_.load_buffer_inplace(
      text_.data(), size, pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
  if (!result)
    source.refuse(1, fmt::format("{} is no sound XML at byte {}: {}: save or copy the file again", what,
                                 result.offset, result.description()));
  for (const pugi::xml_node node : document_.children())
    if (node.type() == pugi::node_doctype)
      source.refuse(1,
                    fmt::format("{} has a document type (DTD), which is not read: write it without", what));
}

std::string_view local_name(const char *name) {
  const std::string_view all = name;
  const std::size_t colon = all.find(':');
  return colon == std::string_view::npos ? all : all.substr(colon + 1);
}

pugi::xml_node child_of(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_node child : node.children())
    if (local_name(child.name()) == name)
      return child;
  return {};
}

void for_each_below(pugi::xml_node node, std::string_view name,
                    const std::function<void(pugi::xml_node)> &found) {
  for (pugi::xml_node at = node.first_child(); at;) {
    const bool is_it = local_name(at.name()) == name;
    if (is_it)
      found(at);
    at = next(at, node, is_it);
  }
}

std::string text_below(pugi::xml_node node) {
  std::string text;
  for (pugi::xml_node at = node.first_child(); at; at = next(at, node, false))
    if (at.type() == pugi::node_pcdata || at.type() == pugi::node_cdata)
      text += at.value();
  return text;
}

} // namespace mdm
