#include "paper_element.hpp"

namespace bench::paper {

namespace {

constexpr size_t COUNT = cga::BLADE_COUNT;

template <cga::Product product, size_t result, size_t left>
constexpr int SIGN = cga::SIGN_TABLE<product>[cga::BLADE_BITMAPS[left]][cga::BLADE_BITMAPS[result]];

template <size_t result, size_t left>
constexpr size_t RIGHT = cga::BLADE_INDICES[cga::BLADE_BITMAPS[left] ^ cga::BLADE_BITMAPS[result]];

template <cga::Product product, size_t result, size_t left>
void add_term(const Element &a, const Element &b, float &sum) {
	if constexpr (SIGN<product, result, left> > 0) {
		sum += a[left] * b[RIGHT<result, left>];
	} else if constexpr (SIGN<product, result, left> < 0) {
		sum -= a[left] * b[RIGHT<result, left>];
	}
}

template <cga::Product product, size_t result, size_t... left>
float coefficient(const Element &a, const Element &b, std::index_sequence<left...>) {
	float sum = 0.0f;
	(add_term<product, result, left>(a, b, sum), ...);
	return sum;
}

template <cga::Product product, size_t... result>
void multiply(const Element &a, const Element &b, Element &sum, std::index_sequence<result...>) {
	((sum[result] = coefficient<product, result>(a, b, std::make_index_sequence<COUNT>())), ...);
}

} // namespace

Element *Pool::take() {
	++_taken;
	if (_free.empty()) {
		_elements.push_back(std::make_unique<Element>());
		return _elements.back().get();
	}
	Element *element = _free.front();
	_free.pop_front();
	return element;
}

void Pool::give_back(Element *element) {
	*element = Element();
	_free.push_back(element);
}

void geometric_product(const Element &left, const Element &right, Element &result) {
	multiply<cga::Product::GEOMETRIC>(left, right, result, std::make_index_sequence<COUNT>());
}

void inner_product(const Element &left, const Element &right, Element &result) {
	multiply<cga::Product::INNER>(left, right, result, std::make_index_sequence<COUNT>());
}

void conjugate(const Element &element, Element &result) {
	constexpr float SIGNS[] = { 1.0f, -1.0f, -1.0f, 1.0f, 1.0f, -1.0f };
	for (size_t index = 0; index < COUNT; ++index) {
		result[index] = SIGNS[cga::blade_grade(int(index))] * element[index];
	}
}

void scale(const Element &element, float factor, Element &result) {
	for (size_t index = 0; index < COUNT; ++index) {
		result[index] = factor * element[index];
	}
}

int term_count(cga::Product product) {
	const cga::SignTable signs = cga::make_sign_table(product);
	int count = 0;
	for (const auto &row : signs) {
		for (const int8_t sign : row) {
			count += sign != 0;
		}
	}
	return count;
}

} // namespace bench::paper
