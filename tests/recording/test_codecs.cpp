// Deltas, soups and samples come back bit for bit; bytes that were not written so are refused.
#include "input/gallery.h"
#include "journal/digest.h"
#include "journal/synthetic.h"
#include "recording/bytes.h"
#include "recording/delta_codec.h"
#include "recording/geometry_codec.h"
#include "recording/layout.h"
#include "recording/recorded.h"

#include <doctest/doctest.h>

#include <limits>
#include <random>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::uint64_t digest_of(const Delta& delta) {
  Digest d;
  d.add(delta);
  return d.value();
}

} // namespace

TEST_CASE("Volumes come back, and damaged ones are refused") {
  for (const std::string_view name : {"nested-tori", "density"}) {
    const auto model = make_gallery_model(name);
    REQUIRE(model.ok());
    const std::string bytes = encode(*model, {{"a note", 0.5}});
    std::vector<InputNote> notes;
    const auto back = decode_soup(bytes, &notes);
    REQUIRE(back.has_value());
    CHECK(notes.size() == 1);
    CHECK(back->outer_triangles == model->outer_triangles);
    CHECK(digest(*back) == digest(*model));
    REQUIRE((back->grid != nullptr) == (model->grid != nullptr));
    if (back->grid) {
      CHECK(back->grid->size == model->grid->size);
      CHECK(back->grid->values == model->grid->values);
      CHECK(back->grid->origin == model->grid->origin);
      CHECK(back->grid->spacing == model->grid->spacing);
      CHECK(bytes.size() < 4 * model->grid->values.size());
    } else {
      CHECK(back->triangles == model->triangles);
    }
    CHECK_FALSE(decode_soup(bytes.substr(0, bytes.size() - 1)).has_value());
    CHECK_FALSE(decode_soup(bytes + "x").has_value());
  }
}

TEST_CASE("Numbers of every length come back") {
  ByteWriter out;
  const std::vector<std::int64_t> numbers{0,
                                          -1,
                                          1,
                                          63,
                                          -64,
                                          64,
                                          1LL << 40,
                                          std::numeric_limits<std::int64_t>::max(),
                                          std::numeric_limits<std::int64_t>::min()};
  for (const std::int64_t n : numbers) out.signed_number(n);
  ByteReader in(out.bytes());
  for (const std::int64_t n : numbers) CHECK(in.signed_number() == n);
  CHECK(in.exhausted());
  CHECK(in.number() == 0);
  CHECK(in.failed());
}

TEST_CASE("The deltas of a whole run come back") {
  const Journal& journal = *whole_run().journal;
  DeltaEncoder encoder;
  DeltaDecoder decoder;
  std::size_t bytes = 0, memory = 0;
  for (std::size_t i = 0; i < journal.operations().size(); ++i) {
    const Delta delta = journal.operations()[i].delta();
    const std::string_view encoded = encoder.encode(delta);
    bytes += encoded.size();
    memory += delta.memory_bytes();
    Delta back;
    REQUIRE(decoder.decode(encoded, back));
    CHECK(digest_of(back) == digest_of(delta));
    CHECK(back.slots_before == delta.slots_before);
  }
  CHECK(bytes < memory / 3);
}

TEST_CASE("What the state does not hold, and odd numbers, come back too") {
  Delta delta;
  Vertex odd;
  odd.position = {-0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  odd.value = 0.25;
  odd.kind = VertexKind::zero;
  odd.alive = false;
  odd.sample_set = 65535;
  odd.room = 127;
  delta.added_vertices = {odd, Vertex{}};
  delta.killed_vertices = {VertexId(1u), VertexId(0u)};
  delta.values = {{VertexId(1u), 7.5, -0.0}, {VertexId(1u), -0.0, 1}};
  delta.moves = {{VertexId(0u), {1, 2, 3}, {4, 5, 6}}, {VertexId(0u), {4, 5, 6}, {-0.0, 0, 0}}};
  delta.removed = {{TetId(5u), {VertexId(0u), VertexId(9u), VertexId(), VertexId(3u)}, -1}};
  delta.added = {{TetId(7u), {VertexId(4u), VertexId(1u), VertexId(2u), VertexId(3u)}, 1},
                 {TetId(2u), {}, 0},
                 {TetId(3u), {VertexId(4u), VertexId(1u), VertexId(2u), VertexId(3u)}, -1, 5},
                 {TetId(1u), {VertexId(4u), VertexId(1u), VertexId(2u), VertexId(3u)}, -127}};
  delta.slots_before = 3;
  delta.sides = {};
  delta.removed_facets = {{FacetId(3u), {VertexId(2u), VertexId(1u), VertexId(0u)}}};
  delta.added_facets = {{FacetId(0u), {VertexId(2u), VertexId(1u), VertexId(0u)}}};
  delta.facet_slots_before = 8;
  delta.sample_set = Delta::SampleSetChange{3, 4};
  delta.form = Delta::FormChange{ZeroForm::embedded, ZeroForm::free};
  delta.facet_labels = {{+1, -127}, {-1, -2}};
  DeltaEncoder encoder;
  DeltaDecoder decoder;
  const std::string bytes(encoder.encode(delta));
  Delta back;
  REQUIRE(decoder.decode(bytes, back));
  CHECK(digest_of(back) == digest_of(delta));
  CHECK(back.added_vertices[0].alive == false);
  CHECK(back.added_vertices[0].room == 127);
  CHECK(back.added_vertices[1].room == 1);
  CHECK(back.facet_slots_before == 8);
  CHECK(back.facet_labels == delta.facet_labels);

  CHECK(back.added[2].dropped == 5);
  CHECK(back.added[3].side == -127);

  // Sides and dropped facets that the state holds and such that it does not.
  Delta second;
  second.sides = {{TetId(7u), 1, -1}, {TetId(2u), 1, 0}};
  second.dropped = {{TetId(3u), 5, 15}, {TetId(2u), 1, 0}};
  second.removed = {{TetId(1u), {VertexId(4u), VertexId(1u), VertexId(2u), VertexId(3u)}, -127},
                    {TetId(7u), {VertexId(4u), VertexId(1u), VertexId(2u), VertexId(3u)}, 100, 2}};
  const std::string more(encoder.encode(second));
  REQUIRE(decoder.decode(more, back));
  CHECK(digest_of(back) == digest_of(second));
  REQUIRE(back.dropped.size() == 2);
  CHECK(back.dropped[0].before == 5);
  CHECK(back.dropped[0].after == 15);
  CHECK(back.removed[1].dropped == 2);

  // Every shorter text is refused, and a longer one.
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    DeltaDecoder fresh;
    CHECK(!fresh.decode(std::string_view(bytes).substr(0, n), back));
  }
  DeltaDecoder fresh;
  CHECK(!fresh.decode(bytes + '\0', back));
}

TEST_CASE("A slot far beyond what the bytes can fill is damage") {
  for (const std::uint32_t id : {4000u, 1000000u}) {
    Delta delta;
    delta.added = {{TetId(id), {VertexId(0u), VertexId(1u), VertexId(2u), VertexId(3u)}, 1}};
    delta.added_facets = {{FacetId(id), {VertexId(0u), VertexId(1u), VertexId(2u)}}};
    DeltaEncoder encoder;
    DeltaDecoder decoder;
    Delta back;
    CHECK(decoder.decode(encoder.encode(delta), back) == (id < 5000));
  }
}

TEST_CASE("Random bytes are no delta, or a harmless one") {
  std::mt19937_64 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes(random() % 60, '\0');
    for (char& c : bytes) c = static_cast<char>(random() & 0x7f);
    DeltaDecoder decoder;
    Delta delta;
    if (decoder.decode(bytes, delta)) CHECK(delta.added.size() <= bytes.size());
  }
}

TEST_CASE("Indices that differ by more than numbers hold are no indices") {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t second : {most, -most - 1, std::int64_t{1}}) {
    ByteWriter out;
    out.number(1);
    for (int i = 0; i < 24; ++i) out.byte(0);
    out.number(1);
    out.signed_number(0);
    out.signed_number(second);
    out.signed_number(second);
    CHECK(!decode_soup(out.bytes()));
  }
  ByteWriter out;
  out.number(2);
  out.byte(1);
  for (int i = 0; i < 2; ++i) out.real(1);
  out.number(0);
  out.real(0.5);
  for (int i = 0; i < 6; ++i) out.signed_number(most);
  out.number(2);
  out.byte(1);
  out.byte(1);
  out.number(0);
  out.number(0);
  CHECK(decode_samples(out.bytes()).has_value());
}

TEST_CASE("Soups and samples come back") {
  const auto soup = make_gallery_model("bracket");
  REQUIRE(soup.ok());
  const auto back = decode_soup(encode(*soup));
  REQUIRE(back.has_value());
  CHECK(back->points == soup->points);
  CHECK(back->triangles == soup->triangles);
  CHECK(!decode_soup(encode(*soup) + "x"));
  const std::vector<InputNote> notes{{"Something was guessed.", 0}, {"by up to", 0.125}};
  const std::string bytes = encode(*soup, notes);
  std::vector<InputNote> read;
  const auto with_notes = decode_soup(bytes, &read);
  REQUIRE(with_notes.has_value());
  CHECK(with_notes->triangles == soup->triangles);
  CHECK(read == notes);
  CHECK(!decode_soup(bytes.substr(0, bytes.size() - 1)));
  CHECK(!decode_soup(bytes + "x"));

  BoundarySamples samples = *whole_run().scene->samples;
  const std::string snapped = encode(samples);
  CHECK(snapped.size() < samples.size() * 24);
  const auto same = decode_samples(snapped);
  REQUIRE(same.has_value());
  CHECK(same->positions == samples.positions);
  CHECK(same->labels == samples.labels);
  CHECK(same->components == samples.components);
  CHECK(same->covering_radius == samples.covering_radius);
  CHECK(same->snap_unit == samples.snap_unit);

  samples.positions[0].x += 1e-17;
  samples.positions[1].y = -0.0;
  const auto exact = decode_samples(encode(samples));
  REQUIRE(exact.has_value());
  CHECK(exact->positions == samples.positions);
  CHECK(same_bits(exact->positions[1].y, -0.0));
}
