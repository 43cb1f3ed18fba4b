#include "ui/hidden/hidden_status.h"

#include "text/catalogue.h"
#include "ui/parts/view_window.h"

namespace viewing {

const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden) {
    static const std::shared_ptr<const HiddenResult> none;
    return hidden.answer ? hidden.answer->camera : none;
}

std::string progress_text(float fraction) {
    return std::to_string(static_cast<int>(100.0F * fraction)) + " %";
}

void tell_waiting(const HiddenStatus& hidden) {
    if (hidden.fraction)
        offer(say("The method is at work: {percent}.", "percent"_a = progress_text(*hidden.fraction)).c_str());
    else
        offer("The method is at work.");
}

}  // namespace viewing
