#include "playground/drawing/shader.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

using namespace playground::drawing;

TEST_CASE("shaders are assembled completely") {
	for (const Renderer renderer : { Renderer::COMPATIBILITY, Renderer::RENDERING_DEVICE }) {
		for (const Space space : { Space::MODEL, Space::SCREEN, Space::ROUND, Space::LINE, Space::PLANE }) {
			for (const StrokePass pass : { StrokePass::CORE, StrokePass::FRINGE }) {
				const std::string shader = stroke_shader(space, renderer, pass);
				CHECK(shader.rfind("shader_type spatial;", 0) == 0);
				CHECK(shader.find("#include") == std::string::npos);
				CHECK(shader.find("\tpoint = vec4(") < shader.find("\tPOSITION = clip;"));
			}
		}
		for (const Space space : { Space::SCREEN, Space::ROUND, Space::PLANE }) {
			CHECK(fill_shader(space, renderer).find("void fragment()") != std::string::npos);
		}
	}
}
