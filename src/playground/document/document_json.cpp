#include "playground/document/document_json.hpp"

#include "cga/text/json.hpp"
#include "cga/text/json_reader.hpp"
#include "cga/text/number_text.hpp"
#include "playground/expression/names.hpp"

#include <cmath>
#include <set>
#include <utility>

namespace playground {

namespace {

constexpr std::string_view FORMAT = "ga_godot_scene";
constexpr size_t MAX_ERRORS = 100;

void append_attributes(std::string &json, const Attributes &attributes) {
	json += '{';
	const char *separator = "";
	for (const auto &[key, value] : attributes) {
		json += separator;
		separator = ", ";
		cga::append_json_string(json, key);
		json += ": ";
		append_attribute_value(json, value);
	}
	json += '}';
}

class DocumentReader {
public:
	explicit DocumentReader(std::string_view text) :
			_text(text), _reader(text) {}

	LoadedDocument read() {
		if (_text.size() > MAX_DOCUMENT_LENGTH) {
			report_at(0, "the document is too long: it has " + std::to_string(_text.size()) + " bytes, and at most " + std::to_string(MAX_DOCUMENT_LENGTH) + " are accepted");
		} else if (_reader.next_is('[')) {
			read_multivectors();
		} else if (_reader.next_is('{')) {
			read_document_object();
			if (!_reader.error() && !_reader.is_at_end()) {
				_reader.fail_expected("the end");
			}
			report_error();
			_loaded.is_document = _has_format || _has_entries;
			if (!_loaded.is_document && _errors.empty()) {
				report_at(0, "expected the key \"entries\" in the document");
			}
		} else {
			_reader.fail_expected("'{' before a document or '[' before 32 coefficients");
			report_error();
		}
		if (_attribute_count > MAX_ATTRIBUTES) {
			_loaded = {};
			_unlisted_errors = 0;
			_errors = { { "the document has too many attributes: at least " + std::to_string(_attribute_count) + ", and at most " + std::to_string(MAX_ATTRIBUTES) + " are accepted", 0 } };
		}
		_loaded.errors = cga::describe_errors(_text, _errors);
		if (_unlisted_errors > 0) {
			_loaded.errors.push_back("and " + std::to_string(_unlisted_errors) + (_unlisted_errors == 1 ? " more error" : " more errors"));
		}
		return std::move(_loaded);
	}

private:
	void report_error() {
		if (_reader.error()) {
			report_at(_reader.error()->offset, _reader.error()->message);
		}
	}

	void report_at(size_t offset, std::string message) {
		if (_errors.size() < MAX_ERRORS) {
			_errors.push_back({ std::move(message), offset });
		} else {
			++_unlisted_errors;
		}
	}

	// Calls `read_member` with each key. Stops at the first error and returns false.
	template <class ReadMember>
	bool read_object(ReadMember read_member) {
		if (!_reader.take('{', "'{'")) {
			return false;
		}
		bool is_first = true;
		while (!_reader.next_is('}')) {
			if (!is_first && !_reader.take(',', "',' or '}'")) {
				return false;
			}
			const std::optional<std::string> key = _reader.read_string();
			if (!key || !_reader.take(':', "':' after the key") || !read_member(*key)) {
				return false;
			}
			is_first = false;
		}
		return _reader.take('}', "'}'");
	}

	bool read_document_object() {
		return read_object([this](const std::string &key) {
			if (key == "format") {
				return read_format();
			}
			if (key == "version") {
				return read_version();
			}
			if (key == "attributes") {
				return read_attributes(_loaded.state.attributes, "the document");
			}
			return key == "entries" ? read_entries() : _reader.skip_value();
		});
	}

	bool read_format() {
		_reader.next_character();
		const size_t offset = _reader.position();
		const std::optional<std::string> format = _reader.read_string();
		if (!format) {
			return false;
		}
		_has_format = *format == FORMAT;
		return _has_format || _reader.fail(offset, "expected the format \"" + std::string(FORMAT) + "\"; this file has another format");
	}

	bool read_version() {
		_reader.next_character();
		const size_t offset = _reader.position();
		const std::optional<double> version = _reader.read_number();
		if (!version) {
			return false;
		}
		if (!(*version >= 1.0) || *version != std::floor(*version)) {
			report_at(offset, "the version must be an integer of at least 1");
		} else if (*version > DOCUMENT_VERSION) {
			report_at(offset, "the document has a newer version than " + std::to_string(DOCUMENT_VERSION) + ", the latest that this GA-Godot reads; update GA-Godot");
		}
		return true;
	}

	// Empty after an error. An array or an object is reported and read as no value.
	std::optional<AttributeValue> read_attribute() {
		const auto value = [](auto read) { return read ? std::optional<AttributeValue>(*read) : std::nullopt; };
		switch (_reader.next_character()) {
			case '"':
				return value(_reader.read_string());
			case 't':
			case 'f':
				return value(_reader.read_boolean());
			case 'n':
				return _reader.read_null() ? std::optional<AttributeValue>(AttributeValue()) : std::nullopt;
			case '[':
			case '{':
				report_at(_reader.position(), "expected a string, a number, true, false or null as attribute");
				return _reader.skip_value() ? std::optional<AttributeValue>(AttributeValue()) : std::nullopt;
			default:
				return value(_reader.read_number());
		}
	}

	bool read_attributes(Attributes &attributes, const std::string &owner) {
		return read_object([this, &attributes, &owner](const std::string &key) {
			_reader.next_character();
			const size_t offset = _reader.position();
			std::optional<AttributeValue> value = read_attribute();
			if (!value) {
				return false;
			}
			if (const cga::Result<void, Error> checked = check_attribute(key, *value); !checked) {
				report_at(offset, "attribute of " + owner + " skipped: " + checked.error().message);
			} else {
				set_attribute(attributes, key, *std::move(value));
			}
			return ++_attribute_count <= MAX_ATTRIBUTES || _reader.fail(offset, "too many attributes");
		});
	}

	bool read_entries() {
		_has_entries = true;
		if (!_reader.take('[', "'[' before the entries")) {
			return false;
		}
		bool is_first = true;
		while (!_reader.next_is(']')) {
			if (is_first || _reader.take(',', "',' or ']'")) {
				read_entry();
			}
			is_first = false;
			if (_reader.error()) {
				const size_t error_offset = _reader.error()->offset;
				report_error();
				if (_attribute_count > MAX_ATTRIBUTES || !find_entry(error_offset)) {
					return false;
				}
				is_first = true;
			}
		}
		return _reader.take(']', "']'");
	}

	// Continues at the next entry after an error. No string contains `{"name"`, because its quotes would be escaped.
	bool find_entry(size_t from) {
		for (size_t start = _text.find('{', from); start != std::string_view::npos; start = _text.find('{', start + 1)) {
			_reader.restart_at(start + 1);
			if (_reader.next_is('"') && _text.substr(_reader.position(), 6) == "\"name\"") {
				_reader.restart_at(start);
				return true;
			}
		}
		_reader.restart_at(_text.size());
		return false;
	}

	void read_entry() {
		_reader.next_character();
		const size_t offset = _reader.position();
		EntryState entry;
		std::optional<std::string> text;
		const bool is_read = read_object([this, &entry, &text](const std::string &key) {
			if (key == "name") {
				std::optional<std::string> name = _reader.read_string();
				entry.name = std::move(name).value_or("");
				return !_reader.error();
			}
			if (key == "expression") {
				text = _reader.read_string();
				return text.has_value();
			}
			if (key == "attributes") {
				return read_attributes(entry.attributes, "'" + entry.name + "'");
			}
			return _reader.skip_value();
		});
		const std::string what = check_name(entry.name) ? "entry '" + entry.name + "'" : "entry";
		if (!is_read) {
			const cga::OffsetError error = *_reader.error();
			_reader.restart_at(error.offset);
			_reader.fail(error.offset, what + " skipped: " + error.message);
		} else if (const cga::Result<void, Error> checked = check_entry(entry.name, text.has_value()); !checked) {
			report_at(offset, what + " skipped: " + checked.error().message);
		} else {
			entry.text = *std::move(text);
			_names.insert(entry.name);
			_loaded.state.entries.push_back(std::move(entry));
		}
	}

	cga::Result<void, Error> check_entry(const std::string &name, bool has_text) const {
		if (const cga::Result<void, Error> checked = check_name(name); !checked) {
			return checked;
		}
		if (!has_text) {
			return Error("it has no expression");
		}
		if (_names.count(name) > 0) {
			return Error("an earlier entry has the same name");
		}
		if (_names.size() >= MAX_ENTRIES) {
			return too_many_entries();
		}
		return {};
	}

	// At '[': an array of 32 numbers, or an array of such arrays.
	void read_multivectors() {
		_reader.take('[', "'['");
		if (!_reader.next_is('[')) {
			read_multivector(0, _text.size());
			return;
		}
		do {
			_reader.next_character();
			const size_t start = _reader.position();
			if (_reader.skip_value()) {
				read_multivector(start, _reader.position());
			}
		} while (!_reader.error() && _reader.next_is(',') && _reader.take(',', "','"));
		if (_reader.take(']', "',' or ']'") && !_reader.is_at_end()) {
			_reader.fail_expected("the end");
		}
		report_error();
	}

	void read_multivector(size_t start, size_t end) {
		const std::string_view array = _text.substr(start, end - start);
		const cga::TextResult<cga::Multivector> value = cga::from_json(array);
		if (!value) {
			report_at(start + value.error().offset, "multivector skipped: " + value.error().message);
			return;
		}
		if (_loaded.state.entries.size() >= MAX_ENTRIES) {
			report_at(start, "multivector skipped: " + too_many_entries().message);
			return;
		}
		_loaded.is_document = true;
		_loaded.state.entries.push_back({ "x" + std::to_string(_loaded.state.entries.size() + 1), cga::to_json(*value), {} });
	}

	std::string_view _text;
	cga::JsonReader _reader;
	LoadedDocument _loaded;
	std::vector<cga::OffsetError> _errors;
	size_t _unlisted_errors = 0;
	size_t _attribute_count = 0;
	std::set<std::string> _names;
	bool _has_format = false;
	bool _has_entries = false;
};

} // namespace

void append_attribute_value(std::string &json, const AttributeValue &value) {
	if (const bool *boolean = std::get_if<bool>(&value)) {
		json += *boolean ? "true" : "false";
	} else if (const double *number = std::get_if<double>(&value)) {
		cga::append_number(json, *number);
	} else if (const std::string *text = std::get_if<std::string>(&value)) {
		cga::append_json_string(json, *text);
	} else {
		json += "null";
	}
}

std::string to_json(const DocumentState &state) {
	std::string json = "{\n\t\"format\": ";
	cga::append_json_string(json, FORMAT);
	json += ",\n\t\"version\": " + std::to_string(DOCUMENT_VERSION);
	if (!state.attributes.empty()) {
		json += ",\n\t\"attributes\": ";
		append_attributes(json, state.attributes);
	}
	json += ",\n\t\"entries\": [";
	const char *separator = "\n";
	for (const EntryState &entry : state.entries) {
		json += separator;
		separator = ",\n";
		json += "\t\t{\"name\": ";
		cga::append_json_string(json, entry.name);
		json += ", \"expression\": ";
		cga::append_json_string(json, entry.text);
		if (!entry.attributes.empty()) {
			json += ", \"attributes\": ";
			append_attributes(json, entry.attributes);
		}
		json += '}';
	}
	return json + (state.entries.empty() ? "]\n}\n" : "\n\t]\n}\n");
}

LoadedDocument read_document(std::string_view text) {
	return DocumentReader(text).read();
}

} // namespace playground
