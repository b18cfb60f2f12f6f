#pragma once
/// \file
/// XML that strangers wrote, as a tree.

#include "text/source.hpp"

#include <pugixml.hpp>

#include <functional>
#include <string>

namespace mdm {

/// The tree of an XML text, whose characters it takes over. Entities but the five of XML are left as they
/// are, and nothing outside the text is read.
class XmlTree {
public:
  /// \throws InputError if it is not well-formed, has a document type, in which entities would be, or more than 2^20
  /// tags, which bounds the memory
  XmlTree(std::string text, const Source &source, std::string_view what);

  pugi::xml_node root() const { return document_.document_element(); }

private:
  std::string text_;
  pugi::xml_document document_;
};

/// A name without the prefix of its namespace.
std::string_view local_name(const char *name);

/// The first child of that local name, or none.
pugi::xml_node child_of(pugi::xml_node node, std::string_view name);

/// Calls found(node) for all nodes below `node` of that local name, in the order of the text; not below
/// those.
void for_each_below(pugi::xml_node node, std::string_view name,
                    const std::function<void(pugi::xml_node)> &found);

/// The text of a node with all that is below it.
std::string text_below(pugi::xml_node node);

} // namespace mdm
