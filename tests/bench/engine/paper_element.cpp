#include "paper_element.hpp"

namespace bench::paper {

namespace {

constexpr size_t COUNT = cga::BLADE_COUNT;

template <cga::Product PRODUCT, size_t RESULT, size_t LEFT>
constexpr int8_t SIGN = cga::SIGN_TABLE<PRODUCT>[cga::BLADE_BITMAPS[LEFT]][cga::BLADE_BITMAPS[RESULT]];

template <size_t RESULT, size_t LEFT>
constexpr size_t RIGHT = cga::BLADE_INDICES[cga::BLADE_BITMAPS[LEFT] ^ cga::BLADE_BITMAPS[RESULT]];

template <cga::Product PRODUCT, size_t RESULT, size_t LEFT>
void add_term(const Element &a, const Element &b, float &sum) {
	if constexpr (SIGN<PRODUCT, RESULT, LEFT> > 0) {
		sum += a[LEFT] * b[RIGHT<RESULT, LEFT>];
	} else if constexpr (SIGN<PRODUCT, RESULT, LEFT> < 0) {
		sum -= a[LEFT] * b[RIGHT<RESULT, LEFT>];
	}
}

template <cga::Product PRODUCT, size_t RESULT, size_t... LEFT>
float coefficient(const Element &a, const Element &b, std::index_sequence<LEFT...>) {
	float sum = 0.0f;
	(add_term<PRODUCT, RESULT, LEFT>(a, b, sum), ...);
	return sum;
}

template <cga::Product PRODUCT, size_t... RESULT>
void multiply(const Element &a, const Element &b, Element &sum, std::index_sequence<RESULT...>) {
	((sum[RESULT] = coefficient<PRODUCT, RESULT>(a, b, std::make_index_sequence<COUNT>())), ...);
}

} // namespace

Element *Pool::acquire() {
	++_acquired;
	if (_free.empty()) {
		_elements.push_back(std::make_unique<Element>());
		return _elements.back().get();
	}
	Element *element = _free.front();
	_free.pop_front();
	return element;
}

void Pool::release(Element *element) {
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
		for (const int sign : row) {
			count += sign != 0;
		}
	}
	return count;
}

} // namespace bench::paper
