#include "ui/window/workbench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/catalogue.h"
#include "text/words.h"
#include "topics/matrices/shown/followed_point.h"
#include "ui/lesson/strip.h"
#include "ui/panel/panel.h"
#include "ui/parts/look.h"
#include "ui/views/lower_view.h"
#include "ui/window/window_layout.h"

namespace viewing {
namespace {

/// Converts held keys to motion along the camera's own axes.
MotionInput motion_of(const FrameInput& input) {
    const auto axis = [&](Key plus, Key minus) {
        return (input.is_down(plus) ? 1.0 : 0.0) - (input.is_down(minus) ? 1.0 : 0.0);
    };
    MotionInput motion;
    motion.move = {axis(Key::d, Key::a), axis(Key::r, Key::f), axis(Key::w, Key::s)};
    motion.yaw = axis(Key::left, Key::right);
    motion.pitch = axis(Key::up, Key::down);
    motion.roll = axis(Key::q, Key::e);
    motion.slow = input.is_down(Key::shift);
    return motion;
}

/// When presenting, returns the switches to offer: `kinds`, the controls that the state's layout lists, and the step's
/// highlighted parts. Otherwise returns nullopt, for all switches.
std::optional<std::vector<std::string>> offered(const Workbench& window, const Params& params,
                                                std::vector<std::string> kinds) {
    if (!window.presenter.is_on()) return std::nullopt;
    for (const std::string& path : params.view.layout.controls) kinds.push_back("control:" + path);
    kinds.insert(kinds.end(), window.stage.highlight.begin(), window.stage.highlight.end());
    return kinds;
}

void draw_splitters(Arrangement& arrangement, const Layout& layout, const Rect& between) {
    const Rect& lower = layout.lower_left.empty() ? layout.lower_right : layout.lower_left;
    ImGui::SetCursorScreenPos({lower.min.x, std::max(layout.camera.max.y, layout.caption.max.y)});
    const float length = std::max(layout.lower_right.max.x, lower.max.x) - lower.min.x;
    widgets::Splitter("lower height", false, arrangement.lower_height, 80.0F, 600.0F, length, -1.0F);
    if (!layout.panel.empty()) {
        ImGui::SetCursorScreenPos({between.min.x + px(2.0F), between.min.y});
        widgets::Splitter("panel width", true, arrangement.panel_width, 298.0F, 420.0F, between.height());
    }
    if (!layout.matrices.empty()) {
        ImGui::SetCursorScreenPos({between.max.x - px(8.0F), between.min.y});
        widgets::Splitter("matrices width", true, arrangement.matrices_width, 360.0F, 560.0F, between.height(), -1.0F);
    }
    if (!layout.lower_fit) return;
    // The arrangement stores this split as a fraction, so that it fits windows of any width.
    const float whole = (layout.lower_right.max.x - layout.lower_left.min.x) / widgets::CurrentContext().scale;
    float left = arrangement.lower_split * whole;
    ImGui::SetCursorScreenPos({layout.lower_left.max.x + px(2.0F), layout.lower_left.min.y});
    if (widgets::Splitter("lower split", true, left, 0.25F * whole, 0.75F * whole, layout.lower_left.height()))
        arrangement.lower_split = left / whole;
}

void draw_loading(Session& session, const Layout& layout) {
    const std::optional<float> fraction = session.loading_fraction();
    if (!fraction) return;
    const ImVec2 size(px(360.0F), px(96.0F));
    const Rect& over = layout.camera.empty() ? layout.status_bar : layout.camera;
    ImGui::SetNextWindowPos({(over.min.x + over.max.x - size.x) * 0.5F, (over.min.y + over.max.y - size.y) * 0.5F});
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextUnformatted(say("Loading {name}", "name"_a = printable(session.loading_name())).c_str());
    ImGui::ProgressBar(*fraction, {-1.0F, 0.0F});
    if (widgets::Button("Cancel")) session.cancel_loading();
    ImGui::End();
}

void draw_message(Session& session, const Layout& layout) {
    if (!session.message.is_error) return;
    // Without a status bar (for example when presenting), place the message above the strip or the window's edge.
    const ImVec2 window_px = ImGui::GetIO().DisplaySize;
    const float bottom = !layout.status_bar.empty() ? layout.status_bar.min.y
                         : !layout.strip.empty()    ? layout.strip.min.y
                                                    : window_px.y;
    const float width = std::min(px(560.0F), window_px.x - px(20.0F));
    ImGui::SetNextWindowPos({window_px.x * 0.5F, bottom - px(8.0F)}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowSize({width, 0.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().raised);
    ImGui::Begin("message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    widgets::Trouble(printable(session.message.text).c_str());
    if (widgets::SmallButton("Dismiss")) session.message = {};
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace

Arrangement Workbench::arranged(const Session& session) const {
    const BesideParams& beside = session.params.view.beside;
    Arrangement now = arrangement;
    now.halves = beside.shows != Beside::nothing && beside.layout == BesideLayout::halves;
    now.in_lesson = guide.is_shown();
    now.prefers_lower_right = lower_shown(views, session.params) == Slot::right;
    constexpr float least_derivation = 420.0F;  // fits a derivation's figure with the lines beside it
    if (is_any_shown(session.params, &LowerView::has_derivation)) {
        now.least_lower = least_derivation;
        now.least_area = 100'000.0F;
        // A derivation's lines need more height, unless the user has chosen a height.
        constexpr float lines = 330.0F;
        now.least_camera = 0.5F;
        if (now.lower_height == Arrangement{}.lower_height) now.lower_height = lines;
    }
    if (!arrangement.bare) arrange(now, session.params, listed_matrices(session));
    if (place() == Place::stage) open_lower_views(now, session.params, lower_shown(views, session.params));
    const std::vector<std::string>& controls = session.params.view.layout.controls;
    if (!controls.empty() && !is_named(controls, "camera.navigation") && is_named(stage.highlight, "lamps"))
        now.telling.control_rows += rows_of_lamps;
    const auto wants_matrices = [&](ViewName view, Slot slot) {
        return now.maximized == view && lower_view(session.params, slot).wants_matrices;
    };
    now.beside_matrices = !arrangement.bare && (wants_matrices(ViewName::lower_left, Slot::left) ||
                                                wants_matrices(ViewName::lower_right, Slot::right));
    return now;
}

float Workbench::width_of_editor(float window_px) const {
    const bool is_drawn = step_editor_.is_open() && guide.watches_file() && !presenter.is_on();
    return is_drawn ? std::floor(std::min(470.0F * widgets.scale, 0.5F * window_px)) : 0.0F;
}

Layout Workbench::layout(ImVec2 window_px, const Session& session) const {
    const float editor = width_of_editor(window_px.x);
    Layout made = layout_of_areas({window_px.x - editor, window_px.y}, window_px.x, session);
    if (editor > 0.0F) {  // views beside the editor; bars as wide as the window
        for (Rect* rect : {&made.top_bar, &made.status_bar, &made.strip}) rect->max.x += editor;
        for (Rect* rect : {&made.panel, &made.matrices, &made.camera, &made.lower_left, &made.lower_right, &made.beside,
                           &made.caption})
            if (!rect->empty()) *rect = {{rect->min.x + editor, rect->min.y}, {rect->max.x + editor, rect->max.y}};
    }
    if (made.panel.empty() || !session.params.view.layout.controls.empty()) return made;
    made.sections = made.panel;
    made.sections.min.y = made.panel.max.y -= section_links_.height_px(made.panel);
    return made;
}

Layout Workbench::layout_of_areas(ImVec2 window_px, float strip_width, const Session& session) const {
    Arrangement now = arranged(session);
    const StripLook look{arrangement.presents, false, presenter.clock(), false, guide.watches_file()};
    const bool has_strip = guide.is_shown() && arrangement.has_strip;
    if (has_strip) now.strip_px = strip_height(*guide.run(), strip_width, widgets, look);
    if (has_strip && !arrangement.presents && !guide.is_sheet()) {
        // Keep the question at the same height in every step, unless that takes too much space from the views.
        constexpr float most_share = 0.34F;
        const float tallest = tallest_strip(*guide.run(), strip_width, widgets, look);
        now.strip_px = std::max(now.strip_px, std::min(tallest, std::floor(most_share * window_px.y)));
    }
    if (has_strip && arrangement.presents) {
        // Keep the strip in place throughout a lesson, unless that takes space from parts that the step names.
        const float own = now.strip_px;
        now.strip_px = std::max(own, tallest_strip(*guide.run(), strip_width, widgets, look));
        if (!lay_out(window_px, widgets.scale, now).column_fits) now.strip_px = own;
    }
    const Layout bare = lay_out(window_px, widgets.scale, now);
    const NamedFile* preset = presets_.current(session);
    if (!preset || bare.camera.empty() || arrangement.bare) return bare;
    const Rect& last = now.halves ? bare.beside : bare.camera;
    const float width = now.presents ? bare.top_bar.width() - 2.0F * bare.camera.min.x : last.max.x - bare.camera.min.x;
    const Caption caption = caption_of(*preset, widgets, {width, bare.camera.height()}, caption_fold_);
    now.caption_px = caption.height_px;
    Layout layout = lay_out(window_px, widgets.scale, now);
    layout.caption_is_folded = caption.is_folded;
    return layout;
}

std::vector<std::string> Workbench::listed_matrices(const Session& session) const {
    const std::vector<std::string>& listed = session.params.view.layout.matrices;
    if (!listed.empty() || place() != Place::stage) return listed;
    return matrices_on_stage(session.params, presets_.current(session), lower_shown(views, session.params));
}

FrameInput Workbench::after_typing(const FrameInput& input) {
    FrameInput taken = input;
    if (input.loses_focus) widgets::EndTyping(widgets);
    const bool has_waited = !waiting_.pressed.empty() || !waiting_.dropped_files.empty();
    taken.pressed.insert(taken.pressed.begin(), waiting_.pressed.begin(), waiting_.pressed.end());
    taken.dropped_files.insert(taken.dropped_files.begin(), waiting_.dropped_files.begin(),
                               waiting_.dropped_files.end());
    waiting_ = {};
    const bool leads_away = std::any_of(taken.pressed.begin(), taken.pressed.end(), [this](const KeyPress& press) {
        const WindowCommand* const command = command_of(press, place());
        return command && command->open >= Open::text;
    });
    if (has_waited || !widgets::IsTyping(widgets) || !(leads_away || !taken.dropped_files.empty())) return taken;
    widgets::EndTyping(widgets);
    waiting_.pressed.swap(taken.pressed);
    waiting_.dropped_files.swap(taken.dropped_files);
    return taken;
}

Open Workbench::open_now(const Session& session) const {
    const bool in_dialog = help_.is_open() || file_dialog_.is_open() || search_.is_open() || matrix_dialog_.is_open() ||
                           session.asks_to_read() != nullptr;
    if (in_dialog) return Open::dialog;
    // WantTextInput stays true for one frame after typing ends.
    if (ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive()) return Open::text;
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) ? Open::list : Open::nothing;
}

void Workbench::handle_keys(const CommandContext& context, const FrameInput& input) {
    Session& session = context.session;
    const Open open = open_now(session);
    for (const KeyPress& press : input.pressed) {
        if (arrangement.embedded) break;  // the embedding page handles keys
        const bool turns_page = press.key == Key::page_down || press.key == Key::page_up;
        if ((open < Open::text || (open == Open::text && turns_page)) && take_key_of_page(press, session)) continue;
        const WindowCommand* const command = command_of(press, place());
        // An empty search field has nothing to undo, so the key is the window's.
        const bool can_undo = open == Open::text && press.ctrl && (press.key == Key::z || press.key == Key::y) &&
                              presets_.has_empty_search();
        if (command && (command->open >= open || can_undo)) command->run(*this, context);
    }
    for (const std::filesystem::path& file : input.dropped_files) session.open(file.string());
}

void Workbench::draw_columns(Session& session, const WindowContent& content, const Layout& layout) {
    const auto& [derived, before, plan, problems, pictures, status] = content;
    const HiddenStatus& hidden = pictures.hidden;
    const bool on_plate = layout.panel_over_picture;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        on_plate ? ImVec2(px(12.0F), px(8.0F)) : ImVec2(px(8.0F), px(2.0F)));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, on_plate ? widgets.palette.raised : widgets.palette.ground);
    if (!layout.panel.empty()) {
        widgets.targets.offered = offered(*this, session.params, {"control", "button"});
        begin_area("panel", layout.panel, 0);
        if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) views.hovered = ViewName::none;
        if (session.params.view.layout.controls.empty())
            draw_panel(session, derived, problems, views.hidden.panel, hidden, camera_tab_);
        else
            draw_listed_controls(session, derived, problems, views.hidden.panel, hidden, camera_tab_,
                                 !arrangement.presents);
        section_links_.note();
        widgets::CountScrolled();
        ImGui::End();
        if (!layout.sections.empty()) {
            begin_area("sections", layout.sections, ImGuiWindowFlags_NoScrollWithMouse);
            section_links_.draw();
            ImGui::End();
        }
    }
    ImGui::PopStyleColor();
    widgets.targets.offered = offered(*this, session.params, {});
    if (!layout.matrices.empty()) {
        begin_area("matrices", layout.matrices, 0);
        if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) views.hovered = ViewName::matrices;
        if (const std::vector<std::string> listed = listed_matrices(session); listed.empty())
            draw_matrices(session, derived, before, matrix_choice_,
                          matrices_about(session.params, presets_.current(session)));
        else
            draw_listed_matrices(session, derived, before, matrix_choice_, listed);
        widgets::CountScrolled(widgets.scrolled_count > 0);
        ImGui::End();
    }
    ImGui::PopStyleVar();
}

void Workbench::draw_views(Session& session, const WindowContent& content, const Layout& layout,
                           const FrameInput& input, MotionInput& motion) {
    const auto& [derived, before, plan, problems, pictures, status] = content;
    const Arrangement arranged_now = arranged(session);
    const Rect between = views_area(layout, arranged_now);
    begin_area("views", between, ImGuiWindowFlags_NoScrollWithMouse, ImVec2(0.0F, 0.0F));
    if (ImGui::IsWindowHovered()) views.hovered = ViewName::none;
    views.hovered_pixel.reset();
    views.plate = layout.panel_over_picture ? layout.panel : Rect{};
    draw_camera_view(views, session, derived, problems, layout.camera, pictures, input, motion);
    draw_beside_view(views, session, derived, layout, pictures, input, motion);
    if (arranged_now.presents && !layout.caption.empty()) {
        ImGui::End();
        begin_area("caption", layout.caption, 0, ImVec2(0.0F, 0.0F));
    }
    if (const NamedFile* preset = presets_.current(session))
        draw_caption(*preset, session, layout.caption, layout.caption_is_folded, caption_fold_);
    if (layout.lower_in_column) {
        ImGui::End();
        begin_area("lower views", lower_views_area(layout), ImGuiWindowFlags_NoScrollWithMouse, ImVec2(0.0F, 0.0F));
    }
    for (const Slot slot : {Slot::left, Slot::right}) {
        const Rect& rect = slot == Slot::left ? layout.lower_left : layout.lower_right;
        const ImTextureID picture = pictures.lower[static_cast<std::size_t>(slot)];
        draw_lower_view(slot, {views, session, derived, plan, pictures, rect, picture}, !layout.lower_fit);
    }
    if (arranged_now.maximized == ViewName::none && !layout.is_short && !arranged_now.presents)
        draw_splitters(arrangement, layout, between);
    ImGui::End();
    widgets.targets.offered.reset();
}

void Workbench::draw_windows(Session& session, const WindowContent& content, const FrameInput& input,
                             MotionInput& motion, Requests& requests) {
    const Pictures& pictures = content.pictures;
    const CommandContext context{session, requests, content.problems, content.derived.aspect};
    widgets::NewFrame(widgets);
    const Layout now = layout(ImGui::GetIO().DisplaySize, session);
    views.moves = guide.moves;
    begin_hidden_frame(views.hidden, session, pictures.hidden);
    if (!std::exchange(has_panel_window_, true)) {
        begin_area("panel", now.panel);
        ImGui::End();
    }
    if (!now.top_bar.empty() && top_bar_.draw(*this, presets_, context, now, pictures.preset)) help_.open();
    draw_columns(session, content, now);
    draw_views(session, content, now, input, motion);
    draw_status_bar(session, now, content.status, recorder.sign());
    widgets::StopUnlessShown(views.call_player);
    widgets::StopUnlessShown(views.pass_player);
    widgets::StopUnlessShown(views.way_player);
    end_hidden_frame(views.hidden);
    widgets::DrawHighlights(now.strip.empty() ? ImGui::GetIO().DisplaySize.y : now.strip.min.y);
    draw_lesson(session, now, pictures, requests);
    draw_loading(session, now);
    draw_message(session, now);
    session.message.is_drawn = true;
    file_dialog_.draw(session);
    help_.draw();
    draw_search(context, now);
    draw_permission(session);
    if (matrix_choice_.pastes != 0) {
        const char* const held = ImGui::GetClipboardText();
        matrix_dialog_.paste(held ? held : "", std::exchange(matrix_choice_.pastes, '\0'));
    }
    matrix_dialog_.draw(session, content.derived);
    want_korean(session);
}

Requests Workbench::draw(Session& session, const WindowContent& content, const FrameInput& all_input) {
    const FrameInput input = after_typing(all_input);
    if (recorder.is_full()) recorder.write(session);
    replay.update(session, input.dt_s);
    follow_lesson(session, input);
    past.note_opened(session);
    Requests requests;
    if (session.message.is_drawn) session.message.shown_s += input.dt_s;
    if (message_ends_in_s(session.message) == 0.0) session.message = {};
    handle_keys({session, requests, content.problems, content.derived.aspect}, input);
    set_stage(session);

    const bool keys_move = !ImGui::GetIO().WantTextInput && !presenter.takes_letters() && !input.is_down(Key::ctrl) &&
                           !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    MotionInput motion = keys_move ? motion_of(input) : MotionInput{};
    if (presenter.is_on()) motion.roll = 0.0;  // while presenting, Q shows the QR code
    draw_windows(session, content, input, motion, requests);
    requests.cancel_hidden = std::exchange(views.hidden.panel.cancel_method, false);
    requests.restart_hidden = std::exchange(views.hidden.panel.restart_method, false);
    requests.view_picture = std::exchange(views.hidden.growth.wanted_picture, std::nullopt);
    requests.full_screen = presenter.take_wish_for_full_screen();

    // Ignore idle time when motion starts: the window may have slept.
    session.navigate(motion, session.is_moving() ? input.dt_s : std::min(input.dt_s, 1.0 / 60.0));
    const bool rests = !ImGui::IsAnyItemActive() && !widgets::MayBeTakenBack(widgets) && !session.is_moving() &&
                       !is_playing(views) && !replay.is_playing();
    if (rests && !guide.is_revealing() && !presenter.holds_before()) session.rest();
    return requests;
}

void Workbench::show(Session& session, const WindowContent& content, const FrameInput& input) {
    MotionInput motion;
    Requests requests;
    draw_windows(session, content, input, motion, requests);
}

}  // namespace viewing
