// Writes one color where a pass has changed the mask: each pixel once, however often the pass touched it.
uniform sampler2D previous_mask;
uniform sampler2D changed_mask;
uniform vec4 value;

out vec4 color;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    if (texelFetch(previous_mask, texel, 0).r == texelFetch(changed_mask, texel, 0).r) discard;
    color = value;
}
