#include "ui/window/bars.h"

#include <algorithm>
#include <utility>

#include "state/fields.h"
#include "text/catalogue.h"
#include "text/words.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/look.h"
#include "ui/window/window_layout.h"
#include "ui/window/workbench.h"

namespace viewing {
namespace {

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string scene_title(const SceneSource& source, const std::vector<NamedFile>& scenes) {
    const auto* name = std::get_if<std::string>(&source);
    if (!name) return tr("custom");
    for (const NamedFile& scene : scenes)
        if (scene.name == *name) return scene.title;
    return std::filesystem::path(*name).filename().string();
}

/// Draws a list of the scenes. Returns the chosen one, or null.
const NamedFile* choose_scene(const char* shown, const std::vector<NamedFile>& scenes, float width) {
    const NamedFile* chosen = nullptr;
    if (!widgets::BeginChoice("##scene", shown, width)) return nullptr;
    for (const NamedFile& scene : scenes) {
        if (ImGui::Selectable(widgets::LabelText(scene.title.c_str()).c_str(), scene.title == shown)) chosen = &scene;
        widgets::Record(scene.name.c_str());
        widgets::Tooltip(scene.title.c_str(), scene.about.c_str());
    }
    widgets::EndChoice();
    return chosen;
}

/// Returns the width in pixels of a button at the bar's right end, including the gap to the next button.
float button_room(const char* label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::CalcTextSize(tr(label)).x + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
}

constexpr float step_padding = 5.0F;  ///< design pixels on each side of a step button's symbol

/// Draws a button that opens the neighboring preset. If there is none, `preset` is null and `why` says why.
bool step_button(const char* label, const NamedFile* preset, const char* why) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(step_padding), ImGui::GetStyle().FramePadding.y});
    const bool clicked = widgets::Button(label, preset != nullptr, why);
    ImGui::PopStyleVar();
    if (preset) widgets::Tooltip(preset->title.c_str(), preset->about.c_str());
    return clicked;
}

float step_buttons_room() {
    return 2.0F * (ImGui::CalcTextSize("◂").x + 2.0F * px(step_padding) + px(2.0F));
}

/// Draws the list of presets and, if `has_steps`, the buttons that open its neighbors.
void draw_presets(PresetPicker& picker, Session& session, float width, bool has_steps, const PresetPicture& picture) {
    const NamedFile* open = picker.current(session);
    const std::string title = open ? tr(open->title.c_str()) : tr("choose…");
    const std::string shown = session.departs_from_preset() ? say("{preset} (changed)", "preset"_a = title) : title;
    const NamedFile* chosen = picker.draw(open, shown, width, picture);
    if (has_steps) {
        const NamedFile *before = picker.at(session, -1), *after = picker.at(session, 1);
        ImGui::SameLine(0.0F, px(2.0F));
        if (step_button("◂###previous preset", before,
                        open ? marked("this is the first preset") : marked("no preset is open")))
            chosen = before;
        ImGui::SameLine(0.0F, px(2.0F));
        if (step_button("▸###next preset", after, marked("this is the last preset"))) chosen = after;
    }
    if (chosen) session.open(chosen->name);
}

void draw_lesson_button(Guide& guide, StartPage& start_page, Session& session) {
    const bool waits = guide.run() && !guide.is_shown();
    if (widgets::Button(waits ? "Back to the lesson###Lesson" : "Lesson")) {
        if (waits)
            guide.resume(session);
        else
            start_page.open();
    }
    widgets::Tooltip("Lesson", waits
                                   ? marked("Returns to the step that you left and restores its original state.")
                                   : marked("The lessons of the lecture: each step asks before it shows the answer."));
}

/// Returns the name of the column that the bar's button shows next when only one column fits. In a short window, the
/// button's cycle includes a step that shows only the views.
const char* next_column(const Arrangement& arrangement, const Layout& layout) {
    if (layout.is_short && !arrangement.prefers_column) return marked("Controls");
    if (layout.is_short && arrangement.prefers_matrices) return marked("Views");
    return arrangement.prefers_matrices ? marked("Controls") : marked("Matrices");
}

void show_next_column(Arrangement& arrangement, const Layout& layout) {
    if (!layout.is_short) {
        arrangement.prefers_matrices = !arrangement.prefers_matrices;
        return;
    }
    const bool had_column = std::exchange(arrangement.prefers_column, true);
    if (had_column && arrangement.prefers_matrices) arrangement.prefers_column = false;
    arrangement.prefers_matrices = had_column && !arrangement.prefers_matrices;
}

/// Draws a menu's button and begins the popup below it, which stays inside the window and closes on Escape. Returns
/// whether the popup is open.
bool begin_menu(const char* button, const char* popup, const char* explanation, float least_width = 0.0F) {
    if (widgets::Button(button)) ImGui::OpenPopup(popup);
    widgets::Tooltip(button, explanation);
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, corner.y + px(4.0F)}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowSizeConstraints({least_width, 0.0F}, {FLT_MAX, FLT_MAX});
    if (!ImGui::BeginPopup(popup)) return false;
    widgets::ClosePopupOnEscape();
    return true;
}

/// Draws the controls that determine what a drag in the camera view does.
void mouse_controls(MouseHabits& mouse) {
    const MouseHabits usual;
    const auto drag = [](const char* label, bool& pans, const char* other, const char* other_tip) {
        const char* const names[] = {other, marked("pans")};
        const char* const tips[] = {other_tip, marked("Shifts the picture with the pointer.")};
        int chosen = pans ? 1 : 0;
        if (widgets::Segments(label, chosen, names, 0, tips)) pans = chosen == 1;
    };
    drag(marked("right drag"), mouse.right_pans, marked("looks"),
         marked("Turns the camera, as the left button does. In Orbit, it pans."));
    drag(marked("middle drag"), mouse.middle_pans, marked("orbits"),
         marked("Orbits the camera about the point under the pointer. With Shift, it pans."));
    widgets::Toggle("Dragging keeps the horizon level", mouse.keeps_horizon, usual.keeps_horizon);
    widgets::Tooltip(
        "Dragging keeps the horizon level",
        "In Fly, dragging yaws about the world's up axis and pitches about the camera's right axis. If off, dragging "
        "turns about the camera's own axes, as the keys do, and can tilt the horizon.");
    widgets::Toggle("Dragging up looks down", mouse.inverts_y, usual.inverts_y);
    widgets::Slider("mouse speed", mouse.sensitivity,
                    {.min = least_sensitivity,
                     .max = greatest_sensitivity,
                     .step = 0.01,
                     .decimals = 1,
                     .default_value = usual.sensitivity},
                    px(160.0F));
}

}  // namespace

void begin_area(const char* name, const Rect& rect, ImGuiWindowFlags extra, std::optional<ImVec2> padding) {
    ImGui::SetNextWindowPos(rect.min);
    ImGui::SetNextWindowSize({rect.width(), rect.height()});
    if (padding) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, *padding);
    ImGui::Begin(name, nullptr, fixed_window | extra);
    if (padding) ImGui::PopStyleVar();
}

void TopBar::draw_file_menu(Workbench& window, const CommandContext& context) const {
    if (!begin_menu(marked("File"), "file menu", marked("Open and save states, meshes and pictures"))) return;
    const WindowCommand* chosen = nullptr;
    for (const FilePart part : {FilePart::files, FilePart::copies, FilePart::pastes, FilePart::others}) {
        if (part == FilePart::others) ImGui::Separator();
        for (const WindowCommand& command : window_commands()) {
            if (command.file_part != part) continue;
            const char* const label =
                window.recorder.is_recording() && command.name_to_stop ? command.name_to_stop : command.name;
            if (ImGui::MenuItem(widgets::LabelText(label).c_str(), key_text(command.key).c_str())) chosen = &command;
            widgets::Record(label);
        }
    }
    if (!lectures_.empty()) ImGui::Separator();
    for (const LessonFile& lecture : lectures_) {
        window.korean.want(lecture.title.shown());
        const std::string label = say("Lecture: {title}", "title"_a = lecture.title.shown());
        if (ImGui::MenuItem((label + "###lecture " + lecture.id).c_str())) window.guide.open(lecture.path.string());
        widgets::Record(("lecture " + lecture.id).c_str());
    }
    ImGui::EndPopup();
    if (chosen) chosen->run(window, context);
}

void TopBar::draw_look_menu(Workbench& window, Params& params, Requests& requests) {
    // Make the menu wide enough for the slider with its label from the first frame; apart from that, it sizes itself to
    // its content.
    const float least = widgets::LabelledWidth("scale", px(160.0F)) + 2.0F * ImGui::GetStyle().WindowPadding.x;
    if (!begin_menu(marked("Look"), "look menu", marked("Theme, language, scale, folded panels and the mouse"), least))
        return;
    static constexpr const char* themes[] = {marked("Dark"), marked("Light"), marked("Projector")};
    if (control(params, "ui.theme", {.segments = true, .names = themes, .label = "##theme"}))
        requests.chosen_theme = params.ui.theme;
    for (const char* const name : language_names) window.korean.want(name);
    if (control(params, "ui.language", {.segments = true, .names = language_names, .label = "##language"}))
        requests.chosen_language = params.ui.language;
    // The scale resizes the whole window, including this slider, so apply it only on release.
    Params scaled = params;
    if (pending_scale_) scaled.ui.scale = *pending_scale_;
    if (control(scaled, "ui.scale",
                {.slider = true, .width = 160.0F, .label = marked("scale"), .min = 0.5, .max = 3.0}))
        pending_scale_ = scaled.ui.scale;
    if (pending_scale_ && !ImGui::IsAnyItemActive())
        requests.chosen_scale = params.ui.scale = *std::exchange(pending_scale_, std::nullopt);
    bool multisampled = params.view.samples == 4;
    if (widgets::Toggle("Multisampling 4×", multisampled, true)) params.view.samples = multisampled ? 4 : 0;
    explain(field("view.samples"));
    ImGui::Separator();
    bool panel = !is_folded(params, "panel"), matrices = !is_folded(params, "matrices");
    if (widgets::Toggle("Controls (F2)", panel, true)) fold(params, "panel", !panel);
    if (widgets::Toggle("Matrices (F3)", matrices, true)) fold(params, "matrices", !matrices);
    widgets::Toggle("Handles and labels (H)", window.views.handles, true);
    ImGui::Separator();
    mouse_controls(window.views.mouse);
    ImGui::Separator();
    if (widgets::Button("Full screen (F11)")) requests.toggle_full_screen = true;
    ImGui::EndPopup();
}

bool TopBar::draw(Workbench& window, PresetPicker& presets, const CommandContext& context, const Layout& layout,
                  const PresetPicture& picture) {
    Session& session = context.session;
    const widgets::Group group("top");
    begin_area("top", layout.top_bar, ImGuiWindowFlags_NoScrollWithMouse, ImVec2(px(10.0F), px(7.0F)));
    const char* const other_column = next_column(window.arrangement, layout);
    float buttons = layout.matrices_fit ? 0.0F : button_room(other_column);
    const char* const lesson = window.guide.run() && !window.guide.is_shown() ? "Back to the lesson" : "Lesson";
    for (const char* label : {lesson, "File", "Look", "?"}) buttons += button_room(label);
    const float exercises_room = button_room("Exercises");
    // Shorten the preset list in a narrow bar: the buttons need the width.
    const float whole_titles = layout.top_bar.width() > px(1300.0F) ? 320.0F : 220.0F;
    const float undo = button_room("Undo") + button_room("Redo");
    const float names = px(190.0F) + ImGui::CalcTextSize(tr("Scene")).x + ImGui::CalcTextSize(tr("Preset")).x;
    const float wide_lists = px(170.0F + whole_titles) + step_buttons_room();
    const bool narrow =
        layout.top_bar.width() < std::max(px(1100.0F), names + wide_lists + buttons + exercises_room + undo);
    const float scene_width = px(narrow ? 130.0F : 170.0F), preset_width = px(narrow ? 150.0F : whole_titles);
    const float lists = scene_width + px(6.0F) + preset_width;
    // If the Exercises button does not fit, the start page still has one.
    const bool has_exercises = !narrow || layout.top_bar.width() - px(20.0F) - buttons - exercises_room >= lists;
    if (has_exercises) buttons += exercises_room;
    // If the Undo and Redo buttons do not fit, Ctrl+Z and Ctrl+Shift+Z still work.
    const bool has_undo = !narrow || layout.top_bar.width() - px(20.0F) - buttons - undo >= lists;
    if (has_undo) buttons += undo;
    const float room = layout.top_bar.width() - px(20.0F) - buttons;
    const bool has_steps = !narrow || lists + step_buttons_room() <= room;  // without them, use Page up and Page down
    const float lists_room = room - (has_steps ? step_buttons_room() : 0.0F);
    const float share = narrow ? std::clamp(lists_room / lists, 0.1F, 1.0F) : 1.0F;
    const float spare = narrow ? std::clamp(lists_room - lists, 0.0F, px(50.0F)) : 0.0F;
    if (!narrow) {
        ImGui::AlignTextToFramePadding();
        ImGui::PushFont(window.widgets.fonts.heading);
        ImGui::TextUnformatted("Viewing Sandbox");
        ImGui::PopFont();
        ImGui::SameLine(0.0F, px(22.0F));
        ImGui::TextUnformatted(tr("Scene"));
        ImGui::SameLine();
    }
    const std::string shown = scene_title(session.params.scene, scenes_);
    if (const NamedFile* scene = choose_scene(shown.c_str(), scenes_, share * scene_width + spare))
        session.params.scene = scene->name;
    explain(field("scene"));
    ImGui::SameLine(0.0F, px(narrow ? 6.0F : 18.0F));
    if (!narrow) {
        ImGui::TextUnformatted(tr("Preset"));
        ImGui::SameLine();
    }
    draw_presets(presets, session, share * preset_width, has_steps, picture);

    // Right-align the buttons.
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(),
                             layout.top_bar.width() - buttons + ImGui::GetStyle().ItemSpacing.x - px(10.0F)));
    if (!layout.matrices_fit) {
        if (widgets::Button(other_column)) show_next_column(window.arrangement, layout);
        ImGui::SameLine();
    }
    draw_lesson_button(window.guide, window.start_page, session);
    ImGui::SameLine();
    if (has_exercises) {
        if (widgets::Button("Exercises")) window.exercises.open_page();
        widgets::Tooltip("Exercises", marked("Questions with your own numbers, checked automatically."));
        ImGui::SameLine();
    }
    if (has_undo) {
        if (widgets::Button("Undo", session.can_undo(), "nothing to undo")) session.undo();
        ImGui::SameLine();
        if (widgets::Button("Redo", session.can_redo(), "nothing to redo")) session.redo();
        ImGui::SameLine();
    }
    draw_file_menu(window, context);
    ImGui::SameLine();
    draw_look_menu(window, session.params, context.requests);
    ImGui::SameLine();
    const bool wants_help = widgets::Button("?");
    widgets::Tooltip("Keys", "Every key and mouse gesture (F1)");
    ImGui::End();
    return wants_help;
}

void draw_status_bar(const Session& session, const Layout& layout, const StatusLine& status,
                     const std::string& recording) {
    const widgets::Context& context = widgets::CurrentContext();
    if (layout.status_bar.empty())
        return ImGui::GetForegroundDrawList()->AddText({px(10.0F), px(8.0F)}, context.palette.trouble,
                                                       recording.c_str());
    begin_area("status", layout.status_bar, ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoInputs,
               ImVec2(px(10.0F), px(4.0F)));
    ImGui::PushFont(context.fonts.small_number);
    ImGui::PushStyleColor(ImGuiCol_Text, context.palette.quiet);
    const float room = recording.empty() ? 0.0F : ImGui::CalcTextSize(recording.c_str()).x + px(18.0F);
    if (!recording.empty()) {
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(context.palette.trouble), "%s", recording.c_str());
        widgets::Record(recording.c_str());
        ImGui::SameLine(px(10.0F) + room);
    }
    ImGui::TextUnformatted(status.frame_time.c_str());
    ImGui::SameLine(px(84.0F) + room);
    ImGui::TextUnformatted(status.renderer.c_str());
    ImGui::PopFont();
    ImGui::PushFont(context.fonts.note);
    // Show as many pieces of text as fit, the most important first; the hint keeps its position.
    const char* hint = tr("F1 keys");
    const float hint_x = layout.status_bar.width() - ImGui::CalcTextSize(hint).x - px(10.0F);
    const auto append = [&](const std::string& text) {
        if (text.empty() || ImGui::GetItemRectMax().x + ImGui::CalcTextSize(text.c_str()).x + px(34.0F) > hint_x)
            return;
        ImGui::SameLine(0.0F, px(18.0F));
        ImGui::TextUnformatted(text.c_str());
    };
    if (!session.message.is_error) append(printable(session.message.text));
    const bool tells_pixel = !widgets::IsCovered("bar:pixel") && !widgets::IsPartCovered("column:pixel");
    const float told_from = ImGui::GetItemRectMax().x;
    if (tells_pixel)
        for (const std::string& part : status.told) append(part);
    if (ImGui::GetItemRectMax().x > told_from || !tells_pixel)
        widgets::MarkTarget("bar:pixel", {told_from, layout.status_bar.min.y},
                            {std::max(ImGui::GetItemRectMax().x, told_from + px(40.0F)), layout.status_bar.max.y});
    ImGui::SameLine(hint_x);
    ImGui::TextUnformatted(hint);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::End();
}

double message_ends_in_s(const StatusMessage& message) {
    constexpr double lasts_s = 8.0;
    return message.is_error || message.text.empty() ? -1.0 : std::max(lasts_s - message.shown_s, 0.0);
}

}  // namespace viewing
