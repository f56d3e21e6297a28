"""Outlines of planar faces from points: loops of points, smooth curves through them, a STEP file (README, "From points").

  point_files   reads points and aerofoil coordinates
  loops         closed loops of points, checked and arranged as outline and holes
  polygons      distances, crossings and insides of polygons
  corners       where curves end: corners of a loop, nose and trailing edge of an aerofoil
  splines       C2 cubics through points
  edges         edges of a loop, and of a far field around it
  near_polygon  edges along an open polygon of few points
  fine_loops    loops of edges as fine polygons
  wake          a curve from a body to the far field
  wake_ends     where it begins and ends
  step_file     writes edges as a planar face

Points are complex numbers, x + iy.
"""
