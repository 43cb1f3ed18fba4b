// A hidden-surface method's entry: how it finds an order or a picture, in what it differs from other methods, and its
// words. Each method of state/visibility_params.h has one: in its own source here or, if GL draws it, in
// hidden_surfaces.cpp. The views show what a result contains, whatever the method. Read method_parts.h next.
#pragma once

#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {

/// The words for the two levels of a method's steps.
struct StepWords {
    const char *group, *within;
    const char *next, *previous;                   ///< what the buttons for groups do
    const char* (*progress)(int group) = nullptr;  ///< the sentence for a step in a group
};

struct HiddenMethod {
    const char* name;  ///< in lists
    /// Finds all that is the same at every step: the polygons, their order, the steps and their groups, and counters.
    void (*find)(HiddenData& data, HiddenResult& result, WorkProgress* progress);
    /// Counts what the step has reached besides polygons; null if there is nothing else.
    void (*count)(HiddenResult& result) = nullptr;
    /// Makes the picture at the step; null if GL draws it.
    void (*draw)(HiddenData& data, HiddenResult& result, WorkProgress* progress) = nullptr;
    StepWords words{};             ///< for a method that groups its steps
    bool computes_pixels = false;  ///< decides pixel by pixel; otherwise, polygons are drawn in an order
    bool sorts_by_key = false;     ///< sorts whole polygons by one number, which is wrong in some scenes
    bool splits = false;           ///< cuts polygons in parts
    bool has_tree = false;         ///< builds a BSP tree and walks it
    bool casts_rays = false;       ///< each step is a pixel's ray
};

namespace hidden_methods {
using Entry = HiddenMethod;
VIEWING_METHODS(VIEWING_ENTRY)
}  // namespace hidden_methods

const HiddenMethod& hidden_method(VisibilityMethod method);

/// Returns the methods' names, in the order of VisibilityMethod.
std::span<const char* const> method_names();

}  // namespace viewing
