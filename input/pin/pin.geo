// A plate with a hole of radius 1 and a pin of radius 0.98 in it, one layer of bricks thick.
SetFactory("OpenCASCADE");
Rectangle(1) = {-2, -2, 0, 4, 4};
Disk(2) = {0, 0, 0, 1};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Disk(4) = {0, 0, 0, 0.98};

Mesh.RecombineAll = 1;             // quadrangles, of which bricks are made
Mesh.RecombinationAlgorithm = 3;
Mesh.MeshSizeMin = 0.4;
Mesh.MeshSizeMax = 0.8;
Mesh.MeshSizeFromCurvature = 24;   // edges on a circle

plate[] = Extrude {0, 0, 0.25} { Surface{3}; Layers{1}; Recombine; };
pin[] = Extrude {0, 0, 0.25} { Surface{4}; Layers{1}; Recombine; };

Physical Volume("plate") = {plate[1]};
Physical Volume("pin") = {pin[1]};
