// Tests what a script reads from `measure` about hidden-surface methods and depth fighting.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "cli/program.h"

namespace cli_tests {
namespace {

using Json = nlohmann::json;

class Measure : public Program {
protected:
    Json visibility(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "measure");
        arguments.insert(arguments.end(), {"--what", "visibility"});
        return expect(0, arguments).json();
    }
};

const std::vector<std::string> methods{"depth_buffer",          "none",    "painter", "newell", "bsp",
                                       "software_depth_buffer", "ray_cast"};
const std::vector<std::string> counters{
    "comparisons",   "swaps",          "splits",   "fragments", "tree_depth",
    "pixels_tested", "pixels_written", "overdraw", "rays",      "intersection_tests"};

TEST_F(Measure, VisibilityHasEveryMethodWithEveryNumberOrNull) {
    const Json measured = visibility({"--size", "160x90"});
    EXPECT_EQ(measured["scene"], "torus-and-boxes");
    EXPECT_EQ(measured["size"], Json({160, 90}));
    EXPECT_EQ(measured["polygons"], 4120) << "a torus of 64 · 32 · 2 triangles and two boxes of 12";
    ASSERT_EQ(measured["methods"].size(), methods.size());
    const std::map<std::string, std::set<std::string>> has{
        {"depth_buffer", {}},
        {"none", {}},
        {"painter", {"comparisons", "swaps", "pixels_tested", "pixels_written", "overdraw"}},
        {"newell", {"comparisons", "swaps", "splits", "fragments", "pixels_tested", "pixels_written", "overdraw"}},
        {"bsp", {"comparisons", "splits", "fragments", "tree_depth", "pixels_tested", "pixels_written", "overdraw"}},
        {"software_depth_buffer", {"pixels_tested", "pixels_written", "overdraw"}},
        {"ray_cast", {"pixels_tested", "pixels_written", "overdraw", "rays", "intersection_tests"}}};
    for (const std::string& name : methods) {
        SCOPED_TRACE(name);
        const Json& method = measured["methods"][name];
        EXPECT_GT(method["time_ms"].get<double>(), 0.0);
        EXPECT_EQ(method["build_ms"].is_number(), name == "bsp" || name == "ray_cast");
        for (const std::string& counter : counters) {
            ASSERT_TRUE(method.contains(counter)) << counter;
            EXPECT_EQ(method[counter].is_number(), has.at(name).contains(counter)) << counter;
        }
        EXPECT_TRUE(method["problem"].is_null());
        EXPECT_GE(method["wrong_pixels"].get<int>(), 0);
    }
    EXPECT_EQ(measured["methods"]["ray_cast"]["rays"], 160 * 90);
    EXPECT_EQ(measured["methods"]["ray_cast"]["wrong_pixels"], 0);
    // GL draws the pictures of these methods and rounds the positions of corners. Only that of software_depth_buffer is
    // computed pixel by pixel.
    EXPECT_LE(measured["methods"]["newell"]["wrong_pixels"], 2);
    EXPECT_LE(measured["methods"]["bsp"]["wrong_pixels"], 2);
    EXPECT_EQ(measured["methods"]["software_depth_buffer"]["wrong_pixels"], 0);
    EXPECT_LE(measured["methods"]["depth_buffer"]["wrong_pixels"], 2);
    EXPECT_GT(measured["methods"]["none"]["wrong_pixels"], 100);
    const Json& culling = measured["culling"];
    EXPECT_EQ(culling["before"], 4120);
    EXPECT_EQ(culling["by_plane"]["front"].get<int>() + culling["by_plane"]["back"].get<int>() +
                  culling["by_plane"]["edge_on"].get<int>(),
              4120);
    EXPECT_EQ(culling["by_plane"]["front"], culling["by_winding"]["front"]);
    EXPECT_EQ(culling["disagree"], 0);
    EXPECT_EQ(culling["after"], culling["by_plane"]["front"]);
}

TEST_F(Measure, VisibilityOfACycleMatchesTheLecture) {
    const Json measured = visibility({"painter-cycle", "--size", "160x90"});
    for (const char* key : {"nearest", "farthest", "centroid"}) EXPECT_GT(measured["painter_keys"][key], 20) << key;
    EXPECT_EQ(measured["methods"]["newell"]["wrong_pixels"], 0);
    EXPECT_GT(measured["methods"]["newell"]["splits"], 0);
}

TEST_F(Measure, OrderNamesTheCycleOfThreeBars) {
    const Json measured = expect(0, {"measure", "cyclic-overlap", "--what", "order"}).json();
    EXPECT_EQ(measured["scene"], "cyclic-overlap");
    const Json& objects = measured["objects"];
    EXPECT_EQ(objects["count"], 3);
    EXPECT_EQ(objects["exists"], false);
    EXPECT_TRUE(objects["order"].is_null());
    const auto cycle = objects["cycle"].get<std::vector<std::string>>();
    EXPECT_EQ(std::set<std::string>(cycle.begin(), cycle.end()),
              (std::set<std::string>{"red bar", "green bar", "blue bar"}));
    const Json& polygons = measured["polygons"];
    EXPECT_EQ(polygons["count"], 36) << "three boxes of 12";
    EXPECT_EQ(polygons["object"].size(), 36);
    for (const char* key : {"nearest", "farthest", "centroid"}) EXPECT_GT(polygons["painter_keys"][key], 0) << key;
}

TEST_F(Measure, OrderExistsForSeparateBoxes) {
    const std::string boxes =
        R"(scene={"objects":[{"name":"near","shape":"box","position":[0,1,3]},{"name":"far","shape":"box","position":[0,1,-3]}]})";
    const Json measured = expect(0, {"measure", "--set", "camera.position=[0,1,12]", "--set", "camera.yaw=0", "--set",
                                     "camera.pitch=0", "--set", boxes, "--what", "order"})
                              .json();
    EXPECT_EQ(measured["objects"]["pairs"], Json::parse(R"([["far", "near"]])"));
    EXPECT_EQ(measured["objects"]["order"], Json::parse(R"(["far", "near"])"));
    EXPECT_TRUE(measured["objects"]["cycle"].is_null());
    EXPECT_EQ(measured["polygons"]["painter_keys"]["farthest"], 0);
    EXPECT_NE(expect(2, {"measure", "--what", "order", "--device", "auto"}).err.find("order draws nothing"),
              std::string::npos);
}

/// The triangles are one behind the other, and each hides all triangles behind it.
TEST_F(Measure, OrderListsAtMostAMillionPairs) {
    const auto write_squares = [this](int count) {
        std::string mesh;
        for (int i = 0; i < count; ++i)
            for (const char* corner : {"-1 0 ", "1 0 ", "0 2 "})
                mesh += "v " + std::string(corner) + std::to_string(-0.001 * i) + "\n";
        for (int i = 0; i < count; ++i)
            mesh += "f " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " " +
                    std::to_string(3 * i + 3) + "\n";
        write("squares.obj", mesh);
    };
    write("state.json", R"({"scene": {"objects": [{"name": "squares", "shape": "mesh", "file": "squares.obj"}]},
        "camera": {"position": [0, 1, 9], "yaw": 0, "pitch": 0}})");
    write_squares(60);
    const Json measured = expect(0, {"measure", "state.json", "--what", "order"}).json();
    EXPECT_EQ(measured["polygons"]["pairs"].size(), 60 * 59 / 2);
    write_squares(1500);  // 1.12 million
    refused({"measure", "state.json", "--what", "order"}, {"a million pairs"});
}

TEST_F(Measure, PainterUsesTheStatesKey) {
    for (const char* key : {"nearest", "farthest", "centroid"}) {
        const Json measured = visibility({"--size", "160x90", "--set", std::string("visibility.sort_key=") + key,
                                          "--set", "visibility.step=2", "--set", "visibility.method=newell"});
        EXPECT_EQ(measured["methods"]["painter"]["wrong_pixels"], measured["painter_keys"][key]) << key;
        EXPECT_LE(measured["methods"]["newell"]["wrong_pixels"], 2) << "all steps, whatever the state's step";
    }
}

TEST_F(Measure, ExactCurvesAreComparedByObject) {
    const Json measured = visibility({"curved", "--size", "160x90", "--set", "visibility.exact_curves=true"});
    EXPECT_LT(measured["methods"]["ray_cast"]["wrong_pixels"], 100) << "only a few pixels of a curved shape are wrong";
    EXPECT_EQ(measured["methods"]["software_depth_buffer"]["wrong_pixels"], 0);
}

TEST_F(Measure, VisibilityOfNothingAndOfAnInlineScene) {
    const Json empty = visibility({"--size", "16x9", "--set", R"(scene={"objects":[]})"});
    EXPECT_EQ(empty["scene"], "inline");
    EXPECT_EQ(empty["polygons"], 0);
    for (const std::string& name : methods) EXPECT_EQ(empty["methods"][name]["wrong_pixels"], 0) << name;
}

TEST_F(Measure, GrowthHasARowForEveryMethodAndCount) {
    const Json measured = expect(0, {"measure", "--what", "growth", "--max", "50", "--size", "32x24"}).json();
    EXPECT_EQ(measured["polygons"], "small");
    EXPECT_TRUE(measured["scene"].is_null());
    EXPECT_EQ(measured["size"], Json({32, 24}));
    std::set<int> counts;
    for (const Json& row : measured["rows"]) {
        counts.insert(row["polygons"].get<int>());
        EXPECT_GT(row["time_ms"].get<double>(), 0.0);
        EXPECT_TRUE(row["problem"].is_null());
    }
    EXPECT_EQ(counts, (std::set<int>{10, 30, 50}));
    EXPECT_EQ(measured["rows"].size(), 3U * 6U);
    EXPECT_TRUE(measured["summary"].get<std::string>().starts_with("Methods with the fewest")) << measured["summary"];
    EXPECT_TRUE(measured["times"].get<std::string>().starts_with("Median times of several runs with 50 polygons"))
        << measured["times"];
}

TEST_F(Measure, WithoutTimesIsByteIdentical) {
    const std::vector<std::vector<std::string>> commands{
        {"measure", "--what", "growth", "--max", "100", "--size", "32x24", "--no-times"},
        {"measure", "--what", "growth", "--max", "100", "--size", "32x24", "--no-times", "--format", "csv"},
        {"measure", "cyclic-overlap", "--what", "visibility", "--size", "32x24", "--no-times"}};
    for (const std::vector<std::string>& command : commands) {
        const std::string first = expect(0, command).out;
        EXPECT_EQ(first, expect(0, command).out);
        EXPECT_EQ(first.find("_ms"), std::string::npos) << first;
    }
}

TEST_F(Measure, GrowthAsCsvHasALineForEveryRow) {
    const Ended ended = expect(0, {"measure", "--what", "growth", "--max", "10", "--size", "32x24", "--format", "csv"});
    std::istringstream lines(ended.out);
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line,
              "method,polygons,operation,operations,pixels_painted,problem,time_ms,time_least_ms,time_most_ms,runs,"
              "painting_ms,build_ms\r");
    int rows = 0;
    while (std::getline(lines, line)) ++rows;
    EXPECT_EQ(rows, 6);
}

TEST_F(Measure, GrowthUsesTheScenesPolygons) {
    const Json measured = expect(0, {"measure", "cyclic-overlap", "--what", "growth", "--polygons", "scene", "--max",
                                     "1000", "--size", "32x24"})
                              .json();
    EXPECT_EQ(measured["polygons"], "scene");
    EXPECT_EQ(measured["scene"], "cyclic-overlap");
    for (const Json& row : measured["rows"]) EXPECT_LE(row["polygons"], 100) << "the scene has no more polygons";
}

TEST_F(Measure, FightingHasEveryPairCountedAndPredicted) {
    const Json measured = expect(0, {"measure", "depth-fighting", "--what", "fighting", "--set", "depth.format=d16",
                                     "--set", "projection.near=0.5", "--size", "640x360"})
                              .json();
    ASSERT_EQ(measured["pairs"].size(), 6U);
    int wrong = 0, pixels = 0;
    for (const Json& pair : measured["pairs"]) {
        SCOPED_TRACE(pair.dump());
        const double z = pair["distance"], gap = pair["gap"];
        EXPECT_NEAR(gap, 0.01, 0.0002);
        // The step is z² (f − n) / (f n (2¹⁶ − 1)).
        EXPECT_NEAR(pair["step"], z * z * 999.5 / (1000.0 * 0.5 * 65535.0), 1e-6);
        EXPECT_NEAR(pair["predicted_onset_gap"], pair["quantisation"].get<double>() + pair["arithmetic"].get<double>(),
                    1e-12);
        EXPECT_GT(pair["pixels"], 1000);
        const double share = pair["wrong"].get<double>() / pair["pixels"].get<double>();
        const Json &said = pair["predicted_wrong_fraction"], &jittered = pair["trembling_wrong_fraction"];
        EXPECT_GE(share, said["least"]);
        EXPECT_LE(share, said["most"]);
        EXPECT_EQ(jittered["cameras"], 12);
        EXPECT_GE(jittered["standard_error"], 0.0);
        EXPECT_LE(jittered["standard_error"], (jittered["most"].get<double>() - jittered["least"].get<double>()));
        EXPECT_GE(jittered["mean"], jittered["least"]);
        EXPECT_LE(jittered["mean"], jittered["most"]);
        EXPECT_EQ(share > 0.0, gap < pair["predicted_onset_gap"]);
        wrong += pair["wrong"].get<int>();
        pixels += pair["pixels"].get<int>();
    }
    EXPECT_EQ(measured["pairs"][0]["objects"], Json({"back quad at 4", "front quad at 4"}));
    EXPECT_NEAR(measured["wrong_fraction"], static_cast<double>(wrong) / pixels, 1e-12);
    EXPECT_EQ(measured["elsewhere"]["wrong"], 0);
    const double ratio =
        measured["minimum_gap"].get<double>() / measured["search"]["predicted_onset_gap"].get<double>();
    EXPECT_GT(ratio, 1.0 / 3.0);
    EXPECT_LT(ratio, 3.0);
}

TEST_F(Measure, FightingOfNoPairsAndWithoutADepthTestHasNullsAndAReason) {
    const Json measured = expect(0, {"measure", "--what", "fighting", "--size", "16x9", "--set",
                                     R"(scene={"objects":[]})", "--set", "depth.test=false"})
                              .json();
    EXPECT_EQ(measured["pairs"], Json::array());
    EXPECT_EQ(measured["wrong_fraction"], 0.0);
    EXPECT_TRUE(measured["minimum_gap"].is_null());
    EXPECT_FALSE(measured["search"]["problem"].get<std::string>().empty());
}

TEST_F(Measure, MirrorHasEveryWayWithItsPictureAndDepths) {
    const Json measured = expect(0, {"measure", "mirror-unclipped", "--what", "mirror", "--size", "320x180"}).json();
    EXPECT_EQ(measured["scene"], "torus-and-boxes");
    EXPECT_EQ(measured["size"], Json({320, 180}));
    const std::vector<std::string> names{"clip distance", "no clipping", "oblique near plane", "mirrored camera"};
    ASSERT_EQ(measured["ways"].size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Json& way = measured["ways"][i];
        SCOPED_TRACE(way.dump());
        EXPECT_EQ(way["way"], names[i]);
        EXPECT_EQ(way["pixels"], 320 * 180);
        EXPECT_EQ(way["different"].get<int>() > 320 * 180 / 20, names[i] == "no clipping");
        EXPECT_EQ(way["different"] == 0, names[i] != "no clipping");
        EXPECT_EQ(way["worst"] == 0, way["different"] == 0);
        EXPECT_LE(way["worst"], 255);
        EXPECT_GT(way["image_pixels"], 500);
        EXPECT_GT(way["distinct_depths"], 100);
        EXPECT_GE(way["first_depth"], 0.0);
        EXPECT_LT(way["first_depth"], way["last_depth"]);
        EXPECT_LE(way["last_depth"], 1.0);
        EXPECT_EQ(way.size(), 8U);
    }
    EXPECT_LT(measured["ways"][2]["first_depth"], 0.001) << "the near plane is the mirror";
    const Json off =
        expect(0, {"measure", "--what", "mirror", "--size", "16x9", "--set", "reflection.enabled=false"}).json();
    for (const Json& way : off["ways"]) {
        EXPECT_EQ(way["different"], 0);
        EXPECT_EQ(way["image_pixels"], 0);
    }
}

TEST_F(Measure, RefusesUnknownQuantitiesAndListsAll) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"measure"}, {"measure", "--what", "miror"}})
        refused(arguments, {"visibility", "growth", "fighting", "mirror"});
}

TEST_F(Measure, EndsInTime) {
    const Ended ended = expect(8, {"measure", "--what", "growth", "--max", "1000000", "--timeout", "0.05"});
    EXPECT_NE(ended.err.find("--timeout"), std::string::npos);
    EXPECT_EQ(ended.out, "");
}

}  // namespace
}  // namespace cli_tests
