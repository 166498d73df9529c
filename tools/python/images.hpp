// Baked meshes and robots of the Python package: images.
#pragma once

#include <memory>
#include <string>

#include "image/image_file.hpp"
#include "python/arrays.hpp"
#include "text/files.hpp"

namespace flashbvh::python {

using Baked = tool::ImageFile;

inline bool is_closed(const Baked& baked) {
  return (baked.header().flags & kImageIsClosed) != 0;
}

/// Opens an image file, or an image as bytes.
template <class Image>
std::unique_ptr<Image> opened(const py::object& source) {
  if (py::isinstance<py::bytes>(source)) {
    return std::make_unique<Image>("image", std::string(py::bytes(source)));
  }
  return std::make_unique<Image>(path_of(source));
}

/// An image made here; `path` is its name for messages.
template <class Image>
std::unique_ptr<Image> opened(const std::string& path, const std::vector<std::uint32_t>& words) {
  return std::make_unique<Image>(path, std::string(reinterpret_cast<const char*>(words.data()),
                                                   words.size() * sizeof words[0]));
}

/// Adds a class with the members that all images have.
template <class Image>
py::class_<Image> add_image(py::module_& module, const char* name) {
  return py::class_<Image>(module, name)
      .def("save",
           [](const Image& image, const py::object& path) {
             tool::write_file(path_of(path), {image.bytes(), image.header().byte_count});
           })
      .def_property_readonly(
          "image",
          [](const Image& image) { return py::bytes(image.bytes(), image.header().byte_count); })
      .def_property_readonly("cell", &Image::cell);
}

}  // namespace flashbvh::python
