#include "playground/drawing/form.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <initializer_list>

using namespace playground::drawing;

TEST_CASE("the mesh of each form has valid triangles") {
	for (int i = 0; i < SHARED_FORM_COUNT; ++i) {
		CAPTURE(i);
		const FormMesh mesh = mesh_of(Form(i));
		CHECK_FALSE(mesh.strokes.vertices.empty());
		CHECK(mesh.strokes.vertices.size() < 2500);
		CHECK(mesh.strokes.indices.size() % 3 == 0);
		for (const int32_t index : mesh.strokes.indices) {
			CHECK(index >= 0);
			CHECK(size_t(index) < mesh.strokes.vertices.size());
		}
		for (const StrokeVertex &vertex : mesh.strokes.vertices) {
			CHECK(glm::length(vertex.tangent) > 0.0f);
			CHECK(glm::length(vertex.offset) > 0.0f);
			CHECK(vertex.opacity > 0.0f);
			CHECK(vertex.opacity <= 1.0f);
		}
		for (const int32_t index : mesh.fill.indices) {
			CHECK(size_t(index) < mesh.fill.vertices.size());
		}
		CHECK(mesh.fill.indices.size() % 3 == 0);
	}
	CHECK(mesh_of(Form::CUSTOM).strokes.vertices.empty());
}

TEST_CASE("only surfaces have fills") {
	for (const Form form : { Form::SPHERE, Form::PLANE, Form::TANGENT_ACROSS }) {
		CHECK_FALSE(mesh_of(form).fill.indices.empty());
	}
	CHECK(mesh_of(Form::CIRCLE).fill.indices.empty());
}

TEST_CASE("a curve is a strip whose arc length increases along it") {
	Strokes strokes;
	strokes.add_curve({ { { 0.0f, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f } }, { { 3.0f, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f } }, { { 3.0f, 4.0f, 0.0f }, { 0.0f, 1.0f, 0.0f } } });
	CHECK(strokes.vertices.size() == 6);
	CHECK(strokes.indices.size() == 12);
	CHECK(strokes.vertices[5].arc == 7.0f);
	CHECK(strokes.vertices[4].offset.y == -strokes.vertices[5].offset.y);
}

TEST_CASE("the arrow of a point pair points from the first point to the second") {
	const FormMesh mesh = mesh_of(Form::POINT_PAIR);
	int arrows = 0, dots = 0;
	for (const StrokeVertex &vertex : mesh.strokes.vertices) {
		arrows += int(vertex.profile == Profile::ARROW);
		dots += int(vertex.profile == Profile::DOT);
		CHECK(vertex.tangent.x > 0.0f);
	}
	CHECK(arrows == 4);
	CHECK(dots == 8);
}
