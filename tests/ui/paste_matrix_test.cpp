// Pasting a matrix into the window: a correct one is accepted; for any other, a dialog names the mistake and fixes it.
#include <glm/gtc/matrix_transform.hpp>

#include "desk.h"
#include "topics/matrices/numbers/matrix_text.h"

namespace viewing::test {
namespace {

void press_paste(Desk& desk) {
    desk.press_with(Key::ctrl, Key::v);
    desk.settle();
}

double worst_entry(const glm::dmat4& a, const glm::dmat4& b) {
    double worst = 0.0;
    for (int i = 0; i < 16; ++i) worst = std::max(worst, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return worst;
}

bool is_recorded(const Desk& desk, const std::string& label) {
    return std::any_of(desk.recorded().begin(), desk.recorded().end(),
                       [&](const RecordedItem& item) { return item.label == label; });
}

/// Chooses Paste in the Copy menu of the matrix at this position in the column.
void paste_into(Desk& desk, std::size_t place) {
    desk.click_one_of("matrices/Copy", place);
    desk.settle();
    desk.click("matrices/Paste from the clipboard");
    desk.settle();
}

const glm::dmat4 pasted_view = glm::lookAtRH(glm::dvec3(5, 4, 3), glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 0));

TEST(PasteMatrix, ARightOneIsTakenInOneUndoStep) {
    for (const MatrixFormat format :
         {MatrixFormat::glm, MatrixFormat::numpy, MatrixFormat::matlab, MatrixFormat::text, MatrixFormat::latex}) {
        Desk desk;
        const Params before = desk.params();
        desk.clipboard = matrix_text("view_from_world", pasted_view, format);
        press_paste(desk);
        EXPECT_LT(worst_entry(desk.derived.view_from_world, pasted_view), 1e-9);
        EXPECT_EQ(desk.session.message.text, "the camera now comes from the pasted V");
        desk.undo();
        EXPECT_EQ(desk.params(), before);
    }
}

TEST(PasteMatrix, TheMenuOfEachMatrixKnowsItsLetter) {
    Desk desk;
    desk.click("matrices/Show C");
    desk.settle();
    // The name m says nothing about the matrix, but the first Copy menu belongs to C.
    desk.clipboard = matrix_text("m", glm::inverse(pasted_view), MatrixFormat::numpy);
    paste_into(desk, 0);
    EXPECT_LT(worst_entry(desk.derived.view_from_world, pasted_view), 1e-9);
    desk.clipboard = "no matrix";
    paste_into(desk, 1);
    EXPECT_TRUE(desk.session.message.is_error);
    EXPECT_EQ(desk.session.message.text, "the clipboard holds no matrix of 16 numbers");
}

TEST(PasteMatrix, AFaultIsNamedAndFixed) {
    Desk desk;
    const Params before = desk.params();
    desk.clipboard = matrix_text("V", glm::transpose(pasted_view), MatrixFormat::numpy);
    press_paste(desk);
    EXPECT_EQ(desk.params(), before);
    ASSERT_TRUE(is_recorded(desk, "pasted/Fix and use it"));
    desk.click("pasted/Fix and use it");
    desk.settle();
    EXPECT_LT(worst_entry(desk.derived.view_from_world, pasted_view), 1e-9);
    EXPECT_FALSE(is_recorded(desk, "pasted/Close"));
}

TEST(PasteMatrix, ANameOfAnotherMatrixIsAskedAbout) {
    Desk desk;
    const Params before = desk.params();
    desk.clipboard = matrix_text("R", pasted_view, MatrixFormat::numpy);
    press_paste(desk);
    EXPECT_EQ(desk.params(), before);
    ASSERT_TRUE(is_recorded(desk, "pasted/Show it as it is"));
    desk.click("pasted/Fix and use it");
    desk.settle();
    EXPECT_LT(worst_entry(desk.derived.view_from_world, pasted_view), 1e-9);
}

TEST(PasteMatrix, AnUnknownOneCanOnlyBeClosed) {
    Desk desk;
    const Params before = desk.params();
    desk.clipboard = "1 2 3 4\n5 6 7 8\n9 10 11 12\n13 14 15 17";
    press_paste(desk);
    EXPECT_FALSE(is_recorded(desk, "pasted/Fix and use it"));
    desk.click("pasted/Close");
    desk.settle();
    EXPECT_EQ(desk.params(), before);
    EXPECT_FALSE(is_recorded(desk, "pasted/Close"));
}

TEST(PasteMatrix, AWrongOneIsShownAsItIsUntilReleased) {
    struct Wrong {
        const char* name;
        glm::dmat4 matrix;
        std::size_t edit;  ///< the position of its Edit button
    };
    const glm::dmat4 p = glm::perspectiveRH_NO(1.0, 1.5, 0.5, 40.0);
    for (const Wrong& wrong :
         {Wrong{"V", glm::transpose(pasted_view), 0}, {"P", glm::transpose(p), 1}, {"S", glm::dmat4(2.0), 2}}) {
        SCOPED_TRACE(wrong.name);
        Desk desk;
        const Params before = desk.params();
        desk.clipboard = matrix_text(wrong.name, wrong.matrix, MatrixFormat::numpy);
        press_paste(desk);
        desk.click("pasted/Show it as it is");
        desk.settle();
        const glm::dmat4& shown = *wrong.name == 'V'   ? desk.derived.view_from_world
                                  : *wrong.name == 'P' ? desk.derived.clip_from_view
                                                       : desk.derived.chosen_shadow().shadowed_world_from_world;
        EXPECT_EQ(shown, wrong.matrix);
        EXPECT_FALSE(is_recorded(desk, "pasted/Close"));
        const bool is_said = std::any_of(desk.problems.begin(), desk.problems.end(), [](const Problem& problem) {
            return problem.kind == ProblemKind::wrong && problem.id.starts_with("by_hand");
        });
        EXPECT_TRUE(is_said);
        desk.click("matrices/Release");
        desk.settle();
        EXPECT_EQ(desk.params(), before);
    }
}

TEST(PasteMatrix, PIsTakenWithItsLens) {
    Desk desk;
    desk.clipboard = matrix_text("P", glm::frustum(-0.1, 0.3, -0.2, 0.1, 0.25, 80.0), MatrixFormat::glm);
    press_paste(desk);
    const ProjectionParams& projection = desk.params().projection;
    EXPECT_EQ(projection.type, ProjectionType::frustum);
    EXPECT_NEAR(projection.left, -0.1, 1e-12);
    EXPECT_NEAR(projection.top, 0.1, 1e-12);
    EXPECT_NEAR(projection.far, 80.0, 1e-9);
    desk.clipboard = matrix_text("P", glm::infinitePerspective(1.0, 1.5, 0.25), MatrixFormat::glm);
    press_paste(desk);
    EXPECT_TRUE(std::isinf(projection.far));
    EXPECT_EQ(projection.aspect, 1.5);
}

// A state on the clipboard is still pasted as a state.
TEST(PasteMatrix, StatesAreStillPasted) {
    Desk desk;
    desk.clipboard = R"({"projection": {"fovy": 55}})";
    press_paste(desk);
    EXPECT_EQ(desk.params().projection.fovy, 55.0);
}

}  // namespace
}  // namespace viewing::test
