// What the two views below the camera's can show, and which of it they do. Pure.
#pragma once

#include <span>

#include "state/params.h"

namespace viewing {

/// The two views below the camera's.
enum class Slot { left, right };

/// What a slot shows: never `automatic`, which is the observer on the left and what belongs to the hidden-surface
/// method on the right.
Topic topic_of(const Params& params, Slot slot);

/// Another topic for a slot. What the other slot shows already comes over from there: they swap.
void choose_topic(Params& params, Slot slot, Topic topic);

/// Which slot has what this state is about, where there is room for one of them only: the one whose topic was chosen.
Slot telling_slot(const Params& params);

/// Whether one of the two slots shows it.
bool is_shown(const Params& params, Topic topic);

/// As they stand in the list, in the order of Topic; the first one is `automatic`.
std::span<const char* const> topic_names();

}  // namespace viewing
