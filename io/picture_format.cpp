#include "io/picture_format.hpp"

#include "io/output_file.hpp"
#include "io/table.hpp"

namespace delone::io {

PictureFormat picture_format(const std::string& path, const std::string& format) {
  const std::string name = file_format(path, format);
  if (name == "png") return PictureFormat::png;
  if (name == "svg") return PictureFormat::svg;
  if (name == "pdf") return PictureFormat::pdf;
  if (name == "eps") return PictureFormat::eps;
  throw WriteError(path + ": \"" + name +
                   "\" is no picture format: use png, svg, pdf or eps");
}

}  // namespace delone::io
