// The comparison of four ways to draw a mirror image: the captions on the pictures, and which way a click selects.
#include "topics/planes/shown/mirror_ways_view.h"

#include <algorithm>

#include "desk.h"
#include "ui/parts/look.h"

namespace viewing::test {
namespace {

constexpr const char* names[] = {"clip distance", "no clipping", "oblique near plane", "mirrored camera"};

class MirrorWaysView : public ::testing::Test {
protected:
    Session session = session_of("mirror-unclipped");
    widgets::Context context;
    Rect rect{{20, 20}, {620, 360}};
    MirrorWaysShown shown;
    widgets::test::Harness ui{context, [this] { draw(); }, {1000, 700}};

    MirrorWaysView() {
        context.palette = widgets::palette_of(widgets::ThemeKind::dark);
        context.scale = 1.0F;
        context.fonts = load_fonts(1.0F);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        widgets::ApplyStyle(context);
    }

    void draw() {
        widgets::NewFrame(context);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({1000, 700});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration);
        draw_mirror_ways_view(session, rect, shown);
        ImGui::End();
    }
    void report(std::int64_t different, std::int64_t image_pixels, glm::ivec2 size_px = {160, 90}) {
        auto ways = std::make_shared<MirrorWays>();
        ways->size_px = size_px;
        for (std::size_t way = 0; way < mirror_way_count; ++way)
            ways->reports[way] = {.different = way == 1 ? different : 0,
                                  .worst = 120,
                                  .first_depth = 0.25,
                                  .last_depth = 0.75,
                                  .distinct_depths = 100,
                                  .image_pixels = image_pixels,
                                  .compared = 14400};
        shown.ways = ways;
    }
    /// Returns the corners of all letters, without their halos.
    static std::vector<ImVec2> letters() {
        std::vector<ImVec2> corners;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int list = 0; list < drawn.CmdListsCount; ++list)
            for (const ImDrawVert& vertex : drawn.CmdLists[list]->VtxBuffer)
                if (vertex.col == palette().text) corners.push_back(vertex.pos);
        return corners;
    }
    /// Counts the vertices of this color within a picture.
    int painted(std::string_view label, ImU32 color) const {
        const RecordedItem& item = ui.find(label);
        int count = 0;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int list = 0; list < drawn.CmdListsCount; ++list)
            for (const ImDrawVert& vertex : drawn.CmdLists[list]->VtxBuffer)
                count += vertex.col == color && vertex.pos.x >= item.min.x - 2 && vertex.pos.x <= item.max.x + 2 &&
                                 vertex.pos.y >= item.min.y - 2 && vertex.pos.y <= item.max.y + 2
                             ? 1
                             : 0;
        return count;
    }
};

TEST_F(MirrorWaysView, HasOnePicturePerWayInTheCamerasShapeWithoutOverlap) {
    report(1440, 500);
    ui.frames(3);
    for (const char* name : names) {
        const RecordedItem& item = ui.find(name);
        EXPECT_NEAR((item.max.x - item.min.x) / (item.max.y - item.min.y), 16.0F / 9.0F, 0.03F) << name;
        EXPECT_GE(item.min.x, rect.min.x);
        EXPECT_GE(item.min.y, rect.min.y);
        EXPECT_LE(item.max.x, rect.max.x + 0.5F);
        EXPECT_LE(item.max.y, rect.max.y + 0.5F);
        for (const char* other : names) {
            if (other == name) continue;
            const RecordedItem& second = ui.find(other);
            EXPECT_TRUE(item.max.x <= second.min.x || second.max.x <= item.min.x || item.max.y <= second.min.y ||
                        second.max.y <= item.min.y);
        }
    }
}

TEST_F(MirrorWaysView, AClickAppliesTheWayAndNothingElse) {
    report(1440, 500);
    ui.frames(3);
    const Params before = session.params;
    const struct {
        MirrorClip clip;
        MirroredThing mirrored;
    } expected[] = {{MirrorClip::clip_distance, MirroredThing::scene},
                    {MirrorClip::none, MirroredThing::scene},
                    {MirrorClip::oblique, MirroredThing::scene},
                    {MirrorClip::clip_distance, MirroredThing::camera}};
    for (const std::size_t way : {2U, 3U, 0U, 1U}) {
        ui.click(names[way]);
        Params wanted = before;
        wanted.reflection.clip = expected[way].clip;
        wanted.reflection.mirrored = expected[way].mirrored;
        EXPECT_EQ(session.params, wanted) << names[way];
        ui.click(names[way]);
        EXPECT_EQ(session.params, wanted) << "again";
        ui.right_click(names[(way + 1) % 4]);
        EXPECT_EQ(session.params, wanted) << "only by the left button";
        ui.frames(2);
        for (std::size_t other = 0; other < 4; ++other)
            EXPECT_EQ(painted(names[other], palette().mirror) > 0, other == way) << names[other];
    }
}

TEST_F(MirrorWaysView, FramesNoWayIfTheStateUsesNoneOfThem) {
    session.params.reflection.clip = MirrorClip::oblique;
    session.params.reflection.mirrored = MirroredThing::camera;
    ui.frames(3);
    for (const char* name : names) EXPECT_EQ(painted(name, palette().mirror), 0) << name;
}

TEST_F(MirrorWaysView, SaysThatReflectionIsOff) {
    report(1440, 500);
    ui.frames(3);
    const int letters_on = ImGui::GetDrawData()->TotalVtxCount;
    session.params.reflection.enabled = false;
    ui.frames(3);
    for (const char* name : names) EXPECT_FALSE(ui.has(name)) << name;
    EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 4 * 30) << "a sentence";
    EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, letters_on);
}

TEST_F(MirrorWaysView, ShowsNumbersOnlyOnceMeasured) {
    ui.frames(3);
    const int without = painted(names[0], palette().text);
    report(1440, 500);
    ui.frames(3);
    const int with = painted(names[0], palette().text);
    EXPECT_GT(with, without + 4 * 20) << "the reference, and its depths";
    report(1440, 0);
    ui.frames(3);
    EXPECT_LT(painted(names[0], palette().text), with - 4 * 15) << "an image without depths shows none";
}

/// Every letter stays on a picture, and a quarter of each picture's height stays free of letters, at any size.
TEST_F(MirrorWaysView, CaptionsStayOnTheirPicturesAndLeaveRoom) {
    const struct {
        ImVec2 size;
        glm::ivec2 picture_px{160, 90};
    } places[] = {{{900, 600}}, {{420, 230}}, {{420, 230}, {400, 60}}, {{236, 210}}, {{180, 110}},
                  {{90, 60}},   {{30, 30}},   {{60, 230}, {60, 400}}};
    for (const auto& [size, picture_px] : places) {
        SCOPED_TRACE(std::to_string(size.x) + " × " + std::to_string(size.y));
        rect.max = {rect.min.x + size.x, rect.min.y + size.y};
        report(1440, 500, picture_px);
        ui.frames(3);
        std::size_t on_pictures = 0;
        for (const char* name : names) {
            const RecordedItem& item = ui.find(name);
            std::vector<float> heights{item.min.y, item.max.y};
            for (const ImVec2& letter : letters())
                if (letter.x >= item.min.x && letter.x <= item.max.x && letter.y >= item.min.y &&
                    letter.y <= item.max.y)
                    heights.push_back(letter.y);
            on_pictures += heights.size() - 2;
            std::ranges::sort(heights);
            float free = 0.0F;
            for (std::size_t i = 1; i < heights.size(); ++i) free = std::max(free, heights[i] - heights[i - 1]);
            EXPECT_GE(free, 0.25F * (item.max.y - item.min.y)) << name;
        }
        EXPECT_EQ(on_pictures, letters().size());
    }
}

TEST_F(MirrorWaysView, IsDefinedInTheSmallestView) {
    for (const bool has_report : {false, true}) {
        if (has_report) report(0, 0);
        for (const ImVec2 size : {ImVec2{6, 6}, ImVec2{5, 100}, ImVec2{100, 5}, ImVec2{1, 1}, ImVec2{0, 0}}) {
            rect.max = {rect.min.x + size.x, rect.min.y + size.y};
            const Params before = session.params;
            ui.frames(3);
            EXPECT_EQ(session.params, before);
            for (const char* name : names) EXPECT_TRUE(ui.has(name));
        }
    }
    auto nothing = std::make_shared<MirrorWays>();
    shown.ways = nothing;
    ui.frames(3);
}

TEST(MirrorWaysTopic, IsALowerViewThatLeavesTheStateUnchanged) {
    Desk desk({1600, 900}, "mirror-unclipped");
    for (const ImVec2 size : {ImVec2{1600, 900}, ImVec2{800, 600}, ImVec2{250, 200}, ImVec2{2, 2}}) {
        ImGui::GetIO().DisplaySize = size;
        desk.session.params.view.lower_right = Topic::mirror_ways;
        const Params before = desk.session.params;
        desk.ui.frames(4);
        EXPECT_EQ(desk.session.params, before);
    }
    ImGui::GetIO().DisplaySize = {1600, 900};
    desk.settle();
    desk.ui.click("lower/oblique near plane");
    desk.settle();
    EXPECT_EQ(desk.session.params.reflection.clip, MirrorClip::oblique);
    desk.undo();
    EXPECT_EQ(desk.session.params.reflection.clip, MirrorClip::none);
}

}  // namespace
}  // namespace viewing::test
