"""Outlines of planar faces from points: loops of points, smooth curves through them, a STEP file
(pipelines/manual.md, "From points").

  point_files   reads the lines of a file and the numbers in them
  point_rows    headings, columns, separators: the loops of a file
  forms         what a file describes: loops, or aerofoils in one of their formats
  aerofoils     recognises an aerofoil by its points
  loops         closed loops of points, checked and arranged as outline and holes
  polygons      distances, crossings and insides of polygons
  box_tree      segments that may meet
  simplify      loops of fewer points
  corners       where curves end: corners of a loop, nose and trailing edge of an aerofoil
  splines       C2 cubics through points
  near_spline   points added so that the cubic stays near the polygon
  smoothing     points moved onto a smooth curve, within a tolerance
  fit           how far curves are from points, in sentences
  edges         edges of a loop, and of a far field around it
  near_polygon  edges along an open polygon of few points
  fine_loops    loops of edges as fine polygons
  wake          a curve from a body to the far field
  wake_ends     where it begins and ends
  step_file     writes edges as a planar face

Points are complex numbers, x + iy.
"""
