#include "ui/views/beside_view.h"

#include <algorithm>

#include "state/file/beside.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "topics/depth/shown/depth_views.h"
#include "ui/parts/look.h"
#include "ui/parts/setting_words.h"
#include "ui/parts/view_parts.h"
#include "ui/views/views.h"
#include "widgets/depth.h"

namespace viewing {
namespace {

constexpr int few_digits = 4;

/// Joins the first `most` settings, in words; the rest are only counted.
std::string joined_words(const std::vector<std::string>& settings, int digits, std::size_t most) {
    std::string words;
    for (std::size_t i = 0; i < std::min(settings.size(), most); ++i)
        words += (words.empty() ? "" : ", ") + setting_in_words(settings[i], digits);
    if (settings.size() > most) words += " " + say("and {count} more", "count"_a = settings.size() - most);
    return words;
}

}  // namespace

BesideTitles beside_titles(const Params& params, std::size_t most) {
    const BesideParams& beside = params.view.beside;
    if (beside.shows == Beside::depth) return {tr("color"), tr("depth")};
    if (beside.shows == Beside::other_depth)
        return {depth_title(params.depth.format, params.depth.mapping), depth_title(beside.format, beside.mapping)};
    const Params other = beside_params(params);
    const std::vector<std::string> there = settings_to(params, other), here = settings_to(other, params);
    const BesideTitles rounded{joined_words(here, few_digits, most), joined_words(there, few_digits, most)};
    if (rounded.camera != rounded.beside) return rounded;
    return {joined_words(here, all_digits, most), joined_words(there, all_digits, most)};
}

void draw_beside_title(const Rect& rect, float width, const Params& params, std::string BesideTitles::*side) {
    const widgets::Context& context = widgets::CurrentContext();
    ImGui::PushFont(widgets::HasPlainTitles() ? context.fonts.caption : context.fonts.heading);
    const std::string whole = beside_titles(params).*side;
    const bool fits = ImGui::CalcTextSize(whole.c_str()).x <= width;
    const std::string shown = fits ? whole : widgets::Shortened(beside_titles(params, 1).*side, width);
    ImGui::PopFont();
    view_header(rect, shown.c_str());
    if (!fits) widgets::Tooltip("", whole.c_str());
}

void draw_beside_legend(const Session& session, const Derived& derived, const Rect& rect) {
    if (session.params.view.beside.shows == Beside::depth) depth_picture_legend(session, derived, rect);
}

void draw_beside_picture(Session& session, const Rect& rect, ImTextureID picture) {
    const Beside shows = session.params.view.beside.shows;
    if (shows == Beside::depth)
        view_header(rect, marked("Depth buffer"));
    else
        draw_beside_title(rect, rect.width(), session.params, &BesideTitles::beside);
    if (shows == Beside::depth) depth_choices(session.params, rect.max.x);
    if (shows == Beside::other_depth) header_note(tr("the same picture with another depth buffer"), rect.max.x);
    picture_item("beside view", rect, picture);
}

void draw_beside_divider(Session& session, const Derived& derived, const Rect& rect, ImTextureID picture,
                         bool has_sentences) {
    auto share = static_cast<float>(session.params.view.beside.share);
    const float middle = rect.min.x + share * rect.width();
    if (picture)
        ImGui::GetWindowDrawList()->AddImage(picture, {middle, rect.min.y}, rect.max, {share, 1.0F}, {1.0F, 0.0F});
    draw_beside_legend(session, derived, {{std::min(middle, rect.max.x - px(260.0F)), rect.min.y}, rect.max});
    const BesideTitles both = beside_titles(session.params);
    if (widgets::Divider("divider", rect.min, rect.max, share,
                         {.left = both.camera.c_str(), .right = both.beside.c_str(), .names_at_bottom = has_sentences}))
        session.params.view.beside.share = share;
}

void draw_beside_view(ViewState& state, Session& session, const Derived& derived, const Layout& layout,
                      const Pictures& pictures, const FrameInput& input, MotionInput& motion) {
    if (layout.beside.empty()) return;
    const widgets::Group group("beside");
    const Rect& rect = layout.beside;
    widgets::MarkTarget("view:camera", rect.min, rect.max);
    if (widgets::IsCovered("view:camera")) {
        ImGui::SetCursorScreenPos(rect.min);
        return widgets::Plate("beside view", {rect.width(), rect.height()});
    }
    draw_beside_picture(session, rect, pictures.beside);
    Overlay overlay(ImGui::GetWindowDrawList(), rect, derived.clip_from_world);
    if (ImGui::IsItemHovered()) {
        state.hovered = ViewName::camera;
        state.hovered_pixel =
            camera_pixel_at(rect, ImGui::GetIO().MousePos, state.camera_px, session.params.projection);
        if (state.hovered_pixel) state.told_pixel = state.hovered_pixel;
    }
    camera_mouse(state, session, derived, overlay, Handle::none, pictures.hidden, input, motion);
    if (state.pinned.pixel) draw_pin(overlay, *state.pinned.pixel);
    const float free = state.plate.empty() ? rect.max.x : std::min(state.plate.min.x, rect.max.x);
    draw_beside_legend(session, derived, {rect.min, {free, rect.max.y}});
}

}  // namespace viewing
