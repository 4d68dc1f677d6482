package q;

imprt r.S;

component P {
    port in Boolean a;
}
