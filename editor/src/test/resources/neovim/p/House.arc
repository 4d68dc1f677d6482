package p;

component House {
    port in Boolean bell, out Boolean light;

    component Door front;

    connect bell -> front.pressed;
    connect front.opens -> light;
}
