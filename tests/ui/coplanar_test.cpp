// The scene `coplanar` adapts to its parameters while the window is open.
#include "desk.h"

namespace viewing::test {
namespace {

class CoplanarTest : public ::testing::Test {
protected:
    Desk desk{{1600, 1500}, "depth-fighting"};
    Params& params = desk.session.params;

    /// Returns the distance from the back quad of the first pair to its front quad, along their normal.
    double gap() const {
        const std::vector<SceneObject>& objects = desk.session.scene().objects;
        const glm::dmat4& back = objects.at(0).world_from_model;
        return glm::dot(glm::dvec3(objects.at(1).world_from_model[3] - back[3]), glm::normalize(glm::dvec3(back[1])));
    }
};

TEST_F(CoplanarTest, IsRebuiltImmediatelyWithoutLoading) {
    EXPECT_NEAR(gap(), 0.01, 1e-12);
    const int version = desk.session.scene_version();
    params.coplanar.gap = 0.05;
    desk.session.update_scene();
    EXPECT_NEAR(gap(), 0.05, 1e-12);
    EXPECT_EQ(desk.session.scene_version(), version + 1);
    EXPECT_FALSE(desk.session.loading_fraction());
    desk.ui.frames(3);
    EXPECT_EQ(desk.session.scene_version(), version + 1) << "rebuilt once per change";
    params.coplanar.distance = 8.0;
    desk.ui.frame();
    EXPECT_EQ(desk.session.scene().objects.at(0).description.name, "back quad at 8");
}

TEST_F(CoplanarTest, UndoRestoresTheScene) {
    desk.settle();
    params.coplanar.gap = 0.05;
    desk.ui.frames(3);
    ASSERT_TRUE(desk.session.can_undo());
    desk.undo();
    EXPECT_EQ(params.coplanar.gap, 0.01);
    EXPECT_NEAR(gap(), 0.01, 1e-12);
    EXPECT_FALSE(desk.session.can_undo());
    desk.redo();
    EXPECT_NEAR(gap(), 0.05, 1e-12);
}

TEST_F(CoplanarTest, OtherScenesAreUnaffected) {
    params.scene = std::string("decals");
    desk.settle();
    const int version = desk.session.scene_version();
    params.coplanar.gap = 0.5;
    desk.ui.frames(3);
    EXPECT_EQ(desk.session.scene_version(), version);
    params.scene = std::string("coplanar");
    desk.settle();
    EXPECT_NEAR(gap(), 0.5, 1e-12);
}

}  // namespace
}  // namespace viewing::test
