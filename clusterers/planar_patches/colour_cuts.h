// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/scene/frame.h"
#include "patch_growing.h"

namespace gestalt {

/// Where colour cuts a smooth patch. Lengths in pixels are for a focal length of 525 px and follow it.
struct ColourCutParams {
  double cut_share = 0;      ///< of a cut's length: what must be an edge of the colour image; 0: no cuts
  double cut_contrast = 6;   ///< CIELAB units a pixel: the weakest edge
  double cut_length = 12;    ///< px: the shortest cut
  double cut_width = 6;      ///< px: the narrowest part that a cut leaves, its pixels over the cut's length
  double longest_cut = 0.4;  ///< m: between the ends of a cut
};

/// Adds the declarations to those of a component whose Params derive from ColourCutParams.
template <class Params>
Parameters<Params>& declare_colour_cuts(Parameters<Params>& parameters) {
  const auto real = [&](const char* name, double ColourCutParams::*member, double low, double high, const char* unit,
                        const char* text) {
    parameters.real(name, static_cast<double Params::*>(member), low, high, unit, text);
  };
  using P = ColourCutParams;
  real("cut_share", &P::cut_share, 0, 1, "",
       "patches are cut along straight lines of which this share is an edge of the colour image; 0: none is");
  real("cut_contrast", &P::cut_contrast, 0.1, 100, "CIELAB/px", "the weakest of such edges");
  real("cut_length", &P::cut_length, 2, 1000, "px", "the shortest cut, for f = 525 px");
  real("cut_width", &P::cut_width, 1, 1e6, "px",
       "the narrowest part that a cut may leave, its pixels over the cut's length, for f = 525 px");
  real("longest_cut", &P::longest_cut, 0.001, 1000, "m", "the longest cut: no object's face is wider");
  return parameters;
}

struct CutPatches {
  LabelledPatches patches;
  std::vector<int> grown;  ///< of patch label - 1: the label that it was grown as, in [1, count of grown patches]
};

/// Cuts patches in two along straight lines from outline to outline that colour edges follow, and the parts again:
/// faces of two objects that are flush are one patch to depth alone (paper, Section 9). Print is cut too where it
/// crosses a whole patch; the relations join it again. The first part of a patch keeps its label. The frame must have
/// colour.
CutPatches cut_along_colour_edges(const Frame& frame, const LabelledPatches& patches, const ColourCutParams& params);

}  // namespace gestalt
