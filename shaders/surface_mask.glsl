// Part of surface.frag: a mask that replaces the stencil. MASK_TEST tests it with discard, and MASK_WRITE writes it along
// with the color.
#if defined(MASK_TEST) || defined(MASK_WRITE)
uniform sampler2D mask_texture;  // value / 255, before the pass
uniform int mask_reference;

int mask_before() {
    return int(texelFetch(mask_texture, ivec2(gl_FragCoord.xy), 0).r * 255.0 + 0.5);
}
#endif
#ifdef MASK_TEST
uniform int mask_func;  // a CompareFunc
uniform int mask_read_bits;

// Comparisons are encoded as bit sets of less, equal and greater, as in GL.
bool passes_mask() {
    int value = mask_before() & mask_read_bits, reference = mask_reference & mask_read_bits;
    int relation = reference < value ? COMPARE_LESS : reference == value ? COMPARE_EQUAL : COMPARE_GREATER;
    return (mask_func & relation) != 0;
}
#endif
#ifdef MASK_WRITE
uniform int mask_op;  // a StencilOp
uniform int mask_write_bits;
layout(location = 1) out vec4 mask;

int mask_after() {
    int before = mask_before(), after = mask_reference;  // replace
    if (mask_op == STENCIL_INCREMENT) after = min(before + 1, 255);
    if (mask_op == STENCIL_DECREMENT) after = max(before - 1, 0);
    if (mask_op == STENCIL_INVERT) after = 255 - before;
    if (mask_op == STENCIL_ZERO) after = 0;
    return (before & (255 - mask_write_bits)) | (after & mask_write_bits);
}
#endif

