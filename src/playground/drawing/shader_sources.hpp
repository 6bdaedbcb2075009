#pragma once

// The files of shaders/, which the build embeds (site_scons/shader_sources.py).

namespace playground::drawing::shader_sources {

extern const char *const COMMON;
extern const char *const UNBOUNDED_POSITIONS;
extern const char *const FILL_PLANE;
extern const char *const FILL_ROUND;
extern const char *const FILL_SCREEN;
extern const char *const ROUND_POSITIONS;
extern const char *const STROKE;
extern const char *const STROKE_POSITION_LINE;
extern const char *const STROKE_POSITION_MODEL;
extern const char *const STROKE_POSITION_PLANE;
extern const char *const STROKE_POSITION_ROUND;
extern const char *const STROKE_POSITION_SCREEN;

} // namespace playground::drawing::shader_sources
