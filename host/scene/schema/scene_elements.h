#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The element that a section has last, or would have first.
ElementIndex last_element(const Scene& scene, const Section& section);
/// All elements of a section; of one that is not repeated the only one.
std::vector<ElementIndex> elements_of(const Scene& scene, const Section& section);

/// The last element of a row's section, which gets its first one if it has none.
ElementIndex last_element_or_first(Scene& scene, const Parameter& parameter, const Place& place);

/// Begins a new element of default values in the repeated section of this row, in the last element of its
/// parent; does nothing for others. Throws Error(bad_input) where the section has its most elements;
/// `place.subject` names the section.
void append_element(Scene& scene, const Parameter& parameter, const Place& place);

/// Takes an element away, with its keyframes and places; those behind it count one less.
void remove_element(Scene& scene, const Section& section, ElementIndex element);

/// The numbers that a value is made of: one, three, or none where it has no value or is no number.
std::vector<double*> numbers_of(Scene& scene, const Parameter& parameter, ElementIndex element);

/// Gives a row its default, as if nobody had set it.
void clear_value(Scene& scene, const Parameter& parameter, ElementIndex element = {});

/// The struct of a section, or of one of its elements, in a scene that says nothing.
const void* default_struct(const Section& section);

/// Whether two scenes have other values or keyframes in a row that affects any of these.
bool differ_in(Affects what, const Scene& before, const Scene& after);

/// Makes the elements, values and keyframes of all rows that affect any of these those of another scene, and
/// which sections are given. Costs what the two differ in, where a copy of a scene costs all of it; where
/// values were written stays as it was.
void take_values(Affects what, const Scene& from, Scene& to);

/// Takes an edit, from `before` to `after`, out of a scene that other edits came to later: elements that it
/// added go, and values and keyframes are those of before unless they were edited again. What it deleted
/// stays deleted.
void take_out_edit(const Scene& before, const Scene& after, Scene& scene);

}  // namespace offing::scene
