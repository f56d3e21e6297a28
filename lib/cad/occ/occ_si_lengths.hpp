#pragma once
// The metre with each prefix that STEP files may give it.

#include <StepBasic_SiPrefix.hxx>
#include <array>

namespace quadrille::occ {

struct SiLength {
  StepBasic_SiPrefix prefix;
  const char* name;
  double metres;
};

/// All but the metre itself, which has no prefix.
inline constexpr std::array<SiLength, 16> si_lengths{{{StepBasic_spExa, "exametre", 1e18},
                                                      {StepBasic_spPeta, "petametre", 1e15},
                                                      {StepBasic_spTera, "terametre", 1e12},
                                                      {StepBasic_spGiga, "gigametre", 1e9},
                                                      {StepBasic_spMega, "megametre", 1e6},
                                                      {StepBasic_spKilo, "kilometre", 1e3},
                                                      {StepBasic_spHecto, "hectometre", 1e2},
                                                      {StepBasic_spDeca, "decametre", 1e1},
                                                      {StepBasic_spDeci, "decimetre", 1e-1},
                                                      {StepBasic_spCenti, "centimetre", 1e-2},
                                                      {StepBasic_spMilli, "millimetre", 1e-3},
                                                      {StepBasic_spMicro, "micrometre", 1e-6},
                                                      {StepBasic_spNano, "nanometre", 1e-9},
                                                      {StepBasic_spPico, "picometre", 1e-12},
                                                      {StepBasic_spFemto, "femtometre", 1e-15},
                                                      {StepBasic_spAtto, "attometre", 1e-18}}};

}  // namespace quadrille::occ
