"""Search for positions of the irregular nodes at which the blocks are best (pipelines/manual.md, "Irregular nodes
where you want them").

  layouts         runs the stages for given nodes and measures the blocks
  boundary        points along the boundary of a face
  symmetries      isometries of a layout, and nodes that they map onto each other
  goals           which of two layouts is better
  compass_search  tries moves of the nodes and keeps the better ones

Points and displacements are complex numbers, x + iy.
"""
