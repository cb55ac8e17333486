#include "app/pictures/image.h"

#include <mutex>

#include "app/pictures/picture.h"
#include "app/view/framing.h"

namespace pupflow::pictures {

namespace {

/// Makes a context current for one call.
class Turn {
 public:
  explicit Turn(context::Context& context) : context_(context) { context.make_current(); }
  ~Turn() { context_.release_current(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  context::Context& context_;
};

}  // namespace

io::Image image(const ImageJob& job, const LitterView& litter) {
  Picture picture(job.width, job.height, job.bar, job.look);
  const view::Camera camera = view::framed(job.camera, litter.params, picture.scene_aspect());
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  // Never destroyed: drivers may be gone before the objects of this module are.
  static const auto* const headless = new Headless(job.look);
  const Turn turn(*headless->context);
  return picture.draw(*headless->renderer, litter, camera);
}

}  // namespace pupflow::pictures
