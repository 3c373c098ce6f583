// SPDX-License-Identifier: Apache-2.0
#include "model/formats/field_meanings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "ref/error.hpp"

namespace halfspace::model {
namespace {

// `fields`: names with a blank between them, # for a digit; in valid_if # is the last digit of the field's name.
struct Line {
  const char *record, *fields, *meaning, *unit, *valid_if;
};

// The first line that fits is that of a field. Records in the order of the pipeline.
const Line kFields[] = {
    {"Merge", "merges", "a word of `entry` comes with each word of `stored`", "", ""},
    {"Merge", "sends", "a word of `merged` goes for each word of `stored`", "", ""},
    {"Merge", "first last", "objects that are looked for and erased: from first to last, none if first > last", "", ""},
    {"Merge", "r g b", "the background, which erased pixels become", "colour", ""},
    {"StaticCommand", "merges", "what is stored is merged with what is drawn", "", ""},
    {"StaticCommand", "sends", "a word of `merged` goes for each stamp of the box", "", ""},
    {"StaticCommand", "first last", "objects that are looked for and erased: from first to last, none if first > last",
     "", ""},
    {"StaticCommand", "r g b", "the background, which erased pixels become, and what is stored anew", "colour", ""},
    {"StaticCommand", "passes", "what is drawn is the next frame of hs_pipeline, else a buffer", "", ""},
    {"StaticCommand", "anew", "what is stored is background, else a buffer", "", ""},
    {"StaticCommand", "shows", "what is sent goes to the frame, else into a buffer", "", "sends"},
    {"StaticCommand", "stored", "number of the buffer that is stored", "", "!anew"},
    {"StaticCommand", "drawn", "number of the buffer that is drawn", "", "merges !passes"},
    {"StaticCommand", "kept", "number of the buffer that what is sent goes into", "", "sends !shows"},
    {"StaticCommand", "x_first x_last y_first y_last", "the box of the run", "stamps", ""},
    {"BufferPlace", "buffer", "number of the buffer", "", ""},
    {"BufferPlace", "x y", "column and row of the stamp", "stamps", ""},
    {"StampPixels", "depth", "of the pixel; background: 2^b − 1", "depth", ""},
    {"StampPixels", "object", "that the pixel shows; background: 0", "", ""},
    {"StampPixels", "r g b", "colour of the pixel", "colour", ""},
    {"KeptStamp", "buffer", "number of the buffer", "", ""},
    {"KeptStamp", "x y", "column and row of the stamp", "stamps", ""},
    {"KeptStamp", "depth", "of the pixel; background: 2^b − 1", "depth", ""},
    {"KeptStamp", "object", "that the pixel shows; background: 0", "", ""},
    {"KeptStamp", "r g b", "colour of the pixel", "colour", ""},
    {"Found", "count", "pixels that show an object that is looked for", "pixels", ""},
    {"Found", "x_first x_last y_first y_last", "the box of their stamps; 0 where there is none", "stamps", ""},

    {"*", "last", "ends the frame", "", ""},
    {"*", "empty", "1: nothing is drawn or stored, and what counts only without it means nothing", "", ""},

    {"Light", "light", "its number, from 0", "", ""},
    {"Light", "x y z", "the unit vector to the light", "", ""},
    {"Light", "half_x half_y half_z", "the unit vector half-way between it and the viewer", "", ""},
    {"Material", "material", "its number, from 0", "", ""},
    {"Material", "light", "number of the light that the coefficients are for", "", ""},
    {"Material", "gloss", "k: the exponent of the highlight is 2^k; the same for all lights", "", ""},
    {"Material", "base_r base_g base_b", "what it shows without light; those of all lights are added", "colour", ""},
    {"Material", "diffuse_r diffuse_g diffuse_b", "times n·L", "colour", ""},
    {"Material", "specular_r specular_g specular_b", "times (n·H)^(2^k)", "colour", ""},
    {"TextureEntry", "texture", "its number, from 1", "", ""},
    {"TextureEntry", "base", "address of its first texel: a multiple of how many it has", "texels", ""},
    {"TextureEntry", "log2_width log2_height", "logarithms of its sides", "log2 of texels", ""},
    {"Texel", "address", "where it lies in the memory of texels", "texels", ""},
    {"Texel", "r g b", "its colour", "colour", ""},

    {"Triangle", "index",
     "its number, from 1 in the order of the frame; 0: a frame without triangles, or none was left", "", ""},
    {"Triangle", "object", "the object that it is of; not 0", "", ""},
    {"Triangle", "face", "the face that it is of, modulo 2^b; not 0", "", ""},
    {"Triangle", "x# y#", "where vertex # is in the picture, row 0 on top", "pixels", ""},
    {"Triangle", "depth#", "of vertex #: 0 nearest, 2^b − 1 farthest", "depth", ""},
    {"Triangle", "r# g# b#", "colour of vertex #", "colour", ""},
    {"Triangle", "r g b", "its colour", "colour", ""},

    {"Setup", "index", "number of the triangle", "", ""},
    {"Setup", "x_min x_max", "first and last column of its box in the frame", "stamps", "!empty"},
    {"Setup", "y_min y_max", "first and last row of its box in the frame", "stamps", "!empty"},
    {"Setup", "x_start", "column where the walk of the top row begins", "stamps", "!empty"},
    {"Setup", "e#", "edge function # at the centre of the first pixel of stamp (x_start, y_min); inside: none is < 0",
     "pixels²", "!empty"},
    {"Setup", "e#_dx e#_dy", "its step to the next pixel, and to the next row", "pixels", "!empty"},
    {"Setup", "depth", "the plane of depth at the same centre, ½ included", "depth", "!empty"},
    {"Setup", "depth_dx depth_dy", "its step to the next pixel, and to the next row", "depth a pixel", "!empty"},

    {"Attributes", "index", "number of the triangle", "", ""},
    {"Attributes", "x y", "where vertex 0 is, in the order that setup gives them", "pixels", "!empty"},
    {"Attributes", "dx# dy#", "vertex # less vertex 0", "pixels", "!empty"},
    {"Attributes", "shift", "s = floor(log2 D) of twice the area D in units of its last place", "", "!empty"},
    {"Attributes", "reciprocal", "2^s / D, rounded", "", "!empty"},
    {"Attributes", "first", "which vertex, as given, is vertex 0", "", "!empty"},
    {"Attributes", "turned", "1: the other two follow it backwards", "", "!empty"},
    {"Attributes", "r# g# b#", "colour of vertex #", "colour", "!empty"},
    {"Attributes", "r g b", "the triangle's colour", "colour", "!empty"},

    {"Normals", "index", "number of the triangle", "", ""},
    {"Normals", "material", "number of its material", "", ""},
    {"Normals", "x# y# z#", "normal of vertex # as given, of any length; of length 0: no light falls on it", "", ""},
    {"Colours", "index", "number of the triangle", "", ""},
    {"Colours", "r# g# b#", "colour of vertex # as given", "colour", ""},
    {"Colours", "r g b", "the triangle's colour", "colour", ""},

    {"NormalPlanes", "index", "number of the triangle, whose entry it is", "", "!empty"},
    {"NormalPlanes", "material", "number of its material", "", "!empty"},
    {"NormalPlanes", "x y z", "planes of its normal at the centre of pixel (0, 0), ½ included, plus 2^p units", "",
     "!empty"},
    {"NormalPlanes", "x_dx x_dy y_dx y_dy z_dx z_dy", "steps to the next pixel, and to the next row", "a pixel",
     "!empty"},
    {"Planes", "index", "number of the triangle, whose entry it is", "", "!empty"},
    {"Planes", "r g b", "planes of its colour at the centre of pixel (0, 0), ½ included; flat: the colour", "colour",
     "!empty"},
    {"Planes", "r_dx r_dy g_dx g_dy b_dx b_dy", "steps to the next pixel, and to the next row", "colour a pixel",
     "!empty"},

    {"TextureCoordinates", "index", "number of the triangle", "", ""},
    {"TextureCoordinates", "texture", "number of its texture; 0: none", "", ""},
    {"TextureCoordinates", "repeats", "e: the coordinates are in units of 2^e textures", "", "texture"},
    {"TextureCoordinates", "s# t# q#", "of vertex # as given; full scale is 1, s and t are times q in perspective", "",
     "texture"},
    {"TexturePlanes", "index", "number of the triangle, whose entry it is", "", "!empty"},
    {"TexturePlanes", "texture", "number of its texture; 0: none", "", "!empty"},
    {"TexturePlanes", "repeats", "e: the coordinates are in units of 2^e textures", "", "!empty texture"},
    {"TexturePlanes", "s t q", "planes of s, t, q at the centre of pixel (0, 0), ½ included", "", "!empty texture"},
    {"TexturePlanes", "s_dx s_dy t_dx t_dy q_dx q_dy", "steps to the next pixel, and to the next row", "a pixel",
     "!empty texture"},

    {"MotionVectors", "index", "number of the triangle", "", ""},
    {"MotionVectors", "face", "the face that it is of, modulo 2^b; not 0", "", ""},
    {"MotionVectors", "there_#", "1: it has a place in key frame #", "", ""},
    {"MotionVectors", "origin_x_# origin_y_#", "where its place in key frame # is counted from", "pixels", "there_#"},
    {"MotionVectors", "extent_#", "e: its places lie within 2^e pixels of the origin", "", "there_#"},
    {"MotionVectors", "s#_# t#_# q#_#", "place of a vertex in a key frame, less the origin, over 2^e; as texture", "",
     "there_#"},
    {"MotionVectors", "r#_# g#_# b#_#", "colour of a vertex less that in a key frame, plus full scale", "colour",
     "there_#"},
    {"MotionPlanes", "index", "number of the triangle, whose entry it is", "", "!empty"},
    {"MotionPlanes", "face", "the face that it is of", "", "!empty"},
    {"MotionPlanes", "there_#", "1: it has a place in key frame #", "", "!empty"},
    {"MotionPlanes", "origin_x_# origin_y_#", "where its place in key frame # is counted from", "pixels",
     "!empty there_#"},
    {"MotionPlanes", "extent_#", "e: its places lie within 2^e pixels of the origin", "", "!empty there_#"},
    {"MotionPlanes", "s_# t_# q_#", "planes of the place in key frame # at the centre of pixel (0, 0), ½ included", "",
     "!empty there_#"},
    {"MotionPlanes", "s_dx_# s_dy_# t_dx_# t_dy_# q_dx_# q_dy_#", "steps to the next pixel, and to the next row",
     "a pixel", "!empty there_#"},
    {"MotionPlanes", "r_# g_# b_#", "planes of the difference of colours to key frame #, likewise", "colour",
     "!empty there_#"},
    {"MotionPlanes", "r_dx_# r_dy_# g_dx_# g_dy_# b_dx_# b_dy_#", "steps to the next pixel, and to the next row",
     "colour a pixel", "!empty there_#"},

    {"TriangleDepth", "index", "number of the triangle", "", ""},
    {"TriangleDepth", "x y", "the stamp at whose first pixel the plane starts", "stamps", "!setup.empty"},
    {"TriangleDepth", "depth", "the plane of depth at its centre, ½ included", "depth", "!setup.empty"},
    {"TriangleDepth", "depth_dx depth_dy", "steps to the next pixel, and to the next row", "depth a pixel",
     "!setup.empty"},
    {"Stamp", "triangle_last", "ends the triangle", "", ""},
    {"Stamp", "index", "number of the triangle", "", ""},
    {"Stamp", "x y", "column and row of the stamp; its first pixel is x times its width, y times its height", "stamps",
     ""},
    {"Stamp", "mask", "1: the triangle covers the pixel", "", ""},
    {"Stamp", "depth", "of the triangle at the pixel: 0 nearest", "depth", "mask"},
    {"Update", "index", "number of the triangle, which the pixels show from now on", "", ""},
    {"Update", "x y", "column and row of the stamp", "stamps", ""},
    {"Update", "mask", "1: the pixel is written", "", ""},
    {"Update", "depth", "what is written to the Z-buffer", "depth", "mask"},
    {"Visible", "visible", "1: a fragment of the triangle passed the Z-test", "", ""},
    {"Visible", "index", "number of the triangle", "", ""},
    {"Scan", "x y", "column and row of the stamp", "stamps", ""},
    {"Scan", "index", "number of the triangle that the pixel shows; 0: background, and outside the frame", "", ""},
    {"Pixel", "x y", "column and row of the stamp", "stamps", ""},
    {"Pixel", "r g b", "colour of the pixel", "colour", ""},
    {"Motion", "x y", "the pixel", "pixels", ""},
    {"Motion", "face", "the face that it shows; 0: none, in a word that only ends the frame", "", ""},
    {"Motion", "there_#", "1: the same point has a place in key frame #, and the vector fits", "", ""},
    {"Motion", "vx_# vy_#", "the way from the pixel's centre to it; 0 where there is none", "pixels", ""},
    {"Motion", "r_# g_# b_#", "colour less that in key frame #, plus full scale", "colour", ""},
    {"ShownPixel", "x y", "the pixel", "pixels", ""},
    {"ShownPixel", "shown", "1: it shows a triangle", "", ""},
    {"ShownPixel", "face", "of that triangle; background: 0", "", ""},
    {"ShownPixel", "r g b", "its colour", "colour", ""},
    {"Entry", "x y", "column and row of the stamp", "stamps", ""},
    {"Entry", "depth", "of the pixel; background: 2^b − 1", "depth", ""},
    {"Entry", "object", "that the pixel shows; background: 0", "", ""},
    {"Entry", "r g b", "colour of the pixel", "colour", ""},

    {"KeyWeightWord", "weight", "of key frame 0; key frame 1 has the rest to 1", "", ""},
    {"KeyRequest", "tile_x tile_y", "column and row of the tile", "tiles of 8 pixels", ""},
    {"KeyBlock", "r g b", "colour of the pixel in the key frame; beyond the frame anything", "colour", ""},
    {"KeyBlock", "face", "that it shows; 0: background, or more than one; beyond the frame anything", "", ""},
    {"Compensated", "x y", "the pixel", "pixels", ""},
    {"Compensated", "r g b", "its colour; 0 without a key", "colour", ""},
    {"Compensated", "keys", "bit k: it is from key frame k; none: a hole, or the background", "", ""},
    {"Asked", "face", "that has holes: geometry sends its triangles again; 0: there is none", "", ""},
    {"FilmPixel", "x y", "the pixel", "pixels", ""},
    {"FilmPixel", "r g b", "its colour", "colour", ""},
};

struct Order {
  const char *record, *order, *any_order_within;
};

constexpr const char *kByTriangle = "a word a triangle, in the order of `triangle`",
                     *kScan = "stamps from left to right, rows downward; all of the frame";
const Order kOrders[] = {
    {"Light", "by light", ""},
    {"Material", "by material and light", ""},
    {"TextureEntry", "by texture", ""},
    {"Texel", "by address", ""},
    {"Triangle", "triangles as they are drawn", ""},
    {"Setup", kByTriangle, ""},
    {"Attributes", kByTriangle, ""},
    {"Normals", kByTriangle, ""},
    {"Colours", kByTriangle, ""},
    {"NormalPlanes", kByTriangle, ""},
    {"Planes", kByTriangle, ""},
    {"TextureCoordinates", kByTriangle, ""},
    {"TexturePlanes", kByTriangle, ""},
    {"MotionVectors", kByTriangle, ""},
    {"MotionPlanes", kByTriangle, ""},
    {"TriangleDepth", kByTriangle, ""},
    {"Stamp", "by triangle, in the order of `triangle`; those of a triangle as they are walked", "index"},
    {"Update", "in the order of the stamps that passed", "index"},
    {"Visible", kByTriangle, ""},
    {"Scan", kScan, ""},
    {"Pixel", kScan, ""},
    {"Motion", "covered pixels in the order of their stamps, in a stamp by lane", ""},
    {"ShownPixel", "by stamp, in the order of `masked`, in a stamp by lane; those of the frame", ""},
    {"Entry", kScan, ""},
    {"KeyWeightWord", "a word a frame", ""},
    {"KeyRequest", "as tiles are missed", ""},
    {"KeyBlock", "in answer to each request: the blocks of its tile, row by row", ""},
    {"Compensated", "that of `motion`, of a film that of `ordered`", ""},
    {"Asked", "as holes are found, in the order of `ordered`; a face once for holes that follow each other", ""},
    {"FilmPixel", "frame after frame, row by row", ""},
    {"Merge", "a word a run", ""},
    {"Found", "a word a run", ""},
    {"StaticCommand", "a word a run", ""},
    {"BufferPlace", "of each run the stamps of its box, from left to right, rows downward", ""},
    {"StampPixels", "in answer to each place", ""},
    {"KeptStamp", "of each run the stamps of its box, from left to right, rows downward", ""},
};

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool fits(const std::string& pattern, const std::string& name) {
  return pattern.size() == name.size() && std::equal(pattern.begin(), pattern.end(), name.begin(),
                                                     [](char p, char n) { return p == '#' ? is_digit(n) : p == n; });
}

bool fits_one(const std::string& patterns, const std::string& name) {
  const std::vector<std::string> all = words_of(patterns);
  return std::any_of(all.begin(), all.end(), [&](const std::string& pattern) { return fits(pattern, name); });
}

std::string with_digit(std::string text, const std::string& name) {
  const auto digit = std::find_if(name.rbegin(), name.rend(), is_digit);
  if (digit != name.rend()) std::replace(text.begin(), text.end(), '#', *digit);
  return text;
}

// A triangle without an index is told as one with.
std::string told_as(const std::string& record) { return record == "UnnumberedTriangle" ? "Triangle" : record; }

}  // namespace

FieldMeaning field_meaning(const std::string& record, const std::string& field) {
  for (const Line& line : kFields) {
    if ((line.record == told_as(record) || line.record[0] == '*') && fits_one(line.fields, field)) {
      return {with_digit(line.meaning, field), line.unit, with_digit(line.valid_if, field)};
    }
  }
  throw ref::Error(fmt::format("{}.{}: model/formats/field_meanings.cpp has no line for it: add one", record, field));
}

RecordOrder record_order(const std::string& record) {
  for (const Order& order : kOrders) {
    if (order.record == told_as(record)) return {order.order, order.any_order_within};
  }
  throw ref::Error(fmt::format("{}: model/formats/field_meanings.cpp has no order for it: add one", record));
}

std::vector<std::string> field_lines() {
  std::vector<std::string> lines;
  for (const Line& line : kFields) {
    for (const std::string& field : words_of(line.fields)) lines.push_back(fmt::format("{} {}", line.record, field));
  }
  return lines;
}

std::vector<std::string> order_lines() {
  std::vector<std::string> lines;
  for (const Order& order : kOrders) lines.push_back(order.record);
  return lines;
}

bool is_line_of(const std::string& line, const std::string& record, const std::string& field) {
  const std::vector<std::string> parts = words_of(line);
  return (parts[0] == record || parts[0] == "*") && fits(parts[1], field);
}

}  // namespace halfspace::model
