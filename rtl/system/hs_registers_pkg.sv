// SPDX-License-Identifier: Apache-2.0
// Addresses and fields of the registers. Printed by rtl/system/registers.py from registers.toml:
// change that, not this file.
package hs_registers_pkg;
  localparam int unsigned AddressBits = 8;

  localparam logic [7:0] Id = 8'h00;

  localparam logic [7:0] Bus = 8'h04;
  localparam int unsigned BusVersion = 0;
  localparam int unsigned BusVersionBits = 8;
  localparam int unsigned BusBytes = 8;
  localparam int unsigned BusBytesBits = 8;

  localparam logic [7:0] Lanes = 8'h08;
  localparam int unsigned LanesX = 0;
  localparam int unsigned LanesXBits = 8;
  localparam int unsigned LanesY = 8;
  localparam int unsigned LanesYBits = 8;

  localparam logic [7:0] Largest = 8'h0c;
  localparam int unsigned LargestWidth = 0;
  localparam int unsigned LargestWidthBits = 16;
  localparam int unsigned LargestHeight = 16;
  localparam int unsigned LargestHeightBits = 16;

  localparam logic [7:0] Triangles = 8'h10;

  localparam logic [7:0] Widths = 8'h14;
  localparam int unsigned WidthsCoord = 0;
  localparam int unsigned WidthsCoordBits = 8;
  localparam int unsigned WidthsSubpixel = 8;
  localparam int unsigned WidthsSubpixelBits = 8;
  localparam int unsigned WidthsDepth = 16;
  localparam int unsigned WidthsDepthBits = 8;
  localparam int unsigned WidthsColour = 24;
  localparam int unsigned WidthsColourBits = 8;

  localparam logic [7:0] Features = 8'h18;
  localparam int unsigned FeaturesColours = 0;
  localparam int unsigned FeaturesColoursBits = 2;
  localparam int unsigned FeaturesNormals = 2;
  localparam int unsigned FeaturesNormalsBits = 2;
  localparam int unsigned FeaturesCoordinates = 4;
  localparam int unsigned FeaturesCoordinatesBits = 2;
  localparam int unsigned FeaturesOutsideFrame = 6;
  localparam int unsigned FeaturesOutsideFrameBits = 1;
  localparam int unsigned FeaturesOutsidePlanes = 7;
  localparam int unsigned FeaturesOutsidePlanesBits = 1;

  localparam logic [7:0] Answers = 8'h1c;
  localparam int unsigned AnswersNormal = 0;
  localparam int unsigned AnswersNormalBits = 8;
  localparam int unsigned AnswersMaterial = 8;
  localparam int unsigned AnswersMaterialBits = 8;
  localparam int unsigned AnswersTexture = 16;
  localparam int unsigned AnswersTextureBits = 8;
  localparam int unsigned AnswersRepeats = 24;
  localparam int unsigned AnswersRepeatsBits = 8;

  localparam logic [7:0] Coordinate = 8'h20;

  localparam logic [7:0] Control = 8'h24;
  localparam int unsigned ControlStart = 0;
  localparam int unsigned ControlStartBits = 1;
  localparam int unsigned ControlStop = 1;
  localparam int unsigned ControlStopBits = 1;

  localparam logic [7:0] Status = 8'h28;
  localparam int unsigned StatusBusy = 0;
  localparam int unsigned StatusBusyBits = 1;
  localparam int unsigned StatusDone = 1;
  localparam int unsigned StatusDoneBits = 1;
  localparam int unsigned StatusStopped = 2;
  localparam int unsigned StatusStoppedBits = 1;
  localparam int unsigned StatusError = 3;
  localparam int unsigned StatusErrorBits = 1;
  localparam int unsigned StatusErrorKind = 4;
  localparam int unsigned StatusErrorKindBits = 2;
  localparam int unsigned StatusErrorClient = 8;
  localparam int unsigned StatusErrorClientBits = 4;

  localparam logic [7:0] InterruptEnable = 8'h2c;
  localparam int unsigned InterruptEnableDone = 0;
  localparam int unsigned InterruptEnableDoneBits = 1;
  localparam int unsigned InterruptEnableStopped = 1;
  localparam int unsigned InterruptEnableStoppedBits = 1;
  localparam int unsigned InterruptEnableError = 2;
  localparam int unsigned InterruptEnableErrorBits = 1;
  localparam int unsigned InterruptEnableFrame = 3;
  localparam int unsigned InterruptEnableFrameBits = 1;

  localparam logic [7:0] InterruptPending = 8'h30;
  localparam int unsigned InterruptPendingDone = 0;
  localparam int unsigned InterruptPendingDoneBits = 1;
  localparam int unsigned InterruptPendingStopped = 1;
  localparam int unsigned InterruptPendingStoppedBits = 1;
  localparam int unsigned InterruptPendingError = 2;
  localparam int unsigned InterruptPendingErrorBits = 1;
  localparam int unsigned InterruptPendingFrame = 3;
  localparam int unsigned InterruptPendingFrameBits = 1;

  localparam logic [7:0] Frame = 8'h34;
  localparam int unsigned FrameWidth = 0;
  localparam int unsigned FrameWidthBits = 16;
  localparam int unsigned FrameHeight = 16;
  localparam int unsigned FrameHeightBits = 16;

  localparam logic [7:0] Background = 8'h38;
  localparam int unsigned BackgroundB = 0;
  localparam int unsigned BackgroundBBits = 8;
  localparam int unsigned BackgroundG = 8;
  localparam int unsigned BackgroundGBits = 8;
  localparam int unsigned BackgroundR = 16;
  localparam int unsigned BackgroundRBits = 8;

  localparam logic [7:0] Commands = 8'h3c;

  localparam logic [7:0] IndexBase = 8'h40;

  localparam logic [7:0] DepthBase = 8'h44;

  localparam logic [7:0] PlanesBase = 8'h48;

  localparam logic [7:0] Cycles = 8'h60;

  localparam logic [7:0] Frames = 8'h64;

  localparam logic [7:0] Drawn = 8'h68;

  localparam logic [7:0] Visible = 8'h6c;

  localparam logic [7:0] TriangleWaits = 8'h70;

  localparam logic [7:0] VideoWaits = 8'h74;

  localparam logic [7:0] BytesRead = 8'h80;
  localparam int unsigned BytesReadClients = 6;

  localparam logic [7:0] BytesWritten = 8'ha0;
  localparam int unsigned BytesWrittenClients = 3;
endpackage
