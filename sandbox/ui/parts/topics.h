// The topics that the two views below the camera view can show, and the current ones. Pure functions.
#pragma once

#include <imgui.h>

#include <span>

#include "state/params.h"

namespace viewing {

/// The two views below the camera view.
enum class Slot { left, right };

/// Returns the topic of a slot. Resolves `automatic`: on the left to the observer, on the right to the topic of the
/// hidden-surface method.
Topic topic_of(const Params& params, Slot slot);

/// Chooses another topic for a slot. If the other slot already shows it, the two swap.
void choose_topic(Params& params, Slot slot, Topic topic);

/// Returns the slot to show if only one fits: the right one if only the right topic was chosen, or if neither was
/// chosen and the hidden-surface method has its own topic; otherwise the left one.
Slot telling_slot(const Params& params);

/// Whether one of the two slots shows the topic.
bool is_shown(const Params& params, Topic topic);

/// Whether the topic's picture shows a space from outside, so that dragging it turns the observer.
bool is_seen_from_outside(Topic topic);

/// Whether a lower view examines the pinned pixel: a click in the camera view then pins one.
bool examines_pixel(const Params& params);

/// The size in design pixels below which a topic's view is hard to read from the back row.
ImVec2 least_size_on_stage(Topic topic);
/// Returns the height in design pixels to which a crowded stage may shrink the view. Tables and charts keep all their
/// content.
float lowest_on_stage(Topic topic);

/// The topics' names for the list, in the order of Topic; the first one is `automatic`.
std::span<const char* const> topic_names();

}  // namespace viewing
