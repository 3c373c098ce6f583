// SPDX-License-Identifier: Apache-2.0
// The tables of index rendering: what four architectures light, store and move.
#ifndef HALFSPACE_CLI_REPRO_INDEX_TABLES_HPP_
#define HALFSPACE_CLI_REPRO_INDEX_TABLES_HPP_

#include <array>
#include <string>
#include <vector>

#include "cli/common/table.hpp"
#include "study/papers/index_rendering.hpp"

namespace halfspace::cli {

// A model in a frame of a level.
struct DrawnModel {
  std::string scene;
  bool culled;  // its back faces
  const model::HardwareLevel* level;
  int width, height;
  ref::ShadingMode mode;
  model::FourRates rates;  // Gouraud: with a texture on all of it
};

// Bytes of the buffers: stored, or moved in a frame.
struct BufferRow {
  std::string scene;  // empty: of none
  bool culled;
  const model::HardwareLevel* level;
  int width, height;
  ref::ShadingMode mode;
  std::array<model::BufferBytes, 4> bytes;  // beta with a copy of the planes in its wide pixel
  model::BufferBytes beta_colour;           // with what shading needs of them at the pixel alone
  int wide_bits = 0;                        // of the copy
  // Where they are moved: the wide pixel with which gamma and beta are even; TdbS if each pixel reads it anew.
  double even_bits = 0, shading_every_pixel = 0;
};

std::vector<BufferRow> size_rows();
std::vector<BufferRow> worst_rows();
std::vector<BufferRow> simulated_rows(const std::vector<DrawnModel>& drawn);

Table lightings_table(const std::vector<DrawnModel>& drawn);
Table sizes_table(const std::vector<BufferRow>& rows);
Table worst_table(const std::vector<BufferRow>& rows);
Table simulated_table(const std::vector<BufferRow>& rows);
// In how many of the frames it is as the paper says.
Table claims_table(const std::vector<BufferRow>& worst, const std::vector<BufferRow>& simulated);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_INDEX_TABLES_HPP_
