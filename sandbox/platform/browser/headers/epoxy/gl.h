// WebGL 2 under the file name of the desktop's loader; there is nothing to load here. Below are names that OpenGL ES
// 3.0 lacks, for code that checks gl/dialect.h first and never uses them here.
#pragma once

#include <GLES3/gl3.h>
//
#include <GLES2/gl2ext.h>

#define GLAPIENTRY
#define GL_CLIP_DISTANCE0 GL_CLIP_DISTANCE0_APPLE
#define GL_CLIP_DISTANCE1 GL_CLIP_DISTANCE1_APPLE
#define GL_STENCIL_INDEX 0x1901
#define GL_DEBUG_OUTPUT GL_DEBUG_OUTPUT_KHR
#define GL_DEBUG_OUTPUT_SYNCHRONOUS GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR
#define GL_DEBUG_TYPE_ERROR GL_DEBUG_TYPE_ERROR_KHR
#define GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR_KHR
#define GL_DEBUG_SEVERITY_HIGH GL_DEBUG_SEVERITY_HIGH_KHR

inline void glDebugMessageCallback(GLDEBUGPROCKHR, const void*) {}
