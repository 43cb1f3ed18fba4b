// The pixel view and the cell view in their own window. They show a frame whose buffers are computed here fragment by
// fragment. Their texts agree with the buffers, clicks take effect, and every item stays inside its view at any size.
#include <algorithm>
#include <map>

#include "desk.h"
#include "frame/plan/draw_calls.h"
#include "topics/depth/numbers/fragment_text.h"
#include "topics/depth/numbers/fragments.h"
#include "topics/depth/shown/cell_layout.h"
#include "topics/depth/shown/cell_view.h"
#include "topics/depth/shown/draw_steps.h"
#include "topics/depth/shown/pixel_view.h"
#include "ui/window/theme.h"

namespace viewing::test {
namespace {

constexpr glm::ivec2 camera_px{160, 90};

class DepthViews : public ::testing::Test {
protected:
    enum class Shown { pixel, cells };

    Session session = session_of("interpenetrating");
    widgets::Context context;
    Shown shown = Shown::cells;
    Rect rect{{20, 20}, {435, 250}};
    widgets::StepPlayer player;
    Derived derived;
    FramePlan frame_plan;
    DepthData data;
    std::optional<glm::ivec2> hovered_pixel;  ///< in the camera's picture
    widgets::test::Harness ui{context, [this] { draw(); }, {1700, 1100}};
    FragmentFinder finder{session.scene()};
    Params& params = session.params;

    DepthViews() { look(Theme::dark); }

    void look(Theme theme) {
        context.palette = palette_of(theme);
        context.scale = context.palette.type_scale;
        context.fonts = load_fonts(context.scale);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        widgets::ApplyStyle(context);
    }
    void resize(float width, float height) {
        rect.max = {rect.min.x + width * context.scale, rect.min.y + height * context.scale};
        ui.frames(4);
    }

    /// Returns a pixel with more than three fragments, at least two of them drawn.
    glm::ivec2 busy_pixel() {
        ui.frame();
        for (int y = 0; y < camera_px.y; ++y)
            for (int x = 0; x < camera_px.x; ++x) {
                const std::vector<Fragment> found = finder.at(frame_plan, {x, y}, camera_px);
                const auto drawn = std::ranges::count_if(found, &Fragment::drawn);
                if (found.size() > 3 && drawn > 1) return {x, y};
            }
        throw std::runtime_error("no pixel with several surfaces");
    }
    std::vector<std::string> labels_with(std::string_view part) const {
        std::vector<std::string> found;
        for (const RecordedItem& item : context.recorded)
            if (item.label.find(part) != std::string::npos) found.push_back(item.label);
        return found;
    }
    bool says(std::string_view sentence) const { return ui.has("cells/" + std::string(sentence)); }
    std::string cell_label(const char* grid, glm::ivec2 pixel) const {
        const glm::ivec2 at = pixel - data.now.first_pixel;
        return std::string("cells/") + grid + "/cell/" + std::to_string(at.x) + "/" + std::to_string(at.y);
    }

private:
    /// Returns what a pixel holds after these fragments are drawn, each in a color of its own.
    BufferCell cell_of(const std::vector<Fragment>& fragments) const {
        BufferCell cell{frame_plan.background, code(frame_plan.clear_depth_value), frame_plan.clear_depth_value};
        for (const Fragment& fragment : fragments) {
            if (!fragment.passes) continue;
            if (fragment.drawn)
                cell.color = {static_cast<std::uint8_t>(40 * fragment.object_index + 90),
                              static_cast<std::uint8_t>(17 * fragment.triangle + 5), 77};
            if (!fragment.depth.test || !fragment.depth.write) continue;
            cell.stored = fragment.stored;
            cell.window_depth = fragment.stored / 16'777'215.0;
        }
        return cell;
    }
    static std::uint32_t code(double depth) { return static_cast<std::uint32_t>(std::llround(depth * 16'777'215.0)); }

    CellBlock block(const DrawLimit& limit, glm::ivec2 first, glm::ivec2 size) const {
        CellBlock made{first, size, {}};
        FramePlan stopped = frame_plan;
        stopped.limit = limit;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                made.cells.push_back(cell_of(finder.at(stopped, first + glm::ivec2(x, y), camera_px)));
        return made;
    }

    void fill() {
        derived = derive(params, session.scene(), {camera_px, true});
        frame_plan = plan(params, derived);
        const FramePlan stopped = frame_plan;
        frame_plan.limit = {};
        data.calls = draw_calls(frame_plan, session.scene());
        const std::optional<glm::ivec2> pixel = params.view.pixel ? params.view.pixel : hovered_pixel;
        const auto asked =
            std::make_tuple(params.view.call, params.view.triangle, pixel, cell_block_size(rect, params.view.cells));
        if (asked == asked_) return;
        asked_ = asked;
        data.pixel.reset();
        data.now = data.before = {};
        data.fragments.clear();
        data.incoming.clear();
        if (!pixel) return;
        const glm::ivec2 size = cell_block_size(rect, params.view.cells), first = *pixel - size / 2;
        data.now = block(stopped.limit, first, size);
        data.before = block(step_before(stopped.limit, data.calls), first, size);
        data.fragments = finder.at(frame_plan, *pixel, camera_px);
        const BufferCell cell = cell_of(data.fragments);
        const int seen = seen_fragment(data.fragments);
        data.pixel.emplace();
        data.pixel->pixel = *pixel;
        data.pixel->color = cell.color;
        data.pixel->written = data.pixel->has_depth = seen >= 0;
        data.pixel->stored = cell.stored;
        data.pixel->window_depth = cell.window_depth;
        if (seen >= 0) data.pixel->object = data.fragments[static_cast<std::size_t>(seen)].object;
        fill_incoming(stopped);
    }
    void fill_incoming(const FramePlan& stopped) {
        data.incoming.assign(data.now.cells.size(), std::nullopt);
        const DrawLimit limit = limit_of(step_of(stopped.limit, data.calls), data.calls);
        if (limit.call < 0) return;
        const DrawCall& call = data.calls[static_cast<std::size_t>(limit.call)];
        for (std::size_t i = 0; i < data.incoming.size(); ++i) {
            const int x = static_cast<int>(i) % data.now.size.x, y = static_cast<int>(i) / data.now.size.x;
            for (const Fragment& one : finder.at(frame_plan, data.now.first_pixel + glm::ivec2(x, y), camera_px))
                if (one.pass == call.pass && one.object_index == call.object && one.triangle == limit.triangles - 1)
                    data.incoming[i] = one;
        }
    }
    std::optional<std::tuple<int, int, std::optional<glm::ivec2>, glm::ivec2>> asked_;

    void draw() {
        widgets::NewFrame(context);
        fill();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("views", nullptr, ImGuiWindowFlags_NoDecoration);
        if (shown == Shown::pixel)
            draw_pixel_view(session, derived, data,
                            pinned_pixel(params, derived, frame_plan, session.scene(), camera_px), rect);
        else
            draw_cell_view(session, data, frame_plan, rect, player);
        ImGui::End();
    }
};

class PixelView : public DepthViews {
protected:
    PixelView() { shown = Shown::pixel; }
};
class CellView : public DepthViews {};

// ---- the pixel view ----------------------------------------------------------------------------------

TEST_F(PixelView, ExplainsItselfWithoutAPixel) {
    ui.frames(3);
    EXPECT_TRUE(ui.has("pixel/Point at the camera view to see what a pixel stores; click to pin the pixel."));
}

TEST_F(PixelView, ListsSurfacesAndTestsAndMarksTheVisibleOne) {
    hovered_pixel = busy_pixel();
    resize(700, 400);
    const std::vector<Fragment> expected = finder.at(frame_plan, *hovered_pixel, camera_px);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const TestText test = test_text(expected[i], {24, false});
        const bool is_seen = static_cast<int>(i) == seen_fragment(expected);
        EXPECT_TRUE(ui.has("pixel/" + std::to_string(i + 1) + " " + expected[i].object + ": " + say(test.whole()) +
                           (is_seen ? ", seen" : "")));
    }
    EXPECT_EQ(labels_with(", seen").size(), 1U);
    EXPECT_EQ(labels_with("stored: ").size(), 1U);
}

TEST_F(PixelView, ClickingARowGoesToTheStepThatSendsItsFragment) {
    params.view.pixel = busy_pixel();
    ui.frames(2);
    const std::vector<Fragment> fragments = data.fragments;
    ASSERT_GT(fragments.size(), 1U);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const std::vector<std::string> rows =
            labels_with("pixel/" + std::to_string(i + 1) + " " + fragments[i].object + ": ");
        ASSERT_EQ(rows.size(), 1U);
        ui.click(rows.front());
        const FramePlan whole = plan(params, derived);
        // The frame that stops at this step is the first one that contains the fragment.
        const auto count_in = [&](int step) {
            FramePlan stopped = whole;
            stopped.limit = limit_of(step, data.calls);
            return finder.at(stopped, *params.view.pixel, camera_px).size();
        };
        const int step = step_of({params.view.call, params.view.triangle}, data.calls);
        EXPECT_EQ(count_in(step), i + 1);
        EXPECT_EQ(count_in(step - 1), i);
    }
}

TEST_F(PixelView, APinCanBeReleased) {
    hovered_pixel = busy_pixel();
    ui.frames(3);
    EXPECT_FALSE(ui.has("pixel/Release"));
    EXPECT_TRUE(ui.has("pixel/live"));
    params.view.pixel = hovered_pixel;
    ui.frames(3);
    EXPECT_FALSE(ui.has("pixel/live"));
    ui.click("pixel/Release");
    EXPECT_FALSE(params.view.pixel);
}

TEST_F(PixelView, EveryNumberExplainsItself) {
    hovered_pixel = busy_pixel();
    resize(415, 230);
    const std::map<std::string, std::string> formulas = {{"stored", "z_{window} (2^{24} - 1)"},
                                                         {"z_{window}", "z_{window} = stored / (2^{24} - 1)"},
                                                         {"z_{ndc}", "z_{ndc} = 2 z_{window} - 1"},
                                                         {"eye z", "z_{eye} = -n f / (f - d (f - n)); d = z_{window}"},
                                                         {"width Δz", "Δz = z^2 (f - n) / (f n (2^{24} - 1))"},
                                                         {"world", "C (x_{eye}, y_{eye}, z_{eye}, 1)"}};
    for (const auto& [name, formula] : formulas) {
        const std::vector<std::string> labels = labels_with("pixel/" + name + ": ");
        ASSERT_EQ(labels.size(), 1U) << name;
        ui.hover(labels[0]);
        ui.frames(90);
        const std::vector<std::string> tooltips = labels_with("tooltip");
        ASSERT_EQ(tooltips.size(), 1U) << name;
        EXPECT_NE(ui.text_of(tooltips[0]).find(formula), std::string::npos) << ui.text_of(tooltips[0]);
    }
}

// ---- the cell view -----------------------------------------------------------------------------------

TEST_F(CellView, PinsAndReleasesPixels) {
    const glm::ivec2 pixel = busy_pixel();
    hovered_pixel = pixel;
    ui.frames(3);
    const glm::ivec2 other = pixel + glm::ivec2(1, -1);
    ui.click(cell_label("depths", other));
    EXPECT_EQ(params.view.pixel, other);
    ui.frames(2);
    ui.click(cell_label("colours", other));
    EXPECT_EQ(params.view.pixel, std::nullopt);
}

TEST_F(CellView, StepsThroughCallsAndTriangles) {
    hovered_pixel = busy_pixel();
    ui.frames(3);
    ASSERT_GT(data.calls.size(), 1U);
    const int last = static_cast<int>(data.calls.size()) - 1;
    ui.click("cells/calls/←");
    EXPECT_EQ(params.view.call, last);
    EXPECT_EQ(params.view.triangle, -1);
    ui.click("cells/steps/←");
    EXPECT_EQ(step_of({params.view.call, params.view.triangle}, data.calls), step_count(data.calls) - 1);
    ui.click("cells/steps/→");
    EXPECT_EQ(step_of({params.view.call, params.view.triangle}, data.calls), step_count(data.calls));
    ui.click("cells/calls/→");
    EXPECT_EQ(params.view.call, -1);
    ui.click("cells/calls/call");
    ui.frames(2);
    ui.click("cells/calls/1  " + say(name_of(data.calls[0], frame_plan, session.scene())));
    ui.frames(2);
    EXPECT_EQ(params.view.call, 0);
    EXPECT_EQ(params.view.triangle, -1);
    ui.click("cells/calls/←");
    EXPECT_EQ(step_of({params.view.call, params.view.triangle}, data.calls), 0);
    EXPECT_TRUE(says("Nothing is drawn yet: both buffers hold their clear values."));
}

TEST_F(CellView, PlaysToTheEndInBothKindsOfBar) {
    hovered_pixel = busy_pixel();
    for (const float width : {415.0F, 1300.0F}) {
        params.view.call = -1;
        resize(width, 230);
        player.steps_per_s = 10.0F;
        ui.click(width < 600.0F ? "cells/steps/play" : "cells/steps/Play");
        ASSERT_TRUE(player.playing);
        int before = step_of({params.view.call, params.view.triangle}, data.calls);
        EXPECT_LE(before, 2);
        for (int i = 0; i < 1000 && player.playing; ++i) {
            ui.frame(0.1F);
            const int now = step_of({params.view.call, params.view.triangle}, data.calls);
            ASSERT_GE(now, before);
            ASSERT_LE(now, before + 2);
            before = now;
        }
        EXPECT_FALSE(player.playing);
        EXPECT_EQ(before, step_count(data.calls));
    }
}

TEST_F(CellView, DescribesWhatHappensToAPixel) {
    hovered_pixel = busy_pixel();
    const int count = (ui.frame(), step_count(data.calls));
    std::map<std::string, int> seen;
    for (int step = 1; step <= count; ++step) {
        const DrawLimit limit = limit_of(step, data.calls);
        params.view.call = limit.call;
        params.view.triangle = limit.triangles;
        ui.frame();
        const glm::ivec2 at = *hovered_pixel - data.now.first_pixel;
        const bool changes = data.before.at(at) != data.now.at(at);
        const bool replaced = !labels_with("so color and depth are replaced.").empty();
        EXPECT_EQ(replaced, changes) << "step " << step;
        const bool stays = !labels_with("is false").empty() || says("This triangle does not cover the pixel.") ||
                           !labels_with("is culled").empty() || says("This triangle leaves the pixel unchanged.");
        EXPECT_EQ(stays, !changes) << "step " << step;
        ++seen[replaced ? "replaced" : says("This triangle does not cover the pixel.") ? "not covered" : "stays"];
    }
    EXPECT_GT(seen["replaced"], 1);
    EXPECT_GT(seen["not covered"], 1);
    EXPECT_GT(seen["stays"], 0);
}

TEST_F(CellView, DescribesTheCellUnderThePointer) {
    hovered_pixel = busy_pixel();
    ui.frames(3);
    params.view.call = static_cast<int>(data.calls.size()) - 1;
    ui.frames(2);
    for (const glm::ivec2 away : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(-1, 1)}) {
        const glm::ivec2 pixel = *hovered_pixel + away;
        ui.hover(cell_label("colours", pixel));
        ui.frames(90);
        const std::vector<std::string> tooltips = labels_with("tooltip");
        ASSERT_EQ(tooltips.size(), 1U);
        const BufferCell& cell = data.now.at(pixel - data.now.first_pixel);
        const std::string text = ui.text_of(tooltips[0]);
        EXPECT_TRUE(text.starts_with("pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")\n"));
        EXPECT_NE(text.find(code_text(cell.stored, {24, false})), std::string::npos) << text;
    }
}

TEST_F(CellView, ACallPastTheLastOneShowsTheWholeFrame) {
    hovered_pixel = busy_pixel();
    params.view.call = 10'000;
    ui.frames(3);
    EXPECT_TRUE(says("All draw calls are done. Go back a step to see the comparison that decides a pixel."));
}

TEST_F(CellView, CanBeSteppedThroughWithoutAPixel) {
    ui.frames(3);
    EXPECT_TRUE(says("Point at the camera view, or click a pixel to pin it."));
    ui.click("cells/calls/←");
    EXPECT_EQ(params.view.call, static_cast<int>(data.calls.size()) - 1);
}

TEST_F(CellView, ThePlayerKnowsWhetherItsBarIsShown) {
    ui.frame();
    EXPECT_TRUE(player.shown);
    player.shown = false;
    params.visibility.method = VisibilityMethod::painter;
    ui.frame();
    EXPECT_FALSE(player.shown);
}

TEST_F(CellView, OtherMethodsHaveTheirOwnSteps) {
    params.visibility.method = VisibilityMethod::painter;
    ui.frames(3);
    ui.click("Use the GL depth buffer");
    EXPECT_EQ(params.visibility.method, VisibilityMethod::depth_buffer);
}

// ---- sizes -------------------------------------------------------------------------------------------

TEST_F(DepthViews, StayInsideAtEverySizeAndTheme) {
    hovered_pixel = busy_pixel();
    for (const Theme theme : {Theme::dark, Theme::projector})
        for (const glm::vec2 size : {glm::vec2(240, 150), glm::vec2(300, 230), glm::vec2(415, 230), glm::vec2(620, 232),
                                     glm::vec2(905, 300), glm::vec2(1200, 700)}) {
            look(theme);
            for (const Shown one : {Shown::pixel, Shown::cells}) {
                shown = one;
                params.view.call = one == Shown::cells ? 0 : -1;
                resize(size.x, size.y);
                EXPECT_FALSE(context.recorded.empty());
                for (const RecordedItem& item : context.recorded) {
                    EXPECT_GE(item.min.x, rect.min.x) << item.label << " at " << size.x;
                    EXPECT_LE(item.max.x, rect.max.x + 1.0F) << item.label << " at " << size.x;
                    if (one == Shown::pixel) continue;  // its content scrolls
                    EXPECT_LE(item.max.y, rect.max.y + 1.0F) << item.label;
                }
            }
        }
}

TEST_F(DepthViews, CellsAreLargeEnoughForTheirNumbers) {
    resize(400, 300);  // one frame loads the fonts
    for (float width = 240; width <= 1600; width += 31)
        for (float height = 150; height <= 900; height += 29) {
            const Rect view{{10, 10}, {10 + width, 10 + height}};
            const CellLayout layout = lay_out_cells(view);
            ASSERT_GE(layout.block.x, 2);
            ASSERT_GE(layout.block.y, 2);
            EXPECT_EQ(layout.block, cell_block_size(view, std::nullopt));
            EXPECT_GE(layout.colors.width() - 8.0F, 29.0F * static_cast<float>(layout.block.x));
            EXPECT_GE(layout.colors.height() - 8.0F, 29.0F * static_cast<float>(layout.block.y));
            EXPECT_LE(layout.colors.max.x, layout.depths.min.x);
            EXPECT_LE(layout.steps.max.y, layout.colors.min.y - layout.caption_height);
            EXPECT_LE(layout.depths.max.y, layout.sentence.min.y);
            EXPECT_LE(layout.sentence.max.y, view.max.y);
        }
    const CellLayout none = lay_out_cells({});
    EXPECT_EQ(none.block, glm::ivec2(1));
}

}  // namespace
}  // namespace viewing::test
