#include "host/scene/schema/schema.h"

namespace offing::scene {

Storage moved(Storage storage, std::size_t offset) {
  std::visit(
      [&](auto& at) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(at)>, ChoiceStorage>) {
          at.offset += offset;
        } else {
          at = std::remove_cvref_t<decltype(at)>(at.offset() + offset);
        }
      },
      storage);
  return storage;
}

void SchemaTable::add(const SchemaNode& node, const Section* section, const std::string& prefix) {
  const auto whole = [&](std::string_view name) -> std::string_view {
    return name.empty() ? name : std::string_view(keys_.emplace_back(prefix + std::string(name)));
  };
  for (const auto& entry : node.entries) {
    if (const auto* facts = std::get_if<Parameter>(&entry)) {
      Parameter& row = rows_.emplace_back(*facts);
      row.key = whole(row.key);
      row.alias = whole(row.alias);
      row.instead_of = whole(row.instead_of);
      row.section = section;
      if (section->is_repeated()) row.max_count = section->max_count;
      continue;
    }
    const auto& child = std::get<SchemaNode::Child>(entry);
    const std::string name = prefix + child.node->name;
    const Section& inner = sections_.emplace_back(Section{.name = name,
                                                          .parent = section,
                                                          .offset = child.offset,
                                                          .list = child.list,
                                                          .max_count = child.max_count});
    add(*child.node, &inner, name + '.');
  }
}

}  // namespace offing::scene
