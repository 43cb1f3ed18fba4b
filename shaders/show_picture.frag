// Draws a picture over the target; the picture's first row is the top one.
in vec2 position_texture;

uniform sampler2D picture;
uniform vec2 picture_share;  // fraction of the target that the picture fills, centered

out vec4 color;

void main() {
    vec2 position = (position_texture - 0.5) / picture_share + 0.5;
    if (any(lessThan(position, vec2(0.0))) || any(greaterThan(position, vec2(1.0)))) discard;
    ivec2 size = textureSize(picture, 0);
    ivec2 texel = ivec2(vec2(position.x, 1.0 - position.y) * vec2(size));
    color = texelFetch(picture, clamp(texel, ivec2(0), size - 1), 0);
}
