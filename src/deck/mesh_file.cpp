#include "mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace perinox::deck {
namespace {

struct Format {
  const char* mark;  ///< how the file's first bytes begin, or how its name ends
  const char* name;
};

constexpr std::array<Format, 13> beginnings{{
    {"CDF\x01", "an Exodus or NetCDF mesh"},
    {"CDF\x02", "an Exodus or NetCDF mesh"},
    {"CDF\x05", "an Exodus or NetCDF mesh"},
    {"\x89HDF", "an Exodus or HDF5 file"},
    {"$MeshFormat", "a Gmsh mesh"},
    {"*heading", "an Abaqus mesh"},
    {"*node", "an Abaqus or LS-DYNA mesh"},
    {"*keyword", "an LS-DYNA mesh"},
    {"solid ", "an STL surface"},
    {"# vtk DataFile", "a VTK mesh"},
    {"<VTKFile", "a VTK mesh"},
    {"<?xml", "an XML file, such as a VTK mesh"},
    {"ISO-10303-21", "a STEP geometry"},
}};

constexpr std::array<Format, 26> endings{{
    {".g", "an Exodus mesh"},      {".e", "an Exodus mesh"},     {".exo", "an Exodus mesh"},
    {".msh", "a Gmsh mesh"},       {".geo", "a Gmsh geometry"},  {".inp", "an Abaqus mesh"},
    {".stl", "an STL surface"},    {".vtk", "a VTK mesh"},       {".vtu", "a VTK mesh"},
    {".vtp", "a VTK surface"},     {".step", "a STEP geometry"}, {".stp", "a STEP geometry"},
    {".iges", "an IGES geometry"}, {".igs", "an IGES geometry"}, {".obj", "a Wavefront surface"},
    {".ply", "a PLY surface"},     {".bdf", "a Nastran mesh"},   {".nas", "a Nastran mesh"},
    {".cdb", "an Ansys mesh"},     {".k", "an LS-DYNA mesh"},    {".key", "an LS-DYNA mesh"},
    {".unv", "a UNV mesh"},        {".med", "a MED mesh"},       {".neu", "a neutral mesh"},
    {".off", "an OFF surface"},    {".cgns", "a CGNS mesh"},
}};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// True if the text begins with a header of columns, which a table has under whatever name.
bool begins_as_table(const std::string& first_bytes) {
  const std::string line = first_bytes.substr(0, first_bytes.find('\n'));
  return line.find(',') != std::string::npos && line.find('\0') == std::string::npos && line[0] != '*';
}

}  // namespace

std::string mesh_format(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(200, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  const std::string small = lower(head);
  for (const Format& one : beginnings)
    if (small.rfind(lower(one.mark), 0) == 0) return one.name;
  if (begins_as_table(head)) return "";
  const std::string ending = lower(std::filesystem::path(path).extension().string());
  for (const Format& one : endings)
    if (ending == one.mark) return one.name;
  return "";
}

}  // namespace perinox::deck
