// The growth of costs, measured in the background, plotted as results arrive, summarized in sentences, and exported.
#include "topics/hidden/shown/growth_view.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "platform/file.h"
#include "platform/free_file.h"
#include "text/catalogue.h"
#include "text/per_enum.h"
#include "topics/hidden/numbers/hidden_budget.h"
#include "topics/hidden/numbers/scene_surface.h"
#include "topics/hidden/shown/hidden_status.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "ui/parts/view_window.h"
#include "widgets/diagrams.h"

namespace viewing {
namespace {

/// Places items side by side, and wraps at the right edge.
class Flow {
public:
    explicit Flow(float room) : room_(room) {}

    /// Places the cursor for an item of this width.
    void next(float width) {
        const float gap = px(6.0F);
        if (used_ > 0.0F && used_ + gap + width <= room_) {
            ImGui::SameLine(0.0F, gap);
            used_ += gap + width;
        } else {
            used_ = width;
        }
    }
    float room() const { return room_; }

private:
    float room_;
    float used_ = 0.0F;
};

constexpr int own_scene = static_cast<int>(GrowthScene::own_polygons);

const std::vector<GrowthRow>& shown_rows(const GrowthViewState& state) {
    return state.rows[state.scene];
}

/// Starts the measurement. The worker thread builds everything that it measures, from a copy of the scene that shares
/// its meshes with the original.
void start(GrowthViewState& state, const Scene& scene) {
    state.was_started = true;
    state.log = std::make_shared<BackgroundLog<GrowthRow>>();
    state.measuring.start([log = state.log, which = static_cast<GrowthScene>(state.scene),
                           scene](WorkProgress& progress) -> Result<std::vector<GrowthRow>> {
        GrowthRequest request{.scene = which};
        if (which == GrowthScene::own_polygons) {
            if (const Message why = beyond_hidden_budget(scene, true); !why.empty()) return Error{say(why)};
            request.own_polygons = surface_of(scene).polygons;
        }
        return measure_growth(request, &progress, [&log](const GrowthRow& row) { log->add(row); });
    });
}

void save_csv(const GrowthViewState& state, Session& session) {
    const std::filesystem::path file = free_file("viewing-growth", ".csv");
    session.write([file, text = growth_csv(shown_rows(state))] { return write_file(file, text); },
                  say("costs written to {file}", "file"_a = file.string()));
}

/// Draws the choice of polygons, and the button that starts or cancels the measurement.
void measuring(GrowthViewState& state, const Session& session, Flow& flow) {
    static constexpr const char* scenes[] = {marked("small random triangles"), marked("large random triangles"),
                                             marked("the current scene")};
    const bool is_running = state.measuring.is_running();
    const float choice_width = std::min(std::max(px(184.0F), widgets::ChoiceWidth(scenes)), flow.room());
    flow.next(choice_width);
    ImGui::BeginDisabled(is_running);
    widgets::Choice("##scene", state.scene, scenes, 0, choice_width);
    ImGui::EndDisabled();
    if (is_running) widgets::Tooltip("Polygons", "Cannot be changed until the measurement ends.");
    widgets::Tooltip("Polygons",
                     "Small triangles hardly touch one another. Large triangles nearly all intersect, so methods that "
                     "split polygons have many to split. With the current scene, the measurement uses more and more of "
                     "the scene's own polygons.");
    const char* label = is_running ? marked("Cancel") : marked("Measure");
    flow.next(widgets::SmallButtonWidth(label));
    if (!widgets::SmallButton(label)) return;
    if (is_running)
        state.measuring.cancel();
    else
        start(state, session.scene());
}

void quantity_words(GrowthViewState& state, Flow& flow) {
    static constexpr std::array names{marked("time"), marked("operations")};
    static constexpr std::array explanations{
        marked("Time to finish the picture; for a BSP tree, also to build the tree."),
        marked("The number of times that a method performs its most frequent operation (comparisons, pixels tested, "
               "intersection tests), and the number of pixels it paints. Both are the same in every run.")};
    flow.next(widgets::SmallButtonWidth(names[0]) + widgets::SmallButtonWidth(names[1]) + px(2.0F));
    int index = state.shows_operations ? 1 : 0;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (words("##quantity", index, names, explanations, 0, right)) state.shows_operations = index == 1;
}

float saving_width() {
    return widgets::SmallButtonWidth("Save CSV") + px(6.0F) + widgets::SmallButtonWidth("Save PNG");
}

/// Draws the progress or, if nothing is running, the buttons that save the result. Returns true if the caller must save
/// a picture of the chart, whose rectangle is not known yet.
bool progress_or_saving(const GrowthViewState& state, Session& session, Flow& flow) {
    if (state.measuring.is_running()) {
        const float width = std::min(saving_width(), flow.room());
        flow.next(width);
        const std::string percent = progress_text(state.measuring.fraction());
        ImGui::ProgressBar(state.measuring.fraction(), {width, ImGui::GetTextLineHeight() + px(4.0F)}, percent.c_str());
        widgets::Record("progress");
        return false;
    }
    const bool has_rows = !shown_rows(state).empty();
    flow.next(widgets::SmallButtonWidth("Save CSV"));
    if (widgets::SmallButton("Save CSV", has_rows, "Measure first.")) save_csv(state, session);
    flow.next(widgets::SmallButtonWidth("Save PNG"));
    return widgets::SmallButton("Save PNG", has_rows, "Measure first.");
}

/// The measured points of each method, except those where a budget stopped it.
class Curves {
public:
    Curves(std::span<const GrowthRow> rows, bool of_operations) {
        for (const GrowthRow& row : rows) {
            const double value = of_operations ? static_cast<double>(row.work()) : row.time_ms;
            if (row.problem.empty()) points_[row.method].emplace_back(static_cast<double>(row.polygons), value);
        }
        const widgets::Palette& colors = palette();
        const std::array<ImU32, growth_method_count> own = {colors.light,  colors.plane,   colors.mirror,
                                                            colors.camera, colors.trouble, colors.text};
        static constexpr std::array names{marked("painter"),  marked("Newell"),   marked("BSP build"),
                                          marked("BSP walk"), marked("z-buffer"), marked("ray casting")};
        for (std::size_t method = 0; method < growth_method_count; ++method)
            curves_[method] = {.name = names[method], .color = own[method], .points = points_[method]};
    }
    Curves(const Curves&) = delete;
    Curves& operator=(const Curves&) = delete;

    std::span<const widgets::ChartCurve> get() const { return curves_; }

private:
    PerEnum<GrowthMethod, std::vector<glm::dvec2>, growth_method_count> points_;
    std::array<widgets::ChartCurve, growth_method_count> curves_;
};

/// Draws the chart. Returns its rectangle, clipped to the view.
Rect draw_chart(const GrowthViewState& state, const Scene& scene, float height) {
    const Curves curves(shown_rows(state), state.shows_operations);
    const bool is_own = state.scene == own_scene;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    // Fix the range, so that the curves grow while the axis stays in place. Do not fix it for the current scene, which
    // may have far fewer polygons than the fixed range.
    widgets::LogChart("chart", curves.get(),
                      {.x = {.title = marked("polygons"), .min = is_own ? 0.0 : 10.0, .max = is_own ? 0.0 : 100'000.0},
                       .y = {.title = state.shows_operations ? marked("operations") : marked("time in ms")},
                       .marker_x = static_cast<double>(scene.triangle_count()),
                       .marker_label = marked("this scene"),
                       .size = {width, height}});
    const float bottom = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    return {from, {from.x + width, std::min(from.y + height, bottom)}};
}

/// Returns sentences that say which method is fastest for which scenes, and why some curves end early.
std::vector<std::string> sentences(const GrowthViewState& state) {
    std::vector<Message> told{growth_summary(shown_rows(state))};
    // On stage, show only results that are the same on every machine.
    if (!widgets::CurrentContext().is_on_stage) told.push_back(growth_times(shown_rows(state)));
    for (const GrowthRow& row : shown_rows(state)) told.push_back(row.problem);
    std::vector<std::string> said;
    for (const Message& sentence : told)
        if (!sentence.empty()) said.push_back(say(sentence));
    return said;
}

void draw_results(GrowthViewState& state, const Session& session, bool wants_picture) {
    const std::vector<std::string> told = sentences(state);
    float below = 0.0F;
    for (const std::string& sentence : told) below += note_height(sentence.c_str()) + ImGui::GetStyle().ItemSpacing.y;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // If the chart and the sentences do not both fit, the chart fills the view, and the user can scroll down to the
    // sentences.
    const float height = room.y - below >= px(180.0F) ? room.y - below : std::max(room.y, px(120.0F));
    const Rect chart = draw_chart(state, session.scene(), height);
    // Scroll to the top first: the picture is taken from the next frame.
    if (std::exchange(state.wants_picture, wants_picture))
        state.wanted_picture = {chart, free_file("viewing-growth", ".png")};
    if (wants_picture) ImGui::SetScrollY(0.0F);
    for (const std::string& sentence : told) recorded_note(sentence);
}

}  // namespace

void measure_for_stage(GrowthViewState& state, const Session& session) {
    if (state.was_started) return;
    state.shows_operations = true;
    start(state, session.scene());
}

void take_growth_rows(GrowthViewState& state, Session& session) {
    if (!state.log) return;
    // Take the result before the rows: once there is a result, the log is complete.
    const std::optional<Result<std::vector<GrowthRow>>> finished = state.measuring.take();
    state.rows[state.scene] = state.log->entries();
    if (!finished) return;
    state.log.reset();
    if (!*finished) session.report(Error{finished->error()});
}

void draw_growth_view(GrowthViewState& state, Session& session, const Rect& rect) {
    const bool has_switches = widgets::OffersButton("Measure");
    if (state.of_version != session.scene_version() && !state.measuring.is_running()) {
        state.rows[own_scene].clear();  // measured on another scene
        state.of_version = session.scene_version();
    }
    // Use the right end of the header if there is space beside the choice of topic.
    bool wants_picture = false;
    const float left = rect.max.x - saving_width();
    const bool fits_above = left >= ImGui::GetCursorScreenPos().x;
    if (fits_above && has_switches) {
        ImGui::SetCursorScreenPos({left, rect.min.y - px(23.0F)});
        Flow above(saving_width());
        wants_picture = progress_or_saving(state, session, above);
    }
    const ViewWindow view("growth view", rect);
    if (has_switches) {
        Flow flow(ImGui::GetContentRegionAvail().x);
        measuring(state, session, flow);
        quantity_words(state, flow);
        if (!fits_above) wants_picture = progress_or_saving(state, session, flow);
    }
    if (shown_rows(state).empty()) {
        const bool is_running = state.measuring.is_running();
        if (offer(is_running ? marked("Measuring the first method…")
                             : marked("Measures every method on more and more polygons, up to 100,000. The window "
                                      "stays responsive."),
                  has_switches || is_running ? nullptr : marked("Measure")))
            start(state, session.scene());
        return;
    }
    draw_results(state, session, wants_picture);
}

}  // namespace viewing
