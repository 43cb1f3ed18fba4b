// Tests snapshot, inspect, compare and doctor, and the message of `open` when there is no display.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "cli/program.h"
#include "image/png.h"

namespace cli_tests {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// Hides every EGL driver, as on a machine without Mesa.
const Surroundings without_gl{.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}};

class Snapshot : public Program {
protected:
    /// Returns the arguments for a small camera picture, followed by `more`.
    Words small(const std::string& output, const Words& more = {}) const {
        Words words{"snapshot", "--view", "camera", "--size", "96x64", "-o", output};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    Surroundings with_broken_shaders() const;

    /// Returns width and height from the file's header.
    std::pair<int, int> png_size(const std::string& name) const {
        const std::string bytes = read(name);
        EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
        if (bytes.size() < 24) return {0, 0};
        const auto number = [&bytes](std::size_t at) {
            int value = 0;
            for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[i]);
            return value;
        };
        return {number(16), number(20)};
    }
};
class Compare : public Snapshot {};
class Inspect : public Program {};
class Doctor : public Program {};
class Open : public Program {};

TEST_F(Snapshot, DepthAsNumbersIsWhatInspectReads) {
    for (const char* format : {"d16", "d24", "d32f"}) {
        const std::string set = std::string("depth.format=") + format;
        expect(0, {"snapshot", "--view", "depth", "--size", "96x64", "--set", set, "-o", "z.npy"});
        const std::string npy = read("z.npy");
        ASSERT_EQ(npy.size(), 128U + 8U * 96U * 64U);
        for (const auto& [x, y] : {std::pair(48, 32), {48, 60}, {1, 1}}) {
            double depth = 0.0;
            std::memcpy(&depth, npy.data() + 128 + 8 * (96 * y + x), sizeof depth);
            const std::string pixel = std::to_string(x) + "," + std::to_string(y);
            const Json told = expect(0, {"inspect", "--size", "96x64", "--set", set, "--pixel", pixel}).json();
            EXPECT_EQ(depth, told["depth"]["window"].get<double>()) << format << " " << pixel;
        }
    }
    expect(0, {"snapshot", "--view", "depth", "--size", "96x64", "-o", "z.pfm"});
    expect(0, {"snapshot", "--view", "depth", "--size", "96x64", "-o", "z16.png"});
    EXPECT_EQ(png_size("z16.png"), std::pair(96, 64));
    EXPECT_EQ(read("z16.png")[24], 16);
    refused({"snapshot", "--view", "camera", "-o", "c.npy"}, {"-o", "--view depth"});
}

TEST_F(Snapshot, EveryViewHasItsSize) {
    for (const char* view : {"window", "camera", "depth", "stencil", "observer"}) {
        const std::string name = std::string(view) + ".png";
        const Ended run = expect(0, {"snapshot", "--view", view, "--size", "400x300", "-o", name, "--fail-if-blank"});
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(png_size(name), std::pair(400, 300)) << view;
    }
    EXPECT_NE(read("camera.png"), read("depth.png"));
    EXPECT_NE(read("depth.png"), read("stencil.png"));
    expect(0, {"snapshot", "--view", "camera", "-o", "default.png"});
    EXPECT_EQ(png_size("default.png"), std::pair(1280, 720));
}

TEST_F(Snapshot, IsReproducible) {
    for (const char* view : {"camera", "window"}) {
        expect(0, {"snapshot", "--view", view, "--size", "400x300", "-o", "a.png"});
        expect(0, {"snapshot", "--view", view, "--size", "400x300", "-o", "b.png"});
        EXPECT_EQ(read("a.png"), read("b.png")) << view;
    }
    expect(0, small("a.png", {"--repeat", "3"}));
    expect(0, small("b.png"));
    EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(Snapshot, PrintedStateGivesTheSamePicture) {
    const Words settings{"--set", "camera.yaw=20.125", "--set", "shadow.color=\"#102030\""};
    Words words = small("direct.png", settings);
    expect(0, words);
    Words printing{"state"};
    printing.insert(printing.end(), settings.begin(), settings.end());
    const std::string state = expect(0, printing).out;
    expect(0, small("piped.png", {"-"}), {.input = state});
    EXPECT_EQ(read("direct.png"), read("piped.png"));
}

TEST_F(Snapshot, CarriesItsState) {
    write("mine.json", R"({"plane": {"equation": [0.2, 1, 0, 0.1]}})");
    expect(0, {"snapshot", "mine.json", "--set", "shadow.opacity=0.25", "--size", "64x36", "--view", "camera", "-o",
               "a.png"});
    const std::string state = expect(0, {"state", "mine.json", "--set", "shadow.opacity=0.25"}).out;
    EXPECT_EQ(expect(0, {"state", "a.png"}).out, state);
    expect(0, {"snapshot", "a.png", "--size", "64x36", "--view", "camera", "-o", "b.png"});
    EXPECT_EQ(read("a.png"), read("b.png"));
    expect(0, {"compare", "a.png", "b.png", "-o", "difference.png"});
    refused({"state", "difference.png"}, {"difference.png", "contains no state"});
    write("broken.png", "no picture");
    refused({"state", "broken.png"}, {"broken.png", "not a PNG file"});
}

TEST_F(Snapshot, SettingsChangeThePicture) {
    expect(0, small("a.png"));
    expect(0, small("b.png", {"--set", "camera.yaw=20"}));
    expect(0, small("c.png", {"--samples", "0"}));
    EXPECT_NE(read("a.png"), read("b.png"));
    EXPECT_NE(read("a.png"), read("c.png"));
    expect(0, small("d.png", {"--set", "view.samples=0"}));
    EXPECT_EQ(read("c.png"), read("d.png"));
}

TEST_F(Snapshot, GoesToStandardOutput) {
    expect(0, small("a.png"));
    EXPECT_EQ(expect(0, small("-")).out, read("a.png"));
}

TEST_F(Snapshot, ReportsAsJson) {
    const Json report = expect(0, small("a.png", {"--json", "-"})).json();
    EXPECT_EQ(report.at("view"), "camera");
    EXPECT_EQ(report.at("size"), Json::parse("[96, 64]"));
    EXPECT_EQ(report.at("status"), 0);
    EXPECT_FALSE(report.at("renderer").get<std::string>().empty());
    expect(0, small("b.png", {"--json", "report.json"}));
    expect(0, small("b.png", {"--json", "again.json"}));
    Json once = Json::parse(read("report.json")), again = Json::parse(read("again.json"));
    EXPECT_GT(once.at("duration_s"), 0.0);
    once.erase("duration_s");
    again.erase("duration_s");
    EXPECT_EQ(once, again);
    EXPECT_EQ(once.at("output"), "b.png");
    const Json problem = expect(0, small("c.png", {"--json", "-", "--set", "light.position=[3,0,1,1]"})).json();
    EXPECT_FALSE(problem.at("problems").empty());
}

TEST_F(Snapshot, ComparesWithAReference) {
    expect(0, small("reference.png"));
    EXPECT_EQ(expect(0, small("a.png", {"--compare", "reference.png"})).out.find("equal"), 0U);
    const Ended different = run(small("b.png", {"--compare", "reference.png", "--set", "camera.yaw=20"}));
    EXPECT_EQ(different.status, 1) << different.told();
    EXPECT_EQ(different.out.find("different"), 0U);
    EXPECT_TRUE(exists("b.png"));
    const Ended report = run({"snapshot", "--view", "camera", "--size", "96x64", "--compare", "reference.png", "--set",
                              "camera.yaw=20", "--json", "-"});
    EXPECT_EQ(report.status, 1) << report.told();
    EXPECT_EQ(report.json().at("compare").at("equal"), false);
    expect(0, small("b.png", {"--compare", "reference.png", "--set", "camera.yaw=20", "--worst", "255"}));
    expect(0, small("b.png", {"--compare", "reference.png", "--set", "camera.yaw=20", "--share", "1"}));
}

TEST_F(Snapshot, AMissingReferenceExitsWithSix) {
    const Ended run = expect(6, small("a.png", {"--compare", "missing.png"}));
    EXPECT_NE(run.err.find("missing.png"), std::string::npos);
    EXPECT_TRUE(exists("a.png"));
    write("broken.png", "no picture");
    refused(small("b.png", {"--compare", "broken.png"}), {"broken.png"});
}

TEST_F(Snapshot, ABlankPictureExitsWithFiveOnRequest) {
    const Words sky{"--set", "camera.pitch=90"};
    expect(0, small("sky.png", sky));
    Words asked = sky;
    asked.emplace_back("--fail-if-blank");
    expect(5, small("blank.png", asked));
    EXPECT_FALSE(exists("blank.png"));
    expect(0, small("a.png", {"--fail-if-blank"}));
}

TEST_F(Snapshot, WithoutAContextExitsWithThree) {
    const Ended run = expect(3, small("a.png"), without_gl);
    EXPECT_NE(run.err.find("install"), std::string::npos) << run.told();
    EXPECT_EQ(files(), 0U);
}

TEST_F(Snapshot, BadInputIsReportedBeforeTouchingGl) {
    expect(2, small("a.png", {"--set", "projection.near=0"}), without_gl);
    expect(2, small("missing/a.png"), without_gl);
}

/// Mesa can write its shaders to files and read replacements for them. These replacements do not compile.
Surroundings Snapshot::with_broken_shaders() const {
    const std::string shaders = (folder() / "shaders").string();
    std::filesystem::create_directory(shaders);
    run(small("discarded.png"),
        {.environment = {{"MESA_SHADER_DUMP_PATH", shaders}, {"MESA_SHADER_CACHE_DISABLE", "true"}}});
    std::filesystem::remove(folder() / "discarded.png");
    for (const auto& shader : std::filesystem::directory_iterator(shaders))
        write("shaders/" + shader.path().filename().string(), "broken");
    return {.environment = {{"MESA_SHADER_READ_PATH", shaders}, {"MESA_SHADER_CACHE_DISABLE", "true"}}};
}

TEST_F(Snapshot, RejectedShadersExitWithFour) {
    const Surroundings broken = with_broken_shaders();
    if (std::filesystem::is_empty(folder() / "shaders")) GTEST_SKIP() << "this driver does not let shaders be replaced";
    const Ended ended = run(small("a.png"), broken);
    EXPECT_EQ(ended.status, 4) << ended.told();
    EXPECT_NE(ended.err.find("shader"), std::string::npos) << ended.told();
    EXPECT_FALSE(exists("a.png"));
    EXPECT_EQ(run({"inspect", "--pixel", "0,0"}, broken).status, 4);
    EXPECT_EQ(run({"doctor"}, broken).status, 4);
}

TEST_F(Snapshot, OutOfTimeExitsWithEight) {
    const Ended early = expect(8, small("a.png", {"--timeout", "0.001"}));
    EXPECT_NE(early.err.find("0.001 s"), std::string::npos) << early.told();
    expect(8, small("a.png", {"-", "--timeout", "0.3"}), {.input_stays_open = true});
    EXPECT_EQ(files(), 0U);
    expect(0, small("a.png", {"--timeout", "60"}));
}

TEST_F(Snapshot, APipeThatNobodyReadsRunsOutOfTime) {
    ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
    expect(8, small("pipe", {"--timeout", "2"}));
}

TEST_F(Snapshot, AnUnwritableOutputLeavesNothing) {
    refused(small("missing/a.png"), {"missing/a.png", "cannot be written"});
    refused(small("."), {"directory"});
    refused(small(""), {"file name"});
    refused(small("/proc/a.png"), {"/proc/a.png"});
    refused(small("a.png", {"--json", "missing/report.json"}), {"missing/report.json"});
}

TEST_F(Snapshot, AFullDiskIsNoticed) {
    expect(2, small("-"), {.output = "/dev/full"});
    expect(2, small("/dev/full"));
    expect(2, {"state"}, {.output = "/dev/full"});
    expect(2, small("a.png", {"--json", "/dev/full"}));
    EXPECT_EQ(files(), 0U) << "no picture is left without its report";
}

TEST_F(Snapshot, AFailedPictureKeepsTheOldFile) {
    write("a.png", "precious");
    expect(5, small("a.png", {"--set", "camera.pitch=90", "--fail-if-blank"}));
    EXPECT_EQ(read("a.png"), "precious");
    EXPECT_EQ(files(), 1U);
}

TEST_F(Snapshot, WorksInAReadOnlyFolderWithoutAHome) {
    const Surroundings bare{.folder = "/proc", .without = {"HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}};
    expect(0, small((folder() / "a.png").string()), bare);
    expect(0, {"snapshot", "--size", "400x300", "-o", (folder() / "window.png").string()}, bare);
    expect(0, {"matrices"}, bare);
    EXPECT_EQ(files(), 2U);
}

TEST_F(Snapshot, ADeviceCanBeChosen) {
    expect(0, small("a.png", {"--device", "0"}));
    expect(0, small("b.png", {"--device", "auto"}));
    refused(small("c.png", {"--device", "99"}), {"--device"});
}

TEST_F(Compare, SaysInOneLineWhetherPicturesAreEqual) {
    expect(0, small("a.png"));
    expect(0, small("b.png", {"--set", "camera.yaw=20"}));
    EXPECT_EQ(expect(0, {"compare", "a.png", "a.png"}).out.find("equal"), 0U);
    const Ended different = run({"compare", "a.png", "b.png", "-o", "difference.png"});
    EXPECT_EQ(different.status, 1) << different.told();
    EXPECT_EQ(different.out.find("different"), 0U);
    EXPECT_EQ(std::ranges::count(different.out, '\n'), 1);
    EXPECT_EQ(png_size("difference.png"), std::pair(96, 64));
    expect(0, {"compare", "a.png", "b.png", "--share", "1"});
}

TEST_F(Compare, ReportsAsJson) {
    expect(0, small("a.png"));
    expect(0, {"snapshot", "--view", "camera", "--size", "90x64", "-o", "b.png"});
    const Ended result = run({"compare", "a.png", "b.png", "--json", "-"});
    EXPECT_EQ(result.status, 1) << result.told();
    EXPECT_EQ(result.json().at("equal"), false);
    EXPECT_EQ(result.json().at("sizes_differ"), true);
    EXPECT_EQ(result.json().at("size_b"), Json::parse("[90, 64]"));
}

TEST_F(Compare, FilesThatCannotBeReadAreBadInput) {
    expect(0, small("a.png"));
    refused({"compare", "a.png", "missing.png"}, {"missing.png"});
    refused({"compare", "missing.png", "a.png"}, {"missing.png"});
    write("broken.png", read("a.png").substr(0, 200));
    refused({"compare", "a.png", "broken.png"}, {"broken.png"});
    refused({"compare", "a.png", "a.png", "-o", "missing/difference.png"}, {"missing/difference.png"});
}

TEST_F(Inspect, HasTheDocumentedFields) {
    const Json report = expect(0, {"inspect", "--pixel", "640,360"}).json();
    EXPECT_EQ(report.at("pixel"), Json::parse("[640, 360]"));
    EXPECT_EQ(report.at("color").get<std::string>().size(), 7U);
    const Json& depth = report.at("depth");
    for (const char* name : {"window", "stored", "bits", "ndc", "eye_z", "step"})
        EXPECT_TRUE(depth.at(name).is_number()) << name;
    EXPECT_EQ(depth.at("bits"), 24);
    EXPECT_NEAR(depth.at("stored").get<double>(), depth.at("window").get<double>() * 16777215.0, 1.0);
    // The window depth at eye distance z is d = f/(f−n) − f n/((f−n) z), with near 0.5 and far 40.
    const double distance = -depth.at("eye_z").get<double>();
    EXPECT_NEAR(depth.at("window").get<double>(), 40.0 / 39.5 - 40.0 * 0.5 / (39.5 * distance), 1e-6);
    EXPECT_TRUE(report.at("stencil").is_number_integer());
    EXPECT_TRUE(report.at("object").is_string());
    EXPECT_TRUE(report.at("facing") == "front" || report.at("facing") == "back");
    EXPECT_EQ(report.at("world").size(), 3U);
}

TEST_F(Inspect, ListsTheFragmentsInDrawingOrder) {
    // At this pixel the torus is in front of the patch and shows a front and a back face.
    const auto report = nlohmann::ordered_json::parse(expect(0, {"inspect", "--pixel", "640,360"}).out);
    EXPECT_EQ(std::next(report.end(), -1).key(), "fragments");
    const auto& fragments = report.at("fragments");
    ASSERT_EQ(fragments.size(), 3U);
    EXPECT_EQ(fragments[0].at("object"), "plane");
    const nlohmann::ordered_json* last = nullptr;
    for (const auto& fragment : fragments) {
        std::string names;
        for (const auto& [name, value] : fragment.items()) names += name + " ";
        EXPECT_EQ(names, "object eye_z stored within facing passes drawn ");
        if (fragment.at("drawn") == true) last = &fragment;
    }
    ASSERT_NE(last, nullptr);
    EXPECT_EQ(last->at("object"), report.at("object"));
    EXPECT_EQ(last->at("facing"), report.at("facing"));
    EXPECT_NEAR(last->at("stored").get<double>(), report.at("depth").at("stored").get<double>(), 4.0);
    EXPECT_NEAR(last->at("eye_z").get<double>(), report.at("depth").at("eye_z").get<double>(), 1e-4);
}

TEST_F(Inspect, ReportsTiesAndCulledSurfaces) {
    const std::string twice = R"(scene={"objects":[
        {"name":"first","shape":"quad","rotation":[0,90,0],"position":[0,0,-2]},
        {"name":"second","shape":"quad","rotation":[0,90,0],"position":[0,0,-2]},
        {"name":"back","shape":"quad","rotation":[0,-90,0],"position":[0,0,-1]}]})";
    const Json fragments = expect(0, {"inspect", "--pixel", "32,32", "--size", "64x64", "--set", twice, "--set",
                                      "camera.position=[0,0,0]", "--set", "camera.yaw=0", "--set", "camera.pitch=0",
                                      "--set", "plane.equation=[0,1,0,5]", "--set", "cull.enabled=true"})
                               .json()
                               .at("fragments");
    ASSERT_EQ(fragments.size(), 3U);
    EXPECT_TRUE(fragments[0].at("drawn") == true && !fragments[0].contains("tie"));
    EXPECT_TRUE(fragments[1].at("tie") == true && fragments[1].at("passes") == false);
    EXPECT_TRUE(fragments[2].at("culled") == true && fragments[2].at("facing") == "back");
}

TEST_F(Inspect, ListsTheSurfacesThatAMethodSorted) {
    const auto inspected = [this](const std::string& method) {
        return expect(0, {"inspect", "--pixel", "160,90", "--size", "320x180", "--set", "visibility.method=" + method})
            .json();
    };
    for (const char* method : {"painter", "bsp", "ray_cast"}) {
        const Json report = inspected(method);
        std::string last;
        for (const Json& fragment : report.at("fragments"))
            if (fragment.at("drawn") == true) last = fragment.at("object");
        EXPECT_EQ(last, report.at("object").get<std::string>()) << method;
    }
}

TEST_F(Inspect, TheColorIsThatOfThePicture) {
    for (const char* shows : {"color", "depth", "stencil", "facing", "overdraw", "difference", "fighting"}) {
        SCOPED_TRACE(shows);
        const Words state{"coplanar", "--set", "visibility.method=painter", "--set", std::string("view.shows=") + shows,
                          "--size",   "64x48"};
        Words drawing{"snapshot", "--view", "camera", "--samples", "0", "-o", "camera.png"};
        drawing.insert(drawing.end(), state.begin(), state.end());
        expect(0, drawing);
        const viewing::Image picture = *viewing::read_png(folder() / "camera.png");
        Words inspecting{"inspect"};
        inspecting.insert(inspecting.end(), state.begin(), state.end());
        std::vector<std::string> expected;
        for (int y = 3; y < 48; y += 11)
            for (int x = 2; x < 64; x += 9) {
                inspecting.insert(inspecting.end(), {"--pixel", std::to_string(x) + "," + std::to_string(y)});
                const std::uint8_t* const color = picture.pixel(x, y);
                char text[8];
                std::snprintf(text, sizeof text, "#%02x%02x%02x", color[0], color[1], color[2]);
                expected.emplace_back(text);
            }
        const Json report = expect(0, inspecting).json();
        std::vector<std::string> found;
        for (const Json& pixel : report) found.push_back(pixel.at("color"));
        EXPECT_EQ(found, expected);
    }
}

TEST_F(Inspect, TakesSeveralPixelsInOneRun) {
    const auto inspected = [this](Words words) {
        words.insert(words.begin(), {"inspect", "--size", "64x48"});
        return expect(0, words).json();
    };
    const Json a = inspected({"--pixel", "3,4"}), b = inspected({"--pixel", "32,30"});
    EXPECT_TRUE(a.is_object());
    EXPECT_EQ(inspected({"--pixel", "3,4", "--pixel", "32,30"}), Json::array({a, b}));
    write("pixels.txt", "32,30\r\n\n3,4\n");
    EXPECT_EQ(inspected({"--pixels", "pixels.txt", "--pixel", "3,4"}), Json::array({a, b, a}));
    write("one.txt", "3,4");
    EXPECT_EQ(inspected({"--pixels", "one.txt"}), Json::array({a}));
    write("none.txt", "");
    EXPECT_EQ(inspected({"--pixels", "none.txt"}), Json::array());
    EXPECT_EQ(expect(0, {"inspect", "--size", "64x48", "--pixels", "-"}, {.input = "3,4\n"}).json(), Json::array({a}));
    write("bad.txt", "3,4\n64,4\n");
    refused({"inspect", "--size", "64x48", "--pixels", "bad.txt"}, {"--pixels: line 2", "64,4", "0 to 63"});
    refused({"inspect", "--pixels", "missing.txt"}, {"missing.txt: no such file"});
    refused({"inspect", "-", "--pixels", "-"}, {"standard input"});
}

TEST_F(Inspect, ReportsTheSameSurfaceWhateverTheColorsShow) {
    const auto inspected = [this](const std::string& setting) {
        return expect(0, {"inspect", "--pixel", "160,90", "--size", "320x180", "--set", "visibility.method=painter",
                          "--set", setting})
            .json();
    };
    Json expected = inspected("view.shows=color");
    expected.erase("color");
    for (const char* setting : {"view.shows=overdraw", "view.shows=difference", "view.shows=fighting"}) {
        Json found = inspected(setting);
        found.erase("color");
        EXPECT_EQ(found, expected) << setting;
    }
}

TEST_F(Inspect, TheBackgroundIsNoObject) {
    const Json report = expect(0, {"inspect", "--pixel", "0,0", "--size", "64x64", "--set", "camera.pitch=90"}).json();
    EXPECT_TRUE(report.at("fragments").empty());
    EXPECT_TRUE(report.at("object").is_null());
    EXPECT_EQ(report.at("depth").at("window"), 1.0);
    EXPECT_EQ(report.at("depth").at("stored"), 16777215);
}

TEST_F(Inspect, ReportsNoEyeDepthWhereNoDepthWasWritten) {
    const auto at_centre = [this](const std::string& setting) {
        return expect(0, {"inspect", "--pixel", "32,32", "--size", "64x64", "--set", setting}).json();
    };
    for (const char* setting : {"depth.test=false", "depth.write=false"}) {
        SCOPED_TRACE(setting);
        const Json report = at_centre(setting);
        EXPECT_TRUE(report.at("object").is_string());
        EXPECT_EQ(report.at("depth").at("window"), 1.0);
        EXPECT_TRUE(report.at("depth").at("eye_z").is_null() && report.at("depth").at("step").is_null());
        EXPECT_TRUE(report.at("world").is_null());
    }
    EXPECT_TRUE(at_centre("depth.mapping=reversed").at("world").is_array());
}

TEST_F(Inspect, ThePlaneIsAnObject) {
    const Json report = expect(0, {"inspect", "--pixel", "32,32", "--size", "64x64", "--set", R"(scene={"objects":[]})",
                                   "--set", "depth.format=d16"})
                            .json();
    EXPECT_EQ(report.at("object"), "plane");
    EXPECT_EQ(report.at("depth").at("bits"), 16);
    EXPECT_NEAR(report.at("world")[1].get<double>(), 0.0, 1e-2);
}

TEST_F(Doctor, ReportsStepByStep) {
    const std::string text = expect(0, {"doctor"}).out;
    for (const char* step : {"EGL library", "devices", "context", "OpenGL", "shaders", "assets", "display"})
        EXPECT_NE(text.find(step), std::string::npos) << step << "\n" << text;
    const Json json = expect(0, {"doctor", "--json"}).json();
    EXPECT_EQ(json.at("fine"), true);
    EXPECT_GT(json.at("steps").size(), 5U);
    EXPECT_NE(text.find("24-bit depth"), std::string::npos) << text;
    EXPECT_EQ(json.at("depth").at("d32f").at("float"), true);
    EXPECT_GT(json.at("depth").at("d24").at("offset_unit_codes").get<double>(), 0.0);
}

TEST_F(Doctor, ListsFilesLeftByAKilledProgram) {
    EXPECT_EQ(expect(0, {"doctor"}).out.find("left behind"), std::string::npos);
    write(".viewing-sandbox-1.partial", "");
    const std::string text = expect(0, {"doctor"}).out;
    EXPECT_NE(text.find(".viewing-sandbox-1.partial"), std::string::npos) << text;
}

TEST_F(Doctor, WorksWithoutGlAndSaysWhatToInstall) {
    const Ended text = run({"doctor"}, without_gl);
    EXPECT_EQ(text.status, 3) << text.told();
    EXPECT_NE(text.out.find("libgl1-mesa-dri"), std::string::npos) << text.told();
    const Ended json = run({"doctor", "--json"}, without_gl);
    EXPECT_EQ(json.status, 3);
    EXPECT_EQ(json.json().at("fine"), false);
}

/// Returns a step from the output of `doctor --json`.
Json step_of(const Ended& doctor, const std::string& name) {
    const Json report = doctor.json();
    for (const Json& step : report.at("steps"))
        if (step.at("step") == name) return step;
    return {};
}

TEST_F(Doctor, FailsWithoutAssetsAndSaysWhy) {
    std::filesystem::create_directories(folder() / "half" / "presets");
    write("half/presets/a.json", "{}");
    const std::map<std::string, std::string> said{
        {"/nowhere", "the assets are in /nowhere, which is not a folder"},
        {folder().string(), "contains no presets, scenes, lessons, exercises"},
        {(folder() / "half").string(), "half, which contains no scenes, lessons, exercises"}};
    for (const auto& [place, sentence] : said) {
        const Surroundings elsewhere{.environment = {{"VIEWING_SANDBOX_ASSETS", place}}};
        const Ended doctor = run({"doctor", "--json"}, elsewhere);
        EXPECT_EQ(doctor.status, 2) << doctor.told();
        EXPECT_EQ(doctor.json().at("fine"), false);
        const Json assets = step_of(doctor, "assets");
        EXPECT_EQ(assets.at("health"), "missing");
        EXPECT_NE(assets.at("found").get<std::string>().find(sentence), std::string::npos) << assets;
        EXPECT_NE(assets.at("found").get<std::string>().find("VIEWING_SANDBOX_ASSETS"), std::string::npos) << assets;
        EXPECT_NE(run({"doctor"}, elsewhere).out.find("presets and scenes are missing"), std::string::npos);
    }
    // A lone copy of the program has no assets folder beside it, and no variable is set.
    std::filesystem::copy_file(std::getenv("VIEWING_SANDBOX"), folder() / "alone");
    const std::string command = "env -u VIEWING_SANDBOX_ASSETS '" + (folder() / "alone").string() +
                                "' doctor --json > '" + (folder() / "told").string() + "'";
    const int ended = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(ended), 2);
    EXPECT_NE(read("told").find("there is neither an assets folder beside the program"), std::string::npos)
        << read("told");
    EXPECT_NE(expect(0, {"doctor", "--help"}).out.find("VIEWING_SANDBOX_ASSETS"), std::string::npos);
    refused({"state", "teapot"}, {"VIEWING_SANDBOX_ASSETS says that the assets are in /nowhere"},
            {.environment = {{"VIEWING_SANDBOX_ASSETS", "/nowhere"}}});
}

TEST_F(Doctor, ReportsADriverThatOffersNoSuitableContext) {
    const Surroundings old{.environment = {{"MESA_GL_VERSION_OVERRIDE", "2.1"}}};
    const Ended doctor = run({"doctor", "--json"}, old);
    if (doctor.status == 0) GTEST_SKIP() << "this driver does not pretend to be older";
    EXPECT_EQ(doctor.status, 3) << doctor.told();
    const Json context = step_of(doctor, "context");
    EXPECT_NE(context.at("found").get<std::string>().find("there is a driver, but EGL device"), std::string::npos);
    EXPECT_EQ(context.at("found").get<std::string>().find("offers neither"), std::string::npos);
    EXPECT_NE(context.at("advice").get<std::string>().find("MESA_GL_VERSION_OVERRIDE"), std::string::npos);
    expect(3, {"snapshot", "-o", "x.png"}, old);
}

TEST_F(Doctor, ReportsTheContextOfPictures) {
    // Removes the settings that make tests fast, so that each command has to choose its own.
    const Surroundings bare{.without = {"LP_NATIVE_VECTOR_WIDTH", "GALLIVM_PERF"}};
    const Json report =
        expect(0, {"snapshot", "--view", "camera", "--size", "32x32", "-o", "x.png", "--json", "-"}, bare).json();
    const Ended doctor = expect(0, {"doctor", "--json"}, bare);
    const auto has = [](const Json& step, const Json& part) {
        return step.at("found").get<std::string>().find(part.get<std::string>()) != std::string::npos;
    };
    EXPECT_TRUE(has(step_of(doctor, "OpenGL"), report.at("renderer"))) << doctor.out << report;
    EXPECT_TRUE(has(step_of(doctor, "OpenGL"), report.at("gl_version"))) << doctor.out << report;
    EXPECT_TRUE(has(step_of(doctor, "context"), report.at("device"))) << doctor.out << report;
}

TEST_F(Open, AnEmptyDisplayNameLeavesNoTrailingSpace) {
    const std::string error = expect(3, {"open"}, {.environment = {{"DISPLAY", ""}}}).err;
    EXPECT_NE(error.find("there is no display for a window ("), std::string::npos) << error;
    EXPECT_EQ(error.find(" )"), std::string::npos) << error;
}

TEST_F(Open, WithoutADisplayExitsWithThreeAndSuggestsSnapshot) {
    for (const Words& words : {Words{}, Words{"open"}, Words{"opening"}, Words{"--set", "projection.near=0.01"}}) {
        const Ended run = expect(3, words);
        EXPECT_NE(run.err.find("viewing-sandbox snapshot"), std::string::npos) << run.told();
    }
}

}  // namespace
}  // namespace cli_tests
