#include "playground/drawing/shader.hpp"

#include "playground/drawing/shader_sources.hpp"

#include <string_view>

namespace playground::drawing {

namespace {

std::string begin_shader(const char *render_modes, Renderer renderer) {
	// In clip space z / w is 1 at the near plane and FAR_DEPTH at the far plane.
	const char *constants = renderer == Renderer::COMPATIBILITY
			? "const float FAR_DEPTH = -1.0;\nconst bool LINEAR_COLORS = false;\n"
			: "const float FAR_DEPTH = 0.0;\nconst bool LINEAR_COLORS = true;\n";
	return std::string("shader_type spatial;\nrender_mode unshaded, cull_disabled, shadows_disabled, fog_disabled, skip_vertex_transform, ") + render_modes + ";\n" + constants + shader_sources::COMMON;
}

// `functions` defines the functions that `position` calls.
std::string assemble_stroke(std::string begin, const char *functions, std::string_view position) {
	constexpr std::string_view MARKER = "#include STROKE_POSITION\n";
	const std::string_view stroke = shader_sources::STROKE;
	const size_t at = stroke.find(MARKER);
	return begin.append(functions).append(stroke.substr(0, at)).append(position).append(stroke.substr(at + MARKER.size()));
}

} // namespace

std::string stroke_shader(Space space, Renderer renderer, StrokePass pass) {
	using namespace shader_sources;
	const bool core = pass == StrokePass::CORE;
	const std::string begin = begin_shader(core ? "depth_draw_always" : "depth_draw_never", renderer) + (core ? "const bool IS_CORE = true;\n" : "const bool IS_CORE = false;\n");
	switch (space) {
		case Space::MODEL:
			return assemble_stroke(begin, "", STROKE_POSITION_MODEL);
		case Space::SCREEN:
			return assemble_stroke(begin, "", STROKE_POSITION_SCREEN);
		case Space::ROUND:
			return assemble_stroke(begin, ROUND_POSITIONS, STROKE_POSITION_ROUND);
		case Space::LINE:
			return assemble_stroke(begin, UNBOUNDED_POSITIONS, STROKE_POSITION_LINE);
		default:
			return assemble_stroke(begin, "", STROKE_POSITION_PLANE);
	}
}

std::string fill_shader(Space space, Renderer renderer) {
	using namespace shader_sources;
	const std::string begin = begin_shader("depth_draw_never", renderer);
	switch (space) {
		case Space::ROUND:
			return begin + ROUND_POSITIONS + FILL_ROUND;
		case Space::PLANE:
			return begin + UNBOUNDED_POSITIONS + FILL_PLANE;
		default:
			return begin + FILL_SCREEN;
	}
}

} // namespace playground::drawing
