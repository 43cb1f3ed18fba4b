// The results of the hidden-surface methods for the camera view, as the window shows them. Read hidden_state.h next.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frame/problems.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {

/// The results of the hidden-surface methods for the camera view, and the progress of newer ones.
struct HiddenStatus {
    std::shared_ptr<const HiddenAnswer> answer;  ///< the newest answer, perhaps for an earlier camera; null if none
    std::optional<float> fraction;               ///< 0 … 1 while a method computes a newer answer
    bool shows_time = false;                     ///< false in pictures that must be reproducible
};

/// Returns the camera's result, or null if there is none yet.
const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden);

/// Reports a polygon that the painter's algorithm drew over a nearer one; nullopt if the picture is correct.
std::optional<Problem> painter_problem(const HiddenAnswer& answer);

/// Returns the progress of running work, such as "40%"; returns "100%" only once the work is done.
std::string progress_text(float fraction);

/// Shows "Running the method: 40%." in a view that has nothing else to show until the method has finished.
void tell_waiting(const HiddenStatus& hidden);

}  // namespace viewing
