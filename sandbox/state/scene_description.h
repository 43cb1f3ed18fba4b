// A scene as its file says it: objects with a shape and a place. scene.h makes it into meshes.
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

/// "#rrggbb".
struct Color {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Color&) const = default;
};

enum class ShapeKind { box, sphere, torus, cylinder, cone, quad, triangle, teapot, mesh };

/// What is made of a mesh file's numbers.
struct MeshReading {
    double crease_deg = 30.0;  ///< angle between faces up to which made normals are smooth: 0 … 180
    bool fit = true;           ///< centred and scaled; else the file's own coordinates
    bool operator==(const MeshReading&) const = default;
};

/// One object of a scene: what it is and where. world_from_model = T R S.
struct ObjectDescription {
    std::string name;
    ShapeKind shape = ShapeKind::box;
    glm::dvec3 position{0.0};
    Angles rotation;
    glm::dvec3 scale{1.0};
    Color color{0x5a, 0x9e, 0xf0};
    bool decal = false;                    ///< depth.offset applies to it
    std::array<glm::dvec3, 3> vertices{};  ///< triangle only
    std::string file;                      ///< mesh only, relative to the scene's file
    MeshReading reading;                   ///< mesh only
    int resolution = 10;                   ///< teapot only: cuts per patch side
    bool operator==(const ObjectDescription&) const = default;
};

/// What a scene can be made by in place of listing its objects: see coplanar.h.
enum class SceneFormula { coplanar };

struct SceneDescription {
    std::vector<ObjectDescription> objects;  ///< none for a scene that a formula makes
    std::optional<SceneFormula> made_by = {};
    bool operator==(const SceneDescription&) const = default;
};

/// A name in assets/scenes, a path, or the scene itself; written back as it was given.
using SceneSource = std::variant<std::string, SceneDescription>;

}  // namespace viewing
