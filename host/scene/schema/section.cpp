#include "host/scene/schema/section.h"

namespace offing::scene {

namespace {

/// The struct of a section, or the list of them.
const void* place_in(const void* root, const Section& section, ElementIndex element) {
  const void* parent = section.parent ? struct_at(root, *section.parent, element) : root;
  return static_cast<const std::byte*>(parent) + section.offset;
}

void* place_in(void* root, const Section& section, ElementIndex element) {
  return const_cast<void*>(place_in(static_cast<const void*>(root), section, element));
}

}  // namespace

const Section* Section::repeated_parent() const {
  const Section* above = parent;
  while (above && !above->is_repeated()) above = above->parent;
  return above;
}

const void* struct_at(const void* root, const Section& section, ElementIndex element) {
  const void* place = place_in(root, section, element);
  if (!section.is_repeated()) return place;
  return section.list->at(place, section.repeated_parent() ? element.inner : element.outer);
}

void* struct_at(void* root, const Section& section, ElementIndex element) {
  return const_cast<void*>(struct_at(static_cast<const void*>(root), section, element));
}

std::size_t count_of(const void* root, const Section& section, ElementIndex parent) {
  return section.is_repeated() ? section.list->count(place_in(root, section, parent)) : 1;
}

void append_to(void* root, const Section& section, ElementIndex parent) {
  section.list->append(place_in(root, section, parent));
}

void remove_from(void* root, const Section& section, ElementIndex element) {
  section.list->remove(place_in(root, section, element),
                       section.repeated_parent() ? element.inner : element.outer);
}

std::vector<ElementIndex> elements_in(const void* root, const Section& section) {
  const Section* above = section.repeated_parent();
  const std::vector<ElementIndex> parents =
      above ? elements_in(root, *above) : std::vector<ElementIndex>{ElementIndex{}};
  if (!section.is_repeated()) return parents;
  std::vector<ElementIndex> elements;
  for (const ElementIndex parent : parents) {
    const std::size_t count = count_of(root, section, parent);
    for (std::size_t i = 0; i < count; ++i) {
      elements.push_back(above ? ElementIndex{parent.outer, i} : ElementIndex{i, 0});
    }
  }
  return elements;
}

}  // namespace offing::scene
