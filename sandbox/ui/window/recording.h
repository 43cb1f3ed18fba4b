// What Dear ImGui is about to draw, as shapes, text and pictures: one drawing serves the screen and vectors.
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>

#include "figure/drawing.h"

namespace viewing {

/// The picture that a texture holds, top row first.
using ReadTexture = std::function<std::shared_ptr<const Image>(ImTextureID)>;

Ink ink_of(ImU32 color);

/// Of the current ImGui context, whose fonts are those of load_fonts(). Glyphs become lines of characters, triangles
/// that hang together their outline, without the fringe of half a pixel that smooths it on screen, and textured ones
/// their picture. ImGuiStyle::AntiAliasedLinesUseTex has to be off, since lines would be pictures.
Drawing recorded(const ImDrawData& data, const ReadTexture& read);

}  // namespace viewing
