// A picture laid over what is there; its first row is the top one.
in vec2 position_texture;

uniform sampler2D picture;

out vec4 color;

void main() {
    ivec2 size = textureSize(picture, 0);
    ivec2 texel = ivec2(vec2(position_texture.x, 1.0 - position_texture.y) * vec2(size));
    color = texelFetch(picture, min(texel, size - 1), 0);
}
