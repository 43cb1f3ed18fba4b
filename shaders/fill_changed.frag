// One colour where the mask is no longer what it was: each pixel once, however often a pass has met it.
uniform sampler2D previous_mask;
uniform sampler2D changed_mask;
uniform vec4 value;

out vec4 color;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    if (texelFetch(previous_mask, texel, 0).r == texelFetch(changed_mask, texel, 0).r) discard;
    color = value;
}
