// Outputs the bits of a depth as four bytes, the lowest in red, for drivers that cannot read back depth.
in vec2 position_texture;

uniform highp sampler2D depth_texture;

out vec4 color;

void main() {
    uint bits = floatBitsToUint(texelFetch(depth_texture, ivec2(gl_FragCoord.xy), 0).r);
    uvec4 bytes = uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u;
    color = vec4(bytes) / 255.0;
}
