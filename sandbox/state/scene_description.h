// A scene as its file describes it: objects, each with a shape and a placement. scene.h makes meshes from it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/camera.h"

namespace viewing {

/// A color, written as "#rrggbb" in files.
struct Color {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Color&) const = default;
};

enum class ShapeKind { box, sphere, torus, cylinder, cone, quad, triangle, teapot, mesh };

/// Options for reading a mesh file.
struct MeshReading {
    double crease_deg = 30.0;  ///< largest angle between faces with smooth computed normals: 0 … 180
    bool fit = true;           ///< centers and scales the mesh; off: keeps the file's coordinates
    bool operator==(const MeshReading&) const = default;
};

/// One object of a scene: its shape and placement. world_from_model = T R S.
struct ObjectDescription {
    std::string name;
    ShapeKind shape = ShapeKind::box;
    glm::dvec3 position{0.0};
    Angles rotation;
    glm::dvec3 scale{1.0};
    Color color{0x5a, 0x9e, 0xf0};
    bool decal = false;                    ///< depth.decals applies to it
    std::array<glm::dvec3, 3> vertices{};  ///< triangle only
    std::string file;                      ///< mesh only, relative to the scene's file
    MeshReading reading;                   ///< mesh only
    int resolution = 10;                   ///< teapot only: subdivisions per patch side
    bool operator==(const ObjectDescription&) const = default;
};

/// A formula that makes a scene and replaces the list of objects; see coplanar.h.
enum class SceneFormula { coplanar };

struct SceneDescription {
    std::vector<ObjectDescription> objects;  ///< empty if a formula makes the scene
    std::optional<SceneFormula> made_by = {};
    bool operator==(const SceneDescription&) const = default;
};

/// The name of a scene in assets/scenes, a path, or the scene itself; written back unchanged.
using SceneSource = std::variant<std::string, SceneDescription>;

}  // namespace viewing
