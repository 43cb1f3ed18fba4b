// The binary space partitioning tree: built once in world space from polygons, then traversed for any eye. Every plane
// is the plane of one of the polygons; polygons that span a plane are cut. Read software_zbuffer.h next. Source: Fuchs,
// Kedem and Naylor 1980; lecture, Hidden Surface Removal: BSP tree.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/progress.h"
#include "text/message.h"
#include "topics/hidden/methods/choices.h"
#include "topics/hidden/methods/polygons.h"

namespace viewing {

struct BspOptions {
    BspSplitter splitter = BspSplitter::fewest_splits;
    std::optional<double> epsilon{};  ///< tolerance for points on a plane; default_epsilon() if none
    int max_fragments = 1'000'000;
    unsigned random_seed = 1;
};

/// A plane, the polygons in it, and the subtrees on either side. Nodes are numbered in the order in which they are
/// built: step k of the build makes node k.
struct BspNode {
    glm::dvec4 plane{0.0};  ///< unit
    int parent = -1, front = -1, back = -1;
    int depth = 1;                              ///< 1 at the root
    int first_fragment = 0, fragment_count = 0; /**< a run of BspTree::fragments: the polygons in the plane, the lowest
                                                     source last, so that it is visible where they overlap */
    bool sorted = true;                         ///< false if the build stopped earlier: the polygons are unsorted

    int splitter_source = 0;  ///< the polygon that defines the plane
    int input_count = 0;      ///< polygons that reached this node
    int candidate_count = 0;  ///< planes tried
    int front_count = 0, back_count = 0,
        split_count = 0;  ///< polygons on either side, and polygons cut; each piece counts on its side
};

struct BspCounters {
    std::int64_t plane_tests = 0;  ///< polygons tested against a plane, both to choose a plane and to cut
    int splits = 0;
    int depth = 0;
};

/// A tree, which does not depend on any camera. It is stored flat: nodes refer to one another by index.
struct BspTree {
    std::vector<BspNode> nodes;  ///< the root first; empty if there are no polygons
    std::vector<Polygon> fragments;
    double epsilon = 0.0;
    BspCounters counters;
    Message problem;  ///< a sentence if the build stopped at its budget or was canceled
};

/// Builds the tree. Even if the build stops early, every polygon is still in the tree, some in nodes that are not
/// `sorted`.
BspTree build_bsp(std::span<const Polygon> polygons, const BspOptions& options = {}, WorkProgress* progress = nullptr);

/// A visited node, recorded when its own polygons are drawn, with the side of its plane that the eye is on: 1 in front,
/// −1 behind, 0 in the plane. The traversal may treat 0 like 1, because then neither side hides the other, and the
/// node's polygons are seen edge-on.
struct BspVisit {
    int node;
    int eye_side;
};

struct BspWalk {
    std::vector<BspVisit> visits;  ///< depth-first, every node once
    std::vector<int> fragments;    ///< indices into BspTree::fragments in drawing order, each once
};

/// Traverses the tree. `eye_world` is Viewpoint::eye_world(): a point with w = 1, or the unit direction toward the
/// viewer with w = 0.
BspWalk walk_bsp(const BspTree& tree, const glm::dvec4& eye_world, BspOrder order);

}  // namespace viewing
