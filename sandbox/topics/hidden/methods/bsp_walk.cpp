// Traverses the tree for one eye, without recursion, since the tree of a convex mesh has as many levels as the mesh has
// triangles. Read software_zbuffer.cpp next.
#include <cmath>

#include "topics/hidden/methods/bsp.h"

namespace viewing {
namespace {

int side_of_eye(const BspTree& tree, const BspNode& node, const glm::dvec4& eye_world) {
    const double distance = glm::dot(node.plane, eye_world);
    const double tolerance = eye_world.w != 0.0 ? tree.epsilon : parallel_sine;
    if (std::abs(distance) <= tolerance) return 0;
    return distance > 0.0 ? 1 : -1;
}

void draw_own(const BspNode& node, BspOrder order, std::vector<int>& fragments) {
    for (int i = 0; i < node.fragment_count; ++i) {
        const int offset = order == BspOrder::back_to_front ? i : node.fragment_count - 1 - i;
        fragments.push_back(node.first_fragment + offset);
    }
}

}  // namespace

BspWalk walk_bsp(const BspTree& tree, const glm::dvec4& eye_world, BspOrder order) {
    struct Task {
        int node;
        int eye_side;
        bool first_child_done;
    };
    BspWalk walk;
    walk.visits.reserve(tree.nodes.size());
    walk.fragments.reserve(tree.fragments.size());
    std::vector<Task> tasks;
    const auto enter = [&](int node) {
        if (node >= 0) tasks.push_back({node, side_of_eye(tree, tree.nodes[node], eye_world), false});
    };
    if (!tree.nodes.empty()) enter(0);
    while (!tasks.empty()) {
        Task& task = tasks.back();
        const BspNode& node = tree.nodes[task.node];
        const bool front_is_first = (task.eye_side >= 0) == (order == BspOrder::front_to_back);
        if (!task.first_child_done) {
            task.first_child_done = true;
            enter(front_is_first ? node.front : node.back);
            continue;
        }
        walk.visits.push_back({task.node, task.eye_side});
        draw_own(node, order, walk.fragments);
        tasks.pop_back();
        enter(front_is_first ? node.back : node.front);
    }
    return walk;
}

}  // namespace viewing
