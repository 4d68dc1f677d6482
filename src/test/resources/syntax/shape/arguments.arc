component C(Integer size) extends p.Base<Integer>(3, high = size + 1) refines D {
    component Buffer(size = 3, first = size == 4) a;
    component Buffer(1) b;
    component Buffer() c;
    component Inner(Integer a) extends Base() inner { }
    component Other extends Base { }
}
