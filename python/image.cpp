#include "python/image.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/graphics/graphics.h"
#include "app/io/failure.h"
#include "app/io/named_field.h"
#include "python/arrays.h"
#include "python/gil.h"

namespace pupflow::python {
namespace {

namespace fs = std::filesystem;

/// In the build tree, or the library folder that belongs to where this module is installed.
std::vector<std::string> module_candidates() {
  Dl_info self{};
  ::dladdr(reinterpret_cast<const void*>(&module_candidates), &self);
  const fs::path folder = fs::absolute(self.dli_fname).parent_path();
  std::vector<std::string> places;
  for (const char* const way : {"../../bin", PUPFLOW_MODULE_FOLDER}) {
    places.push_back((folder / way / io::kGraphicsModule).lexically_normal().string());
  }
  return places;
}

/// An OpenGL context does not work in a process that was forked after it was made.
graphics::Graphics& load_graphics() {
  static graphics::Graphics& graphics =
      graphics::entered(io::load_module(module_candidates(), graphics::kEntry));
  static const pid_t loaded_by = ::getpid();
  if (loaded_by == ::getpid()) return graphics;
  throw io::Failure(io::ExitCode::no_context,
                    "a forked process cannot draw where its parent has drawn; start it with "
                    "multiprocessing's 'spawn'");
}

pictures::ImageJob job_of(const Look& look) {
  pictures::ImageJob job;
  job.width = look.width;
  job.height = look.height;
  job.camera = view::Camera::parse(look.camera);
  job.bar = look.bar;
  job.look.scale = view::ColorScale(io::named_field(look.color_by, "color_by"));
  if (look.colormap) job.look.scale.set_map(*look.colormap);
  if (look.scale) {
    job.look.scale.set_range(look.scale->first, look.scale->second);
  } else {
    job.look.scale.follow_data();
  }
  return job;
}

std::vector<std::uint8_t> without_alpha(const io::Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t at = 0; at < image.rgba.size(); ++at) {
    if (at % 4 != 3) rgb.push_back(image.rgba[at]);
  }
  return rgb;
}

}  // namespace

py::array draw(const LitterView& litter, const Look& look) {
  auto rgb = std::make_shared<std::vector<std::uint8_t>>();
  {
    const WithoutGil others_may_run;
    *rgb = without_alpha(load_graphics().image(job_of(look), litter));
  }
  return array_over(std::move(rgb), {look.height, look.width, 3});
}

}  // namespace pupflow::python
