-f list.f
none
