pckage q;

component P {
    port in Boolean a;
}
