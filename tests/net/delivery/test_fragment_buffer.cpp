#include "net/delivery/fragment_buffer.hpp"

#include "ack_numbers.hpp"

#include <doctest/doctest.h>

using namespace net;

namespace {

using Bytes = std::vector<uint8_t>;

FragmentItem fragment(const Bytes &bytes, int index, int count, uint8_t snapshot = 7) {
	FragmentItem item;
	item.snapshot = snapshot;
	item.next_chunk = 200;
	item.index = uint16_t(index);
	item.count = uint16_t(count);
	item.bytes = bytes.data();
	item.size = bytes.size();
	return item;
}

} // namespace

TEST_CASE("fragment buffer: the snapshot is reassembled from fragments in any order") {
	const Bytes pieces[] = { { 1, 2, 3 }, { 4 }, { 5, 6 } };
	FragmentBuffer buffer;
	CHECK_FALSE(buffer.is_open());
	CHECK_FALSE(buffer.belongs(fragment(pieces[2], 2, 3)));
	buffer.start(fragment(pieces[2], 2, 3));
	CHECK(buffer.is_open());
	CHECK(buffer.number() == 7);
	CHECK(buffer.next_chunk() == 200);
	for (const int index : { 2, 0, 1 }) {
		CHECK_FALSE(buffer.is_complete());
		CHECK(buffer.belongs(fragment(pieces[index], index, 3)));
		CHECK(buffer.add(fragment(pieces[index], index, 3)));
		CHECK_FALSE(buffer.add(fragment(pieces[index], index, 3)));
	}
	CHECK(buffer.is_complete());
	Bytes snapshot{ 9, 9 };
	buffer.finish(snapshot);
	CHECK(snapshot == Bytes{ 1, 2, 3, 4, 5, 6 });
	CHECK_FALSE(buffer.is_open());
	CHECK_FALSE(buffer.is_complete());
	CHECK_FALSE(buffer.belongs(fragment(pieces[0], 0, 3)));
}

TEST_CASE("fragment buffer: fragments of another snapshot, or another count, do not belong") {
	const Bytes bytes = { 1 };
	FragmentBuffer buffer;
	buffer.start(fragment(bytes, 0, 3));
	CHECK(buffer.add(fragment(bytes, 0, 3)));
	CHECK_FALSE(buffer.belongs(fragment(bytes, 1, 3, 8)));
	CHECK_FALSE(buffer.belongs(fragment(bytes, 1, 4)));
	buffer.start(fragment(bytes, 1, 2, 8));
	CHECK(buffer.add(fragment(bytes, 1, 2, 8)));
	CHECK_FALSE(buffer.is_complete()); // fragment 0 belonged to the previous snapshot
	CHECK(buffer.add(fragment(bytes, 0, 2, 8)));
	CHECK(buffer.is_complete());
}

TEST_CASE("fragment buffer: it acknowledges what has arrived, or all of a decoded snapshot") {
	const Bytes bytes = { 1 };
	FragmentBuffer buffer;
	buffer.start(fragment(bytes, 0, 60));
	CHECK(buffer.ack(false).snapshot == 7);
	CHECK(buffer.ack(false).next == 0);
	CHECK(ack_numbers(buffer.ack(false).later).empty());
	for (const int index : { 0, 1, 3, 34, 35, 59 }) {
		CHECK(buffer.add(fragment(bytes, index, 60)));
	}
	CHECK(buffer.ack(false).next == 2);
	CHECK(ack_numbers(buffer.ack(false).later) == AckNumbers{ 1, 32, 33, 57 });
	CHECK(buffer.ack(true).next == 60);
	CHECK(ack_numbers(buffer.ack(true).later).empty());
}

TEST_CASE("snapshot: all fragments but the last are full") {
	Snapshot snapshot;
	for (const size_t fragment : { size_t(240), size_t(1000), size_t(1280) }) {
		snapshot.fragment_size = fragment;
		for (const size_t size : { size_t(1), fragment, fragment + 1, 10 * fragment }) {
			snapshot.bytes.resize(size);
			CHECK(snapshot.fragment_count() == (size < 2 ? 1 : (size - 1) / fragment + 1));
		}
	}
}
