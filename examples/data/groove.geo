// A block in a groove: two slanted contact edges, each with its own floor, and a free edge between them.
h = 0.2;
Point(1) = {-0.2, 0, 0, h};
Point(2) = {0.2, 0, 0, h};
Point(3) = {1, 0.6, 0, h};
Point(4) = {1, 1.4, 0, h};
Point(5) = {-1, 1.4, 0, h};
Point(6) = {-1, 0.8, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4};
Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1};
Curve Loop(1) = {1:6};
Plane Surface(1) = {1};

Physical Curve("contact left") = {6};
Physical Curve("contact right") = {2};
Physical Curve("clamped") = {4};
Physical Curve("free") = {1, 3, 5};
Physical Surface("body") = {1};
