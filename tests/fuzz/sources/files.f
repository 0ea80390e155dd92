// of a unit
a.sv b.v   # and more
-f more.f
-v b.v -y rtl
-I rtl -Irtl +incdir+rtl+none
-D NAME=1 +define+A=2+B -G Depth=4
+libext+.v
rtl
