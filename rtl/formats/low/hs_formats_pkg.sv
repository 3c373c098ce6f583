// SPDX-License-Identifier: Apache-2.0
// Number formats of configuration `low`. Printed by `halfspace package --config low` from hls/formats/formats.hpp
// and hls/formats/records.hpp: change those, not this file.
package hs_formats_pkg;

  localparam int unsigned HasDepth = 1;
  localparam int unsigned StoresDepth = 1;
  localparam int unsigned Gouraud = 1;
  localparam int unsigned Phong = 0;
  localparam int unsigned HasTexture = 0;
  localparam int unsigned SendsShape = 1;
  localparam int unsigned MaxWidth = 320;
  localparam int unsigned MaxHeight = 200;
  localparam int unsigned Triangles = 4096;
  localparam int unsigned CullsBack = 0;
  localparam int unsigned CullsFront = 0;
  localparam int unsigned GivesIndices = 0;
  localparam int unsigned IndexWindow = 0;
  localparam int unsigned XBits = 9;
  localparam int unsigned YBits = 8;
  localparam int unsigned IndexBits = 13;
  localparam int unsigned SubpixelBits = 4;
  localparam int unsigned CoordBits = 14;
  localparam int unsigned DeltaBits = 15;
  localparam int unsigned AreaBits = 28;
  localparam int unsigned EdgeBits = 29;
  localparam int unsigned EdgeStepBits = 25;
  localparam int unsigned ReciprocalFraction = 18;
  localparam int unsigned ReciprocalBits = 19;
  localparam int unsigned ShiftBits = 5;
  localparam int unsigned SetupInterval = 21;
  localparam int unsigned DepthBits = 16;
  localparam int unsigned DepthFraction = 13;
  localparam int unsigned DepthPlaneBits = 29;
  localparam int unsigned ColourBits = 8;
  localparam int unsigned TriangleColourBits = 72;
  localparam int unsigned OrderBits = 0;
  localparam int unsigned ColourFraction = 14;
  localparam int unsigned ColourPlaneBits = 22;
  localparam int unsigned PlanesWordBits = 213;
  localparam int unsigned Deferred = 0;
  localparam int unsigned Lights = 0;
  localparam int unsigned LightWordBits = 1;
  localparam int unsigned MaterialWordBits = 1;
  localparam int unsigned NormalsWordBits = 1;
  localparam int unsigned ColoursWordBits = 1;
  localparam int unsigned NormalBits = 0;
  localparam int unsigned LightBits = 0;
  localparam int unsigned Materials = 0;
  localparam int unsigned MaterialBits = 0;
  localparam int unsigned HasGloss = 0;
  localparam int unsigned Squarings = 0;
  localparam int unsigned GlossBits = 0;
  localparam int unsigned DirectionBits = 0;
  localparam int unsigned SquaredLengthBits = 0;
  localparam int unsigned RootIndexBits = 0;
  localparam int unsigned RootOffsetBits = 0;
  localparam int unsigned RootValueFraction = 0;
  localparam int unsigned RootSlopeBits = 0;
  localparam int unsigned RootBits = 0;
  localparam int unsigned RootShiftBits = 0;
  localparam int unsigned DotBits = 0;
  localparam int unsigned CosineBits = 0;
  localparam int unsigned CoefficientBits = 0;
  localparam int unsigned LightSumBits = 0;
  localparam int unsigned LightSumFraction = 0;
  localparam int unsigned NormalFraction = 0;
  localparam int unsigned NormalPlaneBits = 0;
  localparam logic [0:0] RootTable = '0;
  localparam int unsigned Bilinear = 0;
  localparam int unsigned Perspective = 0;
  localparam int unsigned Texels = 0;
  localparam int unsigned Textures = 0;
  localparam int unsigned TextureBits = 0;
  localparam int unsigned RepeatBits = 0;
  localparam int unsigned SideBits = 0;
  localparam int unsigned TexelAddressBits = 0;
  localparam int unsigned CoordinateBits = 0;
  localparam int unsigned CoordinateFraction = 0;
  localparam int unsigned CoordinatePlaneBits = 0;
  localparam int unsigned WeightBits = 0;
  localparam int unsigned TexelPlaceBits = 0;
  localparam int unsigned FilteredFraction = 0;
  localparam int unsigned FilteredBits = 0;
  localparam int unsigned TextureWordBits = 1;
  localparam int unsigned TexelWordBits = 1;
  localparam int unsigned TextureCoordinatesWordBits = 1;
  localparam int unsigned TexturePlanesWordBits = 1;
  localparam int unsigned InverseBits = 0;
  localparam int unsigned InverseShiftBits = 0;
  localparam int unsigned InverseIndexBits = 0;
  localparam int unsigned InverseOffsetBits = 0;
  localparam int unsigned InverseValueFraction = 0;
  localparam int unsigned InverseSlopeBits = 0;
  localparam logic [0:0] InverseTable = '0;
  localparam int unsigned HasMotion = 0;
  localparam int unsigned Relight = 0;
  localparam int unsigned FaceBits = 0;
  localparam int unsigned OriginBits = 0;
  localparam int unsigned ExtentBits = 0;
  localparam int unsigned VectorBits = 0;
  localparam int unsigned VectorFraction = 0;
  localparam int unsigned KeyWeightBits = 0;
  localparam int unsigned DifferenceBits = 0;
  localparam int unsigned KeyTaps = 0;
  localparam int unsigned KeySide = 0;
  localparam int unsigned KeyFractionBits = 0;
  localparam int unsigned KeyFirstBehind = 0;
  localparam int unsigned KeyLastBefore = 0;
  localparam int unsigned KeyPlaceBits = 0;
  localparam int unsigned TapWeightBits = 0;
  localparam int unsigned KeySumBits = 0;
  localparam int unsigned TileXBits = 0;
  localparam int unsigned TileYBits = 0;
  localparam int unsigned KeyRequestWordBits = 1;
  localparam int unsigned KeyBlockWordBits = 1;
  localparam int unsigned CompensatedWordBits = 1;
  localparam int unsigned DifferencePlaneBits = 0;
  localparam int unsigned MotionVectorsWordBits = 1;
  localparam int unsigned MotionPlanesWordBits = 1;
  localparam int unsigned MotionWordBits = 1;
  localparam logic [0:0] KeyInnerTable = '0;
  localparam logic [0:0] KeyOuterTable = '0;
  localparam int unsigned UpConverts = 0;
  localparam int unsigned FramesBetween = 0;
  localparam int unsigned ShownPixelWordBits = 1;
  localparam int unsigned AskedWordBits = 1;
  localparam int unsigned FilmPixelWordBits = 1;
  localparam int unsigned HasObjects = 0;
  localparam int unsigned ObjectBits = 0;
  localparam int unsigned ObjectCountBits = 0;
  localparam int unsigned MergeWordBits = 1;
  localparam int unsigned FoundWordBits = 1;

  typedef logic [8:0] x_t;
  typedef logic [7:0] y_t;
  typedef logic [12:0] index_t;
  typedef logic signed [13:0] coord_t;
  typedef logic signed [14:0] delta_t;
  typedef logic [27:0] area_t;
  typedef logic signed [24:0] edge_step_t;
  typedef logic [18:0] reciprocal_t;
  typedef logic [4:0] shift_t;
  typedef logic [15:0] depth_t;
  typedef logic [28:0] depth_plane_t;
  typedef logic signed [28:0] depth_gradient_t;
  typedef logic [7:0] colour_t;
  typedef logic [21:0] colour_plane_t;
  typedef logic signed [21:0] colour_gradient_t;

  typedef struct packed {
    logic last;
    logic [12:0] index;
    logic signed [13:0] x0;
    logic signed [13:0] x1;
    logic signed [13:0] x2;
    logic signed [13:0] y0;
    logic signed [13:0] y1;
    logic signed [13:0] y2;
    logic [15:0] depth0;
    logic [15:0] depth1;
    logic [15:0] depth2;
    logic [7:0] r0;
    logic [7:0] r1;
    logic [7:0] r2;
    logic [7:0] g0;
    logic [7:0] g1;
    logic [7:0] g2;
    logic [7:0] b0;
    logic [7:0] b1;
    logic [7:0] b2;
  } triangle_t;

  typedef struct packed {
    logic last;
    logic [12:0] index;
    logic signed [13:0] x0;
    logic signed [13:0] x1;
    logic signed [13:0] x2;
    logic signed [13:0] y0;
    logic signed [13:0] y1;
    logic signed [13:0] y2;
    logic [15:0] depth0;
    logic [15:0] depth1;
    logic [15:0] depth2;
    logic [7:0] r0;
    logic [7:0] r1;
    logic [7:0] r2;
    logic [7:0] g0;
    logic [7:0] g1;
    logic [7:0] g2;
    logic [7:0] b0;
    logic [7:0] b1;
    logic [7:0] b2;
  } numbered_t;

  typedef struct packed {
    logic last;
    logic empty;
    logic [12:0] index;
    logic [8:0] x_min;
    logic [8:0] x_max;
    logic [8:0] x_start;
    logic [7:0] y_min;
    logic [7:0] y_max;
    logic signed [24:0] e0;
    logic signed [24:0] e1;
    logic signed [24:0] e2;
    logic signed [14:0] e0_dx;
    logic signed [14:0] e1_dx;
    logic signed [14:0] e2_dx;
    logic signed [14:0] e0_dy;
    logic signed [14:0] e1_dy;
    logic signed [14:0] e2_dy;
    logic [28:0] depth;
    logic signed [28:0] depth_dx;
    logic signed [28:0] depth_dy;
  } setup_t;

  typedef struct packed {
    logic last;
    logic empty;
    logic [12:0] index;
    logic signed [13:0] x;
    logic signed [13:0] y;
    logic signed [14:0] dx1;
    logic signed [14:0] dy1;
    logic signed [14:0] dx2;
    logic signed [14:0] dy2;
    logic [4:0] shift;
    logic [18:0] reciprocal;
    logic [7:0] r0;
    logic [7:0] r1;
    logic [7:0] r2;
    logic [7:0] g0;
    logic [7:0] g1;
    logic [7:0] g2;
    logic [7:0] b0;
    logic [7:0] b1;
    logic [7:0] b2;
  } attributes_t;

  typedef struct packed {
    logic last;
    logic empty;
    logic [12:0] index;
    logic [21:0] r;
    logic signed [21:0] r_dx;
    logic signed [21:0] r_dy;
    logic [21:0] g;
    logic signed [21:0] g_dx;
    logic signed [21:0] g_dy;
    logic [21:0] b;
    logic signed [21:0] b_dx;
    logic signed [21:0] b_dy;
  } planes_t;

  // stamp: {stamp_head_t, mask[Lanes], depth[Lanes][15:0]}
  typedef struct packed {
    logic last;
    logic triangle_last;
    logic [12:0] index;
    logic [8:0] x;
    logic [7:0] y;
  } stamp_head_t;

  // update: {update_head_t, mask[Lanes], depth[Lanes][15:0]}
  typedef struct packed {
    logic [12:0] index;
    logic [8:0] x;
    logic [7:0] y;
  } update_head_t;

  typedef struct packed {
    logic last;
    logic visible;
    logic [12:0] index;
  } visible_t;

  // scan: {scan_head_t, index[Lanes][12:0]}
  typedef struct packed {
    logic last;
    logic [8:0] x;
    logic [7:0] y;
  } scan_head_t;

  // pixel: {pixel_head_t, r[Lanes][7:0], g[Lanes][7:0], b[Lanes][7:0]}
  typedef struct packed {
    logic last;
    logic [8:0] x;
    logic [7:0] y;
  } pixel_head_t;

endpackage
