// Arguments that do not compile: temporary meshes and poses, and numbers where a length is due.
#include <cstdint>
#include <type_traits>
#include <utility>

#include "flashbvh/clearance.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/robot/workcell.hpp"
#include "flashbvh/self.hpp"

using namespace flashbvh;

namespace {

template <class Query, class A, class B, class P, class... With>
constexpr bool kTakes = std::is_constructible<Query, A, B, P, With...>::value;

/// The query takes meshes and a pose with these further arguments, and no temporary ones, which
/// would be gone before the first run. `A`, `B`: kinds of meshes.
template <class Query, class A, class B, class P, class... With>
constexpr bool refuses_temporaries() {
  static_assert(kTakes<Query, const A&, const B&, const P&, With...>);
  static_assert(kTakes<Query, A&, B&, P&, With...>);
  static_assert(!kTakes<Query, A, const B&, const P&, With...>);
  static_assert(!kTakes<Query, const A&, B, const P&, With...>);
  static_assert(!kTakes<Query, const A&, const B&, P, With...>);
  static_assert(!kTakes<Query, A, B, P, With...>);
  return true;
}
static_assert(refuses_temporaries<PairQuery, Mesh, Mesh, Pose>());
static_assert(refuses_temporaries<PairQuery, Mesh, Mesh, Pose, PairQuery::Cursor>());
static_assert(refuses_temporaries<WithinQuery, Mesh, Mesh, Pose, WithinQuery::Cursor, Within>());
static_assert(refuses_temporaries<ClearanceQuery, Mesh, Mesh, Pose>());
static_assert(refuses_temporaries<ClearanceQuery, Mesh, Mesh, Pose, ClearanceQuery::Hint>());
static_assert(refuses_temporaries<ClearanceQuery, Mesh, Mesh, Pose, ClearanceQuery::Options>());
static_assert(refuses_temporaries<FirstContact, Mesh, Mesh, BodyMotion, FineLength>());

/// A length is no number: not of cells, nor of the mesh's unit.
template <class Number>
constexpr bool refuses_numbers() {
  constexpr auto ask = [](auto length) -> decltype(closer_than(
                                           std::declval<const Mesh&>(), std::declval<const Mesh&>(),
                                           std::declval<const Pose&>(), length)) { return {}; };
  static_assert(std::is_invocable<decltype(ask), FineLength>::value);
  static_assert(!std::is_invocable<decltype(ask), Number>::value);
  static_assert(!std::is_invocable<decltype(within), Number>::value);
  static_assert(!std::is_constructible<Within, Number>::value);
  static_assert(!kTakes<FirstContact, Mesh&, Mesh&, BodyMotion&, Number>);
  static_assert(!std::is_invocable<decltype(&Workcell::keep_apart), Workcell&, std::uint8_t,
                                   std::uint8_t, Number, Number>::value);
  static_assert(!std::is_invocable<decltype(&Workcell::move), Workcell&, std::uint8_t, const Frame&,
                                   Number>::value);
  return true;
}
static_assert(refuses_numbers<int>() && refuses_numbers<std::uint32_t>());
static_assert(refuses_numbers<float>() && refuses_numbers<double>());

template <class A, class B>
constexpr bool deformable_queries_refuse_temporaries() {
  using Near = DeformableQuery<WithinQuery>;
  using Nearest = DeformableQuery<ClearanceQuery>;
  static_assert(refuses_temporaries<DeformableQuery<PairQuery>, A, B, Pose>());
  static_assert(refuses_temporaries<Near, A, B, Pose, WithinQuery::Cursor, Within>());
  static_assert(refuses_temporaries<Nearest, A, B, Pose, ClearanceQuery::Options>());
  return true;
}
static_assert(deformable_queries_refuse_temporaries<DeformableMesh, DeformableMesh>());
static_assert(deformable_queries_refuse_temporaries<DeformableMesh, Mesh>());
static_assert(deformable_queries_refuse_temporaries<Mesh, DeformableMesh>());

template <class Query, class M, class... With>
constexpr bool kTakesOne = std::is_constructible<Query, M, With...>::value;
static_assert(kTakesOne<SelfQuery, const Mesh&> && !kTakesOne<SelfQuery, Mesh>);
static_assert(kTakesOne<SelfWithinQuery, const Mesh&, Within>);
static_assert(!kTakesOne<SelfWithinQuery, Mesh, Within>);
static_assert(kTakesOne<DeformableQuery<SelfWithinQuery>, const DeformableMesh&, Within>);
static_assert(!kTakesOne<DeformableQuery<SelfWithinQuery>, DeformableMesh, Within>);

/// Whether a ClearanceQuery takes the pose if its options are in braces.
template <class P, class = void>
constexpr bool kTakesBraces = false;
template <class P>
constexpr bool kTakesBraces<
    P, std::void_t<decltype(ClearanceQuery(std::declval<const Mesh&>(), std::declval<const Mesh&>(),
                                           std::declval<P>(), {ClearanceQuery::Hint(), 16}))>> =
    true;
static_assert(kTakesBraces<const Pose&> && !kTakesBraces<Pose>);

}  // namespace
