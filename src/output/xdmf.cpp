#include "xdmf.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace perinox::output {

namespace {
std::string escaped(const std::string& text) {
  std::string xml;
  for (const char letter : text) switch (letter) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += letter;
    }
  return xml;
}

std::string item(const std::string& h5_name, const std::string& dataset, GlobalId rows, int columns, bool integer,
                 int bytes) {
  return fmt::format(R"(<DataItem Dimensions="{}{}" NumberType="{}" Precision="{}" Format="HDF">{}:{}</DataItem>)",
                     rows, columns > 0 ? fmt::format(" {}", columns) : std::string(), integer ? "Int" : "Float", bytes,
                     escaped(h5_name), dataset);
}

std::string attribute(const std::string& name, int columns, const std::string& data) {
  return fmt::format(
      "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">\n          {}\n"
      "        </Attribute>\n",
      escaped(name),
      columns == 9   ? "Tensor"
      : columns == 3 ? "Vector"
                     : "Scalar",
      data);
}
}  // namespace

XdmfIndex::XdmfIndex(std::string title, std::string h5_name, GlobalId particles)
    : title_(std::move(title)), h5_name_(std::move(h5_name)), particles_(particles) {}

void XdmfIndex::add_step(int step, double t, const std::vector<FieldShape>& fields) {
  // A row's number is its particle's id, so the ids also are the list of points that Polyvertex needs.
  steps_ += fmt::format(
      "      <Grid Name=\"step {0}\" GridType=\"Uniform\">\n        <Time Value=\"{1:.17g}\"/>\n"
      "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{2}\" NodesPerElement=\"1\">\n          {3}\n"
      "        </Topology>\n        <Geometry GeometryType=\"XYZ\">\n          {4}\n        </Geometry>\n",
      step, t, particles_, item(h5_name_, "/particles/id", particles_, 0, true, 8),
      item(h5_name_, "/particles/reference", particles_, 3, false, 8));
  for (const FieldShape& field : fields) {
    steps_ +=
        attribute(field.name, field.columns,
                  item(h5_name_, fmt::format("/steps/{}/{}", step, field.name), particles_, field.columns, false, 8));
    for (const std::string& component : field.named) {
      const std::string name = field.name + "_" + component;
      steps_ +=
          attribute(name, 0, item(h5_name_, fmt::format("/components/{}/{}", step, name), particles_, 0, false, 8));
    }
  }
  steps_ += attribute("block", 0, item(h5_name_, "/particles/block", particles_, 0, true, 4));
  steps_ += attribute("volume", 0, item(h5_name_, "/particles/volume", particles_, 0, false, 8));
  steps_ += "      </Grid>\n";
}

std::string XdmfIndex::text() const {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain Name=\"{}\">\n"
      "    <Grid Name=\"steps\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}    </Grid>\n"
      "  </Domain>\n</Xdmf>\n",
      escaped(title_), steps_);
}

std::string replace_file(const std::string& path, const std::string& text) {
  const std::string temporary = path + ".part";
  std::FILE* file = std::fopen(temporary.c_str(), "w");
  if (file == nullptr) return fmt::format("{} cannot be created: {}", temporary, std::strerror(errno));
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) return fmt::format("{} could not be written: {}", temporary, std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  return error ? fmt::format("{} could not be renamed to {}: {}", temporary, path, error.message()) : std::string();
}

}  // namespace perinox::output
