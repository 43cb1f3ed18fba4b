#include "topics/why/shown/why_view.h"

#include <algorithm>
#include <utility>

#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "topics/depth/shown/pixel_parts.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

/// Lessons' name for the fault and its fix, which an exercise may ask for.
constexpr const char* fault_target = "text:why.fault";

ImU32 color_of_kind(WhyRow::Kind kind) {
    switch (kind) {
        case WhyRow::Kind::mirror:
            return palette().mirror;
        case WhyRow::Kind::light:
            return palette().light;
        case WhyRow::Kind::fight:
        case WhyRow::Kind::fault:
            return palette().trouble;
        case WhyRow::Kind::ray:
            return palette().camera;
        default:
            return palette().accent;
    }
}

/// How the rows are laid out: their type, their columns, and the space after each, which a crowded stage makes
/// negative.
struct RowPlace {
    ImFont* font;
    float title_width, swatch_side, width, below = 0.0F;

    float text_left() const { return title_width + px(10.0F); }
    float text_width() const { return std::max(width - text_left() - swatch_side - px(8.0F), px(60.0F)); }
};

/// The texts of a row, broken into lines.
struct RowTexts {
    std::string title, sentence;
    float height;

    RowTexts(const WhyRow& row, const RowPlace& place) {
        ImGui::PushFont(place.font);
        title = widgets::BrokenAtBlanks(say(row.title), place.title_width);
        sentence = widgets::BrokenAtBlanks(say(listed(row.sentences, "\n")), place.text_width());
        height = std::max(ImGui::CalcTextSize(title.c_str()).y, ImGui::CalcTextSize(sentence.c_str()).y);
        ImGui::PopFont();
    }
};

/// Returns the indices of the rows to draw. Without a Fix button, as on stage, the row of the first fault would only
/// repeat the sentence at the top.
std::vector<std::size_t> shown_rows(const Why& why) {
    bool repeats = widgets::HasPlainTitles() && !widgets::OffersButton("Fix");
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < why.rows.size(); ++i) {
        const bool is_fault = why.rows[i].kind == WhyRow::Kind::fault;
        if (is_fault && (std::exchange(repeats, false) || widgets::IsCovered(fault_target))) continue;
        shown.push_back(i);
    }
    return shown;
}

RowPlace place_in(ImFont* font, const std::vector<WhyRow>& rows, const std::vector<std::size_t>& shown, float width) {
    float titles = 0.0F;
    for (const std::size_t i : shown)
        titles = std::max(titles, font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, say(rows[i].title).c_str()).x);
    return {font, std::min(titles, (widgets::HasPlainTitles() ? 0.26F : 0.3F) * width), font->FontSize,
            width - px(6.0F)};
}

/// On stage, the rows are in the type of sentences if they fit, and spread over the height.
RowPlace place_of(const std::vector<WhyRow>& rows, const std::vector<std::size_t>& shown, ImVec2 room) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    const RowPlace usual = place_in(fonts.text, rows, shown, room.x);
    if (!widgets::HasPlainTitles() || shown.empty()) return usual;
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const auto spare = [&](const RowPlace& place) {
        float height = spacing + px(2.0F);
        for (const std::size_t i : shown) height += RowTexts(rows[i], place).height + spacing;
        return room.y - height;
    };
    RowPlace place = place_in(fonts.caption, rows, shown, room.x);
    float rest = spare(place);
    if (rest < 0.0F) {
        place = usual;
        rest = spare(place);
    }
    const float share = std::floor(rest / static_cast<float>(shown.size()));
    place.below = std::clamp(share, px(2.0F) - spacing, 1.5F * place.font->FontSize);
    return place;
}

/// Draws those buttons that the window offers: they change what the camera's picture shows, or copy the explanation.
void draw_buttons(WhyState& state, Session& session, const Why& why) {
    Params& params = session.params;
    bool is_first = true;
    const auto button = [&](const char* label, const char* tip) {
        if (!widgets::OffersButton(label)) return false;
        if (!std::exchange(is_first, false)) ImGui::SameLine(0.0F, px(8.0F));
        const bool clicked = widgets::SmallButton(label);
        widgets::Tooltip(label, tip);
        return clicked;
    };
    const auto toggle = [&](const char* off, const char* on, bool is_part, bool& value, bool& hides, const char* tip) {
        if (!(value ? is_part : hides) || !button(value ? off : on, tip)) return;
        hides = value;
        value = !value;
    };
    toggle(marked("Without the shadow"), marked("With the shadow"), why.has_shadow, params.shadow.enabled,
           state.hides_shadow, marked("Draws the picture with or without its shadows."));
    toggle(marked("Without the mirror"), marked("With the mirror"), why.has_mirror, params.reflection.enabled,
           state.hides_mirror, marked("Draws the picture with or without its mirror images."));
    if (params.view.pass >= 0 && button(marked("Whole frame"), marked("Draws all passes again.")))
        params.view.pass = -1;
    if (button(marked("Copy as text"), marked("Copies the explanation to the clipboard.")))
        ImGui::SetClipboardText(say(why_as_text(why)).c_str());
}

/// Draws one row: its title, its sentence, and the pixel's color after it. Returns whether the pointer is over the row.
bool draw_row(Session& session, const WhyRow& row, const RowPlace& place, int number) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const RowTexts texts(row, place);
    const bool has_fix = !row.fix.empty() && widgets::OffersButton("Fix");
    ImGui::PushID(number);
    const bool stops =
        row.pass >= 0 && is_drawn_by_gl_alone(session.params.visibility.method) && widgets::Offers("control:view.pass");
    const bool is_pressed = ImGui::InvisibleButton("row", {place.width, texts.height});
    const bool over = ImGui::IsItemHovered();
    widgets::Record(("why: " + say(row.title)).c_str());
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (over)
        draw->AddRectFilled({at.x - px(4.0F), at.y - px(2.0F)}, {at.x + place.width, at.y + texts.height + px(2.0F)},
                            palette().field, px(3.0F));
    if (stops) {
        int& pass = session.params.view.pass;
        if (is_pressed) pass = pass == row.pass ? -1 : row.pass;
        widgets::Tooltip(say(row.title).c_str(), pass == row.pass ? marked("Click to draw the whole frame.")
                                                                  : marked("Click to stop the frame after this pass."));
    }
    const ImU32 ink = row.is_quiet ? palette().quiet : palette().text;
    const float left = at.x + place.text_left(), size = place.font->FontSize;
    draw->AddText(place.font, size, at, row.is_quiet ? palette().quiet : color_of_kind(row.kind), texts.title.c_str());
    draw->AddText(place.font, size, {left, at.y}, ink, texts.sentence.c_str());
    if (row.after) {
        const ImVec2 min(at.x + place.width - place.swatch_side, at.y + px(1.0F)),
            max(min.x + place.swatch_side, min.y + place.swatch_side);
        draw->AddRectFilled(min, max, IM_COL32(row.after->r, row.after->g, row.after->b, 255), px(3.0F));
        draw->AddRect(min, max, palette().border, px(3.0F));
    }
    if (has_fix) {
        ImGui::SetCursorScreenPos({left, ImGui::GetCursorScreenPos().y});
        if (widgets::SmallButton("Fix"))
            if (const Result<Params> fixed = apply_settings(session.params, std::vector<std::string>{row.fix}))
                session.params = *fixed;
        widgets::Tooltip("Fix it", say("Sets {setting}. Ctrl+Z undoes the fix.", "setting"_a = row.fix).c_str());
    }
    if (place.below != 0.0F) ImGui::SetCursorPosY(ImGui::GetCursorPosY() + place.below);
    ImGui::PopID();
    return over;
}

/// Draws the pixel, its color, and the sentence.
void draw_head(Session& session, const Why& why) {
    const Color& color = why.read_back ? *why.read_back : why.predicted ? *why.predicted : why.chain.color;
    draw_pixel_headline(session.params.view, why.chain.pixel, color, "");
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(widgets::BrokenAtBlanks(say(why.sentence), width).c_str());
    if (!why.fault.empty() && !widgets::IsCovered(fault_target)) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette().trouble);
        ImGui::TextUnformatted(widgets::BrokenAtBlanks(say(why.fault), width).c_str());
        ImGui::PopStyleColor();
        widgets::MarkTarget(fault_target);
    }
    widgets::Record(say(why.sentence).c_str());
    ImGui::PopFont();
}

}  // namespace

void draw_why_view(WhyState& state, Session& session, const PinnedPixel& pinned, const Rect& rect) {
    const ViewWindow view("why view", rect);
    const widgets::Group group("why");
    state.hovered_row.reset();
    if (!state.told) {
        if (pinned.why_none.empty())
            offer("Point at the camera view to see why a pixel has its color; click to pin the pixel.");
        else if (offer(say(pinned.why_none).c_str(), "Release"))
            release_pixel(session.params.view);
        return;
    }
    const Why& why = *state.told;
    draw_head(session, why);
    ImGui::Dummy({0.0F, px(2.0F)});
    ImGui::BeginChild("rows", ImGui::GetContentRegionAvail());
    const std::vector<std::size_t> shown = shown_rows(why);
    const RowPlace place = place_of(why.rows, shown, ImGui::GetContentRegionAvail());
    for (const std::size_t i : shown)
        if (draw_row(session, why.rows[i], place, static_cast<int>(i))) state.hovered_row = i;
    ImGui::Dummy({0.0F, px(2.0F)});
    draw_buttons(state, session, why);
    widgets::CountScrolled();
    ImGui::EndChild();
}

void draw_why_overlay(const WhyState& state, Overlay& overlay) {
    if (!state.told || widgets::IsCovered("view:why")) return;
    for (const WhyLine& line : state.told->lines) {
        if (state.hovered_row && line.row != *state.hovered_row) continue;
        switch (line.kind) {
            case WhyLine::Kind::sight:
                overlay.line(line.from_world, line.to_world, palette().camera, 2.0F);
                break;
            case WhyLine::Kind::light:
                overlay.line(line.from_world, line.to_world, palette().light, 2.0F);
                break;
            case WhyLine::Kind::cut_light:
                overlay.dot(line.from_world, palette().light, 5.0F);
                overlay.dashed(line.from_world, line.to_world, palette().light, 2.0F);
                if (!line.label.empty()) overlay.label(line.from_world, say(line.label).c_str(), palette().light);
                continue;
            case WhyLine::Kind::image:
                overlay.dashed(line.from_world, line.to_world, palette().mirror, 2.0F);
                overlay.dot(line.to_world, palette().mirror, 5.0F);
                break;
        }
        if (!line.label.empty()) overlay.label(line.to_world, say(line.label).c_str(), palette().mirror);
    }
}

}  // namespace viewing
