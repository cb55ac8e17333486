// Paints marks into a picture.
#pragma once

#include <span>

#include "app/io/png.h"
#include "app/view/flat.h"
#include "app/view/marks.h"
#include "app/view/text.h"

namespace pupflow::view {

/// Paints `flats` into `image`, in their order.
void paint(io::Image& image, TextPainter& text, std::span<const Flat> flats);

/// Paints `marks` over the scene in `image`, which shows what `projection` sees.
void paint_marks(io::Image& image, TextPainter& text, const Marks& marks,
                 const Projection& projection);

}  // namespace pupflow::view
