// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <set>

#include "gestalt/core/base/error.h"
#include "scenes.h"
#include "subjects.h"

namespace gestalt::conformance {
namespace {

const Adjacency* border_of(const SurfaceSet& surfaces, int a, int b) {
  for (const Adjacency& adjacency : surfaces.adjacencies)
    if (adjacency.a == std::min(a, b) && adjacency.b == std::max(a, b)) return &adjacency;
  return nullptr;
}

/// Values of all pairs of a scene, row by row of a matrix of surfaces; pairs of a surface with itself are left out.
/// With reversed, the surface of the larger number comes first in a pair.
std::vector<double> all_pairs(const Relation& relation, const test::KnownScene& known, bool reversed = false) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  const auto measure = relation.bind(scene);
  const int count = int(known.surfaces.surfaces.size());
  const std::size_t columns = relation.values().size();
  std::vector<double> values;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) {
      values.resize(values.size() + columns, std::nan(""));
      const SurfacePair pair{reversed ? b : a, reversed ? a : b, border_of(known.surfaces, a, b)};
      (*measure)(pair, {values.data() + values.size() - columns, columns});
    }
  return values;
}

class RelationContract : public SubjectTest<Relation> {};

TEST_P(RelationContract, DeclaresItsValues) {
  std::set<std::string> names;
  EXPECT_FALSE(subject_->values().empty());
  for (const RelationValue& value : subject_->values()) {
    EXPECT_FALSE(value.name.empty());
    EXPECT_TRUE(names.insert(value.name).second) << value.name << " is declared twice";
    EXPECT_LT(value.low, value.high) << value.name;
    EXPECT_FALSE(value.text.empty()) << value.name;
    EXPECT_EQ(value.text.find('\n'), std::string::npos) << value.name;
  }
}

TEST_P(RelationContract, GivesFiniteValuesInItsRange) {
  for (const NamedScene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const std::vector<double> values = all_pairs(*subject_, scene.known);
    ASSERT_FALSE(values.empty());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const RelationValue& declared = subject_->values()[i % subject_->values().size()];
      EXPECT_TRUE(std::isfinite(values[i])) << declared.name << " = " << values[i];
      EXPECT_TRUE(values[i] >= declared.low && values[i] <= declared.high)
          << declared.name << " = " << values[i] << " is out of [" << declared.low << ", " << declared.high << "]";
    }
  }
}

TEST_P(RelationContract, MeasuresManyPairsAsItDoesOne) {
  for (const NamedScene& named : scenes()) {
    SCOPED_TRACE(named.name);
    const Scene scene(named.known.frame, named.known.patches, named.known.surfaces);
    std::vector<SurfacePair> pairs;
    for (int a = 0, count = int(named.known.surfaces.surfaces.size()); a < count; ++a)
      for (int b = a + 1; b < count; ++b) pairs.push_back({a, b, border_of(named.known.surfaces, a, b)});
    ASSERT_FALSE(pairs.empty());
    const std::size_t columns = subject_->values().size();
    std::vector<double> together(pairs.size() * columns, std::nan("")), alone(columns, std::nan(""));
    subject_->bind(scene)->measure(pairs, together);
    // By another measure and from the last to the first, so that what a measure keeps from pair to pair shows, too.
    const auto measure = subject_->bind(scene);
    for (std::size_t i = pairs.size(); i-- > 0;) {
      (*measure)(pairs[i], alone);
      for (std::size_t k = 0; k < columns; ++k) EXPECT_EQ(together[i * columns + k], alone[k]) << "pair " << i;
    }
  }
}

TEST_P(RelationContract, IsSymmetric) {
  for (const NamedScene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    EXPECT_EQ(all_pairs(*subject_, scene.known), all_pairs(*subject_, scene.known, true));
  }
}

// Sums may be taken in another order, hence the tolerance.
TEST_P(RelationContract, DoesNotDependOnTheNumbersOfTheSurfaces) {
  const std::size_t columns = subject_->values().size();
  for (const NamedScene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const std::vector<double> values = all_pairs(*subject_, scene.known);
    const std::vector<double> others = all_pairs(*subject_, renumbered(scene.known));
    // Numbering the surfaces backwards turns the list of pairs around.
    ASSERT_EQ(values.size(), others.size());
    const std::size_t rows = values.size() / columns;
    for (std::size_t row = 0, a = 0, b = 1, count = scene.known.surfaces.surfaces.size(); row < rows; ++row) {
      const std::size_t other_a = count - 1 - b, other_b = count - 1 - a;
      const std::size_t other_row = other_a * count - other_a * (other_a + 1) / 2 + other_b - other_a - 1;
      for (std::size_t c = 0; c < columns; ++c) {
        const double value = values[row * columns + c], other = others[other_row * columns + c];
        EXPECT_NEAR(value, other, 1e-5 * (1 + std::abs(value)))
            << subject_->values()[c].name << " of surfaces " << a << " and " << b;
      }
      if (++b == count) b = ++a + 1;
    }
  }
}

TEST_P(RelationContract, TakesPairsWithoutABorder) {
  for (const NamedScene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    test::KnownScene apart = scene.known;
    apart.surfaces.adjacencies.clear();
    for (const double value : all_pairs(*subject_, apart)) EXPECT_TRUE(std::isfinite(value)) << value;
  }
}

TEST_P(RelationContract, GivesTheSameTwiceAndForAnyNumberOfThreads) {
  for (const NamedScene& scene : scenes()) {
    SCOPED_TRACE(scene.name);
    const auto run = [&] { return all_pairs(*subject_, scene.known); };
    const auto one = with_threads(1, run);
    EXPECT_EQ(with_threads(1, run), one);
    EXPECT_EQ(with_threads(8, run), one);
  }
}

TEST_P(RelationContract, ReadsColourOnlyWhenItSaysSo) {
  test::KnownScene grey = scenes().front().known;
  const std::vector<double> values = all_pairs(*subject_, grey);
  grey.frame.colour.release();
  if (subject_->needs_colour())
    EXPECT_THROW(all_pairs(*subject_, grey), InputError);
  else
    EXPECT_EQ(all_pairs(*subject_, grey), values);
}

GESTALT_CONFORMANCE(RelationContract, "relation");

}  // namespace
}  // namespace gestalt::conformance
