// How a session begins: with its own scene if that loads quickly, otherwise with the opening scene until the large mesh
// has loaded.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "session/session.h"

namespace viewing {
namespace {

/// An .obj file of `count` triangles side by side, deleted with this object.
struct MeshFile {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("viewing-begin-" + std::to_string(getpid()) + ".obj");
    MeshFile(int count, const char* end) {
        std::FILE* const file = std::fopen(path.c_str(), "w");
        for (int i = 0; i < count; ++i) std::fprintf(file, "v %d 0 0\nv %d 1 0\nv %d 0 1\nf -3 -2 -1\n", i, i, i + 1);
        std::fputs(end, file);
        std::fclose(file);
    }
    ~MeshFile() { std::filesystem::remove(path); }
    MeshFile(const MeshFile&) = delete;
    MeshFile& operator=(const MeshFile&) = delete;

    LoadedState state() const {
        LoadedState state;
        state.params.scene = path.string();
        state.scene_origin = "STATE";
        return state;
    }
};

constexpr int many = 300'000;

TEST(SessionBegin, SmallSceneIsReadyImmediately) {
    const MeshFile file(3, "");
    const Result<Session> session = Session::begin(file.state(), -1.0);
    ASSERT_TRUE(session) << session.error();
    EXPECT_FALSE(session->loading_fraction());
    ASSERT_EQ(session->scene().objects.size(), 1U);
    EXPECT_EQ(session->scene().objects[0].mesh->triangle_count(), 3U);
}

TEST(SessionBegin, EarlyErrorIsReportedImmediately) {
    const MeshFile file(1, "f 1 2 99\n");
    const Result<Session> session = Session::begin(file.state(), -1.0);
    ASSERT_FALSE(session);
    EXPECT_NE(session.error().find("STATE"), std::string::npos) << session.error();
}

TEST(SessionBegin, LargeMeshLoadsBehindTheOpeningScene) {
    const MeshFile file(many, "");
    Result<Session> session = Session::begin(file.state(), 0.0);
    ASSERT_TRUE(session) << session.error();
    EXPECT_TRUE(session->loading_fraction());
    EXPECT_EQ(session->loading_name(), file.path.string());
    EXPECT_GT(session->scene().objects.size(), 1U) << "the opening scene";
    session->finish_loading();
    EXPECT_FALSE(session->loading_fraction());
    ASSERT_EQ(session->scene().objects.size(), 1U);
    EXPECT_EQ(session->scene().objects[0].mesh->triangle_count(), static_cast<std::size_t>(many));
    EXPECT_FALSE(session->can_undo()) << "the session began with this scene";
}

TEST(SessionBegin, LargeBrokenMeshKeepsTheOpeningSceneAndReports) {
    const MeshFile file(many, "f 1 2 99999999\n");
    Result<Session> session = Session::begin(file.state(), 0.0);
    ASSERT_TRUE(session) << session.error();
    session->finish_loading();
    EXPECT_TRUE(session->message.is_error);
    EXPECT_NE(session->message.text.find("99999999"), std::string::npos) << session->message.text;
    EXPECT_EQ(session->params.scene, Params{}.scene);
    EXPECT_GT(session->scene().objects.size(), 1U);
}

}  // namespace
}  // namespace viewing
