// Tests pictures of single views, as pixels and as vector drawings.
#include <cmath>

#include "app/picture.h"
#include "app/vector_figure.h"
#include "figure/faces.h"
#include "frame/ground.h"
#include "golden/states.h"
#include "image/matte.h"

namespace viewing {
namespace {

constexpr glm::ivec2 usual_px{1000, 600};

class FigureTest : public testing::PictureTest {
protected:
    static Result<Image> image_of(const LoadedState& state, const PictureRequest& request) {
        return draw_picture(renderer(), state, scene_of(state), request);
    }
    static Result<Drawing> drawing_of(const LoadedState& state, const PictureRequest& request) {
        return draw_figure(renderer(), state, scene_of(state), request);
    }
};

/// Returns the drawing's text, line by line.
std::string text_in(const Drawing& drawing) {
    std::string text;
    for (const Mark& mark : drawing.marks)
        if (const Line* line = std::get_if<Line>(&mark.what)) {
            for (const char32_t character : line->characters) text += utf8(character);
            text += "\n";
        }
    return text;
}

/// Returns the first text that extends beyond its clip rectangle or the page; "" if none does.
std::string cut_line(const Drawing& drawing) {
    for (const Mark& mark : drawing.marks) {
        const Line* const line = std::get_if<Line>(&mark.what);
        if (!line || line->characters.empty()) continue;
        const DrawingBox clip{glm::max(mark.clip.min, glm::vec2(0.0F)), glm::min(mark.clip.max, drawing.size_px)};
        // A line of text extends vertically from cap height to the baseline, and horizontally from the first
        // character's origin to the middle of the last character.
        const float em = line->em_px, top = line->baseline_px - 0.65F * em;
        const float right = line->lefts_px.back() + 0.25F * em;
        const bool is_whole = line->lefts_px.front() >= clip.min.x - 1.0F && right <= clip.max.x + 1.0F &&
                              top >= clip.min.y - 1.0F && line->baseline_px <= clip.max.y + 1.0F;
        if (is_whole) continue;
        std::string text;
        for (const char32_t character : line->characters) text += utf8(character);
        return text;
    }
    return "";
}

/// Returns whether a single shape covers the whole page.
bool has_ground(const Drawing& drawing) {
    return std::any_of(drawing.marks.begin(), drawing.marks.end(), [&](const Mark& mark) {
        const Shape* const shape = std::get_if<Shape>(&mark.what);
        if (!shape || shape->ink.a == 0) return false;
        glm::vec2 min(1e9F), max(-1e9F);
        for (const Ring& ring : shape->rings)
            for (const glm::vec2& corner : ring) {
                min = glm::min(min, corner);
                max = glm::max(max, corner);
            }
        return min.x <= 1.0F && min.y <= 1.0F && max.x >= drawing.size_px.x - 1.0F && max.y >= drawing.size_px.y - 1.0F;
    });
}

struct Case {
    PictureView view;
    const char* preset;
    std::vector<std::string> settings;
    const char* says;  ///< a text that the figure contains
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {PictureView::matrices, "", {}, "Shadow"},
        {PictureView::matrices, "", {R"(view.layout.matrices=["S"])"}, "rank"},
        {PictureView::derivation, "", {}, "Step by step"},
        {PictureView::derivation, "", {"view.lower_right=mirror_derivation"}, "foot"},
        {PictureView::mirror_derivation, "", {}, "foot"},
        {PictureView::tree, "bsp-walk", {}, ""},
        {PictureView::order, "newell-two-cuts", {}, "polygon"},
        {PictureView::precision, "", {}, "safe gap"},
        {PictureView::codes, "", {}, "near 0.500"},
        {PictureView::histogram, "", {}, "never written"},
        {PictureView::cells, "", {"view.pixel=[640,360]"}, ""},
        {PictureView::pixel, "", {"view.pixel=[640,360]"}, ""},
        {PictureView::fighting, "depth-fighting", {}, ""},
        {PictureView::passes, "", {}, "gl"},
        {PictureView::moving_world, "", {}, "the camera stays"},
        {PictureView::clip, "", {}, "NDC"},
        {PictureView::way, "", {"view.way=2", R"(follow={"object":"box","vertex":3})"}, "P maps it"},
        {PictureView::from_light, "", {}, "the light's view"},
        {PictureView::mirror_ways, "", {}, "mirrored camera"},
        {PictureView::lecture_code, "", {}, "ShadowMatrix"},
        {PictureView::display_code, "", {}, "void display()"},
        {PictureView::observer, "", {}, "camera"},
    };
    return all;
}

class FigureSlowTest : public FigureTest {};

/// Without its background, a drawing has the same texts.
TEST_F(FigureSlowTest, EachViewIsDrawnWithNothingCutOff) {
    for (const Case& one : cases())
        for (const auto& [size_px, theme] : {std::pair(glm::ivec2(1280, 720), "ui.theme=dark"),
                                             std::pair(glm::ivec2(900, 1200), "ui.theme=projector")}) {
            const std::string name = picture_view_names[static_cast<std::size_t>(one.view)];
            SCOPED_TRACE(name + " " + one.preset + " " + std::to_string(size_px.x) + " " + theme);
            std::vector<std::string> settings = one.settings;
            settings.emplace_back(theme);
            const LoadedState state = state_with(settings, one.preset);
            PictureRequest request{one.view, size_px, std::nullopt};
            const Result<Drawing> drawing = drawing_of(state, request);
            ASSERT_TRUE(drawing) << drawing.error();
            EXPECT_EQ(cut_line(*drawing), "");
            EXPECT_NE(text_in(*drawing).find(one.says), std::string::npos) << text_in(*drawing);
            for (const char* button : {"Copy\n", "Edit\n", "Mend\n", "Raise near\n"})
                EXPECT_EQ(text_in(*drawing).find(button), std::string::npos) << button;
            if (size_px.x < size_px.y) continue;
            request.transparent = true;
            const Result<Drawing> cut = drawing_of(state, request);
            ASSERT_TRUE(cut) << cut.error();
            EXPECT_EQ(text_in(*cut), text_in(*drawing));
            EXPECT_TRUE(has_ground(*drawing));
            EXPECT_FALSE(has_ground(*cut));
        }
}

TEST_F(FigureTest, AViewIsReproducible) {
    for (const PictureView view : {PictureView::matrices, PictureView::precision, PictureView::derivation}) {
        const PictureRequest request{view, usual_px, std::nullopt};
        const Result<Image> image = image_of(state_with({}), request), again = image_of(state_with({}), request);
        ASSERT_TRUE(image && again);
        EXPECT_EQ(*image, *again) << static_cast<int>(view);
    }
}

TEST_F(FigureTest, EmptyOrTooSmallViewsAreReported) {
    const auto trouble = [](const Result<Image>& image) { return image ? std::string("drawn") : image.error(); };
    EXPECT_EQ(trouble(image_of(state_with({}), {PictureView::tree, usual_px, std::nullopt})),
              "the view tree has nothing to show: Only the BSP tree method has a tree to show.");
    for (const auto& [view, name] :
         {std::pair{PictureView::pixel, "pixel"}, {PictureView::cells, "cells"}, {PictureView::why, "why"}})
        EXPECT_EQ(
            trouble(image_of(state_with({}), {view, usual_px, std::nullopt})),
            std::string("the view ") + name + " needs a pinned pixel of the camera's picture: set view.pixel=[X,Y]");
    // The picture really fits in the size that the message names.
    const std::string small = trouble(image_of(state_with({}), {PictureView::passes, {700, 320}, std::nullopt}));
    const std::string before = "it fits in 700x";
    const std::size_t at = small.find(before);
    ASSERT_NE(at, std::string::npos) << small;
    const int height = std::stoi(small.substr(at + before.size()));
    EXPECT_EQ(trouble(image_of(state_with({}), {PictureView::passes, {700, height}, std::nullopt})), "drawn") << small;
}

/// Composites a picture over a plain color.
Image over(const Image& image, Color ground) {
    Image whole = image;
    const std::uint8_t under[] = {ground.r, ground.g, ground.b};
    for (std::size_t at = 0; at < whole.rgba.size(); at += 4) {
        const double alpha = image.rgba[at + 3] / 255.0;
        for (std::size_t i = 0; i < 3; ++i)
            whole.rgba[at + i] =
                static_cast<std::uint8_t>(std::lround(image.rgba[at + i] * alpha + under[i] * (1.0 - alpha)));
        whole.rgba[at + 3] = 255;
    }
    return whole;
}

int worst_difference(const Image& a, const Image& b) {
    int worst = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) worst = std::max(worst, std::abs(a.rgba[i] - b.rgba[i]));
    return worst;
}

TEST_F(FigureTest, ATransparentPictureOverTheBackgroundIsThePicture) {
    const LoadedState state = state_with({"ui.theme=light"});
    const Color ground = ground_of(Theme::light).background;
    for (const int samples : {0, 4}) {
        PictureRequest request{PictureView::camera, {480, 270}, samples};
        const Result<Image> opaque = image_of(state, request);
        request.transparent = true;
        const Result<Image> cut = image_of(state, request);
        ASSERT_TRUE(opaque && cut);
        EXPECT_EQ(cut->rgba[3], 0) << "the upper left corner is background";
        const std::size_t middle = 4 * (480 * 125 + 315);  // on the box
        EXPECT_EQ(cut->rgba[middle + 3], 255);
        // Colors are stored in 8 bits, so nearly transparent pixels lose some precision.
        EXPECT_LE(worst_difference(over(*cut, ground), *opaque), 3);
    }
}

TEST_F(FigureTest, LabelsAreOptional) {
    const LoadedState state = state_with({R"(view.beside.shows=depth)"});
    PictureRequest request{PictureView::camera, {640, 360}, std::nullopt};
    const Result<Drawing> plain = drawing_of(state, request);
    request.labels = true;
    const Result<Drawing> labelled = drawing_of(state, request);
    ASSERT_TRUE(plain && labelled);
    EXPECT_EQ(text_in(*plain), "");
    EXPECT_NE(text_in(*labelled).find("n\n"), std::string::npos) << text_in(*labelled);
    const auto insets = [](const Drawing& drawing) {
        return std::count_if(drawing.marks.begin(), drawing.marks.end(),
                             [](const Mark& mark) { return std::holds_alternative<Inset>(mark.what); });
    };
    EXPECT_EQ(insets(*plain), 1);
    EXPECT_EQ(insets(*labelled), 2) << "the camera's picture and the one beside it";
}

TEST_F(FigureTest, PrintedTypeHasTheSameHeightAtAnyResolution) {
    const LoadedState state = state_with({});
    const auto largest_pt = [&](double dpi) {
        PictureRequest request{PictureView::matrices, glm::ivec2(glm::dvec2(1200, 700) * dpi / 96.0), std::nullopt};
        request.dpi = dpi;
        const Result<Drawing> drawing = drawing_of(state, request);
        EXPECT_TRUE(drawing) << drawing.error();
        float largest = 0.0F;
        for (const Mark& mark : drawing->marks)
            if (const Line* line = std::get_if<Line>(&mark.what)) largest = std::max(largest, line->em_px);
        return static_cast<double>(largest) * 72.0 / dpi;
    };
    const double at_96 = largest_pt(96.0);
    EXPECT_GT(at_96, 7.0);
    EXPECT_NEAR(largest_pt(192.0), at_96, 0.05 * at_96);
    EXPECT_NEAR(largest_pt(288.0), at_96, 0.05 * at_96);
}

}  // namespace
}  // namespace viewing
