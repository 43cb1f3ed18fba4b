// The topics that the two views below the camera view can show, and the current ones. Pure functions.
#pragma once

#include "state/params.h"

namespace viewing {

/// The two views below the camera view.
enum class Slot { left, right };

constexpr Slot other_than(Slot slot) {
    return slot == Slot::left ? Slot::right : Slot::left;
}

/// Returns the topic of a slot. Resolves `automatic`: on the left to the observer, on the right to the topic of the
/// hidden-surface method.
Topic topic_of(const Params& params, Slot slot);

/// Chooses another topic for a slot. If the other slot already shows it, the two swap.
void choose_topic(Params& params, Slot slot, Topic topic);

/// Returns the slot to show if only one fits. This is the left slot, unless the left topic is `automatic` and the right
/// topic either was chosen or is the hidden-surface method's own.
Slot telling_slot(const Params& params);

/// Whether the state names the topics of both slots.
bool names_both_topics(const Params& params);

/// Whether one of the two slots shows the topic.
bool is_shown(const Params& params, Topic topic);

}  // namespace viewing
