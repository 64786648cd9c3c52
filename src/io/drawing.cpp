// SPDX-License-Identifier: Apache-2.0
#include "io/drawing.hpp"

#include <slamicp/error.hpp>
#include <slamicp/io/output_file.hpp>

#include "io/text.hpp"

namespace slamicp::drawing {

void save(const Drawing& drawing, double png_scale, const std::filesystem::path& path) {
  const std::string ending = text::ending_of(path);
  if (ending == ".svg")
    write_file(path, to_svg(drawing));
  else if (ending == ".png")
    write_file(path, to_png(drawing, png_scale, text::name_of(path)));
  else
    throw Error("ending " + text::quoted(ending) + " is of no picture that slamicp writes", text::name_of(path),
                "name it .svg or .png");
}

}  // namespace slamicp::drawing
