#include "net/session/rejections.hpp"

#include <doctest/doctest.h>

using namespace net;

TEST_CASE("rejections: reports name the last error and the count since the last report, at most every half second") {
	Rejections rejections;
	CHECK_FALSE(rejections.take_report(0.0));
	rejections.add(PacketError::EMPTY);
	rejections.add(PacketError::TRUNCATED);
	std::optional<Rejections::Report> report = rejections.take_report(1.0);
	REQUIRE(report);
	CHECK(report->error == PacketError::TRUNCATED);
	CHECK(report->count == 2);
	CHECK_FALSE(rejections.take_report(2.0));
	rejections.add(PacketError::BAD_ACK);
	report = rejections.take_report(2.0);
	REQUIRE(report);
	CHECK(report->count == 1);
	rejections.add(PacketError::EMPTY);
	CHECK_FALSE(rejections.take_report(2.4));
	rejections.add(PacketError::BAD_ACK);
	report = rejections.take_report(2.5);
	REQUIRE(report);
	CHECK(report->error == PacketError::BAD_ACK);
	CHECK(report->count == 2);
	CHECK(rejections.count() == 5);
}
