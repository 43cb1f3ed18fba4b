#include "topics/depth/numbers/fighting.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

#include "topics/hidden/numbers/scene_surface.h"

namespace viewing {
namespace {

constexpr double parallel_sine = 0.01745;  ///< of one degree
constexpr double largest_gap_share = 0.1;  ///< of the smaller object's size
constexpr double coplanar_share = 1e-9;    ///< of the smaller object's size; a smaller gap counts as zero
constexpr std::size_t most_triangles = 2;

/// An object that may belong to a pair.
struct FlatObject {
    int object = 0;
    std::vector<Polygon> triangles;
    glm::dvec3 normal_world{0.0};
    double area = 0.0;

    double size() const { return std::sqrt(area); }
};

std::vector<FlatObject> flat_objects(const Scene& scene) {
    std::vector<MeshInstance> instances;
    std::vector<int> object_of_instance;
    for (std::size_t index = 0; index < scene.objects.size(); ++index) {
        const SceneObject& object = scene.objects[index];
        if (object.mesh->triangle_count() > most_triangles) continue;
        instances.push_back({object.mesh.get(), object.world_from_model});
        object_of_instance.push_back(static_cast<int>(index));
    }
    std::vector<FlatObject> found(instances.size());
    for (const Polygon& polygon : polygons_of(instances).polygons) found[polygon.object].triangles.push_back(polygon);
    for (std::size_t index = 0; index < found.size(); ++index) {
        FlatObject& flat = found[index];
        flat.object = object_of_instance[index];
        if (flat.triangles.empty()) continue;
        flat.area = total_area(flat.triangles);
        flat.normal_world = glm::dvec3(flat.triangles.front().plane);
    }
    std::erase_if(found, [](const FlatObject& flat) {
        return flat.triangles.empty() || side_of_plane(flat.triangles.back(), flat.triangles.front().plane,
                                                       1e-6 * flat.size()) != PlaneSide::coplanar;
    });
    return found;
}

/// Returns the part of a polygon that lies within a triangle, seen along the triangle's normal. It has no corners if
/// there is no such part.
Polygon part_within(Polygon polygon, const Polygon& triangle, double epsilon) {
    const glm::dvec3 normal(triangle.plane);
    for (std::size_t corner = 0; corner < triangle.vertices.size(); ++corner) {
        const glm::dvec3& from = triangle.vertices[corner];
        const glm::dvec3& to = triangle.vertices[(corner + 1) % triangle.vertices.size()];
        const glm::dvec3 inwards = glm::normalize(glm::cross(normal, to - from));
        const glm::dvec4 edge(inwards, -glm::dot(inwards, from));
        const PlaneSide side = side_of_plane(polygon, edge, epsilon);
        if (side == PlaneSide::back || side == PlaneSide::coplanar) return {};
        if (side == PlaneSide::spanning) polygon = split(polygon, edge, epsilon).first;
    }
    return polygon;
}

/// Returns the part of the first object that the second one overlaps, in front or behind; empty if they do not overlap.
std::vector<Polygon> overlap_of(const FlatObject& first, const FlatObject& second) {
    const double epsilon = 1e-9 * std::min(first.size(), second.size());
    std::vector<Polygon> parts;
    for (const Polygon& of_first : first.triangles) {
        for (const Polygon& of_second : second.triangles) {
            Polygon part = part_within(of_first, of_second, epsilon);
            if (part.vertices.size() >= 3) parts.push_back(std::move(part));
        }
    }
    if (!(total_area(parts) > 1e-9 * std::min(first.area, second.area))) parts.clear();
    return parts;
}

glm::dvec3 center_of(std::span<const Polygon> parts) {
    glm::dvec3 weighted(0.0);
    for (const Polygon& part : parts) weighted += area(part) * centroid(part);
    return weighted / total_area(parts);
}

/// Returns the distance from the center to the object's farthest corner.
double radius_about(const glm::dvec3& center, const FlatObject& flat) {
    double radius = 0.0;
    for (const Polygon& triangle : flat.triangles)
        for (const glm::dvec3& corner : triangle.vertices) radius = std::max(radius, glm::distance(center, corner));
    return radius;
}

std::optional<FlatPair> pair_of(const Scene& scene, const FlatObject& first, const FlatObject& second) {
    if (glm::length(glm::cross(first.normal_world, second.normal_world)) > parallel_sine) return std::nullopt;
    std::vector<Polygon> overlap = overlap_of(first, second);
    if (overlap.empty()) return std::nullopt;
    const glm::dvec3 center = center_of(overlap);
    const double size = std::min(first.size(), second.size());
    const double same_way = glm::dot(first.normal_world, second.normal_world) < 0.0 ? -1.0 : 1.0;
    const glm::dvec4 plane = same_way * second.triangles.front().plane;
    const double offset = -glm::dot(plane, glm::dvec4(center, 1.0));
    if (std::abs(offset) > largest_gap_share * size) return std::nullopt;
    const auto is_decal = [&](int object) { return scene.objects[object].description.decal; };
    return FlatPair{.first = first.object,
                    .second = second.object,
                    .offset = std::abs(offset) > coplanar_share * size ? offset : 0.0,
                    .center_world = center,
                    .normal_world = first.normal_world,
                    .second_plane_world = plane,
                    .overlap = std::move(overlap),
                    .radius = std::max(radius_about(center, first), radius_about(center, second)),
                    .first_is_decal = is_decal(first.object),
                    .second_is_decal = is_decal(second.object)};
}

std::vector<FlatPair> found_pairs(const Scene& scene) {
    const std::vector<FlatObject> flat = flat_objects(scene);
    std::vector<FlatPair> pairs;
    for (std::size_t first = 0; first < flat.size(); ++first)
        for (std::size_t second = first + 1; second < flat.size(); ++second)
            if (const auto pair = pair_of(scene, flat[first], flat[second])) pairs.push_back(*pair);
    return pairs;
}

/// Keeps the pairs of the latest scene, since every frame needs them again. Safe to use from several threads.
class KeptPairs {
public:
    std::vector<FlatPair> of(const Scene& scene) {
        const std::scoped_lock lock(mutex_);
        const auto is_known = [](const Known& known, const SceneObject& object) { return known.is(object); };
        if (!std::equal(known_.begin(), known_.end(), scene.objects.begin(), scene.objects.end(), is_known)) {
            pairs_ = found_pairs(scene);
            known_.clear();
            for (const SceneObject& object : scene.objects)
                known_.push_back({object.mesh, object.world_from_model, object.description.decal});
        }
        return pairs_;
    }

private:
    /// The properties of an object that determine its pairs.
    struct Known {
        std::weak_ptr<const Mesh> mesh;
        glm::dmat4 world_from_model;
        bool is_decal;

        bool is(const SceneObject& object) const {
            return !mesh.owner_before(object.mesh) && !object.mesh.owner_before(mesh) &&
                   world_from_model == object.world_from_model && is_decal == object.description.decal;
        }
    };

    std::mutex mutex_;
    std::vector<Known> known_;
    std::vector<FlatPair> pairs_;
};

/// Returns the distance from a float32 to the next larger one, in units of 2⁻²⁴. The result is greater than the value,
/// but at most twice as great.
double float_step(double value) {
    return value > 0.0 ? std::exp2(std::floor(std::log2(value)) + 1.0) : 0.0;
}

/// Returns how far apart the window depths of two surfaces may be although they should be equal, in units of 2⁻²⁴. Each
/// rounding to float32 on the way is off by up to half a unit in the last place for each surface, so it can move the
/// two apart by up to one unit. The rounded values are clip z and clip w, which both affect their quotient, and the
/// depth, first as computed from the quotient and then as interpolated. The matrix is multiplied in double and rounded
/// at the end.
double rounded_terms(const DepthCoding& coding, double z) {
    const Lens& lens = coding.lens;
    const double depth = window_depth(lens, coding.mapping, z), of_depth = float_step(depth);
    const double of_w = float_step(z) / z;  // relative
    if (coding.mapping == DepthMapping::logarithmic) {
        // Relative errors of eye z, w and their quotient change the logarithm by the same amount; then the logarithm
        // and the depth are rounded.
        const double start = lens.logarithmic_near(), range = std::log(lens.logarithmic_far() / start);
        return (3.0 * of_w + 2.0 * float_step(std::log(std::max(z, start) / start))) / range + of_depth;
    }
    if (coding.clip_zero_to_one && lens.orthographic) return of_depth;
    if (coding.clip_zero_to_one) {
        const double clip_z = lens.depth_per_inverse_distance();
        return (float_step(clip_z) + clip_z * of_w) / z + of_depth;
    }
    const double ndc_z = std::abs(2.0 * depth - 1.0);  // later halved and shifted to 0 … 1
    if (lens.orthographic) return 0.5 * float_step(ndc_z) + 2.0 * of_depth;
    return 0.5 * (float_step(ndc_z * z) / z + ndc_z * of_w) + 2.0 * of_depth;
}

}  // namespace

std::vector<FlatPair> near_coplanar_pairs(const Scene& scene) {
    static KeptPairs kept;
    return kept.of(scene);
}

DepthCoding depth_coding(const Params& params, const Derived& derived) {
    return {params.lens(), params.depth.mapping, derived.stored_depth.precision, derived.clip_zero_to_one};
}

double depth_rounding(const DepthCoding& coding, double distance, double span) {
    const double z = std::clamp(distance, coding.lens.near, coding.lens.far);
    const double nearest = std::max(z - span, coding.lens.near);
    return std::exp2(-24) * std::max(rounded_terms(coding, z), rounded_terms(coding, nearest));
}

FightingOnset fighting_onset(const DepthCoding& coding, double distance, double span) {
    const Lens& lens = coding.lens;
    const double z = std::clamp(distance, lens.near, lens.far);
    // A code's width in distance divided by its width in depth is the distance per unit of depth. It is the same for
    // every integer format.
    constexpr DepthPrecision any_bits{24, false};
    const double distance_per_depth = depth_step(lens, coding.mapping, any_bits, z) * (std::exp2(24) - 1.0);
    const double code = depth_step(lens, coding.mapping, coding.precision, z) / distance_per_depth;
    const double rounding = depth_rounding(coding, distance, span);

    // The slope changes within a wide code, so compute the distance from the code's two ends.
    const double towards_eye = coding.mapping == DepthMapping::reversed ? 1.0 : -1.0;
    const double depth = window_depth(lens, coding.mapping, z);
    const auto way_of = [&](double change) {
        const double nearer = std::clamp(depth + towards_eye * change, 0.0, 1.0);
        return z - std::max(distance_of_window_depth(lens, coding.mapping, nearer), lens.near);
    };
    const double end = depth + towards_eye * (code + rounding);
    FightingOnset onset;
    onset.quantization = way_of(code);
    onset.arithmetic = way_of(code + rounding) - onset.quantization;
    onset.is_reachable = end >= 0.0 && end <= 1.0;
    return onset;
}

}  // namespace viewing
