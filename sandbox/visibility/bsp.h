// The binary space partitioning tree: built once in world space from polygons, then walked for any eye. Every plane is
// that of one of the polygons; what spans a plane is cut. Read software_zbuffer.h next.
// Source: Fuchs, Kedem and Naylor 1980; lecture, Hidden Surface Removal: BSP tree.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/progress.h"
#include "visibility/choices.h"
#include "visibility/polygons.h"

namespace viewing {

struct BspOptions {
    BspSplitter splitter = BspSplitter::fewest_splits;
    std::optional<double> epsilon{};  ///< how near to a plane counts as on it; default_epsilon() if none
    int max_fragments = 1'000'000;
    unsigned random_seed = 1;
};

/// A plane, the polygons in it, and what lies on either side. Nodes are numbered in the order they are built: node k is
/// step k of the build.
struct BspNode {
    glm::dvec4 plane{0.0};  ///< unit
    int parent = -1, front = -1, back = -1;
    int depth = 1;                              ///< 1 at the root
    int first_fragment = 0, fragment_count = 0; /**< a run of BspTree::fragments: the polygons in the plane, the lowest
                                                     source last, so that it is seen where they overlap */
    bool sorted = true;                         ///< false: a rest that the budget left uncut; drawn in that same order

    int splitter_source = 0;  ///< the polygon that gave the plane
    int input_count = 0;      ///< polygons that came to this node
    int candidate_count = 0;  ///< planes that were tried
    int front_count = 0, back_count = 0,
        split_count = 0;  ///< what the plane did; pieces are counted on their sides too
};

struct BspCounters {
    std::int64_t plane_tests = 0;  ///< polygons held against a plane, choosing and cutting
    int splits = 0;
    int depth = 0;
};

/// Flat: nodes refer to one another by index. Independent of any camera.
struct BspTree {
    std::vector<BspNode> nodes;  ///< the root first; empty without polygons
    std::vector<Polygon> fragments;
    double epsilon = 0.0;
    BspCounters counters;
    std::string problem;  ///< a sentence when the build stopped at its budget or was cancelled
};

/// Also defined for a build that stopped: every polygon is in the tree, some in nodes that are not `sorted`.
BspTree build_bsp(std::span<const Polygon> polygons, const BspOptions& options = {}, WorkProgress* progress = nullptr);

/// A node on the walk, when its own polygons are drawn, and the eye's side of its plane: 1 front, −1 back, 0 in the
/// plane, which goes on as 1: neither side can then hide the other, and the node's polygons are seen edge-on.
struct BspVisit {
    int node;
    int eye_side;
};

struct BspWalk {
    std::vector<BspVisit> visits;  ///< depth-first, every node once
    std::vector<int> fragments;    ///< indices into BspTree::fragments in drawing order, every one once
};

/// `eye_world` as Viewpoint::eye_world() gives it: a point with w = 1, or the unit direction towards the viewer, w = 0.
BspWalk walk_bsp(const BspTree& tree, const glm::dvec4& eye_world, BspOrder order);

}  // namespace viewing
