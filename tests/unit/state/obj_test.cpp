// Valid and broken Wavefront OBJ files.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "platform/sanitized.h"
#include "scratch_folder.h"
#include "state/scene.h"

namespace viewing {
namespace {

class Obj : public testing::ScratchFolder {
protected:
    ObjMesh read(const std::string& content) const {
        Result<ObjMesh> mesh = load_obj(write("m.obj", content));
        EXPECT_TRUE(mesh) << mesh.error();
        return mesh ? *mesh : ObjMesh{};
    }
    Mesh load(const std::string& content) const { return read(content).mesh; }

    /// Returns the notes on a readable file, without its name; "" if there are none.
    std::string notes(const std::string& content) const {
        const std::string opening = (folder_ / "m.obj").string() + ": ";
        std::string all;
        for (const std::string& note : read(content).notes) {
            EXPECT_EQ(note.substr(0, opening.size()), opening);
            all += (all.empty() ? "" : "|") + note.substr(opening.size());
        }
        return all;
    }

    /// Returns the message after the file name.
    std::string refusal(const std::string& content) const {
        const std::filesystem::path file = write("broken.obj", content);
        const Result<ObjMesh> mesh = load_obj(file);
        EXPECT_FALSE(mesh) << content;
        if (mesh) {
            return "";
        }
        const std::string opening = file.string() + ": ";
        EXPECT_EQ(mesh.error().substr(0, opening.size()), opening);
        EXPECT_EQ(mesh.error().find('\n'), std::string::npos);
        return mesh.error().substr(opening.size());
    }
};

/// Returns the area of all triangles and the signed area seen from +z (negative from behind).
std::pair<double, double> areas(const Mesh& mesh) {
    double area = 0.0;
    double seen = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 cross = glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                            glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a);
        area += glm::length(cross) / 2.0;
        seen += cross.z / 2.0;
    }
    return {area, seen};
}

constexpr const char* square = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n";

TEST_F(Obj, QuadsBecomeTwoTriangles) {
    const Mesh mesh = load(std::string(square) + "f 1 2 3 4\n");
    EXPECT_EQ(mesh.triangle_count(), 2U);
    EXPECT_EQ(mesh.positions.size(), 4U);
    ASSERT_EQ(mesh.normals.size(), 4U);
    EXPECT_NEAR(mesh.normals[0].z, 1.0, 1e-6) << "generated, since the file has none";
    const auto [area, seen] = areas(mesh);
    EXPECT_NEAR(area, 4.0, 1e-6) << "side 4 is scaled to side 2";
    EXPECT_NEAR(seen, 4.0, 1e-6);
    const Bounds bounds = bounds_of(mesh);
    EXPECT_NEAR(glm::length(bounds.center()), 0.0, 1e-6);
    EXPECT_NEAR(bounds.size().x, 2.0, 1e-6);
}

// An L with six corners covers 3 of the 4 cells of its 2 × 2 square. A fan would cover the notch.
TEST_F(Obj, ConcavePolygonsAreCutCorrectly) {
    const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
    for (const char* face : {"f 1 2 3 4 5 6", "f 2 3 4 5 6 1", "f 3 4 5 6 1 2", "f 4 5 6 1 2 3", "f 5 6 1 2 3 4"}) {
        const Mesh mesh = load(corners + face + "\n");
        EXPECT_EQ(mesh.triangle_count(), 4U);
        const auto [area, seen] = areas(mesh);
        EXPECT_NEAR(area, 3.0, 1e-6) << face;
        EXPECT_NEAR(seen, 3.0, 1e-6) << face;
    }
    const auto [area, seen] = areas(load(corners + "f 6 5 4 3 2 1\n"));
    EXPECT_NEAR(area, 3.0, 1e-6);
    EXPECT_NEAR(seen, -3.0, 1e-6) << "the winding is kept";
}

TEST_F(Obj, LargePolygonsAreFilled) {
    std::string content;
    std::string face = "f";
    constexpr int corners = 1000;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / corners;
        content += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const Mesh mesh = load(content + face + "\n");
    EXPECT_EQ(mesh.triangle_count(), 998U);
    EXPECT_NEAR(areas(mesh).first, 3.14159, 1e-3);
}

TEST_F(Obj, NegativeIndicesCountFromTheEnd) {
    const Mesh mesh = load("v 9 9 9\n" + std::string(square) + "f -4 -3 -2 -1\n");
    EXPECT_EQ(mesh.triangle_count(), 2U);
    EXPECT_EQ(mesh.positions.size(), 4U) << "an unused vertex does not count";
    EXPECT_NEAR(bounds_of(mesh).size().x, 2.0, 1e-6);
}

TEST_F(Obj, FacesMayComeBeforeTheirVertices) {
    EXPECT_EQ(load("f 1 2 3\n" + std::string(square)).triangle_count(), 1U);
}

TEST_F(Obj, NormalsOfTheFileAreUsed) {
    const std::string normals = "vn 0 3 4\nvn 1 0 0\n";
    const Mesh mesh = load(square + normals + "f 1//1 2//1 3//1\nf 1//1 3//2 4//1\n");
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.positions.size(), 5U) << "corner 3 has two normals";
    EXPECT_NEAR(mesh.normals[0].y, 0.6, 1e-6) << "scaled to length 1";
    EXPECT_NEAR(mesh.normals[0].z, 0.8, 1e-6);
    const Mesh partly = load(square + normals + "f 1//1 2//1 3//1\nf 1 3 4\n");
    ASSERT_EQ(partly.positions.size(), 6U);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(partly.normals[i].z, 0.8, 1e-6) << "kept beside a face without normals";
    for (int i = 3; i < 6; ++i) EXPECT_NEAR(partly.normals[i].z, 1.0, 1e-6) << "generated";
    const Mesh zero = load(std::string(square) + "vn 0 0 0\nf 1//1 2//1 3//1\n");
    EXPECT_NEAR(zero.normals[0].z, 1.0, 1e-6) << "a zero normal is replaced";
}

TEST_F(Obj, ToleratesTexturesCommentsAndLineEndings) {
    const Mesh mesh = load("# a comment\nmtllib nowhere.mtl\no thing\ng group\nusemtl red\ns off\nvt 0 0\nvt 1 0\n" +
                           std::string("v 0 0 0 # first\r\nv 1 0 0 1.0\r\n\r\n  v 0 1e0 -0.5E-1\r\nl 1 2\np 1\n") +
                           "\tf 1/1 2/2 3 # last");
    EXPECT_EQ(mesh.triangle_count(), 1U);
}

TEST_F(Obj, AcceptsALeadingByteOrderMark) {
    EXPECT_EQ(load("\xef\xbb\xbf" + std::string(square) + "f 1 2 3 4\n").triangle_count(), 2U);
    EXPECT_EQ(refusal("v 0 0 0\n\xef\xbb\xbfv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              "line 4: face 1 refers to vertex 3, but the file has 2")
        << "only at the beginning";
}

TEST_F(Obj, MessageQuotesOnlyTheWrongWord) {
    EXPECT_EQ(refusal("v 0 0 root:x:0:0:/root:/bin/sh secret\n"), "line 1: not a number: root:x:0:0:/root:/bi…");
    EXPECT_EQ(refusal("v 0 0 \xe2\x80\xae"
                      "1\x1b[2J\n"),
              "line 1: not a number: \\u202e1\\u001b[2J");
}

TEST_F(Obj, BrokenFilesAreRefusedInOneSentence) {
    EXPECT_EQ(refusal(""), "not an OBJ file, or an empty one: it has no vertices and no faces");
    EXPECT_EQ(refusal("hello\n"), "not an OBJ file, or an empty one: it has no vertices and no faces");
    EXPECT_EQ(refusal(square), "has only vertices (4) and no faces: nothing to shade");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 5\n"), "line 5: face 1 refers to vertex 5, but the file has 4");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 3\nf 1 2 -5\n"),
              "line 6: face 2 refers to vertex -5, which does not exist");
    EXPECT_EQ(refusal(std::string(square) + "f 0 1 2\n"), "line 5: face 1 refers to vertex 0, which does not exist");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2\n"), "line 5: a face with fewer than three corners");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 /3\n"), "line 5: not a corner of a face: /3");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 3/-\n"), "line 5: not a corner of a face: 3/-");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 3/1/1/1\n"), "line 5: not a corner of a face: 3/1/1/1");
    EXPECT_EQ(refusal(std::string(square) + "f a b c\n"), "line 5: not a corner of a face: a");
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 4294967297\n"), "line 5: not a corner of a face: 4294967297");
    for (const char* word : {"nan", "-NaN(ind)", "inf", "-Infinity", "1.#QNAN"})
        EXPECT_EQ(refusal("v 1 0 0\n# no number\nv 0 0 " + std::string(word) + "\nv 0 1 0\nf 1 2 3\n"),
                  "line 3: vertex 2 has a coordinate that is not a finite number");
    EXPECT_EQ(refusal("v 0 0\n"), "line 1: not three numbers");
    EXPECT_EQ(refusal("v 1-2 0 0\n"), "line 1: not a number: 1-2");
    EXPECT_EQ(refusal("v 1e 0 0\n"), "line 1: not a number: 1e");
    EXPECT_EQ(refusal("v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "line 1: vertex 1 has a coordinate beyond 1e12");
    EXPECT_EQ(refusal("v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "line 1: vertex 1 has a coordinate beyond 1e12");
    EXPECT_EQ(refusal(std::string(square) + "f 1 1 1\n"), "has no face with a nonzero area");
    EXPECT_EQ(refusal("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"), "has no face with a nonzero area");
    EXPECT_EQ(refusal("v 0 0 0\nv 1e-310 0 0\nv 0 1e-310 0\nf 1 2 3\n"),
              "is 1·10⁻³¹⁰ units across, but must be at least 1·10⁻³⁰⁰: scale its coordinates up");
    EXPECT_NE(refusal(std::string("\x7f"
                                  "ELF\0\0\1\2",
                                  8))
                  .find("binary data"),
              std::string::npos);
    EXPECT_NE(refusal(std::string((1U << 20U) + 500'000, 'x')).find("a line longer than 1 MiB"), std::string::npos);
    EXPECT_EQ(refusal(std::string(square) + "f 1 2 3\nv 1 2"), "line 6: not three numbers") << "truncated";
}

constexpr const char* ramp_faces[] = {"1 2 3 4", "1 4 6 5", "2 5 6 3", "1 5 2", "4 3 6"};
constexpr const char* ramp_vertices = "v 0 0 0\nv 5 0 0\nv 5 0 3\nv 0 0 3\nv 0 2 0\nv 0 2 3\n";

std::string ramp() {
    std::string text = ramp_vertices;
    for (const char* face : ramp_faces) text += "f " + std::string(face) + "\n";
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

void expect_same(const Mesh& a, const Mesh& b, const std::string& where) {
    EXPECT_EQ(a.positions, b.positions) << where;
    EXPECT_EQ(a.normals, b.normals) << where;
    EXPECT_EQ(a.indices, b.indices) << where;
}

// One mesh in the various forms that programs and people write.
TEST_F(Obj, HarmlessVariationsChangeNothing) {
    const std::string plain = ramp();
    const Mesh mesh = load(plain);
    ASSERT_EQ(mesh.triangle_count(), 8U);
    const std::string ways[] = {
        replaced(plain, "\n", "\r\n"),
        replaced(plain, "\n", "\r"),
        replaced(plain, "\n", "\n\r"),
        "# a comment\r" + replaced(plain, "\n", "\r"),
        replaced(plain, " 6", " \\\n6"),
        replaced(plain, " 6", " \\\r\n 6"),
        replaced(plain, " 6", "\\ \n6"),
        replaced(plain, "v 5 0 3", "v \\\n5 \\\n0 \\\n3"),
        "# ends in \\\n" + plain,
        "mtllib C:\\materials\\\n" + plain,
        replaced(plain, "f 1 2 3 4", "f 1// 2/ 3/7/ 4/-1/"),
        replaced(plain, "f 1 2 3 4", "f 1/12345678901234567890 2 3/0 4"),
        replaced(plain, "v 5 0 3", "v 5 0 3 0.2 nan 0.9"),
        replaced(plain, "v 5 0 3", "v 5 0 3 red"),
        replaced(plain, "v 5 0 3", "v 5.0 0 3# a corner"),
        replaced(plain, "v 5 0 3", "v 5." + std::string(100, '0') + " 0 300" + std::string(40, '0') + "e-42"),
        replaced(plain, "v 0 2 3\n", "v 0 2 3\nv nan 0 0\nv 1e30 1e999 0\n"),
        replaced(plain, "v 0 2 3\n", "v 0 2 3\nvn nan 0 0\nvn 1 1.#IND 0\nvn up\n"),
        replaced(plain, "f 1 2 3 4", "fo 1 2 3 4"),
        plain + "g \nusemtl\nlod 3\nbevel on\nvt nan\nvp 1 2\n",
    };
    for (const std::string& way : ways) {
        SCOPED_TRACE(way);
        EXPECT_EQ(notes(way), "");
        expect_same(load(way), mesh, way);
    }
    EXPECT_EQ(refusal(replaced(plain, "f 1 2 3 4", "f 1 2 3 4/1//")), "line 7: not a corner of a face: 4/1//");
}

TEST_F(Obj, LinesThatEndAtABlockAreReadCompletely) {
    const Mesh mesh = load(ramp());
    constexpr std::size_t block = 256U << 10U;
    for (const char* end : {"\n", "\r\n", "\r", " \\\n "}) {
        for (std::size_t at = block - 3; at <= block + 3; ++at) {
            const std::string comment = "#" + std::string(at - 12, 'x') + "\nv 0 0 0";
            const std::string rest = ramp().substr(8);
            const std::string text = std::string(end) == " \\\n "
                                         ? comment.substr(0, comment.size() - 2) + end + "0\n" + rest
                                         : comment + end + rest;
            expect_same(load(text), mesh, end);
            EXPECT_EQ(refusal(text + "f 1 2 9\n"), "line " +
                                                       std::to_string(13 + (std::string(end) == " \\\n " ? 1 : 0)) +
                                                       ": face 6 refers to vertex 9, but the file has 6");
        }
    }
}

TEST_F(Obj, MessagesNameTheFirstLineOfAStatement) {
    EXPECT_EQ(refusal("v 0 0 0\rv 1 0 0\r\n\nv 0 1 0\r\rf 1 2 x\r"), "line 6: not a corner of a face: x");
    EXPECT_EQ(refusal(ramp() + "f 1 \\\n2 \\\nx\n"), "line 12: not a corner of a face: x");
    EXPECT_EQ(refusal(ramp() + "\nf 1 2 \\\n7\nf 1 2 8\n"), "line 13: face 6 refers to vertex 7, but the file has 6");
    EXPECT_EQ(refusal(ramp() + "f 1 2 \\"), "line 12: a face with fewer than three corners");
    std::string far_apart = "v 0 0 0\nv 1 0 0\n#\n#\nv 0 1 0\nv 1 1 nan\nf 1 2 3\n#\nf 1 2 3\nf 1 2 4\n";
    EXPECT_EQ(refusal(far_apart), "line 6: vertex 4 has a coordinate that is not a finite number");
    EXPECT_EQ(refusal(replaced(far_apart, "f 1 2 4", "f 1 2 5")),
              "line 10: face 3 refers to vertex 5, but the file has 4");
    EXPECT_EQ(refusal("f 1 2 " + replaced(std::string(3U << 20U, 'x'), "xx", "\\\n")),
              "line 1: a line longer than 1 MiB")
        << "also by line continuation";
}

TEST_F(Obj, RefusalNamesTheContentOfTheFile) {
    const std::string vertices = ramp_vertices;
    EXPECT_EQ(refusal(vertices + "l 1 2 3 4 1\nl 5 6\n"), "has only lines (2) and no faces: nothing to shade");
    EXPECT_EQ(refusal(vertices + "p 1 2 3\np 4 5 6\n"), "has only points (2) and no faces: nothing to shade");
    EXPECT_EQ(refusal(vertices + "p 1\nl 5 6\nsurf 0 1 0 1 1 2 3 4\n"),
              "has only lines (1), points (1), curves and surfaces (1) and no faces: nothing to shade");
    EXPECT_EQ(refusal(vertices + "F 1 2 3\n"),
              "has only vertices (6) and no faces: nothing to shade; line 7: not understood: F 1 2 3");
}

TEST_F(Obj, NamesOtherEncodings) {
    const auto wide = [](const std::string& text, bool is_big_endian, int zeros) {
        std::string made;
        for (const char letter : text)
            made += is_big_endian ? std::string(zeros, '\0') + letter : letter + std::string(zeros, '\0');
        return made;
    };
    using namespace std::string_literals;
    EXPECT_EQ(refusal("\xff\xfe"s + wide(ramp(), false, 1)), "line 1: UTF-16 text: save it as UTF-8");
    EXPECT_EQ(refusal("\xfe\xff"s + wide(ramp(), true, 1)), "line 1: UTF-16 text: save it as UTF-8");
    EXPECT_EQ(refusal(wide(ramp(), false, 1)), "line 1: UTF-16 text: save it as UTF-8");
    EXPECT_EQ(refusal(wide(ramp(), true, 1)), "line 1: UTF-16 text: save it as UTF-8");
    EXPECT_EQ(refusal("\xff\xfe\0\0"s + wide(ramp(), false, 3)), "line 1: UTF-32 text: save it as UTF-8");
    EXPECT_EQ(refusal("\0\0\xfe\xff"s + wide(ramp(), true, 3)), "line 1: UTF-32 text: save it as UTF-8");
    EXPECT_EQ(refusal("\0\0\0\0"s), "line 1: binary data");
}

TEST_F(Obj, ReportsOmissionsAndReplacements) {
    const std::string plain = ramp();
    EXPECT_EQ(notes(plain), "");
    EXPECT_EQ(notes(replaced(plain, "f 4 3 6", "f\u00a04 3 6")),
              "line 11: not understood: f\u00a04 3 6 (with a no-break space)");
    EXPECT_EQ(notes("V 0 0 0\n" + plain + "s sharp\nface 1 2 3\n"), "line 1: not understood: V 0 0 0, and 2 more");
    EXPECT_EQ(notes(plain + "l 1 2\np 3\np 4\ncurv 0 1 1 2\n"),
              "only faces are drawn; left out: lines: 1, points: 2, curves and surfaces: 1");
    const std::string named =
        replaced(replaced(plain, "f 1 2 3 4", "f 1//1 2//1 3//1 4//1"), "f 1 5 2", "f 1//9 5 2//8");
    EXPECT_EQ(notes(named),
              "line 7: face 1 refers to normal 1, but the file has 0; corners whose normal comes from "
              "the faces instead: 6");
    EXPECT_EQ(notes("vn 0 0 0\n" + named),
              "line 1: normal 1 has no direction; corners whose normal comes from "
              "the faces instead: 6");
    EXPECT_EQ(notes(plain + "f 1 2//-1 3\n"),
              "line 12: face 6 refers to normal -1, which does not exist; corners whose "
              "normal comes from the faces instead: 1");
    const Mesh without = load(named), mesh = load(plain);
    expect_same(without, mesh, "normals that there are not");
    EXPECT_EQ(notes("v 0 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nf 1 2 3 4\nf 1 2 3\nf 4 3 2 1\n"),
              "line 5: face 1 crosses itself and is filled with a triangle fan (and 1 more)");
}

TEST_F(Obj, RefusesFoldersAndMissingFiles) {
    EXPECT_EQ(load_obj(folder_ / "none.obj").error(), (folder_ / "none.obj").string() + ": no such file");
    EXPECT_EQ(load_obj(folder_).error(), folder_.string() + ": is a directory, not a file");
    EXPECT_NE(load_obj("/dev/zero").error().find("is not a file"), std::string::npos);
}

/// Writes a height field of side × side quads with normals.
std::string height_field(int side) {
    std::string content;
    content.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 120);
    for (int y = 0; y <= side; ++y) {
        for (int x = 0; x <= side; ++x) {
            content += "v " + std::to_string(x * 0.01) + " " + std::to_string(y * 0.01) + " " +
                       std::to_string(0.1 * std::sin(x * 0.05)) + "\n";
        }
    }
    content += "vn 0 0 1\n";
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int corner = y * (side + 1) + x + 1;
            const std::string a = std::to_string(corner);
            const std::string b = std::to_string(corner + 1);
            const std::string c = std::to_string(corner + side + 2);
            const std::string d = std::to_string(corner + side + 1);
            content.append("f ").append(a).append("//1 ").append(b).append("//1 ").append(c).append("//1\nf ");
            content.append(a).append("//1 ").append(c).append("//1 ").append(d).append("//1\n");
        }
    }
    return content;
}

TEST_F(Obj, AMillionTrianglesLoadWithProgress) {
    constexpr int side = is_sanitized ? 354 : 708;
    const std::filesystem::path file = write("big.obj", height_field(side));
    WorkProgress progress;
    const auto start = std::chrono::steady_clock::now();
    const Result<ObjMesh> mesh = load_obj(file, {}, &progress);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    ASSERT_TRUE(mesh) << mesh.error();
    EXPECT_EQ(mesh->mesh.triangle_count(), 2U * side * side);
    EXPECT_EQ(mesh->mesh.positions.size(), (side + 1U) * (side + 1U));
    EXPECT_EQ(progress.fraction, 1.0F);
    RecordProperty("seconds", std::to_string(seconds.count()));
    EXPECT_LT(seconds.count(), 30.0) << "a few seconds at most in a release build";
}

TEST_F(Obj, CanBeCanceled) {
    const std::filesystem::path file = write("big.obj", height_field(300));
    WorkProgress progress;
    progress.canceled = true;
    EXPECT_EQ(load_obj(file, {}, &progress).error(), file.string() + ": loading was canceled");
}

TEST_F(Obj, ProgressNeverDecreases) {
    const std::filesystem::path file = write("big.obj", height_field(300));
    WorkProgress progress;
    std::atomic<bool> done{false};
    bool grows = true;
    std::thread watcher([&] {
        float last = 0.0F;
        while (!done) {
            const float now = progress.fraction;
            grows = grows && now >= last && now <= 1.0F;
            last = now;
        }
    });
    const Result<ObjMesh> mesh = load_obj(file, {}, &progress);
    done = true;
    watcher.join();
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(grows);
}

}  // namespace
}  // namespace viewing
