// Converts Dear ImGui's draw data into shapes, text and images, so that vector output needs no separate drawing code.
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>

#include "figure/drawing.h"

namespace viewing {

/// Reads back a texture's pixels, top row first.
using ReadTexture = std::function<std::shared_ptr<const Image>(ImTextureID)>;

Ink ink_of(ImU32 color);

/// Converts the draw data of the current ImGui context, whose fonts must be those of load_fonts(). Glyphs become lines
/// of text. Connected triangles become their outline, without the fringe of anti-aliasing; if they are textured, they
/// become an image. ImGuiStyle::AntiAliasedLinesUseTex must be off; otherwise, lines would become images.
Drawing recorded(const ImDrawData& data, const ReadTexture& read);

}  // namespace viewing
