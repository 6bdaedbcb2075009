#include "playground/document/document_size.hpp"

#include "cga/text/json_reader.hpp"
#include "playground/document/document_json.hpp"

namespace playground {

namespace {

// What to_json() writes around the name, the expression and the attributes of an entry, and around an attribute.
constexpr std::string_view AROUND_ENTRY = "\t\t{\"name\": , \"expression\": , \"attributes\": {}},\n";
constexpr std::string_view AROUND_ATTRIBUTE = ": , ";

size_t json_length(std::string_view text) {
	std::string json;
	cga::append_json_string(json, text);
	return json.size();
}

} // namespace

DocumentSize &DocumentSize::operator+=(const DocumentSize &other) {
	bytes += other.bytes;
	attributes += other.attributes;
	operations += other.operations;
	return *this;
}

DocumentSize &DocumentSize::operator-=(const DocumentSize &other) {
	bytes -= other.bytes;
	attributes -= other.attributes;
	operations -= other.operations;
	return *this;
}

DocumentSize size_of_empty_document() {
	static const size_t BYTES = to_json({}).size() + std::string_view("\t\"attributes\": {},\n").size();
	return { BYTES, 0, 0 };
}

DocumentSize size_of_entry(std::string_view name, std::string_view text, size_t operations) {
	return { AROUND_ENTRY.size() + json_length(name) + json_length(text), 0, operations };
}

DocumentSize size_of_attributes(const Attributes &attributes) {
	DocumentSize size;
	for (const auto &[key, value] : attributes) {
		size += size_of_attribute(key, value);
	}
	return size;
}

DocumentSize size_of_attribute(std::string_view key, const AttributeValue &value) {
	std::string json;
	append_attribute_value(json, value);
	return { AROUND_ATTRIBUTE.size() + json_length(key) + json.size(), 1, 0 };
}

Error too_many_entries() {
	return "a document has at most " + std::to_string(MAX_ENTRIES) + " entries";
}

cga::Result<void, Error> check_size(const DocumentSize &size) {
	if (size.bytes > MAX_DOCUMENT_LENGTH) {
		return Error("the document would be too long: as JSON it would have at least " + std::to_string(size.bytes) + " bytes, and at most " + std::to_string(MAX_DOCUMENT_LENGTH) + " are accepted");
	}
	if (size.attributes > MAX_ATTRIBUTES) {
		return Error("the document would have at least " + std::to_string(size.attributes) + " attributes, and at most " + std::to_string(MAX_ATTRIBUTES) + " are accepted");
	}
	if (size.operations > MAX_OPERATIONS) {
		return Error("the expressions of the document would take at least " + std::to_string(size.operations) + " operations (a product is one, a call 12 or more), and at most " + std::to_string(MAX_OPERATIONS) + " are accepted");
	}
	return {};
}

} // namespace playground
