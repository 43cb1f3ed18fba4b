#include "ui/panel/beside_panel.h"

#include <algorithm>

#include "state/file/beside.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "topics/depth/shown/depth_panel.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"
#include "ui/parts/setting_words.h"

namespace viewing {
namespace {

/// Draws the settings of the second picture that differ, each with a button that removes the difference.
void difference_rows(Params& params) {
    std::vector<std::string>& all = params.view.beside.set.all;
    std::size_t removed = all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (widgets::SmallButton("×")) removed = i;
        widgets::Tooltip("×", tr("Removes this difference from the second picture."));
        ImGui::PopID();
        ImGui::SameLine(0.0F, px(8.0F));
        widgets::Note(setting_in_words(all[i], 6).c_str());
    }
    if (removed < all.size()) all.erase(all.begin() + static_cast<std::ptrdiff_t>(removed));
}

/// Swaps the two pictures.
void swap_pictures(Params& params) {
    Params other = beside_params(params);
    other.view.beside = params.view.beside;
    show_beside(other, params);
    params = std::move(other);
}

}  // namespace

std::optional<Params> other_state(OtherState which, const Session& session, const std::vector<Problem>& problems) {
    std::optional<Params> other;
    if (which == OtherState::before_edit) {
        other = session.before_latest_edit();
    } else if (which == OtherState::preset) {
        if (session.preset()) other = session.preset()->params;
    } else {
        const auto fixable = std::find_if(problems.begin(), problems.end(),
                                          [](const Problem& problem) { return !problem.fixed_by.empty(); });
        const bool may_say = !widgets::IsCovered("sentences") && !widgets::IsCovered("button:fix");
        if (fixable != problems.end() && may_say)
            if (const Result<Params> fixed = apply_settings(session.params, {&fixable->fixed_by, 1})) other = *fixed;
    }
    Params trial = session.params;
    return other && show_beside(trial, *other) ? other : std::nullopt;
}

const char* why_no_other(OtherState which) {
    switch (which) {
        case OtherState::before_edit:
            return tr("There has been no edit yet, or it changed nothing that the second picture can show.");
        case OtherState::preset:
            return tr("No preset is open, or nothing has changed since it was opened.");
        case OtherState::fixed:
            return tr("None of the reported problems has a fix.");
    }
    return "";
}

void beside_section(Session& session, const std::vector<Problem>& problems) {
    if (!widgets::Section("Second picture", false)) return;
    const widgets::Group group("beside");
    Params& params = session.params;
    static constexpr const char* pictures[] = {marked("nothing"), marked("the depth buffer"), marked("another depth"),
                                               marked("other settings")};
    static constexpr const char* layouts[] = {marked("Two halves"), marked("Divider")};
    control(params, "view.beside.shows", {.width = 150.0F, .names = pictures, .label = marked("2nd picture")});
    control(params, "view.beside.layout", {.segments = true, .names = layouts, .label = "##layout"});
    control(params, "view.beside.format",
            {.width = 130.0F, .names = depth_format_names, .label = marked("other format")});
    control(params, "view.beside.mapping",
            {.width = 130.0F, .names = depth_mapping_names, .label = marked("other mapping")});
    if (widgets::IsListing()) return;
    if (params.view.beside.shows == Beside::settings) difference_rows(params);
    struct Choice {
        OtherState state;
        const char *label, *about;
    };
    static constexpr Choice choices[] = {
        {OtherState::before_edit, marked("Before the last edit"),
         marked("Shows the state before the last edit in the second picture.")},
        {OtherState::preset, marked("The preset"), marked("Shows the unchanged preset in the second picture.")},
        {OtherState::fixed, marked("Fixed"), marked("Shows the same state with its first problem fixed.")}};
    for (const Choice& choice : choices) {
        const std::optional<Params> other = other_state(choice.state, session, problems);
        if (choice.state != OtherState::before_edit) behind(widgets::SmallButtonWidth(choice.label));
        if (widgets::SmallButton(choice.label, other.has_value(), why_no_other(choice.state)))
            show_beside(params, *other);
        widgets::Tooltip(choice.label, tr(choice.about));
    }
    if (params.view.beside.shows != Beside::settings) return;
    behind(widgets::SmallButtonWidth("Swap"));
    if (widgets::SmallButton("Swap")) swap_pictures(params);
    widgets::Tooltip("Swap", tr("Swaps the two pictures: the controls then change the other one."));
}

}  // namespace viewing
