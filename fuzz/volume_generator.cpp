// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of shaft-slabs, shaft-oriented-box and shaft-ellipsoid: a distribution's boxes, with another volume
// in the place of the third one.
#include <limits>

#include "fuzz/generator.h"
#include "fuzz/volume_shapes.h"
#include "fuzz/volume_touch.h"

namespace gnomon::fuzz {

namespace {

using scene::ShaftBoxCase;
using scene::ShaftBoxCaseOf;

/// Makes room for sums of three coordinates: a case of the largest numbers, divided by 16.
template <class F>
void make_room(ShaftBoxCaseOf<F>& c) {
  for (scene::Box<F>* box : {&c.a, &c.b, &c.t}) {
    for (F& x : box->c) x /= 16;
  }
}

template <class F>
struct MakeVolume {
  Flavour flavour = Flavour::rotated;
  F unit = 0;

  void operator()(CaseRandom& random, const scene::Box<F>& box, scene::SlabSet<F>& t) const {
    t = slabs_about(random, box, flavour, unit);
  }
  template <template <class> class Volume>
  void operator()(CaseRandom& random, const scene::Box<F>& box, Volume<F>& t) const {
    const Spanned<F> spanned = spanned_about(random, box, flavour, unit);
    t = {spanned.centre, spanned.axes};
  }
};

template <template <class> class Volume, class F>
class VolumeGenerator final : public Generator<scene::VolumeCaseOf<Volume, double>> {
 public:
  VolumeGenerator(const DistributionChoice& choice, scene::Scalar scalar) {
    const std::string_view name = choice.distribution->name;
    near_touch_ = name == "near-touch";
    huge_ = name == "huge";
    if (name == "integer-grid") make_volume_ = {Flavour::small_ints, 1};
    if (name == "degenerate") make_volume_.flavour = Flavour::degenerate;
    if (name == "mixed-magnitude" || huge_) make_volume_.flavour = Flavour::mixed;
    if (name == "denormal") make_volume_.unit = std::numeric_limits<F>::denorm_min();
    boxes_ = make_generator<ShaftBoxCase>(near_touch_ ? parse_distribution("uniform") : choice, scalar);
  }

  [[nodiscard]] scene::VolumeCaseOf<Volume, double> make(CaseRandom& random) const override {
    ShaftBoxCaseOf<F> boxes = scene::converted<F>(boxes_->make(random));
    if (huge_) make_room(boxes);
    scene::VolumeCaseOf<Volume, F> c{boxes.a, boxes.b, {}};
    make_volume_(random, boxes.t, c.t);
    if (near_touch_) move_to_touch(random, c);
    return scene::converted<double>(c);
  }

 private:
  std::unique_ptr<Generator<ShaftBoxCase>> boxes_;
  MakeVolume<F> make_volume_;
  bool near_touch_ = false, huge_ = false;
};

template <template <class> class Volume>
std::unique_ptr<Generator<scene::VolumeCaseOf<Volume, double>>> make_for(const DistributionChoice& choice,
                                                                         scene::Scalar scalar) {
  if (scalar == scene::Scalar::f32) return std::make_unique<VolumeGenerator<Volume, float>>(choice, scalar);
  return std::make_unique<VolumeGenerator<Volume, double>>(choice, scalar);
}

}  // namespace

template <>
std::unique_ptr<Generator<scene::ShaftSlabsCase>> make_generator(const DistributionChoice& choice,
                                                                 scene::Scalar scalar) {
  return make_for<scene::SlabSet>(choice, scalar);
}
template <>
std::unique_ptr<Generator<scene::ShaftOrientedBoxCase>> make_generator(const DistributionChoice& choice,
                                                                       scene::Scalar scalar) {
  return make_for<scene::OrientedBox>(choice, scalar);
}
template <>
std::unique_ptr<Generator<scene::ShaftEllipsoidCase>> make_generator(const DistributionChoice& choice,
                                                                     scene::Scalar scalar) {
  return make_for<scene::Ellipsoid>(choice, scalar);
}

}  // namespace gnomon::fuzz
