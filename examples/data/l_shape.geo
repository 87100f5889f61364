// An L on a slanted floor, clamped at the end of its arm: "gmsh -2 l_shape.geo" writes l_shape.msh.
h = 0.25;                                              // size of the triangles
Point(1) = {0, 0, 0, h}; Point(2) = {2, 0, 0, h}; Point(3) = {2, 1, 0, h};
Point(4) = {1, 1, 0, h}; Point(5) = {1, 2, 0, h}; Point(6) = {0, 2, 0, h};
For k In {1:6}
  Line(k) = {k, k % 6 + 1};
EndFor
Curve Loop(1) = {1:6}; Plane Surface(1) = {1};
Rotate {{0, 0, 1}, {0, 0, 0}, Pi/9} { Surface{1}; }    // the floor rises by 20 degrees
Physical Curve("contact") = {1}; Physical Curve("clamped") = {5}; Physical Curve("free") = {2, 3, 4, 6};
Physical Surface("body") = {1};
