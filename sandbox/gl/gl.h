// The only place that includes the GL loader; all code that calls GL includes this header.
#pragma once

#include <epoxy/gl.h>
