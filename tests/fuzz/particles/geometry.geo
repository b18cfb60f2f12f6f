LSMGeometry 1.2
BoundingBox 0 0 0 10 10 10
PeriodicBoundaries 0 0 0
Dimension 3D
BeginParticles
Simple
2
1 1 1 0.5 0 3
2.5 1 1 .25 1 4
EndParticles
BeginConnect
0
EndConnect
