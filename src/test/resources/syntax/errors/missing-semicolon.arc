component C {
    component Part part
    timing untimed;
    port in Integer n, { Integer sum; }
}
