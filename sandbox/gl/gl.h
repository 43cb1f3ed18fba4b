// The only place that includes the GL loader; everything that calls GL includes this.
#pragma once

#include <epoxy/gl.h>
