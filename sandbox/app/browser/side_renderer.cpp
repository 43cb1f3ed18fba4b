// A page has only one GL context, so the page's own renderer also does the measurements, between two frames.
#include "app/side_renderer.h"

namespace viewing {

struct SideRenderer::Parts {};

SideRenderer::SideRenderer() = default;
SideRenderer::~SideRenderer() = default;

Result<bool> SideRenderer::lend(const std::function<void(Renderer&)>&) {
    is_impossible_ = true;
    return false;
}

}  // namespace viewing
