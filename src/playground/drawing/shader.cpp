#include "playground/drawing/shader.hpp"

#include "playground/drawing/endless_places.hpp"
#include "playground/drawing/round_places.hpp"

namespace playground::drawing {

namespace {

using namespace shared;

// In clip space z / w is 1 at the near plane, and this at the far plane.
std::string depth_of(Renderer renderer) {
	const bool opengl = renderer == Renderer::compatibility;
	return std::string("const float FAR_DEPTH = ") + (opengl ? "-1.0" : "0.0") + ";\nconst bool LINEAR_COLOURS = " + (opengl ? "false" : "true") + ";\n";
}

// What every shader begins with.
constexpr const char *COMMON = R"(
varying flat vec4 tint;
varying flat vec4 shape;

vec4 tint_of(vec4 colour) {
	return LINEAR_COLOURS ? vec4(pow(colour.rgb, vec3(2.2)), colour.a) : colour;
}

bool is_perspective(mat4 projection) {
	return projection[2][3] < -0.5;
}

// Distance of the far plane.
float far_plane(mat4 projection) {
	return (FAR_DEPTH * projection[3][3] - projection[3][2]) / (FAR_DEPTH * projection[2][3] - projection[2][2]);
}

// The eye in the form's own space, which is scaled alike in all directions.
vec3 eye_of(mat4 model, vec3 camera) {
	return transpose(mat3(model)) * (camera - model[3].xyz) / dot(model[0].xyz, model[0].xyz);
}

float scale_of(mat4 model) {
	return length(model[0].xyz);
}

// Metres a pixel at that distance.
float pixel_size(mat4 projection, vec2 viewport, float depth) {
	float height = 2.0 / (abs(projection[1][1]) * viewport.y);
	return is_perspective(projection) ? height * max(depth, 0.0) : height;
}

// Colours that are blended as light look stronger on dark: the same look in all renderers needs less of them.
float face_opacity(float opacity) {
	return LINEAR_COLOURS ? opacity * mix(0.62, 1.0, opacity) : opacity;
}

// How far away what is that far looks, in the form's own space: in a parallel view all is as far as the view is high.
float distance_of(mat4 projection, float away, float scale) {
	return is_perspective(projection) ? max(away, 1e-9) : 1.0 / (abs(projection[1][1]) * scale);
}
)";

// The eye, far away against the view's direction if the view is parallel.
constexpr const char *ROUND_EYE = R"(
vec3 round_eye(mat4 model, mat4 view_inverse, mat4 projection, vec3 camera) {
	vec3 eye = eye_of(model, camera);
	if (!is_perspective(projection)) {
		eye = vec3(0.0, 0.0, -1.0) + normalize(transpose(mat3(model)) * view_inverse[2].xyz) * 1e3;
	}
	return eye;
}
)";

// Each space has place_stroke(): where the vertex is and its derivative along the curve, both homogeneous, so that
// points at infinity and behind the eye are right, too.
constexpr const char *PLACE_MODEL = R"(
	place = vec4(VERTEX, 1.0);
	derivative = vec4(CUSTOM0.xyz, 0.0);
)";

constexpr const char *PLACE_SCREEN = R"(
	float depth = -(MODELVIEW_MATRIX * vec4(0.0, 0.0, 0.0, 1.0)).z;
	float pixel = pixel_size(PROJECTION_MATRIX, VIEWPORT_SIZE, depth) / scale_of(MODEL_MATRIX) * 0.5 * shape.w;
	place = vec4(VERTEX * pixel, 1.0);
	derivative = vec4(CUSTOM0.xyz, 0.0);
)";

constexpr const char *PLACE_ROUND = R"(
	float radius = 1.0;
	vec3 eye = round_eye(MODEL_MATRIX, INV_VIEW_MATRIX, PROJECTION_MATRIX, CAMERA_POSITION_WORLD);
	float ring = VERTEX.y;
	if (ring < 2.5) {
		float angle_of_eye = nearest_angle(eye, radius, ring);
		float away = distance_of(PROJECTION_MATRIX, length(eye - ring_point(radius, angle_of_eye, ring)), scale_of(MODEL_MATRIX));
		float angle;
		if (VERTEX.z > 0.5) {
			angle = ring_arrow_angle(VERTEX.z - 4.0, angle_of_eye, radius, away);
		} else {
			angle = angle_of_eye + spread_angle(VERTEX.x, radius, away);
			arc = angle / 6.28318531;
		}
		place = vec4(ring_point(radius, angle, ring), 1.0);
		derivative = vec4(ring_tangent(angle, ring), 0.0);
	} else if (ring < 8.5) {
		float number = mod(ring - 3.0, 3.0);
		vec3 axis = (ring < 5.5 ? 1.0 : -1.0) * vec3(number < 0.5 ? 1.0 : 0.0, abs(number - 1.0) < 0.5 ? 1.0 : 0.0, number > 1.5 ? 1.0 : 0.0);
		float side = shape.x;
		vec3 base = vec3(0.0, 0.0, -radius) + axis * radius;
		float depth = -(MODELVIEW_MATRIX * vec4(base, 1.0)).z;
		float tick = min(0.2 * radius, 24.0 * pixel_size(PROJECTION_MATRIX, VIEWPORT_SIZE, depth) / scale_of(MODEL_MATRIX));
		place = vec4(base + axis * side * VERTEX.x * tick, 1.0);
		derivative = vec4(axis * side, 0.0);
	} else {
		float turn = VERTEX.x;
		place = vec4(cap_point(1.0, turn, eye, radius), 1.0);
		derivative = vec4(cap_point(1.0, turn + 0.01, eye, radius) - place.xyz, 0.0);
		arc = turn / 6.28318531;
		if (height_above_sphere(eye, radius) < 0.0) {
			opacity = 0.0;
		}
	}
)";

constexpr const char *PLACE_LINE = R"(
	vec3 eye = eye_of(MODEL_MATRIX, CAMERA_POSITION_WORLD);
	float away = distance_of(PROJECTION_MATRIX, length(eye.yz), scale_of(MODEL_MATRIX));
	float at;
	if (VERTEX.z > 0.5) {
		at = line_arrow_place(VERTEX.z - 7.0, eye.x, away);
	} else {
		float far = far_plane(PROJECTION_MATRIX) / scale_of(MODEL_MATRIX);
		at = eye.x + sign(VERTEX.x) * endless_extent(abs(VERTEX.x), 20.0 * away, far);
		arc = at;
	}
	place = vec4(at, 0.0, 0.0, 1.0);
	derivative = vec4(1.0, 0.0, 0.0, 0.0);
)";

// The horizon: points at infinity.
constexpr const char *PLACE_PLANE = R"(
	place = vec4(cos(VERTEX.y), sin(VERTEX.y), 0.0, 0.0);
	derivative = vec4(-sin(VERTEX.y), cos(VERTEX.y), 0.0, 0.0);
	arc = VERTEX.y / 6.28318531;
	if (!is_perspective(PROJECTION_MATRIX)) {
		opacity = 0.0;
	}
)";

constexpr const char *STROKE_BEGIN = R"(
// Pixels from the middle, along and across, times the depth; the depth. The width in clip space grows with the depth, so
// that only this product is linear over both triangles of a piece of a line.
varying vec3 local_by_depth;
varying vec4 look; // arc or radius of signs, half width, profile, opacity
varying vec4 own_colour;

void vertex() {
	tint = tint_of(COLOR);
	shape = INSTANCE_CUSTOM;
	vec4 place;
	vec4 derivative;
	float arc = CUSTOM0.w;
	float opacity = CUSTOM1.w;
)";

// The image of the derivative on the screen is that of (x / w, y / w), times w^2.
constexpr const char *STROKE_END = R"(
	vec4 clip = PROJECTION_MATRIX * (MODELVIEW_MATRIX * place);
	vec4 ahead = PROJECTION_MATRIX * (MODELVIEW_MATRIX * derivative);
	vec2 along = (ahead.xy * clip.w - clip.xy * ahead.w) * VIEWPORT_SIZE;
	float speed = length(along);
	along = speed > 1e-20 ? along / speed : vec2(1.0, 0.0);
	if (CUSTOM1.z > 1.5) {
		along = vec2(1.0, 0.0);
	}
	float thick = 0.5 * shape.w;
	bool is_line = CUSTOM1.z < 0.5;
	// Of double lines both are as thick as one half of a line.
	vec2 offset = CUSTOM1.xy * thick * (is_line && shape.z > 0.5 ? 1.9 : 1.0);
	vec2 padded = offset + sign(offset) * 1.0;
	clip.xy += (along * padded.x + vec2(-along.y, along.x) * padded.y) * 2.0 / VIEWPORT_SIZE * clip.w;
	// Lines lie on surfaces, signs on lines: a little nearer than these. What is beyond the far plane is drawn on it.
	float nearer = 1.0005 + (is_line ? 0.0 : pixel_size(PROJECTION_MATRIX, VIEWPORT_SIZE, 1.0) * CUSTOM0.w * thick);
	clip.z = (clip.z - FAR_DEPTH * clip.w) * nearer + FAR_DEPTH * clip.w;
	clip.z = max(clip.z, (FAR_DEPTH + 1e-7) * clip.w);
	POSITION = clip;
	VERTEX = (MODELVIEW_MATRIX * place).xyz;
	local_by_depth = vec3(padded * clip.w, clip.w);
	look = vec4(is_line ? arc : arc * thick, abs(offset.y), CUSTOM1.z, opacity);
	own_colour = CUSTOM2;
	if (LINEAR_COLOURS) {
		own_colour.rgb = pow(own_colour.rgb, vec3(2.2));
	}
}

float coverage(float outside) {
	return clamp(0.5 - outside, 0.0, 1.0);
}

void fragment() {
	vec3 colour = mix(tint.rgb, own_colour.rgb, own_colour.a);
	float alpha = look.w * tint.a;
	vec2 local = local_by_depth.xy / local_by_depth.z;
	float radius = length(local);
	float hollow = max(shape.y, shape.z);
	if (look.z < 0.5) {
		float width = max(look.y, 0.5);
		alpha *= coverage(abs(local.y) - look.y) * min(1.0, 2.0 * look.y);
		if (shape.z > 0.5 && look.y > 0.7) {
			// Two lines with a gap between.
			alpha *= 1.0 - coverage(abs(local.y) - 0.42 * look.y);
		}
		if (shape.y > 0.5) {
			// Dashes as long as some pixels, a power of two of the arc: they stay where they are when the view moves.
			float period = exp2(ceil(log2(max(fwidth(look.x), 1e-12) * 11.0)));
			float part = abs(fract(look.x / period) - 0.5) * period / max(fwidth(look.x), 1e-12);
			alpha *= coverage(part - 0.29 * period / max(fwidth(look.x), 1e-12));
		}
	} else if (look.z < 1.5) {
		// A triangle from -r to r, its notch half way.
		float r = look.x;
		float side = abs(local.y) * 0.89 - (r - local.x) * 0.37;
		float back = -local.x - r;
		alpha *= coverage(max(side, back));
	} else if (look.z < 2.5) {
		float rim = coverage(abs(radius - look.x + 0.8) - 0.8);
		float ball = coverage(radius - look.x);
		float light = clamp(1.0 - length(local / look.x - vec2(-0.3, 0.35)) * 0.55, 0.0, 1.0);
		colour = mix(colour * 0.82, min(colour * 1.1 + 0.10, vec3(1.0)), light);
		alpha *= mix(ball, rim, shape.y);
		if (shape.z > 0.5 && shape.y < 0.5) {
			alpha *= max(rim, coverage(radius - 0.38 * look.x));
		}
	} else {
		alpha *= coverage(abs(radius - look.x + 0.7) - 0.7);
	}
	if (alpha < 0.02 || (alpha >= 0.5) != IS_CORE) {
		discard;
	}
	ALBEDO = colour;
	ALPHA = alpha;
}
)";

constexpr const char *ROUND_FILL = R"(
varying vec3 normal;
varying vec3 seen_from;

void vertex() {
	tint = tint_of(COLOR);
	shape = INSTANCE_CUSTOM;
	float radius = 1.0;
	vec3 eye = round_eye(MODEL_MATRIX, INV_VIEW_MATRIX, PROJECTION_MATRIX, CAMERA_POSITION_WORLD);
	vec3 place = cap_point(VERTEX.x, VERTEX.y, eye, radius);
	VERTEX = (MODELVIEW_MATRIX * vec4(place, 1.0)).xyz;
	vec4 clip = PROJECTION_MATRIX * vec4(VERTEX, 1.0);
	clip.z = max(clip.z, (FAR_DEPTH + 1e-7) * clip.w);
	POSITION = clip;
	normal = (place + vec3(0.0, 0.0, radius)) / radius;
	seen_from = normalize(eye - place);
}

void fragment() {
	float facing = abs(dot(normalize(normal), normalize(seen_from)));
	float rim = pow(1.0 - facing, 2.5);
	float light = 0.5 + 0.5 * normalize(mat3(VIEW_MATRIX) * (mat3(MODEL_MATRIX) * normal)).y;
	ALBEDO = tint.rgb * mix(0.82, 1.08, light);
	ALPHA = tint.a * face_opacity(mix(0.13, 0.42, rim) * (shape.y > 0.5 ? 0.45 : 1.0));
}
)";

constexpr const char *PLANE_FILL = R"(
varying vec2 place;
varying float front;

void vertex() {
	tint = tint_of(COLOR);
	shape = INSTANCE_CUSTOM;
	vec3 eye = eye_of(MODEL_MATRIX, CAMERA_POSITION_WORLD);
	float height = distance_of(PROJECTION_MATRIX, abs(eye.z), scale_of(MODEL_MATRIX));
	float far = far_plane(PROJECTION_MATRIX) / scale_of(MODEL_MATRIX);
	float extent = endless_extent(VERTEX.x, 20.0 * height, far);
	place = eye.xy + extent * vec2(cos(VERTEX.y), sin(VERTEX.y));
	front = is_perspective(PROJECTION_MATRIX) ? eye.z : dot(INV_VIEW_MATRIX[2].xyz, MODEL_MATRIX[2].xyz);
	VERTEX = (MODELVIEW_MATRIX * vec4(place, 0.0, 1.0)).xyz;
	vec4 clip = PROJECTION_MATRIX * vec4(VERTEX, 1.0);
	clip.z = max(clip.z, (FAR_DEPTH + 1e-7) * clip.w);
	POSITION = clip;
}

// Lines of a grid, one pixel wide, gone where they would be closer than a few pixels.
float grid(vec2 at, vec2 pixel, float gap, float width) {
	vec2 steps = pixel / gap;
	vec2 off = abs(fract(at / gap + 0.5) - 0.5) / max(steps, vec2(1e-12));
	vec2 line = clamp(vec2(0.5 * width + 0.5) - off, 0.0, 1.0) * (1.0 - smoothstep(vec2(0.08), vec2(0.3), steps));
	return max(line.x, line.y);
}

void fragment() {
	vec2 pixel = max(fwidth(place), vec2(1e-12));
	float finest = min(pixel.x, pixel.y);
	float level = log(finest * 14.0) / log(10.0);
	float gap = pow(10.0, ceil(level));
	float fade = ceil(level) - level;
	float lines = max(grid(place, pixel, gap, 1.0) * fade * 0.55, max(grid(place, pixel, gap * 10.0, 1.0) * mix(0.9, 0.55, 1.0 - fade), grid(place, pixel, gap * 100.0, 1.0) * 0.9));
	vec3 colour = tint.rgb;
	float alpha = 0.13 + 0.30 * lines;
	if (front < 0.0) {
		// The back is duller and hatched.
		colour = mix(colour, vec3(dot(colour, vec3(0.3, 0.6, 0.1))), 0.55) * 0.75;
		float hatch = abs(fract((FRAGCOORD.x + FRAGCOORD.y) / 9.0) - 0.5) * 9.0;
		alpha = 0.14 + 0.22 * lines + 0.16 * clamp(1.0 - hatch, 0.0, 1.0);
	}
	ALBEDO = colour;
	ALPHA = tint.a * face_opacity(alpha);
}
)";

constexpr const char *SCREEN_FILL = R"(
void vertex() {
	tint = tint_of(COLOR);
	shape = INSTANCE_CUSTOM;
	float depth = -(MODELVIEW_MATRIX * vec4(0.0, 0.0, 0.0, 1.0)).z;
	float pixel = pixel_size(PROJECTION_MATRIX, VIEWPORT_SIZE, depth) / scale_of(MODEL_MATRIX) * 0.5 * shape.w;
	VERTEX = (MODELVIEW_MATRIX * vec4(VERTEX * pixel, 1.0)).xyz;
	POSITION = PROJECTION_MATRIX * vec4(VERTEX, 1.0);
}

void fragment() {
	ALBEDO = tint.rgb;
	ALPHA = tint.a * face_opacity(0.3);
}
)";

std::string round_functions() {
	return std::string(ROUND_EYE) + ring_point_source + ring_tangent_source + nearest_angle_source + spread_angle_source + ring_arrow_angle_source + height_above_sphere_source + cap_point_source;
}

std::string endless_functions() {
	return std::string(endless_extent_source) + line_arrow_place_source;
}

} // namespace

std::string stroke_shader(Space space, Renderer renderer, StrokePass pass) {
	const bool core = pass == StrokePass::core;
	const std::string begin = std::string("shader_type spatial;\nrender_mode unshaded, cull_disabled, shadows_disabled, fog_disabled, skip_vertex_transform, ") + (core ? "depth_draw_always;\nconst bool IS_CORE = true;\n" : "depth_draw_never;\nconst bool IS_CORE = false;\n") + depth_of(renderer) + COMMON;
	switch (space) {
		case Space::model:
			return begin + STROKE_BEGIN + PLACE_MODEL + STROKE_END;
		case Space::screen:
			return begin + STROKE_BEGIN + PLACE_SCREEN + STROKE_END;
		case Space::round:
			return begin + round_functions() + STROKE_BEGIN + PLACE_ROUND + STROKE_END;
		case Space::line:
			return begin + endless_functions() + STROKE_BEGIN + PLACE_LINE + STROKE_END;
		default:
			return begin + STROKE_BEGIN + PLACE_PLANE + STROKE_END;
	}
}

std::string fill_shader(Space space, Renderer renderer) {
	const std::string begin = std::string("shader_type spatial;\nrender_mode unshaded, cull_disabled, depth_draw_never, shadows_disabled, fog_disabled, skip_vertex_transform;\n") + depth_of(renderer) + COMMON;
	switch (space) {
		case Space::round:
			return begin + round_functions() + ROUND_FILL;
		case Space::plane:
			return begin + endless_functions() + PLANE_FILL;
		default:
			return begin + SCREEN_FILL;
	}
}

} // namespace playground::drawing
