// What the hidden-surface methods have found for the camera's view, as the window shows it. Read hidden_state.h next.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frame/hidden/hidden_views.h"
#include "frame/problems.h"

namespace viewing {

/// What hidden-surface methods have found for the camera view, and whether they are still at it.
struct HiddenStatus {
    std::shared_ptr<const HiddenAnswer> answer;  ///< the newest, maybe of an earlier camera; null: none
    std::optional<float> fraction;               ///< 0 … 1 while a method works on a newer one
    bool shows_time = false;                     ///< false in pictures that have to repeat
};

/// The camera's result, null while there is none.
const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden);

/// Which polygon the painter has drawn over a nearer one; none where it is right.
std::optional<Problem> painter_problem(const HiddenAnswer& answer);

/// How far something is that is worked on: "40 %", and "100 %" only when it is done.
std::string progress_text(float fraction);

/// "The method is at work: 40 %.": instead of a view whose method has not finished.
void tell_waiting(const HiddenStatus& hidden);

}  // namespace viewing
