// Internal to growth.cpp: runs the methods on a given number of polygons. Read growth_report.cpp next.
#pragma once

#include <span>
#include <vector>

#include "topics/hidden/methods/bsp.h"
#include "topics/hidden/methods/growth.h"
#include "topics/hidden/methods/software_zbuffer.h"

namespace viewing {

class GrowthBench {
public:
    /// The request must outlive this object.
    GrowthBench(const GrowthRequest& request, int count);

    /// Runs one method. bsp_walk traverses the tree that bsp_build built.
    GrowthRow run(GrowthMethod method, WorkProgress* progress);

private:
    void run_painter(GrowthRow& row, WorkProgress* progress);
    void run_newell(GrowthRow& row, WorkProgress* progress);
    void run_bsp_build(GrowthRow& row, WorkProgress* progress);
    void run_bsp_walk(GrowthRow& row, WorkProgress* progress);
    void run_z_buffer(GrowthRow& row, WorkProgress* progress);
    void run_ray_casting(GrowthRow& row, WorkProgress* progress);
    void paint(std::span<const Polygon> drawn, std::span<const int> order, GrowthRow& row,
               WorkProgress* progress) const;

    const GrowthRequest& request_;
    const int width_, height_;
    const std::vector<Polygon> polygons_;
    const Viewpoint viewpoint_;
    BspTree tree_;
};

}  // namespace viewing
