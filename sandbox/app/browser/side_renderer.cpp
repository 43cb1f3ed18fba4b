// A page has one GL context, and nothing beside it to draw in: what is measured in pictures is measured by the page's
// own renderer, between two frames.
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
