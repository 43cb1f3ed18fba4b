#include "ui/hidden/hidden_status.h"

#include <cmath>
#include <string>

#include "ui/parts/view_window.h"

namespace viewing {

const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden) {
    static const std::shared_ptr<const HiddenResult> none;
    return hidden.answer ? hidden.answer->camera : none;
}

void tell_waiting(const HiddenStatus& hidden) {
    const std::string percent =
        hidden.fraction ? ": " + std::to_string(static_cast<int>(std::lround(100.0F * *hidden.fraction))) + " %" : "";
    offer(("The method is at work" + percent + ".").c_str());
}

}  // namespace viewing
